//! Velocity and acceleration at a known position, from one factorisation.

use core::marker::PhantomData;

use nalgebra::SVector;

use crate::arithmetic::entrywise::sum;
use crate::arithmetic::magnitude::magnitude;
use crate::arithmetic::scalar::{Real, Scalar};
use crate::error::SolveError;
use crate::linkage::{Factors, Linkage};
use crate::signal::{ChassisMotion, Inputs, Signal};
use crate::solve::factored::Factored;

/// The unknowns and their first and second time derivatives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion<T, const N: usize> {
    /// `q`, in units of length.
    pub position: SVector<T, N>,
    /// `qdot`, per second.
    pub velocity: SVector<T, N>,
    /// `qddot`, per second squared.
    pub acceleration: SVector<T, N>,
    /// The sign of the Jacobian's determinant, if known. It changes only at a singularity, so it tells assemblies
    /// apart.
    pub positive_determinant: Option<bool>,
}

impl<T: Scalar, const N: usize> Motion<T, N> {
    /// A motion at rest in a position.
    pub fn at_rest(position: SVector<T, N>) -> Self {
        let zero = SVector::from([T::zero(); N]);
        Self {
            position,
            velocity: zero,
            acceleration: zero,
            positive_determinant: None,
        }
    }

    /// The same position and assembly at rest.
    pub fn stopped(self) -> Self {
        Self {
            positive_determinant: self.positive_determinant,
            ..Self::at_rest(self.position)
        }
    }
}

impl<T: Real, const N: usize> Motion<T, N> {
    /// The second-order prediction `q + qdot dt + qddot dt^2 / 2`.
    pub fn predict(&self, dt: T) -> SVector<T, N> {
        self.position + (self.velocity + self.acceleration * (dt * T::constant(0.5))) * dt
    }

    /// Positions, velocities and accelerations of all points of the linkage: chassis points, free
    /// points and markers under their names.
    pub fn points<L, C>(&self, linkage: &L, inputs: &Inputs<C, L::Drives>) -> Signal<L::Points>
    where
        L: Linkage<N, Scalar = T>,
        C: ChassisMotion<L::Fixed>,
    {
        self.points_with(linkage, &Prescribed::new(linkage, inputs).fixed)
    }

    /// The same, given the chassis points.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn points_with<L>(&self, linkage: &L, fixed: &Signal<L::Fixed>) -> Signal<L::Points>
    where
        L: Linkage<N, Scalar = T>,
    {
        let value = linkage.points(&self.position, &fixed.value);
        let rate = linkage.velocities(&value, &self.velocity, &fixed.rate);
        let second_rate =
            linkage.accelerations(&value, &rate, &self.acceleration, &fixed.second_rate);
        Signal {
            value,
            rate,
            second_rate,
        }
    }
}

/// Inputs in the form in which the equations take them.
#[derive(Clone, Copy, Debug)]
pub struct Prescribed<F, D> {
    /// Chassis points, with the driven coordinates inserted.
    pub fixed: Signal<F>,
    /// Drives, with angles converted to coordinates.
    pub drives: Signal<D>,
}

impl<F, D> Prescribed<F, D> {
    /// Prepares the inputs of a linkage.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn new<L, C, const N: usize>(linkage: &L, inputs: &Inputs<C, D>) -> Self
    where
        L: Linkage<N, Fixed = F, Drives = D>,
        C: ChassisMotion<F>,
    {
        let drives = linkage.coordinates(&inputs.drives);
        let mut fixed = inputs.chassis.signal(linkage.fixed());
        linkage.put_drives(&mut fixed.value, &drives.value);
        linkage.put_drives(&mut fixed.rate, &drives.rate);
        linkage.put_drives(&mut fixed.second_rate, &drives.second_rate);
        Self { fixed, drives }
    }
}

/// A linkage in one configuration with its factored Jacobian: the linear equations for velocities and accelerations.
#[derive(Clone, Copy, Debug)]
pub struct Tangent<'a, L: Linkage<N>, C, const N: usize> {
    linkage: &'a L,
    chassis: PhantomData<C>,
    prescribed: Prescribed<L::Fixed, L::Drives>,
    position: SVector<L::Scalar, N>,
    factored: Factored<L::Factors, L::Scalar, N>,
}

impl<'a, T, L, C, const N: usize> Tangent<'a, L, C, N>
where
    T: Real,
    L: Linkage<N, Scalar = T>,
    C: ChassisMotion<L::Fixed>,
{
    /// Factors the Jacobian at a position that solves the linkage for `inputs`.
    ///
    /// # Errors
    ///
    /// [`SolveError::Singular`] so close to a singularity that the rounding errors of the position leave hardly a
    /// digit of a velocity.
    pub fn new(
        linkage: &'a L,
        inputs: &Inputs<C, L::Drives>,
        position: &SVector<T, N>,
    ) -> Result<Self, SolveError<T>> {
        let prescribed = Prescribed::new(linkage, inputs);
        let factored = Factored::new(linkage, position, &prescribed.fixed.value)?;
        let position = *position;
        Ok(Self {
            linkage,
            chassis: PhantomData,
            prescribed,
            position,
            factored,
        })
    }

    /// `J qdot = -dF/du udot` (Attia 2003, eq. 3).
    pub fn velocity(&self) -> SVector<T, N> {
        self.rates().velocity()
    }

    /// `J qddot = -C(qdot, qdot) - dF/du uddot` (Attia 2003, eq. 7 and 8).
    pub fn acceleration(&self, velocity: &SVector<T, N>) -> SVector<T, N> {
        self.rates().acceleration(velocity)
    }

    /// Position, velocity and acceleration.
    ///
    /// # Errors
    ///
    /// [`SolveError::Overflow`] if a velocity or an acceleration is not finite.
    pub fn motion(&self) -> Result<Motion<T, N>, SolveError<T>> {
        self.rates().motion()
    }

    fn rates(&self) -> Rates<'_, L, C, N> {
        let factors = self.factored.factors();
        Rates::new(self.linkage, &self.prescribed, &self.position, factors)
    }
}

/// The rates that a [`Tangent`] computes, with borrowed factors: the control loop does not copy them.
pub(crate) struct Rates<'a, L: Linkage<N>, C, const N: usize> {
    linkage: &'a L,
    chassis: PhantomData<C>,
    prescribed: &'a Prescribed<L::Fixed, L::Drives>,
    position: &'a SVector<L::Scalar, N>,
    factors: &'a dyn Factors<L::Scalar, N>,
}

impl<'a, T, L, C, const N: usize> Rates<'a, L, C, N>
where
    T: Real,
    L: Linkage<N, Scalar = T>,
    C: ChassisMotion<L::Fixed>,
{
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn new(
        linkage: &'a L,
        prescribed: &'a Prescribed<L::Fixed, L::Drives>,
        position: &'a SVector<T, N>,
        factors: &'a dyn Factors<T, N>,
    ) -> Self {
        Self {
            linkage,
            chassis: PhantomData,
            prescribed,
            position,
            factors,
        }
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn velocity(&self) -> SVector<T, N> {
        let Prescribed { fixed, drives } = self.prescribed;
        self.factors
            .solve(&self.input_terms(&fixed.rate, &drives.rate))
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn acceleration(&self, velocity: &SVector<T, N>) -> SVector<T, N> {
        let Prescribed { fixed, drives } = self.prescribed;
        let inputs = self.input_terms(&fixed.second_rate, &drives.second_rate);
        let rate = &fixed.rate;
        self.factors
            .solve(&(inputs - self.linkage.curvature(velocity, rate, velocity, rate)))
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn motion(&self) -> Result<Motion<T, N>, SolveError<T>> {
        let velocity = self.velocity();
        let acceleration = self.acceleration(&velocity);
        for rates in [&velocity, &acceleration] {
            magnitude(rates).map_err(SolveError::overflow)?;
        }
        Ok(Motion {
            position: *self.position,
            velocity,
            acceleration,
            positive_determinant: Some(self.factors.determinant_sign() > T::zero()),
        })
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn input_terms(&self, fixed: &L::Fixed, drives: &L::Drives) -> SVector<T, N> {
        let at = &self.prescribed.fixed.value;
        input_terms::<_, C, N>(self.linkage, self.position, at, fixed, drives)
    }
}

/// `-dF/du udot`, or with second rates `-dF/du uddot`, of drives and chassis points.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn input_terms<L, C, const N: usize>(
    linkage: &L,
    position: &SVector<L::Scalar, N>,
    fixed: &L::Fixed,
    fixed_rate: &L::Fixed,
    drive_rate: &L::Drives,
) -> SVector<L::Scalar, N>
where
    L: Linkage<N>,
    C: ChassisMotion<L::Fixed>,
{
    let terms = linkage.drive_rate(position, fixed, fixed_rate, drive_rate);
    if C::MOVES {
        sum(&terms, &linkage.chassis_rate(position, fixed, fixed_rate))
    } else {
        terms
    }
}
