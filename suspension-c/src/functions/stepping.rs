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

        /// A step of `dt` seconds between two inputs that may be far apart, or near each other if `dt` is
        /// 0: to tolerance, in as many sub-steps as necessary, at most 200. `motion` is the one at `from`.
        /// In between the drives follow the cubics with their values and rates at both ends or, if these
        /// lead past a lock, straight lines from rest, in at most 200 further sub-steps. A refusal at a
        /// lock takes 500 to 2,000 times as long as a step of a millisecond. `report` may be NULL.
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

        /// `step_between` along the cubics only, which keeps its progress if it stops early, for example at
        /// a lock: `inputs`, those of `motion`, become `to`. If the step stops early, `inputs` and `motion`
        /// become those of the last good sub-step, `failure->reached` seconds after the start. The status is
        /// then the reason why the next sub-step was refused, however short: at a lock SUSP_ERROR_SINGULAR,
        /// SUSP_ERROR_DIVERGING or another, and shorter steps do not help. From a lock there may be no step
        /// forwards or backwards, because rates are unbounded there. `report` may be NULL.
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

        /// One step of fixed cost, of `dt` seconds, to the configuration of `inputs`. `outputs` states what
        /// it solves for: SUSP_POSITION, SUSP_VELOCITY (and position) or SUSP_ACCELERATION (all three). The
        /// other rates are estimates, which suffice for the next step. `report` may be NULL. The first step
        /// from rest has `dt` = 0.
        fn bounded_step(model: In<Model>, inputs: In<Inputs>, outputs: Outputs, dt: Number, motion: InOut<Motion>, report: Out<Report>, failure: Out<Failure>) -> Status {
            respond(failure, &NAMES, || {
                bounded::<_, 1>(model, still(inputs.get()?), outputs, dt, motion, report)
            })
        }

        /// `bounded_step` with two corrections in place of one, for longer steps, and for steps of a
        /// millisecond that do not solve for the acceleration.
        fn bounded_step_twice(model: In<Model>, inputs: In<Inputs>, outputs: Outputs, dt: Number, motion: InOut<Motion>, report: Out<Report>, failure: Out<Failure>) -> Status {
            respond(failure, &NAMES, || {
                bounded::<_, 2>(model, still(inputs.get()?), outputs, dt, motion, report)
            })
        }

        /// `bounded_step` in one fixed order of pivots, or a refusal: the call for a hard real-time loop. A
        /// refusal takes no longer than a step and does not change the motion; `bounded_step` with the same
        /// arguments returns the reason, or uses another order. Numbers that are not finite are
        /// SUSP_ERROR_OVERFLOW here, inputs as well as results. `report` may be NULL.
        fn attempt(model: In<Model>, inputs: In<Inputs>, outputs: Outputs, dt: Number, motion: InOut<Motion>, report: Out<Report>) -> Status {
            answer(|| attempted::<1>(model, inputs, outputs, dt, motion, report))
        }

        /// `attempt` with two corrections in place of one, like `bounded_step_twice`: in `double` for a
        /// wheel on a smooth road.
        fn attempt_twice(model: In<Model>, inputs: In<Inputs>, outputs: Outputs, dt: Number, motion: InOut<Motion>, report: Out<Report>) -> Status {
            answer(|| attempted::<2>(model, inputs, outputs, dt, motion, report))
        }

        /// `attempt` without the terms for the error of the prediction, which saves a quarter of the time.
        /// It refuses unless that error is within the tolerance, so that the omitted terms are rounding:
        /// for `float` at 1 ms.
        fn attempt_without_corrections(model: In<Model>, inputs: In<Inputs>, outputs: Outputs, dt: Number, motion: InOut<Motion>, report: Out<Report>) -> Status {
            answer(|| attempted::<0>(model, inputs, outputs, dt, motion, report))
        }
    } };
}
