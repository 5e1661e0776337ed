//! Values stated once for all wheels, or for some of them.

use serde::de::value::{self, F64Deserializer, StrDeserializer};
use serde::de::{Error, IntoDeserializer};
use serde::{Deserialize, Deserializer};

use crate::axle::is_within;
use crate::tables::entries::Entries;
use crate::tables::several_notations::{Written, read_written};

/// Values of wheels.
#[derive(Clone, Debug)]
pub enum PerWheel<T> {
    /// One value for all wheels.
    All(T),
    /// Values for the wheels whose names contain these words: `left`, `front`, `front_left`.
    Of(Entries<T>),
}

impl<T> PerWheel<T> {
    /// Returns whether the wheel with this name has a value.
    pub fn is_of(&self, wheel: &str) -> bool {
        match self {
            Self::All(_) => true,
            Self::Of(some) => some.names().any(|words| is_within(words.get_ref(), wheel)),
        }
    }
}

/// Types of values that wheels may have.
pub trait OfWheel {
    /// How the value is written.
    const WRITTEN: &str;
}

impl OfWheel for String {
    const WRITTEN: &str = "\"drive\" or { wheel = \"drive\" }";
}

impl OfWheel for f64 {
    const WRITTEN: &str = "a number or { front = number, rear = number }";
}

impl<'de, T: OfWheel + Deserialize<'de>> Deserialize<'de> for PerWheel<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        read_written(deserializer)
    }
}

impl<'de, T: OfWheel + Deserialize<'de>> Written<'de> for PerWheel<T> {
    const EXPECTED: &'static str = T::WRITTEN;

    fn number(number: f64) -> Option<Self> {
        let all = T::deserialize::<F64Deserializer<value::Error>>(number.into_deserializer());
        all.ok().map(Self::All)
    }

    fn text(name: &str) -> Option<Self> {
        let all = T::deserialize::<StrDeserializer<'_, value::Error>>(name.into_deserializer());
        all.ok().map(Self::All)
    }

    fn table<D: Deserializer<'de>>(table: D) -> Result<Self, D::Error> {
        let of_some = Entries::deserialize(table)?;
        if of_some.is_empty() {
            let message = format!("the table is empty; write {}, or leave it out", T::WRITTEN);
            return Err(D::Error::custom(message));
        }
        Ok(Self::Of(of_some))
    }
}
