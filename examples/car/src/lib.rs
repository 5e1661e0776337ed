//! A car on its suspension's own geometry, to copy. See the README beside.

pub mod contact;
pub mod equilibrium;
pub mod kinematics;
pub mod linkages;
pub mod quarter;
pub mod road;
pub mod saloon;
pub mod strut;
pub mod tyre;
