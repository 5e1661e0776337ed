//! The wheel beside another one.

use crate::mechanism::{Pair, Wheel, WheelPoints};

/// The other wheel of an axle on which each wheel has a drive of travel of its own.
#[derive(Clone, Copy)]
pub(crate) struct OppositeWheel {
    pub(crate) points: WheelPoints,
    pub(crate) travel: usize,
}

impl OppositeWheel {
    /// The wheel beside that of a number, from all wheels and their pairs.
    pub(crate) fn find(wheels: &[Wheel], pairs: &[Pair], number: usize) -> Option<Self> {
        let other = pairs.iter().find_map(|pair| pair.other(number))?;
        let [own, other] = [number, other].map(|wheel| &wheels[wheel]);
        let (own, travel) = own.travel.zip(other.travel)?;
        (own != travel).then_some(Self {
            points: other.points,
            travel,
        })
    }
}
