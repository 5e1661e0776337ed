//! Roots of 30 digits by Newton's method: residuals in double-double numbers, factors in `f64`.

use nalgebra::SVector;
use suspension_core::listing::{DriveKind, Parts};
use suspension_core::solve::lu::Lu;
use suspension_core::{Linkage, Listing, Signal, Values};
use suspension_double_double::DoubleDouble;

use super::judge::Root;

const MAX_ITERATIONS: usize = 60;

/// A correction that leaves 30 digits.
const LAST_CORRECTION: f64 = 1e-25;

type Exact<L, const N: usize> = <<L as Linkage<N>>::Listing as Listing<N>>::Model<DoubleDouble>;

/// A model of both numbers.
pub(crate) struct Refiner<L: Linkage<N>, const N: usize> {
    model: L,
    exact: Exact<L, N>,
}

/// The struct of values in the order of its names.
fn named<V: Default, S: Values<V>>(values: impl Iterator<Item = V>) -> S {
    S::from_values(values)
}

impl<L, const N: usize> Refiner<L, N>
where
    L: Linkage<N, Scalar = f64, Listing: Listing<N, Model<f64> = L>> + Copy,
{
    pub(crate) fn new(model: &L) -> Self {
        Self {
            model: *model,
            exact: L::Listing::converted(model, |x: f64| DoubleDouble::from(x)),
        }
    }

    /// The root that Newton's method finds from `near`; chassis points as given.
    pub(crate) fn root(
        &self,
        fixed: &L::Fixed,
        drives: &L::Drives,
        near: &SVector<f64, N>,
    ) -> Option<Root<N>> {
        let coordinates = self.coordinates(drives);
        let anchors = fixed.values().map(|point| point.map(DoubleDouble::from));
        let anchors = self.exact.drive_anchors(named(anchors), &coordinates);
        let nearest = named(anchors.values().map(|p| p.map(DoubleDouble::nearest)));
        let mut root = near.map(DoubleDouble::from);
        for _ in 0..MAX_ITERATIONS {
            let residual = self.exact.residual(&root, &anchors, &coordinates);
            let at = root.map(DoubleDouble::nearest);
            let lu = Lu::factor(&self.model.jacobian(&at, &nearest)).ok()?;
            let correction = lu.solve(&residual.map(DoubleDouble::nearest));
            root -= correction.map(DoubleDouble::from);
            if correction.amax() < LAST_CORRECTION {
                return Some(root);
            }
        }
        None
    }

    /// What drives prescribe, cosines of all digits.
    fn coordinates(&self, drives: &L::Drives) -> <Exact<L, N> as Linkage<N>>::Drives {
        // At an angle of zero the coordinate of a link is its length, and the rate of an angle about an axis a
        // quarter of it.
        let one = DoubleDouble::from(1.0);
        let at_zero = self.exact.coordinates(&Signal {
            rate: Values::from_values(std::iter::repeat(one)),
            ..Signal::default()
        });
        let quarters = at_zero.rate.values();
        let lengths = at_zero.value.values().zip(quarters);
        let each = lengths.zip(drives.values()).enumerate();
        named(each.map(
            |(index, ((length, quarter), drive))| match self.exact.drive_kind(index) {
                DriveKind::Coordinate => DoubleDouble::from(drive),
                DriveKind::Angle => length * DoubleDouble::from(drive).sine_cosine().1,
                DriveKind::Turn => {
                    let four = DoubleDouble::from(4.0);
                    quarter * four * (DoubleDouble::from(drive) / four).sine_cosine().0
                }
            },
        ))
    }
}
