//! Mechanisms from motion files, and the quantities of their states.
//!
//! All kinematics are those of [`suspension_core`]. From the top:
//!
//! - [`prepare`] makes the [`kinematics`] of any linkage of a [`mod@file`];
//! - a [`mechanism`] moves, and [`quantities`] are read off its states.
//!
//! Beside them are libraries:
//!
//! - [`characteristics`]: values and curves of a design; [`loads`]: the forces in its parts;
//! - [`sensitivities`]: what each hardpoint does to them; [`tolerances`]: how they scatter; [`tune`]: hardpoints moved
//!   until curves are met;
//! - [`bake`]: motions as polynomials; [`reach`]: how far a drive leads the mechanism;
//! - [`assemblies`]: all ways to put a mechanism together;
//! - [`measured_table`]: tables of measured numbers; [`decimals`]: what their commas and points mean;
//! - [`level_of_detail`]: the cheapest method for a need; `dual`: numbers with derivatives in several directions.

pub mod assemblies;
pub mod bake;
pub mod characteristics;
pub mod decimals;
mod dual;
pub mod kinematics;
pub mod level_of_detail;
pub mod loads;
pub mod measured_table;
pub mod mechanism;
pub mod prepare;
pub mod quantities;
pub mod reach;
pub mod sensitivities;
pub mod tolerances;
pub mod tune;

pub use suspension_motion_file::{self as file, failure, interrupt, number};
