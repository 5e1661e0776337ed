//! What a call answers.

use core::ffi::CStr;

use suspension_core::bounded::Refusal;

use crate::describe::Interface;

/// Defines the answers: their numbers, and their texts for people.
macro_rules! statuses {
    ($($name:ident = $number:literal: $text:literal;)*) => {
        /// What a call answers. In C: `susp_status`, an `int32_t`.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        #[repr(i32)]
        pub enum Status {
            $(#[doc = $text] $name = $number,)*
        }

        impl Status {
            /// All of them.
            pub const ALL: &[Self] = &[$(Self::$name),*];

            /// A sentence for people.
            pub const fn text(self) -> &'static CStr {
                match self {
                    $(Self::$name => {
                        const TEXT: &CStr = terminated(concat!($text, "\0"));
                        TEXT
                    })*
                }
            }

            /// The name that the enumeration gives it.
            pub(crate) fn name(self) -> &'static str {
                match self {
                    $(Self::$name => stringify!($name),)*
                }
            }
        }
    };
}

/// Texts without a zero inside.
const fn terminated(text: &str) -> &CStr {
    match CStr::from_bytes_with_nul(text.as_bytes()) {
        Ok(text) => text,
        Err(_) => c"",
    }
}

statuses! {
    Ok = 0: "done";

    Null = 1: "a pointer is NULL that must not be";
    Misaligned = 2: "a pointer is not aligned for what it points to";
    Size = 3: "the memory has another size than the library needs: header and library differ";
    Object = 4: "the object was not made by the function that makes its kind, or not successfully";
    Argument = 5: "an argument is none of the values that it may have";
    Outside = 6: "the drive is outside the range of the curve";
    NoDirection = 7: "the points that give a direction coincide, lie in line or are not finite";

    PointNotFinite = 20: "a coordinate of the point is not finite, or too large to compute with";
    BadLength = 21: "the length is not positive, or too large or too small to compute with";
    Collinear = 22: "the points that carry the point lie in line";
    Flat = 23: "the point lies in the plane of the points that links join it to";
    NotClosed = 24: "the lengths to the point do not fit together in any rigid body";
    NoLine = 25: "the ends of the line that ends at the point coincide";

    NotFinite = 40: "the residual of the equation is not a finite number";
    Overflow = 41: "the change of the unknown is not a finite number";
    CrossedSingularity = 42: "a singularity was crossed: the unknown moved to another assembly";
    Singular = 43: "the equations do not determine the unknown";
    Mirrored = 44: "the point stands on the wrong side of the points that links join it to";
    Diverging = 45: "no root near by: the correction of the unknown grew";
    TooFar = 46: "the step is too long to tell assemblies apart";
    StepTooLong = 47: "the step is longer than the series of the unknown is good for";
    TurningPoint = 48: "the leading quantity turns before it meets its target";
    NotConverged = 49: "the equation is off by more than the tolerance after all iterations";
    StepsUsedUp = 50: "all sub-steps that are allowed are used up";
    UnhealthyPivots = 51: "the pivots of the fixed order are too small: a bounded step tries others";

    UnprovedNearSingular = 60: "nothing is proved: the Jacobian is singular to rounding";
    UnprovedTooFar = 61: "nothing is proved: the root is too far, or a singularity too near";
}

mod calls {
    #![allow(unsafe_code, reason = "names for the linker")]

    use super::Status as Answer;
    use crate::names::Text;

    /// The number of an answer, whatever C makes of it.
    type Status = i32;

    crate::functions! { "susp":
        /// What an answer means: a text that lives as long as the program.
        fn status_text(status: Status) -> Text {
            let known = Answer::ALL.iter().find(|known| **known as i32 == status);
            known.map_or(c"no such status", |known| known.text()).into()
        }
    }
}

pub use calls::status_text;

/// What needs no number.
pub(crate) const INTERFACE: Interface = Interface {
    prefix: "susp",
    number: "",
    docs: &[],
    structures: &[],
    functions: &[calls::FUNCTIONS],
};

impl From<Refusal> for Status {
    fn from(refusal: Refusal) -> Self {
        match refusal {
            Refusal::NotFinite => Self::NotFinite,
            Refusal::Diverging => Self::Diverging,
            Refusal::NotConverged => Self::NotConverged,
            Refusal::CrossedSingularity => Self::CrossedSingularity,
            Refusal::Mirrored => Self::Mirrored,
            Refusal::Unhealthy => Self::UnhealthyPivots,
        }
    }
}
