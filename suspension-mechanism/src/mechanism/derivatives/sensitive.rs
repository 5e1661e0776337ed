//! A mechanism in numbers that have derivatives along changes of its design.

use std::array::from_fn;

use nalgebra::Vector3;

use crate::dual::Dual;
use crate::mechanism::derivatives::design_derivatives::Expansion;
use crate::mechanism::derivatives::gradient::DRIVES_AT_ONCE;
use crate::mechanism::derivatives::positions::Positions;
use crate::mechanism::parts::names::Names;

/// The number of changes along which a [`Sensitive`] number has derivatives.
pub const CHANGES_AT_ONCE: usize = 4;

/// A number with its first derivatives along some changes of the design, and with those of its first derivatives with
/// respect to some drives.
pub type Sensitive = Dual<Dual<f64, CHANGES_AT_ONCE>, DRIVES_AT_ONCE>;

/// A term of an [`Expansion`].
#[derive(Clone, Copy)]
enum Term {
    Value,
    First(usize),
    /// The second derivative with respect to two drives, or twice to the same.
    Second(usize, usize),
}

/// A mechanism with derivatives along changes of its design, and with respect to the drives from `first` on.
pub struct InDesign<'a> {
    /// The names of the mechanism's parts.
    pub names: &'a Names,
    /// The mechanism at its start.
    pub start: &'a Expansion,
    /// Its derivatives along the changes, if they exist; at most as many as a number has derivatives.
    pub changes: &'a [Option<Expansion>],
    /// The first of the drives.
    pub first: usize,
}

impl InDesign<'_> {
    fn number(&self, read: impl Fn(&Expansion) -> f64) -> Dual<f64, CHANGES_AT_ONCE> {
        let along = |change: usize| self.changes.get(change)?.as_ref().map(&read);
        Dual {
            value: read(self.start),
            rates: from_fn(|change| along(change).unwrap_or_default()),
        }
    }

    /// A component of a point of a term; NaN for a drive that does not exist.
    fn component(&self, term: Term, point: usize, axis: usize) -> Dual<f64, CHANGES_AT_ONCE> {
        let drives = self.names.drives.len();
        let row = match term {
            Term::Value => Some(0),
            Term::First(drive) => Some(1 + drive).filter(|_| drive < drives),
            Term::Second(a, b) => {
                let (a, b) = (a.min(b), a.max(b));
                Some(1 + drives + b * (b + 1) / 2 + a).filter(|_| b < drives)
            }
        };
        match row.map(|row| row * self.names.points.len() + point) {
            Some(place) => self.number(|expansion| expansion.points[place][axis]),
            None => Dual::still(f64::NAN),
        }
    }

    fn vector(
        &self,
        point: usize,
        value: Term,
        rate: impl Fn(usize) -> Term,
    ) -> Vector3<Sensitive> {
        let component = |axis: usize| Dual {
            value: self.component(value, point, axis),
            rates: from_fn(|drive| self.component(rate(self.first + drive), point, axis)),
        };
        Vector3::new(component(0), component(1), component(2))
    }
}

impl Positions<Sensitive> for InDesign<'_> {
    fn point(&self, point: usize) -> Vector3<Sensitive> {
        self.vector(point, Term::Value, Term::First)
    }

    fn measure(&self, measure: usize) -> Sensitive {
        let count = self.names.measures.len();
        let measure_row =
            |row: usize| self.number(|expansion| expansion.measures[row * count + measure]);
        let per = |drive: usize| {
            let is_one = drive < self.names.drives.len();
            if is_one {
                measure_row(1 + drive)
            } else {
                Dual::still(f64::NAN)
            }
        };
        Dual {
            value: measure_row(0),
            rates: from_fn(|drive| per(self.first + drive)),
        }
    }

    fn velocity(&self, point: usize, drive: usize) -> Option<Vector3<Sensitive>> {
        let is_known = self.names.vehicle.is_moved_by(drive);
        is_known.then(|| self.vector(point, Term::First(drive), |per| Term::Second(drive, per)))
    }
}
