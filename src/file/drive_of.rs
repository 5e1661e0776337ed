//! Which drive moves which wheel.

use std::collections::BTreeMap;
use std::fmt;

use serde::Deserialize;
use serde::de::{self, MapAccess, Visitor, value::MapAccessDeserializer};
use toml::Spanned;

/// The drive that moves or steers the wheels.
#[derive(Clone, Debug)]
pub enum DriveOf {
    /// One for all wheels.
    All(String),
    /// One for each, by the wheel's name.
    Each(BTreeMap<String, Spanned<String>>),
}

impl<'de> Deserialize<'de> for DriveOf {
    fn deserialize<D: de::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(DriveVisitor)
    }
}

struct DriveVisitor;

impl<'de> Visitor<'de> for DriveVisitor {
    type Value = DriveOf;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("\"drive\" or { wheel = \"drive\" }")
    }

    fn visit_str<E: de::Error>(self, name: &str) -> Result<DriveOf, E> {
        Ok(DriveOf::All(name.to_owned()))
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<DriveOf, A::Error> {
        Deserialize::deserialize(MapAccessDeserializer::new(map)).map(DriveOf::Each)
    }
}
