//! One step of a led motion: Newton's method on the equations and the quantity together.

use crate::arithmetic::magnitude::{index_of_largest, magnitude};
use crate::arithmetic::pivot::least_pivot;
use crate::arithmetic::scalar::Real;
use crate::error::SolveError;
use crate::linkage::Linkage;
use crate::listing::Part;
use crate::model::handedness;
use crate::path::configuration::Configuration;
use crate::path::correct::finite;
use crate::path::curve::Curve;
use crate::path::leader::Leader;
use crate::path::led::Led;
use crate::path::linear::Linear;
use crate::signal::{ChassisMotion, Signal};
use crate::solve::motion::input_terms;
use crate::solve::newton::{bounded_size, rounding_at};
use crate::solve::report::Report;

/// The smallest fraction of the tangent's largest entry that the entry of the local parameter may be.
const POOR: f64 = 0.25;

/// One step of a led motion: how it is made, along which curve, and to which target.
pub(super) struct LedStep<'a, T, L: Linkage<N>, Q, const N: usize> {
    pub(super) leader: &'a Leader<T>,
    pub(super) curve: Curve<'a, L, N>,
    pub(super) quantity: Q,
    pub(super) target: &'a Signal<T>,
}

/// A position that solves the equations and where the quantity meets its target.
struct Met<T, const N: usize> {
    position: Configuration<T, N>,
    /// See [`LedStep::steepest`].
    steepest: T,
    report: Report<T>,
}

impl<T, L, Q, const N: usize> LedStep<'_, T, L, Q, N>
where
    T: Real,
    L: Linkage<N, Scalar = T>,
    Q: Fn(&Signal<L::Points>) -> Signal<T>,
{
    /// Makes the step from the last motion, in the time `dt`.
    pub(super) fn make<C: ChassisMotion<L::Fixed>>(
        &self,
        dt: T,
        led: &Led<T, N>,
    ) -> Result<(Led<T, N>, Report<T>), SolveError<T>> {
        let before = match led.increases {
            Some(increases) => Some(increases),
            None => self.increases(led)?,
        };
        let Met {
            position,
            steepest,
            report,
        } = self.position(dt, led)?;
        handedness::check(
            self.curve.linkage,
            &position.unknowns,
            &self.curve.fixed(&position),
        )?;
        let linear = self.curve.linear(&position, led.parameter)?;
        let largest = linear.tangent.largest_entry();
        let is_poor = linear.tangent.entry(largest).abs() * T::constant(POOR) > T::one();
        let linear = if is_poor {
            self.curve.linear(&position, largest)?
        } else {
            linear
        };
        let slope = self.slope(&position, &linear.tangent)?;
        let part = Part::Unknown(index_of_largest(&linear.tangent.unknowns));
        if !is_steep(slope, steepest, &linear) {
            return Err(SolveError::TurningPoint {
                part,
                asked: self.target.value,
                extreme: self.value(&position)?,
            });
        }
        let increases = Some((slope > T::zero()) == linear.is_positive(&linear.tangent));
        if before.is_some() && before != increases {
            return Err(SolveError::CrossedSingularity { part });
        }
        let next = Led {
            configuration: self.rates::<C>(&position, &linear, slope)?,
            drive: led.drive,
            parameter: linear.parameter,
            increases,
        };
        Ok((next, report))
    }

    /// [`Led::increases`] for a motion that has made no step; unknown if the quantity turns there.
    fn increases(&self, led: &Led<T, N>) -> Result<Option<bool>, SolveError<T>> {
        let at = &led.configuration.value;
        let linear = self.curve.linear(at, led.parameter)?;
        let slope = self.slope(at, &linear.tangent)?;
        let is_steep = is_steep(slope, self.steepest(at)?, &linear);
        let increases = (slope > T::zero()) == linear.is_positive(&linear.tangent);
        Ok(is_steep.then_some(increases))
    }

    /// Newton's method on the equations and the quantity together.
    fn position(&self, dt: T, led: &Led<T, N>) -> Result<Met<T, N>, SolveError<T>> {
        let newton = &self.leader.newton;
        let Signal {
            value,
            rate,
            second_rate,
        } = led.configuration;
        let moves = (rate + second_rate * (dt * T::constant(0.5))) * dt;
        let mut at = value + moves;
        let mut bound = Some(self.first_bound(&moves)?);
        let mut error = T::zero();
        for iterations in 1..=newton.max_iterations {
            let linear = self.curve.linear(&at, led.parameter)?;
            let step = self.correction(&at, &linear)?;
            let rounding = rounding_at(self.curve.linkage, &at.unknowns);
            let correction = bounded_size(&step.unknowns, bound, rounding)?;
            if iterations == 1 {
                error = correction;
            }
            at = at + step;
            // One more correction with the same factors removes the error of second order that the first has left.
            at = at + self.correction(&at, &linear)?;
            let residual = finite(&self.curve.residual(&at))?;
            let tolerance = newton.tolerance_at(self.curve.linkage, &at.unknowns);
            if residual <= tolerance
                && let Some(steepest) = self.steepest_on_target(&at, &linear, tolerance)?
            {
                let report = Report {
                    tolerance,
                    residual_squared: residual * residual,
                    error_squared: error * error,
                    growth_squared: linear.growth_squared(),
                    steps: 1,
                    iterations,
                };
                return Ok(Met {
                    position: at,
                    steepest,
                    report,
                });
            }
            bound = newton.contraction.map(|part| part * correction);
        }
        let residual = self.curve.residual(&at);
        Err(SolveError::NotConverged {
            part: Part::Equation(index_of_largest(&residual)),
            residual: finite(&residual)?,
            tolerance: newton.tolerance_at(self.curve.linkage, &at.unknowns),
            iterations: newton.max_iterations,
        })
    }

    /// The largest permitted first correction of a position that was predicted by the move `moves`.
    fn first_bound(&self, moves: &Configuration<T, N>) -> Result<T, SolveError<T>> {
        let moved = magnitude(&moves.unknowns).map_err(SolveError::overflow)?;
        let size = self.curve.linkage.size();
        let Leader {
            correction_of_move,
            correction_of_size,
            ..
        } = *self.leader;
        Ok((correction_of_move * moved).max(correction_of_size * size))
    }

    /// A Newton step.
    fn correction(
        &self,
        at: &Configuration<T, N>,
        linear: &Linear<L, N>,
    ) -> Result<Configuration<T, N>, SolveError<T>> {
        let error = linear.solve(&self.curve.residual(at));
        let slope = self.slope(at, &linear.tangent)?;
        let excess = self.value(at)? - self.slope(at, &error)? - self.target.value;
        Ok(linear.tangent * (-excess / slope) - error)
    }

    /// Velocity and acceleration at a position.
    fn rates<C: ChassisMotion<L::Fixed>>(
        &self,
        position: &Configuration<T, N>,
        linear: &Linear<L, N>,
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
        let held = linear.solve(&terms(&chassis.rate, &drives.rate));
        let missing = self.target.rate - measured(held, Configuration::zero()).rate;
        let rate = held + linear.tangent * (missing / slope);
        let moving = curve.driven(chassis.rate, rate.drive);
        let curvature = curve
            .linkage
            .curvature(&rate.unknowns, &moving, &rate.unknowns, &moving);
        let right = terms(&chassis.second_rate, &drives.second_rate) - curvature;
        let held = linear.solve(&right);
        let missing = self.target.second_rate - measured(rate, held).second_rate;
        let second_rate = held + linear.tangent * (missing / slope);
        for rates in [&rate, &second_rate] {
            magnitude(&rates.unknowns).map_err(SolveError::overflow)?;
        }
        Ok(Signal {
            value: *position,
            rate,
            second_rate,
        })
    }
}

/// Whether a quantity that changes by `slope` along the tangent, and by `steepest` at most, is not about to turn.
fn is_steep<T: Real, L: Linkage<N, Scalar = T>, const N: usize>(
    slope: T,
    steepest: T,
    linear: &Linear<L, N>,
) -> bool {
    slope.abs() > least_pivot::<T>() * steepest * linear.tangent.norm()
}
