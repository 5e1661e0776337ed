//! A drive over time: a polynomial, a sine, or a recording.

use serde::{Deserialize, Deserializer, de};
use toml::Spanned;

use crate::tables::several_notations::{Written, read_written};
use crate::tables::target_values::CsvTable;

/// A drive over time, as the file states it.
#[derive(Clone, Debug)]
pub enum StatedLaw {
    /// Coefficients of a polynomial of time, constant first; in the file a single number is a constant.
    Polynomial(Vec<f64>),
    /// A harmonic motion.
    Sine(Sine),
    /// Recorded values over time, with a smooth curve through them.
    Recorded(Recording),
}

impl StatedLaw {
    /// The file of a recording.
    pub(crate) fn recording(&self) -> Option<&CsvTable> {
        match self {
            Self::Recorded(recording) => Some(&recording.table),
            Self::Polynomial(_) | Self::Sine(_) => None,
        }
    }
}

/// `mean + amplitude sin(2 pi frequency t + phase)`, in the units of the drive.
#[derive(Clone, Debug)]
pub struct Sine {
    /// The value about which the drive moves.
    pub mean: Spanned<f64>,
    /// Half of the distance between the ends.
    pub amplitude: Spanned<f64>,
    /// Periods in a second, Hz.
    pub frequency: Spanned<f64>,
    /// The angle at time 0, in the file's unit of angles.
    pub phase: Spanned<f64>,
}

/// `offset + factor x`, in the units of the drive, where `x` are values in a file.
#[derive(Clone, Debug)]
pub struct Recording {
    /// The file with its columns of the time in seconds and of `x`.
    pub table: CsvTable,
    /// From the recorded unit and direction to those of the drive.
    pub factor: Spanned<f64>,
    /// The value of the drive where 0 is recorded; 0 if left out.
    pub offset: Option<Spanned<f64>>,
}

/// The keys of a sine and of a recording.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Keys {
    mean: Option<Spanned<f64>>,
    amplitude: Option<Spanned<f64>>,
    frequency: Option<Spanned<f64>>,
    phase: Option<Spanned<f64>>,
    csv: Option<Spanned<String>>,
    columns: Option<Spanned<Vec<Spanned<String>>>>,
    factor: Option<Spanned<f64>>,
    offset: Option<Spanned<f64>>,
}

impl Keys {
    fn law<E: de::Error>(self) -> Result<StatedLaw, E> {
        let needed = E::missing_field;
        let or = |stated: Option<Spanned<f64>>, number| {
            stated.unwrap_or_else(|| Spanned::new(0..0, number))
        };
        let is_recording = self.csv.is_some()
            || self.columns.is_some()
            || self.factor.is_some()
            || self.offset.is_some();
        if !is_recording {
            return Ok(StatedLaw::Sine(Sine {
                mean: self.mean.ok_or_else(|| needed("mean"))?,
                amplitude: self.amplitude.ok_or_else(|| needed("amplitude"))?,
                frequency: self.frequency.ok_or_else(|| needed("frequency"))?,
                phase: or(self.phase, 0.0),
            }));
        }
        let of_sine = [self.mean, self.amplitude, self.frequency, self.phase];
        if of_sine.iter().any(Option::is_some) {
            return Err(E::custom(
                "a drive is a sine, with mean, amplitude, frequency and phase, or a recording, with csv, columns, factor and offset, \
                 not both",
            ));
        }
        Ok(StatedLaw::Recorded(Recording {
            table: CsvTable {
                csv: self.csv.ok_or_else(|| needed("csv"))?,
                columns: self.columns.ok_or_else(|| needed("columns"))?,
            },
            factor: or(self.factor, 1.0),
            offset: self.offset,
        }))
    }
}

impl<'de> Deserialize<'de> for StatedLaw {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        read_written(deserializer)
    }
}

impl<'de> Written<'de> for StatedLaw {
    const EXPECTED: &'static str = "a number, coefficients of a polynomial of time as [value, rate, ...], \
         a sine as { mean = 0.30, amplitude = 0.05, frequency = 1.5 }, \
         or a recording as { csv = \"logged.csv\", columns = [\"t_s\", \"bump\"] }";

    fn number(value: f64) -> Option<Self> {
        Some(Self::Polynomial(vec![value]))
    }

    fn list<D: Deserializer<'de>>(list: D) -> Result<Self, D::Error> {
        let coefficients: Vec<Coefficient> = Vec::deserialize(list)?;
        let numbers = coefficients.into_iter().map(|Coefficient(number)| number);
        Ok(Self::Polynomial(numbers.collect()))
    }

    fn table<D: Deserializer<'de>>(table: D) -> Result<Self, D::Error> {
        Keys::deserialize(table)?.law()
    }
}

/// A coefficient of a polynomial of time.
struct Coefficient(f64);

impl<'de> Deserialize<'de> for Coefficient {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        read_written(deserializer)
    }
}

impl<'de> Written<'de> for Coefficient {
    const EXPECTED: &'static str = "a number, one of the coefficients [value, rate, ...]; values over time stand in a file, as \
         { csv = \"logged.csv\", columns = [\"t_s\", \"bump\"] }";

    fn number(value: f64) -> Option<Self> {
        Some(Self(value))
    }
}
