//! The report of sensitivities as text.

use std::fmt::Write;

use crate::characteristics::{DesignNumber, counted_downwards, refuse_unknown_numbers};
use crate::commands::sensitivities::scatter::{DIGITS, Scatter};
use crate::failure::Failure;
use crate::kinematics::Kinematics;
use crate::mechanism::{Length, Names};
use crate::number::{rounded, without_rounding};
use crate::output::records::{self, Field};
use crate::output::rows::TableTargets;
use crate::quantities::{CAMBER, Quantity, TOE, TOTAL_TOE};
use crate::sensitivities::Sensitivities;

/// Finite differences of constants are smaller than this: rounding.
const ROUNDING: f64 = 1e-9;

pub(super) struct Report<'a> {
    pub(super) file: &'a str,
    pub(super) mechanism: &'a dyn Kinematics,
    pub(super) found: &'a Sensitivities,
    pub(super) scatter: Option<Scatter>,
}

impl Report<'_> {
    /// Returns all numbers that have a value at the design position.
    pub(super) fn numbers(&self) -> impl Iterator<Item = DesignNumber> {
        let all = DesignNumber::all(self.mechanism, &self.found.columns);
        all.filter(move |at| self.found.values[at.column][at.number].is_finite())
    }

    /// Refuses a name that begins no number's name, or only names of numbers without a value.
    ///
    /// # Errors
    ///
    /// A sentence with the names that there are.
    pub(super) fn check(&self, of: &[String]) -> Result<(), String> {
        let known: Vec<DesignNumber> = self.numbers().collect();
        let all = DesignNumber::all(self.mechanism, &self.found.columns);
        let all: Vec<DesignNumber> = all.collect();
        let words = [
            ", and so no sensitivities",
            "Without --of all quantities are printed",
        ];
        refuse_unknown_numbers(of, [&known, &all], self.mechanism, words)
    }

    /// Returns the largest sensitivities of the numbers whose names begin with one of `of`, or of all numbers if `of` is
    /// empty.
    pub(super) fn text(&self, of: &[String], largest: usize) -> String {
        let (per, _) = self.usual_change();
        let axes = self.mechanism.axes.in_words();
        let downwards = counted_downwards(self.mechanism);
        let downwards = downwards.map_or_else(String::new, |note| format!(". {note}"));
        let shown = match largest < self.found.each.len() {
            true => format!(" (the {largest} with the largest effect, see --largest)"),
            false => String::new(),
        };
        let is_wanted = |number: &DesignNumber| of.is_empty() || number.is_one_of(of);
        let numbers: Vec<DesignNumber> = self.numbers().filter(is_wanted).collect();
        let mut out = format!(
            "{}: per {per} of each hardpoint coordinate and link length{shown}; axes of {axes}{downwards}\n{}{}",
            self.file,
            self.tie_rod_note(&numbers),
            self.spin_axis_note(&numbers)
        );
        let (zero, others): (Vec<DesignNumber>, Vec<DesignNumber>) = numbers
            .into_iter()
            .partition(|number| self.stays_zero(number));
        for number in others {
            let value = self.value(&number);
            let (title, symbol) = (&number.title, &number.symbol);
            // Writing into a string cannot fail.
            let _ = writeln!(out, "\n{title}: {} {symbol}", rounded(value, DIGITS));
            let _ = writeln!(out, "  {}", self.largest(&number, largest));
            if let Some(scatter) = &self.scatter {
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

    /// Writes a record for each change, and for each deviation, with all numbers in the units of the file.
    pub(super) fn write(&self, tables: &TableTargets) -> Result<(), Failure> {
        let numbers: Vec<DesignNumber> = self.numbers().collect();
        let record = |name: &str, of: &dyn Fn(&DesignNumber) -> f64| {
            let numbers = numbers.iter().map(|at| Field::Number(Some(of(at))));
            let name = Field::Text(name.to_owned());
            [name].into_iter().chain(numbers).collect()
        };
        let changes = self.found.each.iter().map(|each| {
            record(&each.change.name, &|at| {
                each.of[(at.column, at.number)] * at.in_file
            })
        });
        let scatter = self.scatter.iter().flat_map(Scatter::rows);
        let scatter = scatter.map(|(name, deviations)| {
            record(name, &|at| {
                deviations[at.column][at.number] * at.in_file.abs()
            })
        });
        let records: Vec<Vec<Field>> = changes.chain(scatter).collect();
        let names = numbers.iter().map(|number| number.csv_name.as_str());
        let names: Vec<&str> = ["changed"].into_iter().chain(names).collect();
        records::write(tables, &(), &names, &records)
    }

    /// Says why moving an end of a tie rod does not change the toe at the design position; empty if `numbers` has no toe or
    /// the linkage has no such rod.
    fn tie_rod_note(&self, numbers: &[DesignNumber]) -> String {
        const NAMES: [&str; 3] = ["tie_rod", "track_rod", "toe_link"];
        let changes = self.found.each.iter();
        let mut links = changes.filter_map(|each| each.change.name.strip_prefix("length "));
        let rod = links.find(|link| NAMES.iter().any(|name| link.contains(name)));
        let rod = rod.filter(|_| self.has(numbers, &[&TOE, &TOTAL_TOE]));
        rod.map_or_else(String::new, |rod| {
            format!(
                "A point is moved with its links built anew to it: an end of `{rod}` changes slopes, as bump steer, and not the toe at the \
                 design position, which `length {rod}` does.\n"
            )
        })
    }

    /// Says what a move of a spin axis' inner point is if that is a marker and no joint; empty if `numbers` has no angle of the
    /// wheel.
    fn spin_axis_note(&self, numbers: &[DesignNumber]) -> String {
        let Names { points, wheels, .. } = &self.mechanism.names;
        let markers = self.mechanism.names.markers();
        let mut axes = wheels
            .iter()
            .map(|wheel| wheel.points.axis.map(|end| &points[end]));
        let axis = axes.find(|[inner, _]| markers.contains(inner));
        let axis = axis.filter(|_| self.has(numbers, &[&CAMBER, &TOE, &TOTAL_TOE]));
        axis.map_or_else(String::new, |[inner, centre]| {
            format!(
                "`{inner}` is no joint, it states the spin axis: moving it or `{centre}` alone sets another camber or toe at the design \
                 position, as a shim does.\n"
            )
        })
    }

    /// Returns whether one of these quantities is among the numbers.
    fn has(&self, numbers: &[DesignNumber], quantities: &[&Quantity]) -> bool {
        let mut columns = numbers
            .iter()
            .map(|number| &self.found.columns[number.column]);
        columns.any(|column| quantities.iter().any(|quantity| column.is(quantity)))
    }

    /// Returns the usual change of a hardpoint in words, and its length in the file's unit.
    fn usual_change(&self) -> (&'static str, f64) {
        match self.mechanism.unit.length {
            Length::Metre => ("mm", 1e-3),
            other => (other.symbol(), 1.0),
        }
    }

    fn value(&self, at: &DesignNumber) -> f64 {
        without_rounding(self.found.values[at.column][at.number] * at.scale)
    }

    /// Returns the finite effects of all changes on a number.
    fn effects(&self, at: &DesignNumber) -> Vec<(&str, f64)> {
        let scale = at.scale * self.usual_change().1;
        let each = self.found.each.iter();
        let each = each.map(|each| (&*each.change.name, each.of[(at.column, at.number)] * scale));
        each.filter(|(_, by)| by.is_finite()).collect()
    }

    /// Returns whether a number is zero, no change affects it, and it does not scatter.
    fn stays_zero(&self, at: &DesignNumber) -> bool {
        let effects = self.effects(at);
        let is_known = effects.is_empty() == self.found.each.is_empty();
        let is_unchanged = is_known && greatest(&effects) < ROUNDING;
        let scatters = self.scatter.as_ref();
        let scatters = scatters.is_some_and(|scatter| scatter.changes(at));
        self.value(at) == 0.0 && is_unchanged && !scatters
    }

    fn largest(&self, at: &DesignNumber, count: usize) -> String {
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
