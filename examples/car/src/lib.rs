//! A vehicle model to copy, whose wheels move on the geometry of its suspensions. See its README.

pub mod car;
pub mod chart;
pub mod chassis;
pub mod compare;
pub mod contact;
pub mod corner;
pub mod detail;
pub mod drive;
pub mod driver;
pub mod equilibrium;
pub mod kinematics;
pub mod linkages;
pub mod plot;
pub mod quarter;
pub mod record;
pub mod road;
pub mod saloon;
pub mod scene;
pub mod strut;
pub mod tables;
pub mod tyre;
