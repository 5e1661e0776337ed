//! The ways from one instant to the next: each makes its step, or refuses it for a cause that it
//! names and leaves the motion.

use suspension_core::linkage::Build;
use suspension_core::signal::ChassisMotion;
use suspension_core::step::bounded::Outputs;
use suspension_core::step::series::{InputSeries, SeriesTracker};
use suspension_core::{Bounded, Inputs, Motion, Real, SolveError, Still, Tracker};

use super::draw::Draw;
use super::trial::Trial;
use super::verdict::{demand_cause, demand_root, demand_untouched, rounding};

impl<T, L, const N: usize> Trial<L, N>
where
    T: Real,
    L: Build<N, Scalar = T, Listing: Default>,
{
    pub(super) fn tracked<C: ChassisMotion<L::Fixed>>(
        &mut self,
        inputs: &Inputs<C, L::Drives>,
        dt: T,
        motion: &mut Motion<T, N>,
    ) -> bool {
        let before = *motion;
        let step = Tracker::default().step(&self.model, inputs, dt, motion);
        self.reached.count(&step);
        match &step {
            Ok(_) => self.demand_root(inputs, motion),
            Err(error) => self.demand_refused_step(error, &before, motion),
        }
        step.is_ok()
    }

    pub(super) fn bounded<C: ChassisMotion<L::Fixed>>(
        &mut self,
        inputs: &Inputs<C, L::Drives>,
        dt: T,
        motion: &mut Motion<T, N>,
        draw: &mut Draw<'_>,
    ) {
        let before = *motion;
        let outputs = [Outputs::Position, Outputs::Velocity, Outputs::Acceleration][draw.below(3)];
        let (step, tolerance) = if draw.below(2) == 0 {
            let bounded = Bounded::<T>::default();
            let step = bounded.step_to(outputs, &self.model, inputs, dt, motion);
            (step, bounded.tolerance)
        } else {
            let bounded = Bounded::<T, 3, 1>::new();
            let step = bounded.step_to(outputs, &self.model, inputs, dt, motion);
            (step, bounded.tolerance)
        };
        self.reached.count(&step);
        match step {
            Ok(settled) => {
                assert!(settled.residual() <= settled.tolerance());
                // The residual that it is judged by is what the corrections left. Rounding of the
                // position adds to that what the derivatives make of it.
                let left = tolerance.length(T::EPSILON * self.model.size());
                let chassis = inputs.chassis.signal(self.model.fixed()).value;
                let steepest = self.model.jacobian(&motion.position, &chassis).amax();
                let rounding = rounding(&self.model, &motion.position) * T::constant(16.0);
                let allowed = left + rounding * steepest.max(T::one());
                demand_root(&self.model, inputs, motion, allowed);
            }
            Err(error) => self.demand_refused_step(&error, &before, motion),
        }
    }

    pub(super) fn by_series(
        &mut self,
        inputs: &InputSeries<Still, L::Drives, 4>,
        dt: T,
        motion: &mut Motion<T, N>,
    ) {
        let before = *motion;
        let within = T::EPSILON.sqrt() * self.model.size();
        let tracker = SeriesTracker::within(within);
        let step = tracker.step(&self.model, inputs, dt, motion);
        self.reached.count(&step);
        match step {
            Ok(_) => {
                let inputs = inputs.at::<T, L::Fixed>(dt);
                demand_root(&self.model, &inputs, motion, within);
            }
            Err(error) => self.demand_refused_step(&error, &before, motion),
        }
    }

    pub(super) fn advanced(
        &mut self,
        inputs: &InputSeries<Still, L::Drives, 4>,
        to: T,
        motion: &mut Motion<T, N>,
    ) {
        let inputs = |t: T| inputs.at::<T, L::Fixed>(t);
        let before = *motion;
        let tracker = Tracker {
            max_steps: 20,
            ..Tracker::default()
        };
        let step = tracker.advance(&self.model, inputs, T::zero(), to, motion);
        self.reached.count(&step);
        match step {
            Ok(_) => self.demand_root(&inputs(to), motion),
            Err(stopped) if stopped.reached == T::zero() => demand_untouched(&before, motion),
            Err(stopped) => self.demand_root(&inputs(stopped.reached), motion),
        }
    }

    fn demand_refused_step(
        &self,
        error: &SolveError<T>,
        before: &Motion<T, N>,
        after: &Motion<T, N>,
    ) {
        demand_cause(&self.model, error);
        demand_untouched(before, after);
    }
}
