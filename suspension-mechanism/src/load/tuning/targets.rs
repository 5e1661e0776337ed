//! The targets that a motion file sets for `suspension tune`.

use suspension_listing::did_you_mean::unknown;
use toml::Spanned;

use crate::characteristics::{columns, not_of_this, suggest_for_wheels, zero_at_design};
use crate::failure::Failure;
use crate::file::{NumberList, TargetTable, Wanted, in_order};
use crate::load::tuning::naming::Naming;
use crate::mechanism::{Axis, CountedFrom, Grid, evenly_spaced};
use crate::quantities::Column;
use crate::tune::{self, Reading, Target};

/// The number of places along a drive if the file states one number for all.
const PLACES: usize = 13;

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
        let (places, wanted) = match stated.get_ref() {
            Wanted::Everywhere(wanted) => (PLACES, vec![*wanted]),
            Wanted::Each(each) if drives.len() == 1 && each.len() > 1 => (each.len(), each.clone()),
            Wanted::Each(_) => {
                return refuse(
                    "a list of numbers needs exactly one drive under `over`, and at least two numbers",
                );
            }
        };
        if !wanted.iter().all(|wanted| wanted.is_finite()) {
            let message = "the target is not finite";
            return Err(self.source.refuse(&stated.span(), message));
        }
        let mut axes = Vec::new();
        for along in drives {
            axes.push(self.axis(along, places, &axes)?);
        }
        if let Err(too_many) = Grid::new(self.mechanism, axes.clone(), CountedFrom::Start) {
            return refuse(&too_many);
        }
        let wanted = wanted.iter().map(|wanted| wanted / scale);
        Ok((axes, to_wanted(wanted.collect())))
    }

    /// The axis of a drive, or of drives that move together, with evenly spaced places; `others` are beside it.
    fn axis(
        &self,
        (drives, ends): (&Spanned<String>, &Spanned<NumberList<2>>),
        places: usize,
        others: &[Axis],
    ) -> Result<Axis, Failure> {
        let values = evenly_spaced(self.ends(ends)?, places);
        Axis::named(self.mechanism, drives.get_ref(), &values, others)
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
