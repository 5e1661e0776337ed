//! Lists of so many numbers: an array type of serde's would read that many and drop the rest.

use serde::{Deserialize, Deserializer};

/// As many numbers as there are to be.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq)]
#[serde(try_from = "Vec<f64>")]
pub struct Exactly<const N: usize>(pub [f64; N]);

impl<const N: usize> TryFrom<Vec<f64>> for Exactly<N> {
    type Error = String;

    fn try_from(list: Vec<f64>) -> Result<Self, String> {
        let wanted = || {
            let as_written = if N == 2 { "[from, to]" } else { "[x, y, z]" };
            let comma = if list.len() > N {
                "; a decimal separator is a point, as in 0.5"
            } else {
                ""
            };
            let count = list.len();
            format!("{N} numbers are wanted here, {as_written}, not {count}{comma}")
        };
        let exact = <[f64; N]>::try_from(list.as_slice());
        exact.map(Self).map_err(|_| wanted())
    }
}

/// The numbers alone, for fields.
pub(crate) fn exactly<'de, D, const N: usize>(deserializer: D) -> Result<[f64; N], D::Error>
where
    D: Deserializer<'de>,
{
    Exactly::deserialize(deserializer).map(|Exactly(numbers)| numbers)
}
