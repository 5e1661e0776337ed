//! The range of a drive: the drive is set free, and the curve of configurations is followed both ways.

mod drive_range;
mod free_drive;
mod limit;
mod meeting;

pub use drive_range::{DriveRange, POOR, Station};
pub use free_drive::range;
pub use limit::{Limit, RangeEnd};
pub use meeting::{CARRIED_ON, holds, is_continued, meeting, moves_alone};
