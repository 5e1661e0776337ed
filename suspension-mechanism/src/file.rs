//! What is written in a motion file: its text, its grammar, and what it may say beyond its grammar.

pub mod check;
mod explain;
pub mod inputs;
mod leading;
mod load;
mod mark;
mod mass;
mod motion_file;
mod per_wheel;
mod source;
mod spring;
mod table;
mod tune;

pub use explain::{is_listing, is_motion};
pub use leading::{StandIn, stand_in};
pub use load::{Load, Wrench};
pub use mass::{BodyMass, Centre, MassTable};
pub use motion_file::{Coefficients, MotionFile, Offset, Position, Time, VehicleTable};
pub use per_wheel::PerWheel;
pub use source::Source;
pub use spring::SpringTable;
pub use table::{Table, in_order};
pub use tune::{AxisName, Direction, MoveTable, TargetTable, TuneTable, Wanted};
