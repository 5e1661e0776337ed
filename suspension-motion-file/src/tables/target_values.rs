//! The values that a target of tuning states.

use std::fmt;

use serde::Deserialize;
use serde::de::{
    self, MapAccess, SeqAccess, Visitor,
    value::{MapAccessDeserializer, SeqAccessDeserializer},
};
use toml::Spanned;

/// One number for all places, one for each place, or measured points.
#[derive(Clone, Debug)]
pub enum TargetValues {
    /// The same number at all places.
    Everywhere(f64),
    /// At evenly spaced values of the drive, from the first to the last.
    Each(Vec<f64>),
    /// Pairs of a change of the drive from the design position and the number there.
    Points(Vec<[f64; 2]>),
    /// Such pairs in a file.
    Csv(CsvTable),
}

/// Measured points in a file with comma-separated values.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CsvTable {
    /// The path of the file, from the folder of the motion file.
    pub csv: Spanned<String>,
    /// The headings of the columns of the drive and of the number.
    pub columns: Spanned<Vec<Spanned<String>>>,
}

impl<'de> Deserialize<'de> for TargetValues {
    fn deserialize<D: de::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(TargetValuesVisitor)
    }
}

struct TargetValuesVisitor;

impl<'de> Visitor<'de> for TargetValuesVisitor {
    type Value = TargetValues;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(
            "a number, one for each of evenly spaced values of the drive as [0.0, 0.1, 0.3], measured points as \
             [[-0.05, 0.1], [0.04, 0.3]], or { csv = \"measured.csv\", columns = [\"travel\", \"toe\"] }",
        )
    }

    fn visit_f64<E>(self, number: f64) -> Result<TargetValues, E> {
        Ok(TargetValues::Everywhere(number))
    }

    fn visit_i64<E>(self, number: i64) -> Result<TargetValues, E> {
        Ok(TargetValues::Everywhere(number as f64))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut entries: A) -> Result<TargetValues, A::Error> {
        let (mut numbers, mut points) = (Vec::new(), Vec::new());
        while let Some(entry) = entries.next_element()? {
            match entry {
                Entry::Number(number) => numbers.push(number),
                Entry::Point(point) => points.push(point),
            }
        }
        match (numbers.is_empty(), points.is_empty()) {
            (_, true) => Ok(TargetValues::Each(numbers)),
            (true, false) => Ok(TargetValues::Points(points)),
            (false, false) => Err(de::Error::custom(
                "a list has numbers for evenly spaced values of the drive, or points [drive, value], not both",
            )),
        }
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<TargetValues, A::Error> {
        CsvTable::deserialize(MapAccessDeserializer::new(map)).map(TargetValues::Csv)
    }
}

/// An entry of a list.
enum Entry {
    Number(f64),
    Point([f64; 2]),
}

impl<'de> Deserialize<'de> for Entry {
    fn deserialize<D: de::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(EntryVisitor)
    }
}

struct EntryVisitor;

impl<'de> Visitor<'de> for EntryVisitor {
    type Value = Entry;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number, or a point [drive, value]")
    }

    fn visit_f64<E>(self, number: f64) -> Result<Entry, E> {
        Ok(Entry::Number(number))
    }

    fn visit_i64<E>(self, number: i64) -> Result<Entry, E> {
        Ok(Entry::Number(number as f64))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, entries: A) -> Result<Entry, A::Error> {
        let list = Vec::<f64>::deserialize(SeqAccessDeserializer::new(entries))?;
        let point = <[f64; 2]>::try_from(list.as_slice()).map_err(|_| {
            let count = list.len();
            de::Error::custom(format!("a point is 2 numbers, [drive, value], not {count}"))
        });
        point.map(Entry::Point)
    }
}
