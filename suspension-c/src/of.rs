//! Items of one number type that need no linkage: all types, and functions of baked curves.

/// Functions that need no linkage, and all types, for one number type.
macro_rules! over {
    ($number:ident, $prefix:literal) => {
        /// Items for this number type.
        #[allow(unsafe_code, reason = "names for the linker")]
        pub mod $number {
            use crate::curve;
            use crate::failure::answer;
            use crate::pointer::{In, Out};
            use crate::shared;
            use crate::status::Status;

            type Number = core::primitive::$number;
            /// The rates for which a step solves: see `SUSP_POSITION`.
            pub type Outputs = i32;
            over!(@types $number: Assembly, BakedWheel, BakedWheelRates, CarrierRotation, Certificate,
                Curve, Failure, Kingpin, Mass, Masses, Numbers, Report, RigidMotion, Wheel, WheelRates);

            crate::functions! { $prefix:
                /// Evaluates a wheel for the value of a drive, its rate, per second, and its second rate,
                /// per second squared. SUSP_ERROR_OUTSIDE beyond the range of the curve,
                /// SUSP_ERROR_ARGUMENT if its numbers do not belong to one table.
                fn look_up_wheel(curve: In<Curve>, drive: Number, rate: Number, second_rate: Number, wheel: Out<BakedWheelRates>) -> Status {
                    answer(|| {
                        let (curve, wheel) = (curve.get()?, wheel.get()?);
                        wheel.write(curve::wheel(curve, drive, rate, second_rate)?);
                        Ok(())
                    })
                }
            }

            pub(crate) const INTERFACE: crate::describe::Interface = crate::describe::Interface {
                prefix: $prefix,
                number: stringify!($number),
                docs: &[],
                structures: &[&[shared::NUMBERS], shared::STRUCTURES, &[shared::MASSES]],
                functions: &[FUNCTIONS],
            };
        }
    };
    (@types $number:ident: $($name:ident),*) => {
        $(
            #[doc = concat!("See [`", stringify!($name), "`](shared::", stringify!($name), ").")]
            pub type $name = shared::$name<Number>;
        )*
    };
}

over!(f32, "susp_f32");
over!(f64, "susp_f64");
