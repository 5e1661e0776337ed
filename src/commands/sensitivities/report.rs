//! The report of sensitivities as text.

use std::fmt::Write;

use suspension_listing::did_you_mean::did_you_mean;

use crate::characteristics::{
    as_in_tables, named_in_reports, not_of_this, suggest_for_wheels, zero_at_design,
};
use crate::commands::sensitivities::number::{DIGITS, Number};
use crate::commands::sensitivities::scatter::Scatter;
use crate::mechanism::{Description, Length};
use crate::number::{rounded, without_rounding};
use crate::quantities::{TOE, TOTAL_TOE};
use crate::sensitivities::Sensitivities;

/// Finite differences of constants are smaller than this: rounding.
const ROUNDING: f64 = 1e-9;

pub(super) struct Report<'a> {
    pub(super) file: &'a str,
    pub(super) mechanism: &'a Description,
    pub(super) found: &'a Sensitivities,
    pub(super) scatter: Option<&'a Scatter>,
}

impl Report<'_> {
    /// Returns all numbers that have a value at the design position.
    pub(super) fn numbers(&self) -> impl Iterator<Item = Number> {
        let all = self.all_numbers();
        all.filter(move |at| self.found.values[at.column][at.number].is_finite())
    }

    /// Returns all numbers, with or without a value at the design position.
    fn all_numbers(&self) -> impl Iterator<Item = Number> {
        let columns = 0..self.found.columns.len();
        columns.flat_map(move |column| {
            let numbers = 0..self.found.values[column].len();
            numbers.map(move |number| self.number(column, number))
        })
    }

    fn number(&self, at: usize, number: usize) -> Number {
        let (column, unit) = (&self.found.columns[at], self.mechanism.unit);
        let drive = number.checked_sub(1);
        let drive = drive.and_then(|drive| self.mechanism.names.drives.get(drive));
        let per = drive.map(|drive| format!("_per_{}", drive.name));
        let (scale, symbol) = column.display_scale_per(drive, unit);
        Number {
            column: at,
            number,
            csv_name: column.csv_name(unit) + &per.unwrap_or_default(),
            in_file: column.file_factor_per(drive, unit),
            title: column.title_per(drive),
            scale,
            symbol,
        }
    }

    /// Refuses a name that begins no number's name, or only names of numbers without a value.
    ///
    /// # Errors
    ///
    /// A sentence with the names that there are.
    pub(super) fn check(&self, of: &[String]) -> Result<(), String> {
        let titles: Vec<String> = self.numbers().map(|number| number.title).collect();
        let is_known = |wanted: &&String| titles.iter().any(|title| title.starts_with(*wanted));
        let Some(wanted) = of.iter().find(|wanted| !is_known(wanted)) else {
            return Ok(());
        };
        if self
            .all_numbers()
            .any(|number| number.title.starts_with(wanted))
        {
            return Err(format!(
                "`{wanted}` has no value at the design position, and so no sensitivities; suspension motion --help says where quantities \
                 have none"
            ));
        }
        if let Some(zero) = zero_at_design(wanted, self.mechanism) {
            return Err(zero);
        }
        let named = as_in_tables(wanted);
        let meant = named_in_reports(wanted, self.mechanism).map(|name| format!("`{name}`"));
        let meant = meant.or_else(|| suggest_for_wheels(&named, titles.iter().map(String::as_str)));
        if let Some(message) = not_of_this(&named, self.mechanism).filter(|_| meant.is_none()) {
            return Err(message);
        }
        let known = titles.iter().filter(|title| !title.contains(' '));
        let known: Vec<&str> = known.map(String::as_str).collect();
        let meant = match meant {
            Some(meant) => format!("; did you mean {meant}?"),
            None => did_you_mean(wanted, known.iter().copied()),
        };
        let then = if meant.is_empty() {
            format!("; known are {}", known.join(", "))
        } else {
            format!("{meant} Without --of all quantities are printed")
        };
        Err(format!("no quantity begins with `{wanted}`{then}"))
    }

    /// Returns the largest sensitivities of the numbers whose names begin with one of `of`, or of all numbers if `of` is
    /// empty.
    pub(super) fn text(&self, of: &[String], largest: usize) -> String {
        let (per, _) = self.usual_change();
        let axes = self.mechanism.axes.in_words();
        let is_wanted = |number: &Number| {
            of.is_empty()
                || of
                    .iter()
                    .any(|wanted| number.title.starts_with(wanted.as_str()))
        };
        let numbers: Vec<Number> = self.numbers().filter(is_wanted).collect();
        let mut out = format!(
            "{}: per {per} of each hardpoint coordinate and link length; axes of {axes}\n{}",
            self.file,
            self.tie_rod_note(&numbers)
        );
        let (zero, others): (Vec<Number>, Vec<Number>) = numbers
            .into_iter()
            .partition(|number| self.stays_zero(number));
        for number in others {
            let value = self.value(&number);
            let (title, symbol) = (&number.title, &number.symbol);
            // Writing into a string cannot fail.
            let _ = writeln!(out, "\n{title}: {} {symbol}", rounded(value, DIGITS));
            let _ = writeln!(out, "  {}", self.largest(&number, largest));
            if let Some(scatter) = self.scatter {
                let _ = writeln!(out, "  {}", scatter.in_words(&number));
            }
        }
        let zero: Vec<&str> = zero.iter().map(|number| number.title.as_str()).collect();
        let them = match zero.len() {
            0 => return out,
            1 => "it",
            _ => "them",
        };
        let _ = writeln!(out, "\n0, and nothing changes {them}: {}", zero.join(", "));
        out
    }

    /// Says why moving an end of a tie rod does not change the toe at the design position; empty if `numbers` has no toe or
    /// the linkage has no such rod.
    fn tie_rod_note(&self, numbers: &[Number]) -> String {
        const NAMES: [&str; 3] = ["tie_rod", "track_rod", "toe_link"];
        let is_of_toe = |number: &Number| {
            let column = &self.found.columns[number.column];
            column.is(&TOE) || column.is(&TOTAL_TOE)
        };
        let changes = self.found.each.iter();
        let mut links = changes.filter_map(|each| each.change.name.strip_prefix("length "));
        let rod = links.find(|link| NAMES.iter().any(|name| link.contains(name)));
        let rod = rod.filter(|_| numbers.iter().any(is_of_toe));
        rod.map_or_else(String::new, |rod| {
            format!(
                "A point is moved with its links built anew to it: an end of `{rod}` changes slopes, as bump steer, and not the toe at the \
                 design position, which `length {rod}` does.\n"
            )
        })
    }

    /// Returns the usual change of a hardpoint in words, and its length in the file's unit.
    fn usual_change(&self) -> (&'static str, f64) {
        match self.mechanism.unit.length {
            Length::Metre => ("mm", 1e-3),
            other => (other.symbol(), 1.0),
        }
    }

    fn value(&self, at: &Number) -> f64 {
        without_rounding(self.found.values[at.column][at.number] * at.scale)
    }

    /// Returns the finite effects of all changes on a number.
    fn effects(&self, at: &Number) -> Vec<(&str, f64)> {
        let scale = at.scale * self.usual_change().1;
        let each = self.found.each.iter();
        let each = each.map(|each| (&*each.change.name, each.of[(at.column, at.number)] * scale));
        each.filter(|(_, by)| by.is_finite()).collect()
    }

    /// Returns whether a number is zero, no change affects it, and it does not scatter.
    fn stays_zero(&self, at: &Number) -> bool {
        let effects = self.effects(at);
        let is_known = effects.is_empty() == self.found.each.is_empty();
        let is_unchanged = is_known && greatest(&effects) < ROUNDING;
        let scatters = self.scatter.is_some_and(|scatter| scatter.changes(at));
        self.value(at) == 0.0 && is_unchanged && !scatters
    }

    fn largest(&self, at: &Number, count: usize) -> String {
        let mut effects = self.effects(at);
        if effects.is_empty() && !self.found.each.is_empty() {
            return "it has no derivatives here, as an angle between parallel lines has none"
                .to_owned();
        }
        let greatest = greatest(&effects);
        if greatest < ROUNDING {
            return "nothing changes it".to_owned();
        }
        // Effects that are equal up to rounding stay in the file's order.
        let size = |by: f64| by.abs() as f32;
        effects.sort_by(|(_, a), (_, b)| size(*b).total_cmp(&size(*a)));
        effects.retain(|(_, by)| by.abs() > ROUNDING * greatest);
        let each = effects.iter().take(count);
        let each = each.map(|(change, by)| format!("{change} {}", rounded(*by, DIGITS)));
        let each = each.collect::<Vec<_>>().join(", ");
        let unit = format!("{} per {}", at.symbol, self.usual_change().0);
        format!("{}: {each}", unit.trim_start())
    }
}

/// Returns the largest magnitude of the effects.
fn greatest(effects: &[(&str, f64)]) -> f64 {
    let sizes = effects.iter().map(|(_, by)| by.abs());
    sizes.fold(0.0, f64::max)
}
