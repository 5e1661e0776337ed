//! What drives do to the wheels: they move them up and down, roll an axle, or steer.

use std::fmt;

use crate::mechanism::Names;

/// The effect of a drive, in any listing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Effect {
    /// It moves wheels up and down.
    Travel,
    /// It moves one wheel of an axle up and the other down.
    Roll,
    /// It steers.
    Steer,
}

/// The effect of a drive, or of several that move together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Movement {
    /// Their effect.
    pub effect: Effect,
    /// The number among those with the same effect, from 1.
    pub number: usize,
}

impl Movement {
    /// The drives of a mechanism that have an effect, by number, those of travel first.
    pub fn of_drives(names: &Names) -> Vec<(Self, usize)> {
        let vehicle = &names.vehicle;
        let each = [
            (Effect::Travel, &vehicle.travel),
            (Effect::Steer, &vehicle.steer),
        ];
        let numbered = each.into_iter().flat_map(|(effect, drives)| {
            let numbered = (1..).zip(drives);
            numbered.map(move |(number, drive)| (Self { effect, number }, *drive))
        });
        numbered.collect()
    }
}

impl fmt::Display for Movement {
    /// `travel`; `travel 2` for a second axle or wheel.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self.effect {
            Effect::Travel => "travel",
            Effect::Roll => "roll",
            Effect::Steer => "steer",
        })?;
        match self.number {
            1 => Ok(()),
            number => write!(f, " {number}"),
        }
    }
}
