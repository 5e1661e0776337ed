//! The places of a target, and the values that the motion file wants there.

use std::ops::Range;

use toml::Spanned;

use crate::failure::Failure;
use crate::file::{CsvTable, Dimension, NumberList, TargetTable, TargetValues};
use crate::mechanism::{CountedFrom, Grid, GridAxis, ends, evenly_spaced};
use crate::number::number;
use crate::prepare::analyses::tuning::named_parts::Naming;
use crate::prepare::measured_points::MeasuredPoints;
use crate::tune::{self, Reading};

/// The number of places along a drive if the file states one number for all.
const PLACES: usize = 13;

/// What to do about a column in another unit.
fn convert(_stated: &str) -> String {
    "convert the column".to_owned()
}

/// Drives that move together, with their range.
type Over<'a> = (&'a Spanned<String>, &'a Spanned<NumberList<2>>);

impl Naming<'_> {
    /// The axes over which a target is stated, and the values wanted along them, without the file's unit of angles.
    pub(crate) fn wanted(
        &self,
        name: &Spanned<String>,
        table: &TargetTable,
        reading: &Reading,
    ) -> Result<(Vec<GridAxis>, tune::Wanted), Failure> {
        let refuse = |message: String| Err(self.source.refuse(&name.span(), message));
        let stated = match (&table.value, &table.change) {
            (None, Some(_)) if table.over.is_none() => {
                return refuse(format!(
                    "`change` counts from the design position: state the drives that move under `over`, each with a range, for example {}",
                    self.example(0.06)
                ));
            }
            (Some(stated), None) | (None, Some(stated)) => stated,
            _ => {
                let message = "a target needs either `value` or `change`; `change` counts from the design position";
                return refuse(message.to_owned());
            }
        };
        let over: Vec<_> = table
            .over
            .iter()
            .flat_map(|table| table.get_ref().iter())
            .collect();
        let (axes, mut wanted) = self.along(name, &over, stated, reading)?;
        if !wanted.iter().all(|wanted| wanted.is_finite()) {
            let message = "the target is not finite";
            return Err(self.source.refuse(&stated.span(), message));
        }
        if let Err(too_many) = Grid::new(self.mechanism, axes.clone(), CountedFrom::Start) {
            return refuse(too_many);
        }
        let scale = reading.file_factor(self.mechanism);
        wanted.iter_mut().for_each(|wanted| *wanted /= scale);
        let wanted = match table.value {
            Some(_) => tune::Wanted::Values(wanted),
            None => tune::Wanted::Changes(wanted),
        };
        Ok((axes, wanted))
    }

    /// The axes of drives, and the values along them in the file's units: one for all places, or one for each.
    fn along(
        &self,
        name: &Spanned<String>,
        over: &[Over<'_>],
        stated: &Spanned<TargetValues>,
        reading: &Reading,
    ) -> Result<(Vec<GridAxis>, Vec<f64>), Failure> {
        let refuse = |message: &str| Err(self.source.refuse(&name.span(), message));
        match (stated.get_ref(), over) {
            (TargetValues::Everywhere(wanted), _) => Ok((self.axes(over, PLACES)?, vec![*wanted])),
            (TargetValues::Each(each), [_]) if each.len() > 1 => {
                Ok((self.axes(over, each.len())?, each.clone()))
            }
            (TargetValues::Each(_), _) => refuse(
                "a list of numbers needs exactly one drive under `over`, and at least two numbers",
            ),
            (TargetValues::Points(points), [over]) => {
                self.measured(*over, points.clone(), &stated.span())
            }
            (TargetValues::Csv(file), [over]) => {
                let points = self.points_in(file, over.0, reading)?;
                self.measured(*over, points, &stated.span())
            }
            (TargetValues::Points(_) | TargetValues::Csv(_), _) => refuse(
                "measured points need exactly one drive under `over`, with the range in which they count",
            ),
        }
    }

    /// The points in a file, whose columns have the units of the drives and of the quantity.
    fn points_in(
        &self,
        file: &CsvTable,
        drives: &Spanned<String>,
        reading: &Reading,
    ) -> Result<Vec<[f64; 2]>, Failure> {
        let of = "of the drive and of the quantity, for example [\"travel\", \"toe\"]";
        let points = MeasuredPoints::find(self.source, file, of)?;
        let axis = self.named_axis(drives, &[], &[])?;
        let kind = self.mechanism.names.drives[axis.drives[0].0].kind;
        let unit = self.mechanism.unit;
        points.check_unit(0, &Dimension::from(kind).symbol(unit), convert)?;
        if reading.per.is_none() {
            points.check_unit(1, &reading.column.dimension.symbol(unit), convert)?;
        }
        points.numbers()
    }

    /// The axis along the measured points that are within the range of the drive, and their values.
    fn measured(
        &self,
        (drives, range): Over<'_>,
        mut points: Vec<[f64; 2]>,
        place: &Range<usize>,
    ) -> Result<(Vec<GridAxis>, Vec<f64>), Failure> {
        let [from, to] = self.ends(range)?;
        if points.iter().any(|[at, _]| !at.is_finite()) {
            let message = "the place of a measured point is not finite";
            return Err(self.source.refuse(place, message));
        }
        let all = ends(points.iter().map(|[at, _]| *at));
        points.retain(|[at, _]| (from..=to).contains(at));
        points.sort_by(|[a, _], [b, _]| a.total_cmp(b));
        let (places, wanted): (Vec<f64>, Vec<f64>) =
            points.into_iter().map(|[at, wanted]| (at, wanted)).unzip();
        if places.is_empty() {
            let [from, to] = [from, to].map(number);
            let measured = all.map_or_else(String::new, |all| {
                let [least, greatest] = all.map(number);
                format!("; the points are from {least} to {greatest}")
            });
            let message = format!(
                "no measured point is within the range of `over`, from {from} to {to}{measured}"
            );
            return Err(self.source.refuse(place, message));
        }
        Ok((vec![self.named_axis(drives, &places, &[])?], wanted))
    }

    /// The axes of drives, with as many evenly spaced places along each.
    fn axes(&self, drives: &[Over<'_>], places: usize) -> Result<Vec<GridAxis>, Failure> {
        let mut axes = Vec::new();
        for (drives, range) in drives {
            let values = evenly_spaced(self.ends(range)?, places);
            axes.push(self.named_axis(drives, &values, &axes)?);
        }
        Ok(axes)
    }

    /// The axis of a drive, or of drives that move together, beside others.
    fn named_axis(
        &self,
        drives: &Spanned<String>,
        values: &[f64],
        others: &[GridAxis],
    ) -> Result<GridAxis, Failure> {
        GridAxis::named(self.mechanism, drives.get_ref(), values, others)
            .map_err(|message| self.source.refuse(&drives.span(), message))
    }

    fn ends(&self, stated: &Spanned<NumberList<2>>) -> Result<[f64; 2], Failure> {
        let NumberList(ends) = *stated.get_ref();
        let is_range = ends[0] < ends[1] && ends.iter().all(|end| end.is_finite());
        is_range.then_some(ends).ok_or_else(|| {
            let message = format!(
                "write [from, to], the drive's changes from the design position in the file's unit, for example {}",
                self.example(0.06)
            );
            self.source.refuse(&stated.span(), message)
        })
    }
}
