//! The drives of travel and of steering.

use crate::mechanism::Names;

/// What drives do, in any listing.
pub(super) const TRAVEL: &str = "travel";
pub(super) const STEER: &str = "steer";
pub(super) const ROLL: &str = "roll";

/// A drive of travel or of steering.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Way {
    /// The drive's number.
    pub drive: usize,
    /// `travel` or `steer`; with several such drives the second is `travel 2`.
    pub name: String,
}

impl Way {
    /// Those of a mechanism, travel first.
    pub fn all(names: &Names) -> Vec<Self> {
        let vehicle = &names.vehicle;
        let kinds = [(TRAVEL, &vehicle.travel), (STEER, &vehicle.steer)];
        let each = kinds.into_iter().flat_map(|(kind, drives)| {
            let of_one = move |(number, drive): (usize, &usize)| Self {
                drive: *drive,
                name: numbered(kind, number),
            };
            (1..).zip(drives).map(of_one)
        });
        each.collect()
    }
}

/// `travel`, `travel 2`.
pub(super) fn numbered(kind: &str, number: usize) -> String {
    match number {
        1 => kind.to_owned(),
        number => format!("{kind} {number}"),
    }
}
