//! The way in which drives move a wheel or an axle.

use std::fmt;

use crate::mechanism::Names;

/// The effect of a drive, in any listing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Does {
    /// It moves wheels up and down.
    Travel,
    /// It moves one wheel of an axle up and the other down.
    Roll,
    /// It steers.
    Steer,
}

/// The effect of a drive, or of several that move together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Way {
    /// Their effect.
    pub does: Does,
    /// The number among those with the same effect, from 1.
    pub number: usize,
}

impl Way {
    /// The drives of a mechanism that have an effect, by number, those of travel first.
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
    /// `travel`; `travel 2` for a second axle or wheel.
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
