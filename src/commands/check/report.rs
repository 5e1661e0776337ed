//! The report of a check as text.

use crate::assemblies::Tally;
use crate::commands::check::condition::Condition;
use crate::file::Dimension;
use crate::mechanism::{Axes, Names, Unit, describe_change_from_design};
use crate::number::rounded;
use crate::output::text_table::{TextColumn, laid_out};
use crate::reach::{DriveRange, RangeEnd};

/// The contents of the report.
pub(super) struct Report<'a> {
    pub(super) file: &'a str,
    pub(super) linkage: &'a str,
    pub(super) names: &'a Names,
    pub(super) unit: Unit,
    pub(super) axes: Axes,
    pub(super) design: &'a [f64],
    pub(super) condition: Condition,
    pub(super) ranges: Vec<DriveRange>,
    /// Whether the file's own motion is within reach, in words.
    pub(super) motion: Option<String>,
    pub(super) notes: &'a [String],
}

/// The widest heading that is not the name of a drive.
const CONDITIONING: &str = "conditioning";

/// Digits of residuals, pivots and singular values.
const DIGITS: usize = 3;

/// Digits of a drive's value where it ends.
const DIGITS_OF_END: usize = 4;

impl Report<'_> {
    /// Returns the report as text.
    pub(super) fn text(&self) -> String {
        let Self { names, unit, .. } = self;
        let symbol = unit.symbol();
        let residual = rounded(self.condition.residual, DIGITS);
        let mut lines = vec![
            ("points".to_owned(), self.points()),
            ("equations".to_owned(), self.equations()),
            ("freedom".to_owned(), self.freedom()),
            (
                "design".to_owned(),
                names.drives_in_words(self.design, *unit, None),
            ),
            (
                "residual".to_owned(),
                format!("{residual} {symbol}: the design assembles"),
            ),
            ("rank".to_owned(), self.rank()),
            (CONDITIONING.to_owned(), self.conditioning()),
            ("elimination".to_owned(), self.elimination()),
        ];
        if !self.ranges.is_empty() {
            let from = "of each drive from the design position, the other drives held there; `suspension range` starts from the first instant";
            lines.push(("reach".to_owned(), from.to_owned()));
            lines.extend(self.ranges.iter().flat_map(|range| self.reach(range)));
        }
        let motion = self.motion.iter();
        lines.extend(motion.map(|motion| ("motion".to_owned(), motion.clone())));
        let none = [("notes".to_owned(), "none".to_owned())];
        let notes = self
            .notes
            .iter()
            .map(|note| ("note".to_owned(), note.clone()));
        let notes: Vec<_> = notes.collect();
        lines.extend(if notes.is_empty() { none.into() } else { notes });
        let (what, text): (Vec<_>, Vec<_>) = lines.into_iter().unzip();
        format!(
            "{}: {}, lengths in {symbol}, axes of {}\n\n{}",
            self.file,
            self.linkage,
            self.axes.in_words(),
            laid_out(0, [TextColumn::left(what), TextColumn::left(text)])
        )
    }

    /// Returns the line of the assemblies, which stands below the others.
    pub(super) fn assemblies(&self, tally: &Tally) -> String {
        let names = self.ranges.iter().map(|range| range.name.as_str());
        let headings = names.chain([CONDITIONING]).map(|name| name.chars().count());
        let width = headings.max().unwrap_or_default();
        let doubts = match tally.doubts().as_slice() {
            [] => "the search shows no sign of more".to_owned(),
            doubts => format!("there may be more ({})", doubts.join("; ")),
        };
        format!(
            "{:width$}  {} ways to put the same parts together at the design; {doubts}\n",
            "assemblies", tally.real
        )
    }

    fn points(&self) -> String {
        let Names { chassis, free, .. } = self.names;
        let markers = self.names.markers().len();
        format!("{chassis} on the chassis, {free} free, {markers} carried by bodies")
    }

    fn equations(&self) -> String {
        let Names {
            equations,
            unknowns,
            ..
        } = self.names;
        let drives = self.names.drive_names();
        let of_drives = equations
            .iter()
            .filter(|name| drives.contains(&name.as_str()));
        let of_drives = of_drives.count();
        let others = match drives.len() - of_drives {
            0 => "",
            _ => "; a drive of a chassis point adds none",
        };
        format!(
            "{} for {} unknowns, {of_drives} of them of drives{others}",
            equations.len(),
            unknowns.len(),
        )
    }

    fn freedom(&self) -> String {
        let drives = self.names.drive_names();
        let left = self.names.unknowns.len() - self.condition.rank;
        let left = match left {
            0 => String::new(),
            left => format!("; {left} more that no drive leads"),
        };
        format!(
            "{} led by drives: {}{left}",
            drives.len(),
            drives.join(", ")
        )
    }

    fn rank(&self) -> String {
        let Condition {
            rank,
            redundant,
            undetermined,
            ..
        } = &self.condition;
        let count = self.names.unknowns.len();
        if undetermined.is_empty() {
            return format!(
                "{rank} of {count}: no equation is redundant, all unknowns are determined"
            );
        }
        format!(
            "{rank} of {count}: one of these equations is redundant: {}; these unknowns are not determined: {}",
            redundant.join(", "),
            undetermined.join(", ")
        )
    }

    fn conditioning(&self) -> String {
        let [smallest, largest] = self.condition.singular_values;
        format!(
            "smallest singular value {}, largest {}, without a unit: equations and unknowns are lengths",
            rounded(smallest, DIGITS),
            rounded(largest, DIGITS)
        )
    }

    fn elimination(&self) -> String {
        let Condition { elimination, .. } = &self.condition;
        let Names {
            equations,
            unknowns,
            ..
        } = self.names;
        let health = if elimination.growth < elimination.allowed {
            let growth = rounded(elimination.growth, DIGITS);
            let allowed = rounded(elimination.allowed, DIGITS + 1);
            format!(
                "pivot growth {growth}: elimination magnifies rounding errors at most {growth} times, which is good up to {allowed}; above that \
                 a step changes to partial pivoting and takes longer"
            )
        } else {
            "partial pivoting takes the place of the fixed order at this position; a step takes longer".to_owned()
        };
        format!(
            "smallest pivot {} of equation `{}` and unknown `{}`; {health}",
            rounded(elimination.pivot, DIGITS),
            equations[elimination.equation],
            unknowns[elimination.unknown],
        )
    }

    /// Returns the ends of a drive's range and what limits each.
    fn reach(&self, range: &DriveRange) -> [(String, String); 2] {
        let dimension = Dimension::from(range.kind);
        let (symbol, scale) = (
            dimension.symbol(self.unit),
            dimension.file_factor(self.unit),
        );
        let end = |what: &str, end: &RangeEnd| {
            let change = describe_change_from_design((end.value - range.start) * scale, &symbol);
            let value = rounded(end.value * scale, DIGITS_OF_END);
            let limit = end.limit.in_words(self.unit);
            let end = format!("ends at {value} {symbol}, {change}: {limit}");
            (what.to_owned(), end)
        };
        let [lower, upper] = &range.ends;
        [end(&range.name, lower), end("", upper)]
    }
}
