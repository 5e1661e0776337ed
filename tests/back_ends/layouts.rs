//! The catalogue's layouts over their travel: links, bodies and slides by plain geometry, and for each layout the
//! consequences of its kind, without the solver.

mod double_wishbone_coilover;
mod double_wishbone_rocker;
mod five_link_rack;
mod integral_link;
mod layout;
mod live_axle_panhard;
mod live_axle_splayed;
mod live_axle_watt;
mod macpherson;
mod macpherson_two_links;
mod multi_link;
mod multi_link_coilover;
mod semi_trailing_arm;
mod split_lower_arm;
mod steered_axle;
mod trailing_arm;
mod twist;
mod twist_beam;
