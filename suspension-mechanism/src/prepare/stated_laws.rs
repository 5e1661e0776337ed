//! Drives over time, from what the file states.

use suspension_core::Values;
use toml::Spanned;

use crate::failure::Failure;
use crate::file::{CsvTable, Dimension, Recording, StatedLaw};
use crate::mechanism::{DriveLaws, Law, Sine, Spline, Unit};
use crate::number::{exact, number};
use crate::prepare::measured_points::MeasuredPoints;
use crate::prepare::task::Task;

/// What a sum of time steps may be off, as a fraction of the motion's duration.
const ROUNDING: f64 = 1e-9;

/// The columns of a recording.
const OF_RECORDING: &str =
    "of the time in seconds and of the drive, for example [\"t_s\", \"bump\"]";

impl Task<'_> {
    /// The drives over time, which differ by `offsets` from those of the file; drives that the file does not lead keep
    /// their values in `held`.
    pub(super) fn drive_laws<D: Values<f64>>(
        &self,
        offsets: &D,
        held: &D,
    ) -> Result<DriveLaws, Failure> {
        let table = self.file.drives.get_ref();
        let each = self.names.drives.iter();
        let each = each.zip(offsets.values().zip(held.values()));
        let laws = each.map(
            |(drive, (offset, held))| match table.get(drive.name.as_str()) {
                Some(stated) => self.law(stated, drive.kind, offset),
                None => Ok(Law::Polynomial(vec![held])),
            },
        );
        Failure::all(laws).map(DriveLaws::new)
    }

    /// A drive or a measure over time in local coordinates, which differ by `offset` from those of the file.
    pub(super) fn law(
        &self,
        stated: &Spanned<StatedLaw>,
        dimension: impl Into<Dimension> + Copy,
        offset: f64,
    ) -> Result<Law, Failure> {
        let value = |stated: f64| self.in_radians(stated, dimension);
        match stated.get_ref() {
            StatedLaw::Polynomial(stated) => {
                let mut coefficients: Vec<f64> = stated.iter().copied().map(value).collect();
                if let Some(constant) = coefficients.first_mut() {
                    *constant -= offset;
                }
                Ok(Law::Polynomial(coefficients))
            }
            StatedLaw::Sine(sine) => Ok(Law::Sine(Sine {
                mean: value(*sine.mean.get_ref()) - offset,
                amplitude: value(*sine.amplitude.get_ref()),
                frequency: *sine.frequency.get_ref(),
                phase: self.in_radians(*sine.phase.get_ref(), Dimension::Angle),
            })),
            StatedLaw::Recorded(recording) => {
                let factor = *recording.factor.get_ref();
                let zero = recording
                    .offset
                    .as_ref()
                    .map_or(0.0, |zero| *zero.get_ref());
                let mut points = self.recorded(recording, dimension.into())?;
                for [_, recorded] in &mut points {
                    *recorded = value(zero + factor * *recorded) - offset;
                }
                self.through(&recording.table, points).map(Law::Recorded)
            }
        }
    }

    /// Times and values as they are recorded, perhaps below a line of units. Times are in seconds, and values without a factor
    /// in the unit of the drive, which is of this dimension.
    fn recorded(
        &self,
        recording: &Recording,
        dimension: Dimension,
    ) -> Result<Vec<[f64; 2]>, Failure> {
        let points = MeasuredPoints::find(self.source, &recording.table, OF_RECORDING)?;
        points.check_unit(0, "s", |_| "convert the column".to_owned())?;
        if recording.factor.get_ref().abs() == 1.0 {
            let unit = self.file.unit();
            let remedy = |stated: &str| factor_between(stated, dimension, unit);
            points.check_unit(1, &dimension.symbol(unit), remedy)?;
        }
        let numbers = points.numbers()?;
        points.check_times(&numbers)?;
        Ok(numbers)
    }

    /// The curve through recorded points, which must cover the motion.
    fn through(&self, file: &CsvTable, points: Vec<[f64; 2]>) -> Result<Spline, Failure> {
        let refuse = |message: String| Err(self.source.refuse(&file.csv.span(), message));
        let name = file.csv.get_ref();
        if points.iter().flatten().any(|number| !number.is_finite()) {
            return refuse(format!("{name} has numbers that are not finite"));
        }
        let Some(spline) = Spline::through(points) else {
            return refuse(format!("{name} needs at least two lines of numbers"));
        };
        let ([start, end], slack) = (spline.ends(), ROUNDING * (self.last - self.first).abs());
        let covered = start - slack..=end + slack;
        if [self.first, self.last].iter().any(|t| !covered.contains(t)) {
            let [start, end, first, last] = [start, end, self.first, self.last].map(number);
            return refuse(format!(
                "{name} covers {start} to {end} s, but the motion takes {first} to {last} s; change [time]"
            ));
        }
        Ok(spline)
    }
}

/// Says which factor leads from the stated unit of a column to that of the file.
fn factor_between(stated: &str, dimension: Dimension, unit: Unit) -> String {
    let from = Unit::all().find(|from| dimension.symbol(*from) == stated);
    match from {
        Some(from) => {
            let angles = unit.file_factor(dimension) / from.file_factor(dimension);
            let factor = exact(dimension.conversion(from, unit) * angles);
            format!("state the factor between them, factor = {factor}")
        }
        None => "convert the column, or state the factor between them".to_owned(),
    }
}
