//! The way in which drives move a wheel or an axle.

use std::fmt;

use crate::mechanism::Names;

/// What a drive does, in any listing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Does {
    /// It moves wheels up and down.
    Travel,
    /// It moves one wheel of an axle up and the other down.
    Roll,
    /// It steers.
    Steer,
}

/// What a drive does, or several that move together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Way {
    /// What they do.
    pub does: Does,
    /// Which of those that do it, from 1.
    pub number: usize,
}

impl Way {
    /// The drives of a mechanism that do something, by number, those of travel first.
    pub fn of_drives(names: &Names) -> Vec<(Self, usize)> {
        let vehicle = &names.vehicle;
        let each = [
            (Does::Travel, &vehicle.travel),
            (Does::Steer, &vehicle.steer),
        ];
        let numbered = each.into_iter().flat_map(|(does, drives)| {
            let numbered = (1..).zip(drives);
            numbered.map(move |(number, drive)| (Self { does, number }, *drive))
        });
        numbered.collect()
    }
}

impl fmt::Display for Way {
    /// `travel`; of a second axle or wheel `travel 2`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self.does {
            Does::Travel => "travel",
            Does::Roll => "roll",
            Does::Steer => "steer",
        })?;
        match self.number {
            1 => Ok(()),
            number => write!(f, " {number}"),
        }
    }
}
