//! Change of drive: a motion led by any quantity of the points, in place of one of the drives.
//!
//! With `x = (q, h)`, the entry of the local parameter held in `e` and `z`, and `y` the tangent whose
//! entry there is 1, a Newton step on `F(x) = 0`, `g(x) = target` is
//!
//! ```text
//! M e = F,   dx = -e + y (target - g + g' e) / (g' y),
//! ```
//!
//! and velocity and acceleration follow from the rates of the target in the same way: `g` is affine
//! in the velocities, and its second rate in the accelerations.

use nalgebra::SVector;

use crate::error::SolveError;
use crate::factored::smallest_pivot;
use crate::linkage::Linkage;
use crate::magnitude::{index_of_largest, magnitude};
use crate::motion::{Motion, input_terms};
use crate::newton::{Converged, Newton, within};
use crate::path::configuration::Configuration;
use crate::path::curve::{Curve, finite};
use crate::path::linear::Linear;
use crate::scalar::Real;
use crate::signal::{ChassisMotion, Inputs, Signal};
use crate::substeps::in_steps;
use crate::tracker::{Advanced, CORRECTION_OF_MOVE, CORRECTION_OF_SIZE, Stopped};

/// The smallest part of the tangent's largest entry that the local parameter may have.
const POOR: f64 = 0.25;

/// A motion that another quantity leads in place of one drive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Led<T, const N: usize> {
    /// The unknowns and the coordinate of the drive that is set free, with their rates.
    pub configuration: Signal<Configuration<T, N>>,
    /// The index of the drive that is set free.
    drive: usize,
    /// The local parameter: the entry of the configuration that is held in corrections. `N` is
    /// the drive. The tracker changes it where it becomes poor.
    pub parameter: usize,
    /// Whether the quantity increases along the curve in the direction in which
    /// `det [J, dF/dh; t^T]` is positive, where known: it changes only where the quantity turns
    /// or another curve crosses.
    pub increases: Option<bool>,
}

impl<T: Real, const N: usize> Led<T, N> {
    /// At rest on a curve, with the unknowns `q`: the drive that the curve sets free is free.
    ///
    /// # Errors
    ///
    /// [`SolveError::Singular`] at a bifurcation.
    pub fn at_rest<L>(curve: &Curve<'_, L, N>, q: &SVector<T, N>) -> Result<Self, SolveError<T>>
    where
        L: Linkage<N, Scalar = T>,
    {
        let value = curve.configuration(q);
        Ok(Self {
            configuration: Signal {
                value,
                rate: Configuration::zero(),
                second_rate: Configuration::zero(),
            },
            drive: curve.drive,
            parameter: curve.steepest(&value)?,
            increases: None,
        })
    }

    /// The free drive's value with its rates: an angle in radians, or the coordinate itself.
    pub fn drive<L, C>(&self, linkage: &L, inputs: &Inputs<C, L::Drives>) -> Signal<T>
    where
        L: Linkage<N, Scalar = T>,
        C: ChassisMotion<L::Fixed>,
    {
        let Signal {
            value,
            rate,
            second_rate,
        } = self.configuration;
        Curve::of(linkage, inputs, self.drive).value(&Signal {
            value: value.drive,
            rate: rate.drive,
            second_rate: second_rate.drive,
        })
    }

    /// All points with their rates; `inputs` are those of the last step.
    pub fn points<L, C>(&self, linkage: &L, inputs: &Inputs<C, L::Drives>) -> Signal<L::Points>
    where
        L: Linkage<N, Scalar = T>,
        C: ChassisMotion<L::Fixed>,
    {
        let curve = Curve::of(linkage, inputs, self.drive);
        curve.points_with(&self.configuration, &curve.prescribed.fixed)
    }

    /// The unknowns' motion, for a [`Tracker`](crate::Tracker) to go on with.
    pub fn motion(&self) -> Motion<T, N> {
        let Signal {
            value,
            rate,
            second_rate,
        } = self.configuration;
        Motion {
            position: value.unknowns,
            velocity: rate.unknowns,
            acceleration: second_rate.unknowns,
            positive_determinant: None,
        }
    }
}

/// How to follow a motion that a quantity leads.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Leader<T> {
    /// How each step is solved.
    pub newton: Newton<T>,
    /// Steps that one advance may try, the refused ones included.
    pub max_steps: usize,
    /// See [`Tracker::correction_of_move`](crate::Tracker::correction_of_move).
    pub correction_of_move: T,
    /// See [`Tracker::correction_of_size`](crate::Tracker::correction_of_size).
    pub correction_of_size: T,
}

/// What a step did.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LedStep<T> {
    /// How the position was found.
    pub converged: Converged<T>,
    /// How far the quantity is from its target, in its own unit.
    pub off_target: T,
    /// The new local parameter, an unknown or `N` for the drive, where the old one had become
    /// poor.
    pub switched: Option<usize>,
}

impl<T: Real> Default for Leader<T> {
    fn default() -> Self {
        Self {
            newton: Newton::near_by(),
            max_steps: 200,
            correction_of_move: T::constant(CORRECTION_OF_MOVE),
            correction_of_size: T::constant(CORRECTION_OF_SIZE),
        }
    }
}

impl<T: Real> Leader<T> {
    /// One step of length `dt` to where `quantity` meets `target`, predicted from the last motion.
    /// Of `inputs` the free drive's signal is ignored.
    ///
    /// `quantity` gives a quantity of the points with its first and second rate from theirs. Like
    /// any such rates they must be linear in the velocities, and in the accelerations but for
    /// terms of the velocities.
    ///
    /// # Errors
    ///
    /// [`SolveError::TurningPoint`] where the quantity turns before it meets the target,
    /// [`SolveError::CrossedSingularity`] where another singularity lies between, else as
    /// [`Tracker::step`](crate::Tracker::step). The motion is then unchanged.
    pub fn step<L, C, const N: usize>(
        &self,
        linkage: &L,
        inputs: &Inputs<C, L::Drives>,
        quantity: impl Fn(&Signal<L::Points>) -> Signal<T>,
        target: &Signal<T>,
        dt: T,
        led: &mut Led<T, N>,
    ) -> Result<LedStep<T>, SolveError<T>>
    where
        L: Linkage<N, Scalar = T>,
        C: ChassisMotion<L::Fixed>,
    {
        let course = Course {
            leader: self,
            curve: Curve::of(linkage, inputs, led.drive),
            quantity,
            target,
        };
        match course.step::<C>(dt, led) {
            Ok((next, step)) => {
                *led = next;
                Ok(step)
            }
            Err(error) => Err(course.turning_before(led).unwrap_or(error)),
        }
    }

    /// Follows the motion from time `from` to time `to`, either way, in as few steps as the bounds
    /// on corrections allow: a refused step is halved, a good one doubled.
    ///
    /// # Errors
    ///
    /// [`Stopped`] where steps have shrunk to rounding or `max_steps` are used up; the motion is
    /// then the last good one.
    pub fn advance<L, C, const N: usize>(
        &self,
        linkage: &L,
        inputs: impl Fn(T) -> Inputs<C, L::Drives>,
        quantity: impl Fn(&Signal<L::Points>) -> Signal<T>,
        target: impl Fn(T) -> Signal<T>,
        [from, to]: [T; 2],
        led: &mut Led<T, N>,
    ) -> Result<Advanced<T>, Stopped<T>>
    where
        L: Linkage<N, Scalar = T>,
        C: ChassisMotion<L::Fixed>,
    {
        in_steps([from, to], self.max_steps, |next, dt| {
            let step = self.step(linkage, &inputs(next), &quantity, &target(next), dt, led);
            step.map(|step| step.converged)
        })
    }
}

/// What one step is made of.
struct Course<'a, T, L: Linkage<N>, Q, const N: usize> {
    leader: &'a Leader<T>,
    curve: Curve<'a, L, N>,
    quantity: Q,
    target: &'a Signal<T>,
}

impl<T, L, Q, const N: usize> Course<'_, T, L, Q, N>
where
    T: Real,
    L: Linkage<N, Scalar = T>,
    Q: Fn(&Signal<L::Points>) -> Signal<T>,
{
    fn step<C: ChassisMotion<L::Fixed>>(
        &self,
        dt: T,
        led: &Led<T, N>,
    ) -> Result<(Led<T, N>, LedStep<T>), SolveError<T>> {
        let (position, converged, off_target) = self.position(dt, led)?;
        let linear = self.curve.linear(&position, led.parameter)?;
        let largest = linear.tangent.largest_entry();
        let is_poor = linear.tangent.entry(largest).abs() * T::constant(POOR) > T::one();
        let switched = is_poor.then_some(largest);
        let linear = match switched {
            Some(parameter) => self.curve.linear(&position, parameter)?,
            None => linear,
        };
        let slope = self.slope(&position, &linear.tangent);
        let unknown = index_of_largest(&linear.tangent.unknowns);
        if !(slope.abs() > smallest_pivot::<T>() * linear.tangent.norm()) {
            return Err(SolveError::TurningPoint {
                unknown,
                asked: self.target.value,
                extreme: self.value(&position),
            });
        }
        let increases = Some((slope > T::zero()) == linear.is_positive(&linear.tangent));
        if led.increases.is_some() && led.increases != increases {
            return Err(SolveError::CrossedSingularity { unknown });
        }
        let next = Led {
            configuration: self.rates::<C>(&position, &linear, slope)?,
            drive: led.drive,
            parameter: linear.parameter,
            increases,
        };
        let step = LedStep {
            converged,
            off_target,
            switched,
        };
        Ok((next, step))
    }

    /// Newton's method on the equations and the quantity together.
    fn position(
        &self,
        dt: T,
        led: &Led<T, N>,
    ) -> Result<(Configuration<T, N>, Converged<T>, T), SolveError<T>> {
        let Leader {
            newton,
            correction_of_move,
            correction_of_size,
            ..
        } = self.leader;
        let Signal {
            value,
            rate,
            second_rate,
        } = led.configuration;
        let moves = (rate + second_rate * (dt * T::constant(0.5))) * dt;
        let mut at = value + moves;
        let size = self.curve.linkage.size();
        let moved = magnitude(&moves.unknowns).map_err(|unknown| SolveError::Overflow { unknown })?;
        let mut bound = Some((*correction_of_move * moved).max(*correction_of_size * size));
        for iterations in 1..=newton.max_iterations {
            let linear = self.curve.linear(&at, led.parameter)?;
            let (step, slope) = self.correction(&at, &linear);
            let rounding = newton.rounding_at(self.curve.linkage, &at.unknowns);
            let correction = within(&step.unknowns, bound, rounding)?;
            at = at + step;
            // Once more with the same factors, for what the square of the first has left.
            let (second, _) = self.correction(&at, &linear);
            at = at + second;
            let residual = finite(&self.curve.residual(&at))?;
            let rounding = newton.rounding_at(self.curve.linkage, &at.unknowns);
            let tolerance = newton.tolerance * rounding;
            let off_target = (self.value(&at) - self.target.value).abs();
            // What rounding of the positions and of the quantity itself leaves of it.
            let steepness = (slope.abs() / linear.tangent.norm())
                .max(T::one())
                .max(T::one() / size);
            let near = tolerance * steepness
                + newton.tolerance * T::EPSILON * self.target.value.abs();
            if residual <= tolerance && off_target <= near {
                let converged = Converged {
                    iterations,
                    residual,
                    tolerance,
                    growth: linear.growth(),
                };
                return Ok((at, converged, off_target));
            }
            bound = newton.contraction.map(|part| part * correction);
        }
        let residual = self.curve.residual(&at);
        Err(SolveError::NotConverged {
            equation: index_of_largest(&residual),
            residual: finite(&residual)?,
            tolerance: newton.tolerance * newton.rounding_at(self.curve.linkage, &at.unknowns),
            iterations: newton.max_iterations,
        })
    }

    /// A Newton step, and the quantity's slope along the tangent.
    fn correction(
        &self,
        at: &Configuration<T, N>,
        linear: &Linear<T, N>,
    ) -> (Configuration<T, N>, T) {
        let error = linear.along(&linear.lu.solve(&self.curve.residual(at)));
        let slope = self.slope(at, &linear.tangent);
        let excess = self.value(at) - self.slope(at, &error) - self.target.value;
        let step = linear.tangent * (-excess / slope) - error;
        (step, slope)
    }

    /// Velocity and acceleration at a position.
    fn rates<C: ChassisMotion<L::Fixed>>(
        &self,
        position: &Configuration<T, N>,
        linear: &Linear<T, N>,
        slope: T,
    ) -> Result<Signal<Configuration<T, N>>, SolveError<T>> {
        let curve = &self.curve;
        let chassis = &curve.prescribed.fixed;
        let drives = &curve.prescribed.drives;
        let fixed = curve.fixed(position);
        let terms = |chassis: &L::Fixed, drives: &L::Drives| {
            let q = &position.unknowns;
            input_terms::<_, C, N>(curve.linkage, q, &fixed, chassis, drives)
        };
        let measured = |rate, second_rate| {
            let along = Signal {
                value: *position,
                rate,
                second_rate,
            };
            (self.quantity)(&curve.points_with(&along, chassis))
        };
        let held = linear.along(&linear.lu.solve(&terms(&chassis.rate, &drives.rate)));
        let missing = self.target.rate - measured(held, Configuration::zero()).rate;
        let rate = held + linear.tangent * (missing / slope);
        let moving = curve.driven(chassis.rate, rate.drive);
        let curvature = curve
            .linkage
            .curvature(&rate.unknowns, &moving, &rate.unknowns, &moving);
        let right = terms(&chassis.second_rate, &drives.second_rate) - curvature;
        let held = linear.along(&linear.lu.solve(&right));
        let missing = self.target.second_rate - measured(rate, held).second_rate;
        let second_rate = held + linear.tangent * (missing / slope);
        for rates in [&rate, &second_rate] {
            magnitude(&rates.unknowns).map_err(|unknown| SolveError::Overflow { unknown })?;
        }
        Ok(Signal {
            value: *position,
            rate,
            second_rate,
        })
    }

    fn value(&self, at: &Configuration<T, N>) -> T {
        let none = Configuration::zero();
        self.measured(at, none, none).value
    }

    /// The rate of the quantity where the configuration changes at a rate.
    fn slope(&self, at: &Configuration<T, N>, rate: &Configuration<T, N>) -> T {
        self.measured(at, *rate, Configuration::zero()).rate
    }

    fn measured(
        &self,
        at: &Configuration<T, N>,
        rate: Configuration<T, N>,
        second_rate: Configuration<T, N>,
    ) -> Signal<T> {
        (self.quantity)(&self.curve.moving_points(&Signal {
            value: *at,
            rate,
            second_rate,
        }))
    }

    /// The turning point of the quantity, where it lies near the last motion and before the
    /// target.
    fn turning_before(&self, led: &Led<T, N>) -> Option<SolveError<T>> {
        let from = led.configuration.value;
        let forwards = Configuration::zero().with_entry(led.parameter, T::one());
        let (place, extreme) =
            self.curve
                .extreme(&self.leader.newton, &from, &forwards, |along| {
                    (self.quantity)(&self.curve.moving_points(along))
                })?;
        let asked = self.target.value;
        let here = self.value(&from);
        // So near to the extreme the slope is lost in rounding.
        let near = T::EPSILON * T::constant(1024.0) * self.curve.linkage.size();
        let short = if here < extreme { extreme - asked } else { asked - extreme };
        let is_beyond = short <= near;
        let unknown = index_of_largest(&place.rate.unknowns);
        is_beyond.then_some(SolveError::TurningPoint {
            unknown,
            asked,
            extreme,
        })
    }
}
