//! A car on its suspension's own geometry, to copy. See the README beside.

pub mod car;
pub mod chassis;
pub mod contact;
pub mod corner;
pub mod detail;
pub mod driver;
pub mod equilibrium;
pub mod kinematics;
pub mod linkages;
pub mod quarter;
pub mod road;
pub mod saloon;
pub mod strut;
pub mod tables;
pub mod tyre;
