//! Values stated once for all wheels, or for some of them.

use std::fmt;
use std::marker::PhantomData;

use serde::Deserialize;
use serde::de::{
    self, IntoDeserializer, MapAccess, Unexpected, Visitor, value::MapAccessDeserializer,
};

use crate::axle::is_within;
use crate::tables::entries::Entries;

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
    fn deserialize<D: de::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(OfWheelVisitor(PhantomData))
    }
}

struct OfWheelVisitor<T>(PhantomData<T>);

impl<'de, T: OfWheel + Deserialize<'de>> Visitor<'de> for OfWheelVisitor<T> {
    type Value = PerWheel<T>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(T::WRITTEN)
    }

    fn visit_str<E: de::Error>(self, name: &str) -> Result<PerWheel<T>, E> {
        let all = T::deserialize(name.into_deserializer());
        all.map(PerWheel::All)
            .map_err(|_: E| E::invalid_type(Unexpected::Str(name), &self))
    }

    fn visit_f64<E: de::Error>(self, number: f64) -> Result<PerWheel<T>, E> {
        let all = T::deserialize(number.into_deserializer());
        all.map(PerWheel::All)
            .map_err(|_: E| E::invalid_type(Unexpected::Float(number), &self))
    }

    fn visit_i64<E: de::Error>(self, number: i64) -> Result<PerWheel<T>, E> {
        let all = T::deserialize(number.into_deserializer());
        all.map(PerWheel::All)
            .map_err(|_: E| E::invalid_type(Unexpected::Signed(number), &self))
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<PerWheel<T>, A::Error> {
        let of_some = Entries::deserialize(MapAccessDeserializer::new(map))?;
        if of_some.is_empty() {
            let message = format!("the table is empty; write {}, or leave it out", T::WRITTEN);
            return Err(de::Error::custom(message));
        }
        Ok(PerWheel::Of(of_some))
    }
}
