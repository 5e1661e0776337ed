//! Functions that read a motion: points, measures, derivatives, loads, and a proof of its position.

/// Functions of every listing that read a motion.
#[doc(hidden)]
#[macro_export]
macro_rules! functions_of_reading {
    ($prefix:literal) => { $crate::functions! { $prefix, READING:
        /// Positions, velocities and accelerations of all points of a motion. `inputs` must be those of the
        /// step that computed the motion.
        fn read_points(model: In<Model>, inputs: In<Inputs>, motion: In<Motion>, points: Out<PointRates>) -> Status {
            answer(|| located(model, still(inputs.get()?), motion, points))
        }

        /// The measures of the listing, with rates. A rate is NaN where a measured length is zero, or a
        /// measured angle without `about` is 0 or pi.
        fn read_measures(model: In<Model>, points: In<PointRates>, measures: Out<MeasureRates>) -> Status {
            answer(|| {
                let (model, points) = (model.object()?, points.get()?);
                let measures = measures.get()?;
                let found = model.measures(&signal(points, points_of));
                measures.write(Rates::from_signal(&found, values));
                Ok(())
            })
        }

        /// Motion ratios: all points of a motion with their first and second derivatives for the change
        /// `change` of the drives, for example 1 for one of them and 0 for the rest; the mechanism may be
        /// at rest. The members `rate` are per unit of that change, `second_rate` per unit squared;
        /// `read_measures` computes the derivatives of the measures from them. The rates of `inputs` do not
        /// matter. SUSP_ERROR_SINGULAR where the drives lock.
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

        /// The effects of forces at the points, N in the axes of the points, on the mechanism at rest at the
        /// position of a motion. A force at a marker acts on its body, a force at a chassis point on the
        /// drive that moves it. `drives` receives the work of the forces per unit of each drive,
        /// which is the load on its actuator; `equations` the multiplier of each equation. The multiplier
        /// of a link is the force in it, positive in tension; if a drive prescribes the link's angle from
        /// an axis, the part of the force along the link that the drive causes is not included. The rates
        /// of `inputs` do not matter. Takes about half as long as a step. SUSP_ERROR_SINGULAR where the
        /// drives lock.
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

        /// Adds weight and inertia of masses to `forces`, for `read_loads`. `points` come from
        /// `read_points` with their accelerations; `design` are the points at which the masses are stated.
        /// A mass may refer to any points; SUSP_ERROR_ABSENT for a number without a point,
        /// SUSP_ERROR_NO_DIRECTION if the three points of a body are in line, SUSP_ERROR_OVERFLOW if a
        /// force is not finite.
        fn add_masses(masses: In<Masses>, design: In<Points>, points: In<PointRates>, forces: InOut<Points>) -> Status {
            answer(|| {
                let (masses, design, points) = (masses.get()?, design.get()?, points.get()?);
                let forces = forces.get()?;
                let mut sum = *forces;
                let at = |point| place(design, points, point);
                each_force(masses, at, |point, force| add_at(&mut sum.values, point, force))?;
                *forces = sum;
                Ok(())
            })
        }

        /// Proves that near the position of a motion there is exactly one configuration for `inputs`, whose
        /// rates do not matter. Takes about as long as five steps to tolerance.
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
