//! The data of a place before its derivatives are computed.

use nalgebra::{SVector, Vector3};
use suspension_core::Motion;

use crate::mechanism::names::Names;
use crate::mechanism::points::Points;

/// Up to which order derivatives of quantities are wanted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// The first.
    First,
    /// The second too.
    Second,
}

/// What is known before a place is looked at.
#[derive(Clone, Copy)]
pub(crate) struct Known<'a, const N: usize> {
    pub(crate) order: Order,
    pub(crate) lists: &'a Lists,
    /// How the motion came there, where one drive moved alone.
    pub(crate) arrival: Option<&'a Arrival<N>>,
}

/// How a motion came to a place by one drive, the others held: what it has there are the derivatives with respect to that drive.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Arrival<const N: usize> {
    pub(crate) drive: usize,
    pub(crate) first: SVector<f64, N>,
    pub(crate) second: SVector<f64, N>,
}

impl<const N: usize> Arrival<N> {
    /// Of the motion in which some drives changed by so much in a second, at constant rates.
    pub(crate) fn of(motion: &Motion<f64, N>, changes: &[(usize, f64)]) -> Option<Self> {
        let [(drive, change)] = changes else {
            return None;
        };
        (*change != 0.0).then(|| Self {
            drive: *drive,
            first: motion.velocity / *change,
            second: motion.acceleration / (change * change),
        })
    }
}

/// Lists of points that all places share.
pub(crate) struct Lists {
    /// Rates at rest.
    pub(crate) still: Points,
    /// Rates that are not known.
    pub(crate) unknown: Points,
}

impl Lists {
    /// Of a mechanism's points.
    pub(crate) fn of(names: &Names) -> Self {
        let all = |number: f64| -> Points {
            let each = names.points.iter();
            each.map(|_| Vector3::repeat(number)).collect()
        };
        Self {
            still: all(0.0),
            unknown: all(f64::NAN),
        }
    }
}
