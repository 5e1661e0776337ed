//! Messages: what happened, where by name, by how much, and what to do.

use core::fmt;

use super::Cause;
use crate::arithmetic::scalar::Real;
use crate::listing::{Part, Parts};

/// The content of an error, whatever its type. Printed with `{:#}`, the remedy is left out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Facts {
    /// Its kind.
    pub cause: Cause,
    /// The part concerned.
    pub part: Option<Part>,
    /// The inequality that is not met.
    pub compared: Option<Compared>,
    /// The time that an advance has reached, s.
    pub reached: Option<f64>,
}

/// An inequality that is not met.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Compared {
    /// The name of the value.
    pub what: &'static str,
    /// Its size.
    pub value: f64,
    /// The relation that should hold between the value and the bound.
    pub relation: &'static str,
    /// The bound.
    pub bound: f64,
}

impl Compared {
    pub(crate) fn new<T: Real>(
        what: &'static str,
        value: T,
        relation: &'static str,
        bound: T,
    ) -> Self {
        Self {
            what,
            value: value.to_subset_unchecked(),
            relation,
            bound: bound.to_subset_unchecked(),
        }
    }
}

impl Facts {
    pub(crate) fn new(cause: Cause, part: Option<Part>) -> Self {
        Self {
            cause,
            part,
            compared: None,
            reached: None,
        }
    }

    /// Writes the message, with names if a listing provides them.
    fn write(&self, parts: Option<&dyn Parts>, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(reached) = self.reached {
            write!(f, "stopped at time {} s: ", Number(reached))?;
        }
        f.write_str(self.cause.what())?;
        let mut between = ": ";
        if let Some(part) = self.part {
            write!(f, "{between}{} ", part.kind())?;
            match parts {
                Some(parts) => write!(f, "`{}`", parts.name(part))?,
                None => write!(f, "{}", part.index())?,
            }
            between = ", ";
        }
        if let Some(Compared {
            what,
            value,
            relation,
            bound,
        }) = self.compared
        {
            let (value, bound) = (Number(value), Number(bound));
            write!(f, "{between}{what} {value}, {relation} {bound}")?;
        }
        let remedy = match self.reached {
            Some(_) => self.cause.remedy_of_advance(),
            None => self.cause.remedy(),
        };
        if f.alternate() {
            Ok(())
        } else {
            write!(f, "; {remedy}")
        }
    }
}

impl fmt::Display for Facts {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.write(None, f)
    }
}

/// A number in a message.
struct Number(f64);

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let size = if self.0 < 0.0 { -self.0 } else { self.0 };
        if size == 0.0 || (1e-3..1e6).contains(&size) {
            write!(f, "{:.6}", self.0)
        } else {
            write!(f, "{:.3e}", self.0)
        }
    }
}

/// An error that states its [`Facts`].
pub trait Explain {
    /// The facts of this error.
    fn facts(&self) -> Facts;
}

/// An error with the listing that it concerns. Printed, it names the parts concerned; with `{:#}` the remedy is left
/// out. `Debug` prints the same, because a program whose `main` returns the error prints it that way.
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct Failure<E, G> {
    /// The error.
    pub error: E,
    /// The source of the names: a listing, or a model.
    pub listing: G,
}

impl<E: Explain, G: Parts> fmt::Display for Failure<E, G> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.error.facts().write(Some(&self.listing), f)
    }
}

impl<E: Explain, G: Parts> fmt::Debug for Failure<E, G> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl<E: Explain, G: Parts> core::error::Error for Failure<E, G> {}

/// Implements `Display` with numbers, and [`Failure`] for names.
macro_rules! messages {
    ($([$($parameter:tt)*] $error:ty;)*) => {
        $(
            impl<$($parameter)*> $error {
                /// The error with the listing that it is about, or a model of it: printed, it names
                /// the part concerned.
                pub fn named<G: $crate::listing::Parts>(self, listing: G) -> $crate::error::Failure<Self, G> {
                    $crate::error::Failure { error: self, listing }
                }
            }

            impl<$($parameter)*> core::fmt::Display for $error {
                fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                    core::fmt::Display::fmt(&$crate::error::Explain::facts(self), f)
                }
            }

            impl<$($parameter)*> core::error::Error for $error {}
        )*
    };
}

pub(crate) use messages;
