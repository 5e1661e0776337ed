//! The catalogue of layouts: one listing in each file, all of them as text in [`LISTINGS`].
//!
//! Each layout that is compiled here has a module, which [`linkage!`](crate::linkage!#the-generated-module) writes. The others
//! cost no build time: `suspension-runtime` reads them. To compile one into a program, copy its text and
//! write `linkage! { pub mod name; }`.

#[cfg(feature = "macros")]
use crate::linkage;

macro_rules! catalogue {
    (compiled: $($compiled:ident),*; text: $($text:ident),*;) => {
        $(
            #[cfg(feature = "macros")]
            linkage! { pub mod $compiled; }
        )*

        /// The listings by name, as text.
        pub const LISTINGS: &[(&str, &str)] = &[
            $((stringify!($compiled), include_str!(concat!(stringify!($compiled), ".linkage"))),)*
            $((stringify!($text), include_str!(concat!(stringify!($text), ".linkage"))),)*
        ];
    };
}

catalogue! {
    compiled: attia2003, five_link, double_wishbone, double_wishbone_pushrod;
    text: double_wishbone_coilover, double_wishbone_rocker, five_link_rack, multi_link, multi_link_coilover, macpherson, macpherson_two_links, trailing_arm,
        semi_trailing_arm, split_lower_arm, integral_link, live_axle_panhard, live_axle_splayed, live_axle_watt, steered_axle, twist_beam, front_and_rear_axle;
}
