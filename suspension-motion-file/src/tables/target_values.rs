//! The values that a target of tuning states.

use serde::de::Error;
use serde::{Deserialize, Deserializer};
use toml::Spanned;

use crate::tables::several_notations::{Written, read_written};

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
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        read_written(deserializer)
    }
}

impl<'de> Written<'de> for TargetValues {
    const EXPECTED: &'static str = "a number, one for each of evenly spaced values of the drive as [0.0, 0.1, 0.3], measured points as \
         [[-0.05, 0.1], [0.04, 0.3]], or { csv = \"measured.csv\", columns = [\"travel\", \"toe\"] }";

    fn number(number: f64) -> Option<Self> {
        Some(Self::Everywhere(number))
    }

    fn list<D: Deserializer<'de>>(list: D) -> Result<Self, D::Error> {
        let (mut numbers, mut points) = (Vec::new(), Vec::new());
        for entry in Vec::deserialize(list)? {
            match entry {
                Entry::Number(number) => numbers.push(number),
                Entry::Point(point) => points.push(point),
            }
        }
        match (numbers.is_empty(), points.is_empty()) {
            (_, true) => Ok(Self::Each(numbers)),
            (true, false) => Ok(Self::Points(points)),
            (false, false) => Err(D::Error::custom(
                "a list has numbers for evenly spaced values of the drive, or points [drive, value], not both",
            )),
        }
    }

    fn table<D: Deserializer<'de>>(table: D) -> Result<Self, D::Error> {
        CsvTable::deserialize(table).map(Self::Csv)
    }
}

/// An entry of a list.
enum Entry {
    Number(f64),
    Point([f64; 2]),
}

impl<'de> Deserialize<'de> for Entry {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        read_written(deserializer)
    }
}

impl<'de> Written<'de> for Entry {
    const EXPECTED: &'static str = "a number, or a point [drive, value]";

    fn number(number: f64) -> Option<Self> {
        Some(Self::Number(number))
    }

    fn list<D: Deserializer<'de>>(list: D) -> Result<Self, D::Error> {
        let list = Vec::<f64>::deserialize(list)?;
        let point = <[f64; 2]>::try_from(list.as_slice()).map_err(|_| {
            let count = list.len();
            D::Error::custom(format!("a point is 2 numbers, [drive, value], not {count}"))
        });
        point.map(Self::Point)
    }
}
