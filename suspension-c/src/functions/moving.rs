//! Functions for a moving chassis.

/// Functions of every listing for a chassis that moves.
#[doc(hidden)]
#[macro_export]
macro_rules! functions_of_moving {
    ($prefix:literal) => { $crate::functions! { $prefix, MOVING:
        /// Transforms points that were computed in chassis axes to world axes for a chassis that moves.
        /// This is cheaper than a step with chassis points that move.
        fn carry(chassis: In<RigidMotion>, points: In<PointRates>, carried: Out<PointRates>) -> Status {
            answer(|| {
                let (chassis, points, carried) = (chassis.get()?, points.get()?, carried.get()?);
                carried.write(points.carried(chassis)?);
                Ok(())
            })
        }

        /// Computes the chassis points of a model, which are fixed in chassis axes, for a chassis that
        /// moves: the input of the `moving_` functions.
        fn move_chassis(model: In<Model>, chassis: In<RigidMotion>, points: Out<ChassisRates>) -> Status {
            answer(|| {
                let (model, chassis, points) = (model.object()?, chassis.get()?, points.get()?);
                let moving = chassis.body()?.anchors(solver::Linkage::fixed(model));
                points.write(Rates::from_signal(&moving, values_of_points));
                Ok(())
            })
        }

        /// `step` with chassis points that move. Drives prescribe coordinates in the same axes as these
        /// points.
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
    } };
}
