//! The position of a point: at coordinates, or relative to another point.

use std::fmt;

use serde::Deserialize;
use serde::de::{
    self, MapAccess, SeqAccess, Visitor,
    value::{MapAccessDeserializer, SeqAccessDeserializer},
};
use toml::Spanned;

use crate::tables::number_list::{number_list, spanned_number_list};

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
    fn deserialize<D: de::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(PositionVisitor)
    }
}

struct PositionVisitor;

impl<'de> Visitor<'de> for PositionVisitor {
    type Value = Position;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("[x, y, z] or { from = \"point\", offset = [x, y, z] }")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, entries: A) -> Result<Position, A::Error> {
        number_list(SeqAccessDeserializer::new(entries)).map(Position::At)
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Position, A::Error> {
        Offset::deserialize(MapAccessDeserializer::new(map)).map(Position::Off)
    }
}
