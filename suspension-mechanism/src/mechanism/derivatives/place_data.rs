//! The data of a place before its derivatives are computed.

use nalgebra::{SVector, Vector3};
use suspension_core::Motion;

use crate::mechanism::parts::names::Names;
use crate::mechanism::points::Points;

/// The highest order of the derivatives of quantities that are wanted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DerivativeOrder {
    /// First derivatives.
    First,
    /// First and second derivatives.
    Second,
}

/// The data that are known before a place is evaluated.
#[derive(Clone, Copy)]
pub(crate) struct PlaceData<'a, const N: usize> {
    pub(crate) order: DerivativeOrder,
    pub(crate) rates: &'a SharedRates,
    /// The motion by which the place was reached, if a single drive moved.
    pub(crate) arrival: Option<&'a Arrival<N>>,
}

/// The motion by which a place was reached with one drive moving and the others held: its rates there are the
/// derivatives with respect to that drive.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Arrival<const N: usize> {
    pub(crate) drive: usize,
    pub(crate) first: SVector<f64, N>,
    pub(crate) second: SVector<f64, N>,
}

impl<const N: usize> Arrival<N> {
    /// The arrival by a motion in which some drives changed by these amounts per second, at constant rates.
    pub(crate) fn new(motion: &Motion<f64, N>, changes: &[(usize, f64)]) -> Option<Self> {
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

/// Rates of points that all places share.
pub(crate) struct SharedRates {
    /// Rates at rest.
    pub(crate) still: Points,
    /// Rates that are not known.
    pub(crate) unknown: Points,
}

impl SharedRates {
    pub(crate) fn new(names: &Names) -> Self {
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
