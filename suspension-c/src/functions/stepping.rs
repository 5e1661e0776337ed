//! Functions that step a motion.

/// Functions of every listing that step a motion.
#[doc(hidden)]
#[macro_export]
macro_rules! functions_of_stepping {
    ($prefix:literal) => { $crate::functions! { $prefix, STEPPING:
        /// One step to tolerance, of `dt` seconds, to the configuration of `inputs`: position, velocity
        /// and acceleration. `report` may be NULL.
        fn step(model: In<Model>, inputs: In<Inputs>, dt: Number, motion: InOut<Motion>, report: Out<Report>, failure: Out<Failure>) -> Status {
            respond(failure, &NAMES, || tracked(model, still(inputs.get()?), dt, motion, report))
        }

        /// A step of `dt` seconds between two inputs that may lie far apart, near by where `dt` is 0: to tolerance,
        /// in as many sub-steps as it takes, 200 at most. `motion` is the one at `from`; in between the
        /// drives follow the cubics that have their values and rates at the ends or, where these lead
        /// past a lock, straight lines from rest, in 200 more. `report` may be NULL.
        fn step_between(model: In<Model>, from: In<Inputs>, to: In<Inputs>, dt: Number, motion: InOut<Motion>, report: Out<Report>, failure: Out<Failure>) -> Status {
            respond(failure, &NAMES, || {
                let (model, from, to) = (model.object()?, from.get()?, to.get()?);
                let (motion, report) = (motion.object()?, report.optional()?);
                let [from, to] = [from, to].map(|at| still(at));
                let tracker = solver::Tracker::default();
                fill(report, tracker.step_between(model, [&from, &to], dt, motion)?);
                Ok(())
            })
        }

        /// `step_between` along the cubics alone that keeps what it has got to where it stops early, as at a lock:
        /// `inputs`, those of `motion`, become `to`. If not, both are those of the last good sub-step,
        /// `failure->reached` seconds from the start; from a lock no step may lead on or back, as rates have no bound
        /// there. `report` may be NULL.
        fn advance(model: In<Model>, inputs: InOut<Inputs>, to: In<Inputs>, dt: Number, motion: InOut<Motion>, report: Out<Report>, failure: Out<Failure>) -> Status {
            respond(failure, &NAMES, || {
                let (model, inputs, to) = (model.object()?, inputs.get()?, to.get()?);
                let (motion, report) = (motion.object()?, report.optional()?);
                let (mut reached, to) = (still(inputs), still(to));
                let tracker = solver::Tracker::default();
                let advanced = tracker.advance_between(model, &mut reached, &to, dt, motion);
                *inputs = Rates::from_signal(&reached.drives, values);
                fill(report, advanced?);
                Ok(())
            })
        }

        /// One step of fixed cost, of `dt` seconds, to the configuration of `inputs`. Solved for:
        /// SUSP_POSITION, SUSP_VELOCITY (position too) or SUSP_ACCELERATION (all three). Rates that are
        /// not solved for are estimates, good for the next step. `report` may be NULL. A first step from
        /// rest is one with `dt` = 0.
        fn bounded_step(model: In<Model>, inputs: In<Inputs>, outputs: Outputs, dt: Number, motion: InOut<Motion>, report: Out<Report>, failure: Out<Failure>) -> Status {
            respond(failure, &NAMES, || {
                bounded::<_, 1>(model, still(inputs.get()?), outputs, dt, motion, report)
            })
        }

        /// The same with two corrections in place of one, for longer steps, and for steps of a millisecond
        /// that do not solve for the acceleration.
        fn bounded_step_twice(model: In<Model>, inputs: In<Inputs>, outputs: Outputs, dt: Number, motion: InOut<Motion>, report: Out<Report>, failure: Out<Failure>) -> Status {
            respond(failure, &NAMES, || {
                bounded::<_, 2>(model, still(inputs.get()?), outputs, dt, motion, report)
            })
        }

        /// `bounded_step` in one fixed order of pivots or not at all: the call for a hard real-time loop. A
        /// refusal takes no longer than a step and leaves the motion; `bounded_step` with the same
        /// arguments finds the reason, or another order. `report` may be NULL.
        fn attempt(model: In<Model>, inputs: In<Inputs>, outputs: Outputs, dt: Number, motion: InOut<Motion>, report: Out<Report>) -> Status {
            answer(|| attempted::<1>(model, inputs, outputs, dt, motion, report))
        }

        /// `attempt` with two corrections in place of one, as `bounded_step_twice` has them: in `double` for a wheel on a road.
        fn attempt_twice(model: In<Model>, inputs: In<Inputs>, outputs: Outputs, dt: Number, motion: InOut<Motion>, report: Out<Report>) -> Status {
            answer(|| attempted::<2>(model, inputs, outputs, dt, motion, report))
        }

        /// `attempt` without the terms of the prediction's error, for a quarter less. Accepted only where
        /// that error is within the tolerance, so that what is left out is rounding: `float` at 1 ms.
        fn attempt_without_corrections(model: In<Model>, inputs: In<Inputs>, outputs: Outputs, dt: Number, motion: InOut<Motion>, report: Out<Report>) -> Status {
            answer(|| attempted::<0>(model, inputs, outputs, dt, motion, report))
        }
    } };
}
