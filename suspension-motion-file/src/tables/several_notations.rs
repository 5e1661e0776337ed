//! Values that may be written in several ways: as a number, a text, a list or a table.

use std::fmt;
use std::marker::PhantomData;

use serde::de::{
    self, Deserializer, Error, MapAccess, SeqAccess, Unexpected, Visitor,
    value::{MapAccessDeserializer, SeqAccessDeserializer},
};

/// A value that may be written in several ways. Those that it does not implement are refused.
pub(crate) trait Written<'de>: Sized {
    /// A description of all ways, for the refusal.
    const EXPECTED: &'static str;

    /// The value that is written as a number.
    fn number(_number: f64) -> Option<Self> {
        None
    }

    /// The value that is written as a text.
    fn text(_text: &str) -> Option<Self> {
        None
    }

    /// The value that is written as a list.
    fn list<D: Deserializer<'de>>(_list: D) -> Result<Self, D::Error> {
        Err(D::Error::invalid_type(Unexpected::Seq, &Self::EXPECTED))
    }

    /// The value that is written as a table.
    fn table<D: Deserializer<'de>>(_table: D) -> Result<Self, D::Error> {
        Err(D::Error::invalid_type(Unexpected::Map, &Self::EXPECTED))
    }
}

/// Reads a value in whichever way it is written.
pub(crate) fn read_written<'de, D, V>(deserializer: D) -> Result<V, D::Error>
where
    D: Deserializer<'de>,
    V: Written<'de>,
{
    deserializer.deserialize_any(WrittenVisitor(PhantomData))
}

/// Lets a type that derives `Deserialize` with `remote = "Self"` be written as a table only: serde would also read a list as
/// its keys in order.
macro_rules! written_as_table {
    ($Table:ty, $expected:literal) => {
        impl<'de> serde::Deserialize<'de> for $Table {
            fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                $crate::tables::several_notations::read_written(deserializer)
            }
        }

        impl<'de> $crate::tables::several_notations::Written<'de> for $Table {
            const EXPECTED: &'static str = $expected;

            fn table<D: serde::Deserializer<'de>>(table: D) -> Result<Self, D::Error> {
                Self::deserialize(table)
            }
        }
    };
}

pub(crate) use written_as_table;

struct WrittenVisitor<V>(PhantomData<V>);

impl<'de, V: Written<'de>> Visitor<'de> for WrittenVisitor<V> {
    type Value = V;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(V::EXPECTED)
    }

    fn visit_f64<E: de::Error>(self, number: f64) -> Result<V, E> {
        V::number(number).ok_or_else(|| E::invalid_type(Unexpected::Float(number), &self))
    }

    fn visit_i64<E: de::Error>(self, number: i64) -> Result<V, E> {
        V::number(number as f64).ok_or_else(|| E::invalid_type(Unexpected::Signed(number), &self))
    }

    fn visit_str<E: de::Error>(self, text: &str) -> Result<V, E> {
        V::text(text).ok_or_else(|| E::invalid_type(Unexpected::Str(text), &self))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, list: A) -> Result<V, A::Error> {
        V::list(SeqAccessDeserializer::new(list))
    }

    fn visit_map<A: MapAccess<'de>>(self, table: A) -> Result<V, A::Error> {
        V::table(MapAccessDeserializer::new(table))
    }
}
