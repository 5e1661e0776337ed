//! Ways to compute a motion, and their names.

use std::fmt;
use std::str::FromStr;

/// A way to compute a motion, under the names that tables of figures use.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Method {
    /// The solver to its tolerance: `generated`.
    Exact,
    /// One factorisation and a fixed number of corrections: `bounded_1`, `bounded_2`, ...
    Bounded {
        /// The number of corrections.
        corrections: u8,
    },
    /// Taylor series of this order: `series_2`, ...
    Series {
        /// The order.
        order: u8,
    },
    /// A baked curve of this tolerance in metres: `baked_1e-6`, ...
    Baked {
        /// Tolerance, m.
        tolerance: f64,
    },
}

/// A name that does not belong to a [`Method`]: tables also hold methods for comparison.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NotAMethod;

impl FromStr for Method {
    type Err = NotAMethod;

    fn from_str(name: &str) -> Result<Self, NotAMethod> {
        fn number<T: FromStr>(digits: &str) -> Result<T, NotAMethod> {
            digits.parse().map_err(|_| NotAMethod)
        }
        match name.split_once('_') {
            None if name == "generated" => Ok(Self::Exact),
            Some(("bounded", digits)) => {
                number(digits).map(|corrections| Self::Bounded { corrections })
            }
            Some(("series", digits)) => number(digits).map(|order| Self::Series { order }),
            Some(("baked", digits)) => number(digits).map(|tolerance| Self::Baked { tolerance }),
            _ => Err(NotAMethod),
        }
    }
}

impl fmt::Display for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Exact => f.write_str("generated"),
            Self::Bounded { corrections } => write!(f, "bounded_{corrections}"),
            Self::Series { order } => write!(f, "series_{order}"),
            Self::Baked { tolerance } => write!(f, "baked_{tolerance:e}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn method_names_are_parsed_as_they_are_printed() {
        for name in ["generated", "bounded_2", "series_8", "baked_1e-8"] {
            assert_eq!(
                name.parse::<Method>().map(|m| m.to_string()),
                Ok(name.to_owned())
            );
        }
        for name in [
            "dense_lu",
            "nalgebra_lu",
            "absolute",
            "relative",
            "baked_",
            "bounded_-1",
        ] {
            assert_eq!(name.parse::<Method>(), Err(NotAMethod));
        }
    }
}
