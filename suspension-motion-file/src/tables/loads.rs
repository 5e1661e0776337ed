//! The loads of a load case.

use serde::de::Error;
use serde::{Deserialize, Deserializer};
use toml::Value;

use crate::tables::entries::Entries;
use crate::tables::number_list::number_list;
use crate::tables::several_notations::{Written, read_written};

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
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        read_written(deserializer)
    }
}

impl<'de> Written<'de> for LoadCase {
    const EXPECTED: &'static str =
        "a load case, which has a name: write its lines under [loads.NAME]";

    fn table<D: Deserializer<'de>>(table: D) -> Result<Self, D::Error> {
        Entries::deserialize(table).map(Self)
    }
}

impl<'de> Deserialize<'de> for Load {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        read_written(deserializer)
    }
}

/// How the most usual load is written.
const WRITTEN: &str =
    "a force is written contact = [-3000.0, 0.0, 4000.0], in N, under [loads.NAME]";

impl<'de> Written<'de> for Load {
    const EXPECTED: &'static str = "a force [x, y, z] in N, { force = [x, y, z], moment = [x, y, z] }, a number for a measure, for a drive \
         the name of the measure that bears its load, or acting = [\"NAME\"] with names of springs";

    fn number(force: f64) -> Option<Self> {
        Some(Self::Along(force))
    }

    fn text(measure: &str) -> Option<Self> {
        Some(Self::By(measure.to_owned()))
    }

    fn list<D: Deserializer<'de>>(list: D) -> Result<Self, D::Error> {
        let entries = Vec::<Value>::deserialize(list)?;
        let names = entries
            .iter()
            .map(|entry| entry.as_str().map(str::to_owned));
        let names: Option<Vec<String>> = names.collect();
        if let Some(names) = names.filter(|names| !names.is_empty()) {
            return Ok(Self::BySeveral(names));
        }
        let force = number_list(Value::Array(entries)).map_err(|error| {
            let mistake = error.to_string();
            D::Error::custom(format!("{}; {WRITTEN}", mistake.trim_end()))
        })?;
        Ok(Self::At(Wrench {
            force,
            ..Wrench::default()
        }))
    }

    fn table<D: Deserializer<'de>>(table: D) -> Result<Self, D::Error> {
        Wrench::deserialize(table).map(Self::At)
    }
}
