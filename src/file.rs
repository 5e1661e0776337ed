//! What is written in a motion file: its text, its grammar, and what it may say beyond its grammar.

pub mod check;
mod drive_of;
mod explain;
mod leading;
mod mark;
mod motion_file;
mod source;

pub use drive_of::DriveOf;
pub use explain::{is_listing, is_motion};
pub use leading::{StandIn, stand_in};
pub use motion_file::{Coefficients, MotionFile, Offset, Position, Table, Time, VehicleTable};
pub use source::Source;
