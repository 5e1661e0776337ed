//! The items with which every listing is exported.

/// Defines a static of names that end with a zero.
#[doc(hidden)]
#[macro_export]
macro_rules! names {
    ($table:ident { $($what:ident: $names:expr,)* }) => {
        static $table: Names = Names {
            $($what: {
                const LENGTH: usize = $crate::private::terminated_length($names);
                const TEXT: &[u8] = &$crate::private::terminated::<LENGTH>($names);
                $crate::private::Table(TEXT)
            },)*
        };
    };
}

/// The structs of a listing, and their description.
#[doc(hidden)]
#[macro_export]
macro_rules! structures_of_a_linkage {
    ($prefix:literal) => {
        $crate::structures_of_a_linkage! { $prefix;
            /// The geometry, which does not change while the mechanism moves. Opaque; may be copied.
            Model = Opaque(Linkage, "_model");
            /// The state: unknowns with velocities and accelerations. Opaque; may be copied.
            Motion = Opaque(solver::Motion<Number, UNKNOWNS>, "_motion");
            /// Every point: chassis points, free points, markers. x, y, z of each, in the axes and the
            /// unit of length of the hardpoints; or their velocities or accelerations.
            Points = Vectors(POINTS);
            /// Positions, velocities and accelerations of every point.
            PointRates = Rates(Points);
            /// The chassis points.
            Chassis = Vectors(FIXED);
            /// The chassis points with velocities and accelerations.
            ChassisRates = Rates(Chassis);
            /// The prescribed quantities: coordinates in the unit of the points, angles in rad.
            Drives = Numbers(DRIVES);
            /// The drives with their first and second time derivatives.
            Inputs = Rates(Drives);
            /// The measures of the listing: lengths and coordinates in the unit of the points, angles in
            /// rad.
            Measures = Numbers(MEASURES);
            /// The measures with their first and second time derivatives.
            MeasureRates = Rates(Measures);
            /// One number per equation.
            Equations = Numbers(EQUATIONS);
            /// Constant lengths of links and bodies, in the unit of the points.
            Lengths = Numbers(LENGTHS);
        }
    };
    ($prefix:literal; $($(#[doc = $doc:literal])* $name:ident = $kind:ident($($of:tt)*);)*) => {
        $($(#[doc = $doc])* pub type $name = $crate::structure!(@type $prefix, $kind $($of)*);)*

        const STRUCTURES: &[$crate::private::Structure] = &[$(
            $crate::private::Structure {
                name: stringify!($name),
                docs: &[$($doc),*],
                shape: $crate::structure!(@shape $name, $kind $($of)*),
            }
        ),*];
    };
}

/// The type and the description of a struct.
#[doc(hidden)]
#[macro_export]
macro_rules! structure {
    (@type $prefix:literal, Opaque $of:ty, $name:literal) => {
        Object<$of, { $crate::private::tag(concat!($prefix, $name)) }>
    };
    (@type $prefix:literal, Vectors $names:ident) => { Values<[Number; 3], { room($names) }> };
    (@type $prefix:literal, Numbers $names:ident) => { Values<Number, { room($names) }> };
    (@type $prefix:literal, Rates $of:ident) => { Rates<$of> };
    (@shape $name:ident, Opaque $($of:tt)*) => {
        $crate::private::Shape::Opaque {
            size: size_of::<$name>(),
            align: align_of::<$name>(),
        }
    };
    (@shape $name:ident, Vectors $names:ident) => {
        $crate::private::Shape::Named { names: $names, vectors: true }
    };
    (@shape $name:ident, Numbers $names:ident) => {
        $crate::private::Shape::Named { names: $names, vectors: false }
    };
    (@shape $name:ident, Rates $of:ident) => { $crate::private::Shape::Rates(stringify!($of)) };
}

/// Functions that the functions of a listing share.
#[doc(hidden)]
#[macro_export]
macro_rules! helpers_of_a_linkage {
    () => {
        fn points_of(points: &Points) -> listing::Points<Number> {
            named_points(points)
        }

        fn still(inputs: &Inputs) -> solver::Inputs<solver::Still, listing::Drives<Number>> {
            solver::Inputs::still(signal(inputs, named))
        }

        fn moving(
            chassis: &ChassisRates,
            inputs: &Inputs,
        ) -> solver::Inputs<solver::Signal<listing::Fixed<Number>>, listing::Drives<Number>> {
            solver::Inputs {
                chassis: signal(chassis, named_points),
                drives: signal(inputs, named),
            }
        }

        #[inline(always)]
        fn tracked<C: solver::signal::ChassisMotion<listing::Fixed<Number>>>(
            model: In<'_, Model>,
            inputs: solver::Inputs<C, listing::Drives<Number>>,
            dt: Number,
            motion: InOut<'_, Motion>,
            report: Out<'_, Report>,
        ) -> Result<(), Trouble> {
            let (model, motion) = (model.object()?, motion.object()?);
            let report = report.optional()?;
            fill(
                report,
                solver::Tracker::default().step(model, &inputs, dt, motion)?,
            );
            Ok(())
        }

        #[inline(always)]
        fn bounded<
            C: solver::signal::ChassisMotion<listing::Fixed<Number>>,
            const CORRECTIONS: usize,
        >(
            model: In<'_, Model>,
            inputs: solver::Inputs<C, listing::Drives<Number>>,
            outputs: Outputs,
            dt: Number,
            motion: InOut<'_, Motion>,
            report: Out<'_, Report>,
        ) -> Result<(), Trouble> {
            let (model, motion) = (model.object()?, motion.object()?);
            let (outputs, report) = (outputs_of(outputs)?, report.optional()?);
            let bounded = solver::Bounded::<Number, CORRECTIONS>::new();
            fill(
                report,
                bounded.step_to(outputs, model, &inputs, dt, motion)?,
            );
            Ok(())
        }

        #[inline(always)]
        fn attempted<const CORRECTIONS: usize>(
            model: In<'_, Model>,
            inputs: In<'_, Inputs>,
            outputs: Outputs,
            dt: Number,
            motion: InOut<'_, Motion>,
            report: Out<'_, Report>,
        ) -> Result<(), Status> {
            let (model, motion) = (model.object()?, motion.object()?);
            let (outputs, report) = (outputs_of(outputs)?, report.optional()?);
            let (bounded, inputs) = (
                solver::Bounded::<Number, CORRECTIONS>::new(),
                still(inputs.get()?),
            );
            fill(
                report,
                bounded.attempt(outputs, model, &inputs, dt, motion)?,
            );
            Ok(())
        }

        #[inline(always)]
        fn located<C: solver::signal::ChassisMotion<listing::Fixed<Number>>>(
            model: In<'_, Model>,
            inputs: solver::Inputs<C, listing::Drives<Number>>,
            motion: In<'_, Motion>,
            points: Out<'_, PointRates>,
        ) -> Result<(), Status> {
            let (model, motion, points) = (model.object()?, motion.object()?, points.get()?);
            points.write(Rates::from_signal(
                &motion.points(model, &inputs),
                values_of_points,
            ));
            Ok(())
        }
    };
}
