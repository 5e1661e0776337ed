//! Names that are made of those of a listing.

use super::AXES;
use crate::name::Name;

/// The name of the frame of three points.
pub fn frame_name(owner: &Name) -> Name {
    Name::made(format!("{owner}_frame"))
}

/// The name of the constants of a carried point.
pub fn carried_name(body: &Name, point: &Name) -> Name {
    Name::made(format!("{body}_{point}"))
}

/// The name of the length between two points of a body.
pub fn pair_name(body: &Name, a: &Name, b: &Name) -> Name {
    Name::made(format!("{body}_{a}_{b}"))
}

/// The name of the length that a drive prescribes.
pub fn length_name(drive: &Name) -> Name {
    Name::made(format!("{drive}_length"))
}

/// The name of the distance from the first point of a plane towards another.
pub(crate) fn distance_name(plane: &Name, towards: &Name) -> Name {
    Name::made(format!("{plane}_{towards}"))
}

/// The name of a part of the equations of an angle about an axis.
pub(crate) fn turn_name(drive: &Name, part: &str) -> Name {
    Name::made(format!("{drive}_{part}"))
}

/// The name of a coordinate of a vector.
pub fn coordinate_name(vector: &Name, axis: usize) -> Name {
    Name::made(format!("{vector}_{}", AXES[axis]))
}
