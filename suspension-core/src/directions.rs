//! How a linkage changes with its drives, in any direction of these, from one factorisation.

use nalgebra::SVector;

use crate::error::SolveError;
use crate::factored::{smallest_pivot, with_factors};
use crate::linkage::{Factors, Linkage};
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
#[derive(Clone, Copy)]
pub struct Directions<'a, L: Linkage<N>, const N: usize> {
    linkage: &'a L,
    drives: L::Drives,
    position: &'a SVector<L::Scalar, N>,
    factors: &'a dyn Factors<L::Scalar, N>,
}

impl<T: Real, L: Linkage<N, Scalar = T>, const N: usize> Directions<'_, L, N> {
    /// Factors the Jacobian at a position that solves the linkage for these values of the drives, and gives `work`
    /// the directions there: factors of large models take longer to move than to use.
    ///
    /// # Errors
    ///
    /// As [`Tangent::new`](crate::Tangent::new), else those of `work`.
    #[inline(always)]
    pub fn at<R, E: From<SolveError<T>>>(
        linkage: &L,
        drives: L::Drives,
        position: &SVector<T, N>,
        work: impl FnOnce(&Directions<'_, L, N>) -> Result<R, E>,
    ) -> Result<R, E> {
        let inputs = Inputs::still(Signal::still(drives));
        let fixed = Prescribed::new(linkage, &inputs).fixed.value;
        with_factors(linkage, position, &fixed, smallest_pivot(), |factors| {
            work(&Directions {
                linkage,
                drives,
                position,
                factors,
            })
        })?
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
        let rates =
            rates_at::<_, _, Still, N>(self.linkage, &prescribed, self.position, self.factors);
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
        Series::of(self.linkage, &inputs, self.position, self.factors).map(|series| series.unknowns)
    }
}
