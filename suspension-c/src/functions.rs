//! The functions of a listing, each a thin call of the core.

/// The functions of every listing.
#[doc(hidden)]
#[macro_export]
macro_rules! functions_of_a_linkage {
    ($prefix:literal) => { $crate::functions! { $prefix:
        /// Makes a model whose lengths are those of the points as they stand. `size` is
        /// `sizeof *model`. With SUSP_ERROR_SMALL_PIVOT the model is made all the same: steps to
        /// tolerance go on with partial pivoting, attempts are refused.
        fn model_new(model: Out<Model>, size: usize, design: In<Points>, failure: Out<Failure>) -> Status {
            respond(failure, &NAMES, || {
                let (model, design) = (model.place(size)?, design.get()?);
                let points = points_of(design);
                let built = Linkage::of(listing::Listing, &points)?;
                model.put(built);
                Ok(built.check_pivots(&points)?)
            })
        }

        /// Gives a model other lengths; each body keeps its handedness.
        fn model_set_lengths(model: InOut<Model>, lengths: In<Lengths>, failure: Out<Failure>) -> Status {
            respond(failure, &NAMES, || {
                let (model, lengths) = (model.object()?, lengths.get()?);
                *model = model.with_lengths(&named(lengths))?;
                Ok(())
            })
        }

        /// Attaches a model's markers as they stand among the points.
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

        /// The values that the drives have in a configuration.
        fn model_drives(model: In<Model>, points: In<Points>, drives: Out<Drives>) -> Status {
            answer(|| {
                let (model, points, drives) = (model.object()?, points.get()?, drives.get()?);
                drives.write(values(&model.drives_at(&points_of(points))));
                Ok(())
            })
        }

        /// Makes a motion: at rest, the free points where they stand among `points`. `size` is
        /// `sizeof *motion`.
        fn motion_at_rest(model: In<Model>, motion: Out<Motion>, size: usize, points: In<Points>) -> Status {
            answer(|| {
                let (model, motion) = (model.object()?, motion.place(size)?);
                let points = points_of(points.get()?);
                motion.put(solver::Motion::at_rest(model.unknowns(&points)));
                Ok(())
            })
        }

        /// Makes a motion: at rest, in the configuration nearest to the guess, of which the free points
        /// matter. A step with `dt` = 0 finds its rates. `size` is `sizeof *motion`; `assembly` may be
        /// NULL. For setting up: it takes hundreds of times as long as a step.
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

        /// One step to tolerance, of `dt` seconds, to the configuration of `inputs`: position, velocity
        /// and acceleration. `report` may be NULL.
        fn step(model: In<Model>, inputs: In<Inputs>, dt: Number, motion: InOut<Motion>, report: Out<Report>, failure: Out<Failure>) -> Status {
            respond(failure, &NAMES, || tracked(model, still(inputs.get()?), dt, motion, report))
        }

        /// A step of `dt` seconds, not zero, between two inputs that may lie far apart: to tolerance, in
        /// as many sub-steps as it takes, 200 at most. `motion` is the one at `from`; in between the
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

        /// `attempt` without the terms of the prediction's error, for a quarter less. Accepted only where
        /// that error is within the tolerance, so that what is left out is rounding: `float` at 1 ms.
        fn attempt_without_corrections(model: In<Model>, inputs: In<Inputs>, outputs: Outputs, dt: Number, motion: InOut<Motion>, report: Out<Report>) -> Status {
            answer(|| attempted::<0>(model, inputs, outputs, dt, motion, report))
        }

        /// Positions, velocities and accelerations of all points of a motion, which must be the one that
        /// a step with these inputs left.
        fn read_points(model: In<Model>, inputs: In<Inputs>, motion: In<Motion>, points: Out<PointRates>) -> Status {
            answer(|| located(model, still(inputs.get()?), motion, points))
        }

        /// What the listing measures, with rates. A rate is NaN where a measured length is zero, or a
        /// measured angle 0 or pi.
        fn read_measures(model: In<Model>, points: In<PointRates>, measures: Out<MeasureRates>) -> Status {
            answer(|| {
                let (model, points) = (model.object()?, points.get()?);
                let measures = measures.get()?;
                let found = model.measures(&signal(points, points_of));
                measures.write(Rates::from_signal(&found, values));
                Ok(())
            })
        }

        /// Motion ratios: all points of a motion with their first and second derivative where the drives change
        /// as `change` says, say one of them by 1 and the rest by 0, at rest too. The members `rate` are per unit
        /// of that change, `second_rate` per unit squared; `read_measures` takes them on to the measures.
        /// The rates of `inputs` do not matter. SUSP_ERROR_SINGULAR where the drives lock.
        fn read_derivatives(model: In<Model>, inputs: In<Inputs>, motion: In<Motion>, change: In<Drives>, points: Out<PointRates>, failure: Out<Failure>) -> Status {
            respond(failure, &NAMES, || {
                let (model, motion, points) = (model.object()?, motion.object()?, points.get()?);
                let (inputs, change) = (inputs.get()?, change.get()?);
                let found = solver::directions::Directions::at(model, named(&inputs.value), &motion.position, |directions| {
                    directions.points(named(change))
                })?;
                points.write(Rates::from_signal(&found, values_of_points));
                Ok(())
            })
        }

        /// What forces at the free points do, N in the axes of the points, the mechanism at rest at the position of a
        /// motion; what acts at markers loads nothing, at chassis points the drive that moves them. `drives` gets their work per unit of each
        /// drive, which what moves the drive bears; `equations` the multiplier of each equation: of a
        /// link the force in it, positive in tension; where a drive prescribes the link's own angle from an axis, without
        /// that drive's part along the link. The rates of `inputs` do not matter. Takes about half a step.
        /// SUSP_ERROR_SINGULAR where the drives lock.
        fn read_loads(model: In<Model>, inputs: In<Inputs>, motion: In<Motion>, forces: In<Points>, drives: Out<Drives>, equations: Out<Equations>, failure: Out<Failure>) -> Status {
            respond(failure, &NAMES, || {
                let (model, inputs, motion) = (model.object()?, inputs.get()?, motion.object()?);
                let (drives, equations) = (drives.get()?, equations.get()?);
                let forces = points_of(forces.get()?);
                let loads = solver::statics::Loads::new(model, named(&inputs.value), &motion.position, &forces)?;
                drives.write(values(&loads.on_drives()));
                let [multipliers] = loads.multipliers().data.0;
                equations.write(Values { values: multipliers });
                Ok(())
            })
        }

        /// Adds to `forces` weight and inertia of masses where the points move, which `read_points` found with their
        /// accelerations: for `read_loads`. `design` are the points where the masses are stated. Each is at chassis points and
        /// free points, as what acts at markers loads nothing: SUSP_ERROR_ARGUMENT of a marker, SUSP_ERROR_ABSENT of no
        /// point. SUSP_ERROR_NO_DIRECTION where three points that hold a body are in line.
        fn add_masses(masses: In<Masses>, design: In<Points>, points: In<PointRates>, forces: InOut<Points>) -> Status {
            answer(|| {
                let (masses, design, points) = (masses.get()?, design.get()?, points.get()?);
                let forces = forces.get()?;
                let mut sum = *forces;
                let at = |point| place(BEFORE_MARKERS, design, points, point);
                each_force(masses, at, |point, force| add_at(&mut sum.values, point, force))?;
                *forces = sum;
                Ok(())
            })
        }

        /// Proves that a configuration for `inputs`, of which the rates do not matter, is near a motion's
        /// position, and no other. Takes about as long as four steps to tolerance.
        fn certify(model: In<Model>, inputs: In<Inputs>, motion: In<Motion>, certificate: Out<Certificate>, failure: Out<Failure>) -> Status {
            respond(failure, &NAMES, || {
                let (model, inputs) = (model.object()?, inputs.get()?);
                let (motion, certificate) = (motion.object()?, certificate.get()?);
                let inputs = still(inputs);
                let certifier = solver::certificate::Certifier::new(model);
                match certifier.certify(&inputs, &motion.position) {
                    solver::certificate::Certificate::Proved { radius, unique_within } => {
                        certificate.write(Certificate { radius, unique_within });
                        Ok(())
                    }
                    solver::certificate::Certificate::Unproved { why } => Err(why.into()),
                }
            })
        }

        /// Points that were found in chassis axes, carried into the world with a chassis that moves:
        /// cheaper than to solve with chassis points that move.
        fn carry(chassis: In<RigidMotion>, points: In<PointRates>, carried: Out<PointRates>) -> Status {
            answer(|| {
                let (chassis, points, carried) = (chassis.get()?, points.get()?, carried.get()?);
                carried.write(points.carried(chassis)?);
                Ok(())
            })
        }

        /// The chassis points of a model, which rest in chassis axes, with a chassis that moves: what
        /// the `moving_` functions take.
        fn move_chassis(model: In<Model>, chassis: In<RigidMotion>, points: Out<ChassisRates>) -> Status {
            answer(|| {
                let (model, chassis, points) = (model.object()?, chassis.get()?, points.get()?);
                let moving = chassis.body()?.anchors(solver::Linkage::fixed(model));
                points.write(Rates::from_signal(&moving, values_of_points));
                Ok(())
            })
        }

        /// `step` with chassis points that move. Drives prescribe coordinates in the axes of these.
        fn moving_step(model: In<Model>, chassis: In<ChassisRates>, inputs: In<Inputs>, dt: Number, motion: InOut<Motion>, report: Out<Report>, failure: Out<Failure>) -> Status {
            respond(failure, &NAMES, || {
                let inputs = moving(chassis.get()?, inputs.get()?);
                tracked(model, inputs, dt, motion, report)
            })
        }

        /// `bounded_step` with chassis points that move.
        fn moving_bounded_step(model: In<Model>, chassis: In<ChassisRates>, inputs: In<Inputs>, outputs: Outputs, dt: Number, motion: InOut<Motion>, report: Out<Report>, failure: Out<Failure>) -> Status {
            respond(failure, &NAMES, || {
                let inputs = moving(chassis.get()?, inputs.get()?);
                bounded::<_, 1>(model, inputs, outputs, dt, motion, report)
            })
        }

        /// `read_points` with chassis points that move.
        fn moving_read_points(model: In<Model>, chassis: In<ChassisRates>, inputs: In<Inputs>, motion: In<Motion>, points: Out<PointRates>) -> Status {
            answer(|| located(model, moving(chassis.get()?, inputs.get()?), motion, points))
        }

        /// The name of a point by its number in `points`, from 0; NULL beyond the last.
        fn point_name(index: usize) -> Text {
            NAMES.points.at(index)
        }

        /// The name of a drive by its number; NULL beyond the last.
        fn drive_name(index: usize) -> Text {
            NAMES.drives.at(index)
        }

        /// The name of a measure by its number; NULL beyond the last.
        fn measure_name(index: usize) -> Text {
            NAMES.measures.at(index)
        }

        /// The name of a length by its number; NULL beyond the last.
        fn length_name(index: usize) -> Text {
            NAMES.lengths.at(index)
        }
    } };
}

/// The functions of listings that say what some of their points are.
#[doc(hidden)]
#[macro_export]
macro_rules! functions_of_a_part {
    (wheel, $prefix:literal) => {
        $crate::functions! { $prefix:
            /// The wheel of positions that `read_points` found.
            fn read_wheel(points: In<Points>, wheel: Out<Wheel>) -> Status {
                answer(|| {
                    let (points, wheel) = (points.get()?, wheel.get()?);
                    wheel.write(wheel_of(points_of(points).wheel())?);
                    Ok(())
                })
            }

            /// How the body that carries the wheel turns.
            fn read_rotation(points: In<PointRates>, rotation: Out<CarrierRotation>) -> Status {
                answer(|| {
                    let (points, rotation) = (points.get()?, rotation.get()?);
                    rotation.write(rotation_of(&signal(points, |points| points_of(points).carrier()))?);
                    Ok(())
                })
            }
        }
    };
    (kingpin, $prefix:literal) => {
        $crate::functions! { $prefix:
            /// The kingpin of positions that `read_points` found.
            fn read_kingpin(points: In<Points>, kingpin: Out<Kingpin>) -> Status {
                answer(|| {
                    let (points, kingpin) = (points.get()?, kingpin.get()?);
                    let points = points_of(points);
                    kingpin.write(kingpin_of(points.kingpin(), points.wheel())?);
                    Ok(())
                })
            }
        }
    };
}
