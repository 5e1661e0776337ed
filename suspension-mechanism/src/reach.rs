//! The range of a drive: the drive is set free, and the curve of configurations is followed both ways.

mod course;
mod limit;
mod meeting;
mod station;

pub use course::{DriveRange, POOR, range};
pub use limit::{Limit, RangeEnd};
pub use meeting::{CARRIED_ON, holds, meeting, moves_alone};
pub use station::Station;
