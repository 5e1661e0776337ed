//! The position of a point: at coordinates, or relative to another point.

use serde::{Deserialize, Deserializer};
use toml::Spanned;

use crate::tables::number_list::{number_list, spanned_number_list};
use crate::tables::several_notations::{Written, read_written};

/// The position of a point.
#[derive(Clone, Debug)]
pub enum Position {
    /// Coordinates x, y, z.
    At([f64; 3]),
    /// Relative to another point at the design position.
    Off(Offset),
}

/// A marker's place relative to another point.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Offset {
    /// The other point.
    pub from: Spanned<String>,
    /// The vector from there to the marker, along x, y, z.
    #[serde(deserialize_with = "spanned_number_list")]
    pub offset: Spanned<[f64; 3]>,
}

impl<'de> Deserialize<'de> for Position {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        read_written(deserializer)
    }
}

impl<'de> Written<'de> for Position {
    const EXPECTED: &'static str = "[x, y, z] or { from = \"point\", offset = [x, y, z] }";

    fn list<D: Deserializer<'de>>(list: D) -> Result<Self, D::Error> {
        number_list(list).map(Self::At)
    }

    fn table<D: Deserializer<'de>>(table: D) -> Result<Self, D::Error> {
        Offset::deserialize(table).map(Self::Off)
    }
}
