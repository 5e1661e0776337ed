//! C functions of a listing.

/// Defines C functions and describes them in a table, which is called `FUNCTIONS` or has the given name.
#[doc(hidden)]
#[macro_export]
macro_rules! functions {
    ($prefix:literal: $($functions:tt)*) => {
        $crate::functions! { $prefix, FUNCTIONS: $($functions)* }
    };
    ($prefix:literal, $table:ident: $(
        $(#[doc = $doc:literal])*
        fn $name:ident($($argument:ident: $kind:ident $(<$of:ident>)?),* $(,)?) -> $answer:ident $body:block
    )*) => {
        $(
            $(#[doc = $doc])*
            #[unsafe(export_name = concat!($prefix, "_", stringify!($name)))]
            pub extern "C" fn $name($($argument: $kind $(<'_, $of>)?),*) -> $answer $body
        )*

        pub(super) const $table: &[$crate::private::Function] = &[$(
            $crate::private::Function {
                name: stringify!($name),
                docs: &[$($doc),*],
                arguments: &[$([
                    stringify!($argument),
                    stringify!($kind),
                    concat!($(stringify!($of))?),
                ]),*],
                returns: stringify!($answer),
            }
        ),*];
    };
}

/// Makes a module of C functions for a [`linkage!`](suspension_core::linkage!) listing.
///
/// ```text
/// suspension_c::export!(pub mod four_bar_f32 = four_bar, f32, "my_four_bar_f32");
/// suspension_c::export!(pub mod wishbone_f64 = wishbone, f64, "my_wishbone_f64", design, wheel, kingpin);
/// ```
///
/// The arguments are the path of the listing, the number type `f32` or `f64`, and the prefix of all names.
/// `design` adds the positions that a listing states, if it states all; `wheel` and `kingpin` add functions
/// for listings with these statements. `four_bar_f32::INTERFACE` prints the header, which begins with the comment `///`
/// before `pub mod`.
///
/// Functions get their names with `#[unsafe(export_name)]`: no other function of the program may have the
/// same names, and the calling crate may not forbid `unsafe_code`.
#[macro_export]
macro_rules! export {
    ($(#[doc = $doc:literal])* $visibility:vis mod $name:ident = $listing:path, $number:ident,
     $prefix:literal $(, $part:ident)* $(,)?) => {
        $(#[doc = $doc])*
        #[allow(unsafe_code, reason = "names for the linker")]
        $visibility mod $name {
            #[allow(unused_imports)]
            use super::*;
            use $listing as listing;
            use $crate::private::{
                Build as _, HasKingpin as _, HasWheel as _, In, InOut, Linkage as _, Names, Object, Out, PhantomData, Rates, Status,
                Text, Trouble, Values, add_at, answer, each_force, fill, kingpin_of, named, named_points, of, outputs_of, place, respond,
                room, rotation_of, signal, solver, values, values_of_points, wheel_of,
                wheel_rates_of,
            };

            /// The number type.
            pub type Number = $number;
            type Linkage = listing::Model<Number>;
            const UNKNOWNS: usize = $crate::private::unknowns(PhantomData::<Linkage>);

            const POINTS: &[&str] = listing::Listing::PARTS.points;
            const FIXED: &[&str] = listing::Listing::PARTS.chassis;
            const DRIVES: &[&str] = listing::Listing::PARTS.drives;
            const MEASURES: &[&str] = listing::Listing::PARTS.measures;
            const LENGTHS: &[&str] = listing::Listing::PARTS.lengths;
            const EQUATIONS: &[&str] = listing::Listing::PARTS.equations;

            $crate::names! {
                NAMES {
                    points: POINTS, drives: DRIVES, measures: MEASURES, lengths: LENGTHS,
                    equations: EQUATIONS,
                    unknowns: listing::Listing::PARTS.unknowns,
                }
            }

            $crate::structures_of_a_linkage!($prefix);

            use of::$number::{
                Assembly, CarrierRotation, Certificate, Failure, Kingpin, Masses, Outputs, Report, RigidMotion,
                Wheel, WheelRates,
            };

            $crate::helpers_of_a_linkage!();
            $crate::functions_of_making!($prefix);
            $crate::functions_of_stepping!($prefix);
            $crate::functions_of_reading!($prefix);
            $crate::functions_of_moving!($prefix);
            $crate::functions_of_naming!($prefix);

            $(
                #[doc(hidden)]
                pub mod $part {
                    use super::*;
                    $crate::functions_of_a_part!($part, $prefix);
                }
            )*

            /// The description from which the header is written.
            pub const INTERFACE: $crate::private::Interface = $crate::private::Interface {
                prefix: $prefix,
                number: stringify!($number),
                docs: &[$($doc),*],
                structures: &[STRUCTURES],
                functions: &[MAKING, STEPPING, READING, MOVING, NAMING $(, $part::FUNCTIONS)*],
            };
        }
    };
}
