//! A polynomial of time.

use std::fmt;

use serde::Deserialize;
use serde::de::{self, SeqAccess, Visitor, value::SeqAccessDeserializer};

/// Coefficients of a polynomial, constant first; in the file a single number is a constant.
#[derive(Clone, Debug)]
pub struct Coefficients(pub Vec<f64>);

impl<'de> Deserialize<'de> for Coefficients {
    fn deserialize<D: de::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(CoefficientsVisitor)
    }
}

struct CoefficientsVisitor;

impl<'de> Visitor<'de> for CoefficientsVisitor {
    type Value = Coefficients;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number, or coefficients of a polynomial of time as [value, rate, ...]")
    }

    fn visit_f64<E: de::Error>(self, value: f64) -> Result<Coefficients, E> {
        Ok(Coefficients(vec![value]))
    }

    fn visit_i64<E: de::Error>(self, value: i64) -> Result<Coefficients, E> {
        Ok(Coefficients(vec![value as f64]))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, entries: A) -> Result<Coefficients, A::Error> {
        Vec::deserialize(SeqAccessDeserializer::new(entries)).map(Coefficients)
    }
}
