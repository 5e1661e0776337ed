//! Lists with a fixed count of numbers: an array type of serde would read that many and ignore the rest.

use std::fmt;

use serde::de::{self, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer};
use toml::Spanned;

/// A list of exactly `N` numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NumberList<const N: usize>(pub [f64; N]);

impl<'de, const N: usize> Deserialize<'de> for NumberList<N> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_seq(List).map(Self)
    }
}

/// Reads the numbers for a field of an array type.
pub(crate) fn number_list<'de, D, const N: usize>(deserializer: D) -> Result<[f64; N], D::Error>
where
    D: Deserializer<'de>,
{
    deserializer.deserialize_seq(List)
}

/// As [`number_list`], with the list's place in the file.
pub(crate) fn spanned_number_list<'de, D, const N: usize>(
    deserializer: D,
) -> Result<Spanned<[f64; N]>, D::Error>
where
    D: Deserializer<'de>,
{
    let list = Spanned::<NumberList<N>>::deserialize(deserializer)?;
    Ok(Spanned::new(list.span(), list.into_inner().0))
}

struct List<const N: usize>;

impl<const N: usize> List<N> {
    /// How the list is written.
    const WRITTEN: &str = if N == 2 { "[from, to]" } else { "[x, y, z]" };
}

impl<'de, const N: usize> Visitor<'de> for List<N> {
    type Value = [f64; N];

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{N} numbers {}", Self::WRITTEN)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut entries: A) -> Result<[f64; N], A::Error> {
        let mut list = Vec::new();
        while let Some(number) = entries.next_element::<f64>()? {
            list.push(number);
        }
        <[f64; N]>::try_from(list.as_slice()).map_err(|_| {
            let is_whole = |number: &f64| number.fract() == 0.0;
            let comma = if list.len() > N && list.iter().all(is_whole) {
                "; a decimal separator is a point, as in 0.5"
            } else {
                ""
            };
            let (written, count) = (Self::WRITTEN, list.len());
            de::Error::custom(format!(
                "{N} numbers are wanted here, {written}, not {count}{comma}"
            ))
        })
    }
}
