//! How a linkage changes with its drives, in any direction of these, from one factorisation.

use nalgebra::SVector;

use crate::error::SolveError;
use crate::factored::Factored;
use crate::linkage::Linkage;
use crate::motion::{Prescribed, rates_at};
use crate::scalar::Real;
use crate::series::{InputSeries, Jet, Series};
use crate::signal::{Inputs, Signal, Still};

/// A linkage in one configuration with its factored Jacobian: derivatives with respect to its drives. The
/// chassis rests.
///
/// A direction `a` is a change of all drives. Second and third derivatives in one direction, `D2(a)` and
/// `D3(a)`, give the mixed ones: `D(a, b) = (D2(a + b) - D2(a) - D2(b)) / 2` and
/// `D(a, b, b) = (D3(a + b) + D3(a - b) - 2 D3(a)) / 6`.
#[derive(Clone, Copy, Debug)]
pub struct Directions<'a, L: Linkage<N>, const N: usize> {
    linkage: &'a L,
    drives: L::Drives,
    position: SVector<L::Scalar, N>,
    factored: Factored<L::Factors, L::Scalar, N>,
}

impl<'a, T: Real, L: Linkage<N, Scalar = T>, const N: usize> Directions<'a, L, N> {
    /// Factors the Jacobian at a position that solves the linkage for these values of the drives.
    ///
    /// # Errors
    ///
    /// As [`Tangent::new`](crate::Tangent::new).
    pub fn new(
        linkage: &'a L,
        drives: L::Drives,
        position: &SVector<T, N>,
    ) -> Result<Self, SolveError<T>> {
        let inputs = Inputs::still(Signal::still(drives));
        let fixed = Prescribed::new(linkage, &inputs).fixed.value;
        Ok(Self {
            linkage,
            drives,
            position: *position,
            factored: Factored::new(linkage, position, &fixed)?,
        })
    }

    /// All points with their derivatives where the drives change as `change` says: `rate` per unit of that
    /// change, `second_rate` per unit squared.
    ///
    /// # Errors
    ///
    /// [`SolveError::Overflow`] where a derivative is not finite.
    pub fn points(&self, change: L::Drives) -> Result<Signal<L::Points>, SolveError<T>> {
        let inputs = Inputs::still(Signal {
            rate: change,
            ..Signal::still(self.drives)
        });
        let prescribed = Prescribed::new(self.linkage, &inputs);
        let factors = self.factored.factors();
        let rates = rates_at::<_, _, Still, N>(self.linkage, &prescribed, &self.position, factors);
        Ok(rates.motion()?.points_with(self.linkage, &prescribed.fixed))
    }

    /// The unknowns as a polynomial in the multiple of `change` that is added to the drives.
    ///
    /// # Errors
    ///
    /// [`SolveError::Overflow`] where a coefficient is not finite.
    pub fn unknowns<const K: usize>(
        &self,
        change: L::Drives,
    ) -> Result<Jet<SVector<T, N>, K>, SolveError<T>> {
        let mut drives = Jet::constant(self.drives, L::Drives::default());
        if let Some(first) = drives.terms.first_mut() {
            *first = change;
        }
        let inputs = InputSeries::still(drives);
        let factors = self.factored.factors();
        Series::of(self.linkage, &inputs, &self.position, factors).map(|series| series.unknowns)
    }
}
