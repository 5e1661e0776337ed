//! Curves of configurations with one drive free: turning points, closed curves, bifurcations, and
//! motions led by another quantity.

mod bifurcation;
mod case;
mod led;
mod measures;
mod published;
mod wishbone;
