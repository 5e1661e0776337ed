//! The status that a call returns.

use core::ffi::CStr;

use suspension_core::error::{Cause, Explain};
use suspension_core::step::bounded::Refusal;

use crate::describe::Interface;

/// Defines the answers: their numbers, and their texts for people.
macro_rules! statuses {
    ($($name:ident = $number:literal: $what:literal $(, $remedy:literal)?;)*) => {
        /// What a call answers. In C: `susp_status`, an `int32_t`.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        #[repr(i32)]
        pub enum Status {
            $(#[doc = $what] $name = $number,)*
        }

        impl Status {
            /// All of them.
            pub const ALL: &[Self] = &[$(Self::$name),*];

            /// What happened and what to do, for people.
            pub const fn text(self) -> &'static CStr {
                match self {
                    $(Self::$name => {
                        const TEXT: &CStr = terminated(concat!($what $(, "; ", $remedy)?, "\0"));
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

// Causes of failures are the core's; before them stands what only a caller in C can do wrong.
suspension_core::causes! { statuses {
    Ok = 0: "done";

    Null = 1: "a pointer is NULL that must not be";
    Misaligned = 2: "a pointer is not aligned for what it points to";
    Size = 3: "the memory has another size than the library needs: header and library differ, or an array has another count than the listing";
    Object = 4: "the object was not made by the function that makes its kind, or not successfully";
    Argument = 5: "an argument is none of the values that it may have";
    Outside = 6: "the drive is outside the range of the curve";
    NoDirection = 7: "the points that give a direction coincide, lie in line or are not finite";
    Listing = 8: "the text is no listing that can be solved", "the message says where and why";
    Absent = 9: "the listing has no such part";
} }

impl From<Cause> for Status {
    fn from(cause: Cause) -> Self {
        let number = cause as i32;
        let status = Self::ALL.iter().find(|status| **status as i32 == number);
        status.copied().unwrap_or(Self::Argument)
    }
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
        refusal.facts().cause.into()
    }
}
