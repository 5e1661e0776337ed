//! The loads of a load case.

use std::fmt;

use serde::Deserialize;
use serde::de::{
    self, MapAccess, SeqAccess, Visitor,
    value::{MapAccessDeserializer, SeqAccessDeserializer},
};
use toml::Value;

use crate::tables::entries::Entries;
use crate::tables::number_list::number_list;

/// A load at a place or in a measure.
#[derive(Clone, Debug, PartialEq)]
pub enum Load {
    /// A load in a measure, positive if it increases the measure: a force, N, or if the measure is an angle a moment, N m.
    Along(f64),
    /// A load at a place.
    At(Wrench),
    /// The name of the measure that bears the load of a drive, or of the spring that acts by its rate.
    By(String),
    /// The names of several springs that act by their rates. For a drive only one name is allowed.
    BySeveral(Vec<String>),
}

/// A load case: the loads by the names of places, measures and drives, and the springs that act, under the name `acting`.
#[derive(Clone, Debug, PartialEq)]
pub struct LoadCase(pub Entries<Load>);

/// A force and a moment, in the file's axes.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Wrench {
    /// The force, N.
    #[serde(default, deserialize_with = "number_list")]
    pub force: [f64; 3],
    /// The moment, N m.
    #[serde(default, deserialize_with = "number_list")]
    pub moment: [f64; 3],
}

impl Load {
    /// Returns all numbers.
    pub fn numbers(&self) -> Vec<f64> {
        match self {
            Self::Along(force) => vec![*force],
            Self::At(Wrench { force, moment }) => [*force, *moment].concat(),
            Self::By(_) | Self::BySeveral(_) => Vec::new(),
        }
    }
}

impl<'de> Deserialize<'de> for LoadCase {
    fn deserialize<D: de::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_map(LoadCaseVisitor)
    }
}

struct LoadCaseVisitor;

impl<'de> Visitor<'de> for LoadCaseVisitor {
    type Value = LoadCase;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a load case, which has a name: write its lines under [loads.NAME]")
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<LoadCase, A::Error> {
        Deserialize::deserialize(MapAccessDeserializer::new(map)).map(LoadCase)
    }
}

impl<'de> Deserialize<'de> for Load {
    fn deserialize<D: de::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(LoadVisitor)
    }
}

/// How the most usual load is written.
const WRITTEN: &str =
    "a force is written contact = [-3000.0, 0.0, 4000.0], in N, under [loads.NAME]";

struct LoadVisitor;

impl<'de> Visitor<'de> for LoadVisitor {
    type Value = Load;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(
            "a force [x, y, z] in N, { force = [x, y, z], moment = [x, y, z] }, a number for a measure, for a drive \
             the name of the measure that bears its load, or acting = [\"NAME\"] with names of springs",
        )
    }

    fn visit_f64<E: de::Error>(self, force: f64) -> Result<Load, E> {
        Ok(Load::Along(force))
    }

    fn visit_i64<E: de::Error>(self, force: i64) -> Result<Load, E> {
        Ok(Load::Along(force as f64))
    }

    fn visit_str<E: de::Error>(self, measure: &str) -> Result<Load, E> {
        Ok(Load::By(measure.to_owned()))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, entries: A) -> Result<Load, A::Error> {
        let entries = Vec::<Value>::deserialize(SeqAccessDeserializer::new(entries))?;
        let names = entries
            .iter()
            .map(|entry| entry.as_str().map(str::to_owned));
        let names: Option<Vec<String>> = names.collect();
        if let Some(names) = names.filter(|names| !names.is_empty()) {
            return Ok(Load::BySeveral(names));
        }
        let force = number_list(Value::Array(entries)).map_err(|error| {
            let mistake = error.to_string();
            de::Error::custom(format!("{}; {WRITTEN}", mistake.trim_end()))
        })?;
        Ok(Load::At(Wrench {
            force,
            ..Wrench::default()
        }))
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Load, A::Error> {
        Wrench::deserialize(MapAccessDeserializer::new(map)).map(Load::At)
    }
}
