//! A mechanism far from the origin of its coordinates, solved near it.
//!
//! Coordinates are rounded to a part of their size, and so is what is solved in them: a kilometre
//! away in `f32` nothing is left of a millimetre. Hardpoints are best stated in chassis axes. Where
//! they are given in others, a [`LocalOrigin`] among them makes local ones of all that is put in;
//! rates, angles, lengths and differences are the same in both.

use nalgebra::Vector3;

use crate::linkage::{Build, DriveKind, Linkage, MeasureKind, Named};
use crate::scalar::Real;
use crate::signal::Signal;

/// Among how many sizes of a mechanism its local origin is a multiple: coordinates up to half of
/// that stay as they are, without another rounding.
const STEP: f64 = 16.0;

/// Where local coordinates, parallel to the given ones, have their origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LocalOrigin<T: Real>(Vector3<T>);

impl<T: Real> LocalOrigin<T> {
    /// Near the points: zero where they are near the origin already, and where one is not finite.
    pub fn among<P: Named<Vector3<T>>>(points: &P) -> Self {
        let Some(first) = points.values().next() else {
            return Self(Vector3::zeros());
        };
        let extent = points.values().fold(T::zero(), |extent, point| {
            extent.max((point - first).amax())
        });
        let step = extent * T::constant(STEP);
        let origin = first.map(|x| (x / step).round() * step);
        if origin.iter().all(|x| x.is_finite()) {
            Self(origin)
        } else {
            Self(Vector3::zeros())
        }
    }

    /// The local origin in given coordinates.
    pub fn position(&self) -> Vector3<T> {
        self.0
    }

    /// Points in local coordinates, from given ones.
    pub fn to_local<P: Named<Vector3<T>>>(&self, points: &P) -> P {
        points.map(|point| point - self.0)
    }

    /// Points in given coordinates, from local ones.
    pub fn from_local<P: Named<Vector3<T>>>(&self, points: &P) -> P {
        points.map(|point| point + self.0)
    }

    /// What to subtract from each drive's value, and to add to one that was read off: the local
    /// origin's coordinate where the drive is a coordinate of a point, otherwise zero.
    pub fn of_drives<L: Build<N, Scalar = T>, const N: usize>(&self, linkage: &L) -> L::Drives {
        let values = linkage.drives_at(&self.everywhere());
        let each = values.values().zip(L::DRIVE_KINDS);
        L::Drives::from_values(each.map(|(value, kind)| match kind {
            DriveKind::Coordinate => value,
            DriveKind::Angle => T::zero(),
        }))
    }

    /// What to add to each measure of local points: see [`of_drives`](Self::of_drives).
    pub fn of_measures<L: Linkage<N, Scalar = T>, const N: usize>(&self) -> L::Measures {
        let points = Signal {
            value: self.everywhere(),
            rate: self.everywhere(),
            second_rate: self.everywhere(),
        };
        let values = L::measures(&points).value;
        let each = values.values().zip(L::MEASURE_KINDS);
        L::Measures::from_values(each.map(|(value, kind)| match kind {
            MeasureKind::Length => value,
            MeasureKind::Angle => T::zero(),
        }))
    }

    /// All points in the local origin: what has no direction there, no length and no difference.
    fn everywhere<P: Named<Vector3<T>>>(&self) -> P {
        P::from_fn(|_| self.0)
    }
}
