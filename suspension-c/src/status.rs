//! The status that a call returns.

use core::ffi::CStr;

use suspension_core::error::{Cause, Explain};
use suspension_core::step::bounded::Refusal;

use crate::describe::Interface;

/// Defines the statuses: their numbers and texts.
macro_rules! statuses {
    ($($name:ident = $number:literal: $what:literal $(, $remedy:literal)?;)*) => {
        /// The result of a call. In C: `susp_status`, an `int32_t`.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        #[repr(i32)]
        pub enum Status {
            $(#[doc = $what] $name = $number,)*
        }

        impl Status {
            /// All statuses.
            pub const ALL: &[Self] = &[$(Self::$name),*];

            /// Returns what happened and what to do.
            pub const fn text(self) -> &'static CStr {
                match self {
                    $(Self::$name => {
                        const TEXT: &CStr = terminated(concat!($what $(, "; ", $remedy)?, "\0"));
                        TEXT
                    })*
                }
            }

            /// Returns the name in Rust.
            pub(crate) fn name(self) -> &'static str {
                match self {
                    $(Self::$name => stringify!($name),)*
                }
            }
        }
    };
}

/// Converts a text without zeros to a text that ends with a zero.
const fn terminated(text: &str) -> &CStr {
    match CStr::from_bytes_with_nul(text.as_bytes()) {
        Ok(text) => text,
        Err(_) => c"",
    }
}

// The core defines the causes of failures; before them come the mistakes that only a caller in C can make.
suspension_core::causes! { statuses {
    Ok = 0: "done";

    Null = 1: "a pointer that must not be NULL is NULL";
    Misaligned = 2: "a pointer is not aligned for its type";
    Size = 3: "the memory has another size than the library needs: header and library differ, or an array has another count than the listing";
    Object = 4: "the object was not made by the function that makes its kind, or not successfully";
    Argument = 5: "an argument has a value that is not permitted";
    Outside = 6: "the drive is outside the range of the curve";
    NoDirection = 7: "the points that give a direction coincide, lie in line or are not finite";
    Listing = 8: "the text is not a listing that can be solved", "the message says where and why";
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

    /// The number of a status, in any C compiler.
    type Status = i32;

    crate::functions! { "susp":
        /// The meaning of a status: a text that lives as long as the program.
        fn status_text(status: Status) -> Text {
            let known = Answer::ALL.iter().find(|known| **known as i32 == status);
            known.map_or(c"no such status", |known| known.text()).into()
        }
    }
}

pub use calls::status_text;

/// The interface without a number type.
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
