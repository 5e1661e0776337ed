//! Derivatives of a linkage with respect to its drives, along any direction of them, from one factorisation.

use core::ops::{Add, Neg, Sub};

use nalgebra::SVector;

use crate::arithmetic::entrywise::difference;
use crate::arithmetic::magnitude::magnitude;
use crate::arithmetic::scalar::Real;
use crate::error::SolveError;
use crate::linkage::{Factors, Linkage, Values};
use crate::signal::{Inputs, Signal};
use crate::solve::factored::with_factors_for_rates;
use crate::solve::motion::Prescribed;
use crate::step::series::{InputSeries, Jet, Series};

/// A linkage in one configuration with its factored Jacobian, which gives derivatives with respect to the drives. The
/// chassis is at rest.
///
/// A direction `a` is a change of all drives. Third derivatives in one direction, `D3(a)`, give the mixed ones: `D(a,
/// b, b) = (D3(a + b) + D3(a - b) - 2 D3(a)) / 6`.
#[derive(Clone, Copy)]
pub struct Directions<'a, L: Linkage<N>, const N: usize> {
    linkage: &'a L,
    drives: L::Drives,
    position: &'a SVector<L::Scalar, N>,
    fixed: &'a L::Fixed,
    points: &'a L::Points,
    factors: &'a dyn Factors<L::Scalar, N>,
}

/// The motion of a linkage in one direction: first derivatives.
#[derive(Clone, Copy, Debug)]
pub struct Direction<L: Linkage<N>, const N: usize> {
    change: L::Drives,
    fixed: L::Fixed,
    unknowns: SVector<L::Scalar, N>,
    /// The first derivatives of all points, per unit of the change of the drives.
    pub points: L::Points,
}

impl<T: Real, L: Linkage<N, Scalar = T>, const N: usize> Directions<'_, L, N> {
    /// Factors the Jacobian at a position that solves the linkage for these values of the drives, and passes the
    /// directions there to `work`: factors of large models take longer to move than to use.
    ///
    /// # Errors
    ///
    /// As [`Tangent::new`](crate::Tangent::new), otherwise those of `work`.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn at<R, E: From<SolveError<T>>>(
        linkage: &L,
        drives: L::Drives,
        position: &SVector<T, N>,
        work: impl FnOnce(&Directions<'_, L, N>) -> Result<R, E>,
    ) -> Result<R, E> {
        let inputs = Inputs::still(Signal::still(drives));
        let fixed = Prescribed::new(linkage, &inputs).fixed.value;
        let points = linkage.points(position, &fixed);
        with_factors_for_rates(linkage, position, &fixed, |factors| {
            work(&Directions {
                linkage,
                drives,
                position,
                fixed: &fixed,
                points: &points,
                factors,
            })
        })?
    }

    /// All points with their derivatives for the change of drives `change`: `rate` per unit of that change,
    /// `second_rate` per unit squared.
    ///
    /// # Errors
    ///
    /// [`SolveError::Overflow`] if a derivative is not finite.
    pub fn points(&self, change: L::Drives) -> Result<Signal<L::Points>, SolveError<T>> {
        let direction = self.first(change)?;
        Ok(Signal {
            value: *self.points,
            rate: direction.points,
            second_rate: self.second(&direction)?,
        })
    }

    /// All points.
    pub fn position(&self) -> &L::Points {
        self.points
    }

    /// The first derivatives for the change of drives `change`.
    ///
    /// # Errors
    ///
    /// [`SolveError::Overflow`] if a derivative is not finite.
    pub fn first(&self, change: L::Drives) -> Result<Direction<L, N>, SolveError<T>> {
        let drives = self.coordinates(change).rate;
        let fixed = self.anchors(&drives);
        let terms = self.input_terms(&fixed, &drives);
        let unknowns = self.factors.solve(&terms);
        magnitude(&unknowns).map_err(SolveError::overflow)?;
        Ok(self.direction(change, fixed, unknowns))
    }

    /// The first derivatives, given those of the unknowns: the velocity of a motion that passes this configuration
    /// while the drives change by `change` per second, at a constant rate.
    pub fn first_of(&self, change: L::Drives, unknowns: SVector<T, N>) -> Direction<L, N> {
        let fixed = self.anchors(&self.coordinates(change).rate);
        self.direction(change, fixed, unknowns)
    }

    /// The second derivatives of all points in a direction.
    ///
    /// # Errors
    ///
    /// [`SolveError::Overflow`] if a derivative is not finite.
    pub fn second(&self, direction: &Direction<L, N>) -> Result<L::Points, SolveError<T>> {
        let drives = self.coordinates(direction.change).second_rate;
        let fixed = self.anchors(&drives);
        let unknowns = self.bilinear([direction; 2], &fixed, &drives)?;
        Ok(self.accelerations(&direction.points, &unknowns, &fixed))
    }

    /// The second derivatives, given those of the unknowns: the acceleration of such a motion.
    pub fn second_of(&self, direction: &Direction<L, N>, unknowns: &SVector<T, N>) -> L::Points {
        let fixed = self.anchors(&self.coordinates(direction.change).second_rate);
        self.accelerations(&direction.points, unknowns, &fixed)
    }

    /// The mixed second derivatives of all points in two directions.
    ///
    /// # Errors
    ///
    /// [`SolveError::Overflow`] if a derivative is not finite.
    pub fn mixed(&self, [a, b]: [&Direction<L, N>; 2]) -> Result<L::Points, SolveError<T>> {
        let quarter = T::constant(0.25);
        // For a function Q that is quadratic in the direction: (Q(a + b) - Q(a - b)) / 4.
        let drives = |b: L::Drives| {
            self.coordinates(a.change.combined(&b, Add::add))
                .second_rate
        };
        let (plus, minus) = (drives(b.change), drives(b.change.map(Neg::neg)));
        let drives = plus.combined(&minus, |plus, minus| (plus - minus) * quarter);
        let fixed = self.anchors(&drives);
        let unknowns = self.bilinear([a, b], &fixed, &drives)?;
        let linear = self.linkage.velocities(self.points, &unknowns, &fixed);
        let (still, at_rest) = (SVector::from([T::zero(); N]), L::Fixed::default());
        let markers = |velocities| self.accelerations(&velocities, &still, &at_rest);
        let plus = markers(a.points.combined(&b.points, Add::add));
        let minus = markers(a.points.combined(&b.points, Sub::sub));
        let quadratic = plus.combined(&minus, |plus, minus| (plus - minus) * quarter);
        Ok(linear.combined(&quadratic, Add::add))
    }

    /// The drives' coordinates with their derivatives for the change of drives `change`.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn coordinates(&self, change: L::Drives) -> Signal<L::Drives> {
        self.linkage.coordinates(&Signal {
            rate: change,
            ..Signal::still(self.drives)
        })
    }

    /// Derivatives of the chassis points, given those of the drives' coordinates.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn anchors(&self, drives: &L::Drives) -> L::Fixed {
        self.linkage.drive_anchors(L::Fixed::default(), drives)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn input_terms(&self, fixed: &L::Fixed, drives: &L::Drives) -> SVector<T, N> {
        self.linkage
            .drive_rate(self.position, self.fixed, fixed, drives)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn direction(
        &self,
        change: L::Drives,
        fixed: L::Fixed,
        unknowns: SVector<T, N>,
    ) -> Direction<L, N> {
        Direction {
            change,
            fixed,
            unknowns,
            points: self.linkage.velocities(self.points, &unknowns, &fixed),
        }
    }

    /// Second derivatives of the unknowns in two directions, given those of the chassis points and of the drives'
    /// coordinates.
    fn bilinear(
        &self,
        [a, b]: [&Direction<L, N>; 2],
        fixed: &L::Fixed,
        drives: &L::Drives,
    ) -> Result<SVector<T, N>, SolveError<T>> {
        let terms = self.input_terms(fixed, drives);
        let curvature = self
            .linkage
            .curvature(&a.unknowns, &a.fixed, &b.unknowns, &b.fixed);
        let unknowns = self.factors.solve(&difference(&terms, &curvature));
        magnitude(&unknowns).map_err(SolveError::overflow)?;
        Ok(unknowns)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn accelerations(
        &self,
        velocities: &L::Points,
        unknowns: &SVector<T, N>,
        fixed: &L::Fixed,
    ) -> L::Points {
        self.linkage
            .accelerations(self.points, velocities, unknowns, fixed)
    }

    /// The unknowns as a polynomial in the multiple of `change` that is added to the drives.
    ///
    /// # Errors
    ///
    /// [`SolveError::Overflow`] if a coefficient is not finite.
    pub fn unknowns<const K: usize>(
        &self,
        change: L::Drives,
    ) -> Result<Jet<SVector<T, N>, K>, SolveError<T>> {
        let mut drives = Jet::constant(self.drives, L::Drives::default());
        if let Some(first) = drives.terms.first_mut() {
            *first = change;
        }
        let inputs = InputSeries::still(drives);
        Series::from_factors(self.linkage, &inputs, self.position, self.factors)
            .map(|series| series.unknowns)
    }
}
