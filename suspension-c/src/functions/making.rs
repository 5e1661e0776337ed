//! Functions that make models and motions.

/// Functions of every listing that make models and motions.
#[doc(hidden)]
#[macro_export]
macro_rules! functions_of_making {
    ($prefix:literal) => { $crate::functions! { $prefix, MAKING:
        /// Makes a model with the lengths between the points. `size` is `sizeof *model`.
        /// With SUSP_ERROR_SMALL_PIVOT the model is made nevertheless: steps to tolerance then use partial
        /// pivoting, and attempts are refused.
        fn model_new(model: Out<Model>, size: usize, design: In<Points>, failure: Out<Failure>) -> Status {
            respond(failure, &NAMES, || {
                let (model, design) = (model.place(size)?, design.get()?);
                let points = points_of(design);
                let built = Linkage::of(listing::Listing, &points)?;
                model.put(built);
                Ok(built.check_pivots(&points)?)
            })
        }

        /// Changes the lengths of a model; each body keeps its handedness.
        fn model_set_lengths(model: InOut<Model>, lengths: In<Lengths>, failure: Out<Failure>) -> Status {
            respond(failure, &NAMES, || {
                let (model, lengths) = (model.object()?, lengths.get()?);
                *model = model.with_lengths(&named(lengths))?;
                Ok(())
            })
        }

        /// Attaches a model's markers to their bodies at the given points.
        fn model_set_markers(model: InOut<Model>, points: In<Points>, failure: Out<Failure>) -> Status {
            respond(failure, &NAMES, || {
                let (model, points) = (model.object()?, points.get()?);
                *model = model.with_markers(&points_of(points))?;
                Ok(())
            })
        }

        /// The lengths of a model.
        fn model_lengths(model: In<Model>, lengths: Out<Lengths>) -> Status {
            answer(|| {
                let (model, lengths) = (model.object()?, lengths.get()?);
                lengths.write(values(&model.lengths()));
                Ok(())
            })
        }

        /// The values of the drives in a configuration.
        fn model_drives(model: In<Model>, points: In<Points>, drives: Out<Drives>) -> Status {
            answer(|| {
                let (model, points, drives) = (model.object()?, points.get()?, drives.get()?);
                drives.write(values(&model.drives_at(&points_of(points))));
                Ok(())
            })
        }

        /// Makes a motion at rest with the free points at `points`. `size` is `sizeof *motion`. Where the points
        /// do not satisfy the listing, for example where one is a tenth of a millimetre off the line of its
        /// `slide`, bounded steps are refused with SUSP_ERROR_NOT_CONVERGED: use `assemble` there.
        fn motion_at_rest(model: In<Model>, motion: Out<Motion>, size: usize, points: In<Points>) -> Status {
            answer(|| {
                let (model, motion) = (model.object()?, motion.place(size)?);
                let points = points_of(points.get()?);
                motion.put(solver::Motion::at_rest(model.unknowns(&points)));
                Ok(())
            })
        }

        /// Makes a motion at rest in the configuration nearest to the guess, of which only the free points
        /// matter. A step with `dt` = 0 then computes its rates. `size` is `sizeof *motion`; `assembly` may
        /// be NULL. This call is for initialisation: it takes hundreds of times as long as a step.
        fn assemble(model: In<Model>, inputs: In<Inputs>, guess: In<Points>, motion: Out<Motion>, size: usize, assembly: Out<Assembly>, failure: Out<Failure>) -> Status {
            respond(failure, &NAMES, || {
                let (model, inputs, guess) = (model.object()?, inputs.get()?, guess.get()?);
                let (motion, assembly) = (motion.place(size)?, assembly.optional()?);
                let mut unknowns = model.unknowns(&points_of(guess));
                let inputs = still(inputs);
                let newton = solver::Newton::from_afar();
                let found = solver::assemble(&newton, model, &inputs, &mut unknowns)?;
                motion.put(solver::Motion::at_rest(unknowns));
                fill(assembly, found);
                Ok(())
            })
        }
    } };
}
