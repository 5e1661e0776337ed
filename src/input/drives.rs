//! From polynomials of time to what the solver is given.

use std::f64::consts::PI;

use suspension_core::{Build, DriveKind, Inputs, LocalOrigin, Named, Parts, Signal, Still, Values};
use toml::Spanned;

use crate::failure::Failure;
use crate::input::file::{Table, Unit};
use crate::input::polynomial::Polynomial;
use crate::input::source::Source;
use crate::number::number;
use crate::study::Suspension;

/// A quantity over time: a polynomial with its first and second derivative.
#[derive(Clone, Debug)]
pub struct Law([Polynomial; 3]);

impl Law {
    /// Of a polynomial.
    pub fn new(value: Polynomial) -> Self {
        let rate = value.derivative();
        let second_rate = rate.derivative();
        Self([value, rate, second_rate])
    }

    /// The quantity with its rates at time `t`.
    pub fn at(&self, t: f64) -> Signal<f64> {
        let [value, rate, second_rate] = self.0.each_ref().map(|law| law.at(t));
        Signal {
            value,
            rate,
            second_rate,
        }
    }
}

/// The drives of a linkage over time, in the order of its drives.
#[derive(Clone, Debug)]
pub struct DriveLaws {
    laws: Vec<Law>,
}

impl DriveLaws {
    /// One polynomial for each drive.
    pub fn new(polynomials: impl IntoIterator<Item = Polynomial>) -> Self {
        Self {
            laws: polynomials.into_iter().map(Law::new).collect(),
        }
    }

    /// Taylor coefficients of the drives at time `t`, order 1 first.
    pub fn terms<D: Values<f64>, const K: usize>(&self, t: f64) -> [D; K] {
        let mut derivatives: Vec<Polynomial> =
            self.laws.iter().map(|law| law.0[0].clone()).collect();
        let mut factorial = 1.0;
        std::array::from_fn(|index| {
            factorial *= (index + 1) as f64;
            for derivative in &mut derivatives {
                *derivative = derivative.derivative();
            }
            let values = derivatives.iter().map(|derivative| derivative.at(t));
            D::from_values(values.map(|value| value / factorial))
        })
    }

    /// The inputs at time `t`, the chassis at rest.
    pub fn inputs<D: Values<f64>>(&self, t: f64) -> Inputs<Still, D> {
        let [value, rate, second_rate] = [0, 1, 2].map(|order| {
            let laws = self.laws.iter();
            D::from_values(laws.map(|law| law.0[order].at(t)))
        });
        Inputs::still(Signal {
            value,
            rate,
            second_rate,
        })
    }
}

/// The drives' values in the coordinates in which `origin` is stated, from local ones.
pub fn given<L: Build<N, Scalar = f64>, const N: usize>(
    origin: &LocalOrigin<f64>,
    model: &L,
    local: &L::Drives,
) -> L::Drives {
    let offsets = origin.of_drives(model);
    let each = local.values().zip(offsets.values());
    L::Drives::from_values(each.map(|(local, offset)| local + offset))
}

/// Checks that driving angles lie where a link's angle from an axis can lie, from 0 to pi.
///
/// # Errors
///
/// [`Failure::Input`] at the first that does not, in the table `places`.
pub fn check_angles<L: Suspension<N>, V, const N: usize>(
    source: &Source,
    drives: &L::Drives,
    places: &Table<V>,
) -> Result<(), Failure> {
    let names = <L::Drives as Named<f64>>::NAMES;
    for (drive, (name, value)) in names.iter().zip(drives.values()).enumerate() {
        let kind = L::Listing::default().drive_kind(drive);
        if kind == DriveKind::Angle && !(0.0..=PI).contains(&value) {
            let place = places.get_ref().get(*name).map(Spanned::span);
            let message = format!(
                "drive `{name}` begins at {} rad; the angle of a link from an axis lies between 0 and pi",
                number(value)
            );
            return Err(source.refuse(&place.unwrap_or_else(|| places.span()), message));
        }
    }
    Ok(())
}

/// A drive's unit.
pub fn unit_of(kind: DriveKind, unit: Unit) -> &'static str {
    match kind {
        DriveKind::Angle => "rad",
        DriveKind::Coordinate => unit.symbol(),
    }
}

/// The drives' values in words, as `theta = 0.7 rad`.
pub fn in_words<L: Suspension<N>, const N: usize>(drives: &L::Drives, unit: Unit) -> String {
    each_in_words::<L, N>(drives, unit).join(", ")
}

/// Each drive's value in words.
pub fn each_in_words<L: Suspension<N>, const N: usize>(
    drives: &L::Drives,
    unit: Unit,
) -> Vec<String> {
    let names = <L::Drives as Named<f64>>::NAMES;
    let each = names.iter().zip(drives.values()).enumerate();
    each.map(|(drive, (name, value))| {
        let kind = L::Listing::default().drive_kind(drive);
        format!("{name} = {} {}", number(value), unit_of(kind, unit))
    })
    .collect()
}
