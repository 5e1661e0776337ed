//! The targets that a motion file sets for `suspension tune`.

use std::ops::Range;

use suspension_listing::did_you_mean::unknown;
use toml::Spanned;

use crate::characteristics::{columns, not_of_this, suggest_for_wheels, zero_at_design};
use crate::failure::Failure;
use crate::file::{NumberList, TargetTable, Wanted, in_order};
use crate::load::tuning::measured;
use crate::load::tuning::naming::Naming;
use crate::mechanism::{Axis, CountedFrom, Grid, ends, evenly_spaced};
use crate::number::number;
use crate::quantities::Column;
use crate::tune::{self, Reading, Target};

/// The number of places along a drive if the file states one number for all.
const PLACES: usize = 13;

/// Drives that move together, with their range.
type Over<'a> = (&'a Spanned<String>, &'a Spanned<NumberList<2>>);

impl Naming<'_> {
    pub(super) fn read_target(
        &self,
        name: &Spanned<String>,
        stated: &Spanned<TargetTable>,
    ) -> Result<Target, Failure> {
        let table = stated.get_ref();
        let column = self.column(&table.of)?;
        let per = table.per.as_ref().map(|per| self.drive(per)).transpose()?;
        if per.is_some() && !column.has_derivatives {
            let message = format!("`{}` has no derivatives", table.of.get_ref());
            return Err(self.source.refuse(&table.of.span(), message));
        }
        let reading = Reading { column, per };
        let scale = reading.file_factor(self.mechanism);
        let within = *table.within.get_ref() / scale;
        if !(within.is_finite() && within > 0.0) {
            let message = "`within` must be a positive number, the largest permitted deviation from the target";
            return Err(self.source.refuse(&table.within.span(), message));
        }
        let (over, wanted) = self.wanted(name, table, scale)?;
        Ok(Target {
            name: name.get_ref().clone(),
            reading,
            over,
            wanted,
            within,
        })
    }

    fn column(&self, of: &Spanned<String>) -> Result<Column, Failure> {
        let mut columns = columns(self.mechanism);
        let names: Vec<String> = columns.iter().map(Column::title).collect();
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        let wanted = of.get_ref();
        let refuse = |message: String| Err(self.source.refuse(&of.span(), message));
        if let Some(message) = zero_at_design(wanted, self.mechanism) {
            return refuse(message);
        }
        if let Some(found) = names.iter().position(|name| name == wanted) {
            return Ok(columns.swap_remove(found));
        }
        if let Some(meant) = suggest_for_wheels(wanted, names.iter().copied()) {
            return refuse(format!(
                "unknown quantity `{wanted}`; did you mean {meant}?"
            ));
        }
        if let Some(message) = not_of_this(wanted, self.mechanism) {
            return refuse(message);
        }
        let begun = |name: &&&str| wanted.starts_with(&format!("{name}_"));
        if let Some(name) = names.iter().filter(begun).max_by_key(|name| name.len()) {
            return refuse(format!(
                "unknown quantity `{wanted}`; did you mean `{name}`? Quantities are named without a unit"
            ));
        }
        let message = unknown("quantity", wanted, &names);
        // A long list is shortened where it is printed.
        let all = format!(
            "; suspension sensitivities {} prints all",
            self.source.name()
        );
        let is_answered = message.ends_with('?');
        refuse(message + if is_answered { "" } else { &all })
    }

    /// The axes over which a target is stated, and the values wanted along them.
    fn wanted(
        &self,
        name: &Spanned<String>,
        table: &TargetTable,
        scale: f64,
    ) -> Result<(Vec<Axis>, tune::Wanted), Failure> {
        let refuse = |message: &str| Err(self.source.refuse(&name.span(), message));
        let (stated, to_wanted): (_, fn(Vec<f64>) -> tune::Wanted) = match (
            &table.value,
            &table.change,
        ) {
            (Some(value), None) => (value, tune::Wanted::Values),
            (None, Some(_)) if table.over.is_none() => {
                return refuse(&format!(
                    "`change` counts from the design position: state the drives that move under `over`, each with a range, for example {}",
                    self.example(0.06)
                ));
            }
            (None, Some(change)) => (change, tune::Wanted::Changes),
            _ => {
                return refuse(
                    "a target needs either `value` or `change`; `change` counts from the design position",
                );
            }
        };
        let drives = table.over.iter().flat_map(in_order);
        let drives: Vec<_> = drives.collect();
        let (axes, wanted) = match (stated.get_ref(), drives.as_slice()) {
            (Wanted::Everywhere(wanted), _) => (self.axes(&drives, PLACES)?, vec![*wanted]),
            (Wanted::Each(each), [_]) if each.len() > 1 => {
                (self.axes(&drives, each.len())?, each.clone())
            }
            (Wanted::Each(_), _) => {
                return refuse(
                    "a list of numbers needs exactly one drive under `over`, and at least two numbers",
                );
            }
            (Wanted::Points(points), [over]) => {
                self.measured(*over, points.clone(), &stated.span())?
            }
            (Wanted::Csv(file), [over]) => {
                let points = measured::read(self.source, file)?;
                self.measured(*over, points, &stated.span())?
            }
            (Wanted::Points(_) | Wanted::Csv(_), _) => {
                return refuse(
                    "measured points need exactly one drive under `over`, with the range in which they count",
                );
            }
        };
        if !wanted.iter().all(|wanted| wanted.is_finite()) {
            let message = "the target is not finite";
            return Err(self.source.refuse(&stated.span(), message));
        }
        if let Err(too_many) = Grid::new(self.mechanism, axes.clone(), CountedFrom::Start) {
            return refuse(&too_many);
        }
        let wanted = wanted.iter().map(|wanted| wanted / scale);
        Ok((axes, to_wanted(wanted.collect())))
    }

    /// The axis along the measured points that are within the range of the drive, and their values.
    fn measured(
        &self,
        (drives, range): Over<'_>,
        mut points: Vec<[f64; 2]>,
        place: &Range<usize>,
    ) -> Result<(Vec<Axis>, Vec<f64>), Failure> {
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
    fn axes(&self, drives: &[Over<'_>], places: usize) -> Result<Vec<Axis>, Failure> {
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
        others: &[Axis],
    ) -> Result<Axis, Failure> {
        Axis::named(self.mechanism, drives.get_ref(), values, others)
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
