//! What is written in a motion file: its text, its grammar, and what it may say beyond its grammar; its units, axes and
//! instants; how a mistake in it is told.

mod axes;
mod axle;
pub mod check;
mod dimension;
mod explain;
pub mod failure;
pub mod inputs;
mod instants;
pub mod interrupt;
mod leading;
mod load;
mod mark;
mod mass;
mod motion_file;
pub mod number;
mod number_list;
mod per_wheel;
mod place_of_key;
mod source;
mod spring;
mod table;
mod tell;
mod torque;
mod tune;
mod unit;

pub use axes::Axes;
pub use axle::{Axle, is_within};
pub use dimension::Dimension;
pub use explain::{is_listing, is_motion};
pub use instants::Instants;
pub use leading::{StandIn, stand_in};
pub use load::{Load, LoadCase, Wrench};
pub use mass::{BodyMass, Centre, MassTable};
pub use motion_file::{Coefficients, MotionFile, Offset, Position, Time, VehicleTable};
pub use number_list::NumberList;
pub use per_wheel::PerWheel;
pub use source::Source;
pub use spring::SpringTable;
pub use table::{Table, in_order};
pub use tell::tell;
pub use torque::Torque;
pub use tune::{AxisName, Direction, MoveTable, TargetTable, TuneTable, Wanted};
pub use unit::{Angle, Length, Unit};
