//! Curves of configurations with one drive free: turning points, closed curves, bifurcations, and
//! motions led by another quantity.

mod support;

#[path = "path/bifurcation.rs"]
mod bifurcation;
#[path = "path/case.rs"]
mod case;
#[path = "path/led.rs"]
mod led;
#[path = "path/measures.rs"]
mod measures;
#[path = "path/published.rs"]
mod published;
#[path = "path/random.rs"]
mod random;
#[path = "path/wishbone.rs"]
mod wishbone;
