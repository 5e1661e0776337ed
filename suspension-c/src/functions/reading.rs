//! Functions that read a motion: points, measures, derivatives, loads, and a proof of its position.

/// Functions of every listing that read a motion.
#[doc(hidden)]
#[macro_export]
macro_rules! functions_of_reading {
    ($prefix:literal) => { $crate::functions! { $prefix, READING:
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
        /// position, and no other. Takes about as long as five steps to tolerance.
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
    } };
}
