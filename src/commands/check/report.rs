//! The report of a check as text.

use crate::assemblies::Tally;
use crate::commands::check::condition::Condition;
use crate::file::Dimension;
use crate::mechanism::{Description, Names, describe_change_from_design};
use crate::number::{counted, rounded};
use crate::output::text_table::{TextColumn, laid_out};
use crate::reach::{DriveRange, RangeEnd};

pub(super) struct Report<'a> {
    pub(super) file: &'a str,
    pub(super) mechanism: &'a Description,
    pub(super) condition: Condition,
    /// The ranges of the drives, none of a singular design, or why they are not known.
    pub(super) ranges: Result<Vec<DriveRange>, String>,
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
    pub(super) fn text(&self) -> String {
        let Description {
            linkage,
            names,
            unit,
            axes,
            design,
            ..
        } = self.mechanism;
        let symbol = unit.symbol();
        let residual = rounded(self.condition.residual, DIGITS);
        let mut lines = vec![
            ("points", self.points()),
            ("equations", self.equations()),
            ("freedom", self.freedom()),
            ("design", names.drives_in_words(design, *unit, None)),
            (
                "residual",
                format!("{residual} {symbol}: the design assembles"),
            ),
            ("rank", self.rank()),
            (CONDITIONING, self.conditioning()),
            ("elimination", self.elimination()),
        ];
        match &self.ranges {
            Ok(ranges) if ranges.is_empty() => (),
            Ok(ranges) => {
                let from = "of each drive from the design position, the other drives held there; `suspension range` starts from the first instant";
                lines.push(("reach", from.to_owned()));
                lines.extend(ranges.iter().flat_map(|range| self.reach(range)));
            }
            Err(why) => lines.push(("reach", format!("NOT KNOWN: {why}"))),
        }
        lines.extend(self.motion.iter().map(|motion| ("motion", motion.clone())));
        lines.extend(self.notes.iter().map(|note| ("note", note.clone())));
        if self.notes.is_empty() {
            lines.push(("notes", "none".to_owned()));
        }
        let (what, text): (Vec<_>, Vec<_>) = lines.into_iter().unzip();
        format!(
            "{}: {linkage}, lengths in {}, axes of {}\n\n{}",
            self.file,
            unit.length.in_words(),
            axes.in_words(),
            laid_out(0, [TextColumn::left(what), TextColumn::left(text)])
        )
    }

    /// Returns the line of the assemblies, which stands below the others.
    pub(super) fn assemblies(&self, tally: &Tally) -> String {
        let ranges = self.ranges.iter().flatten();
        let names = ranges.map(|range| range.name.as_str());
        let headings = names.chain([CONDITIONING]).map(|name| name.chars().count());
        let width = headings.max().unwrap_or_default();
        let doubts = match tally.doubts().as_slice() {
            [] => "the search shows no sign of more".to_owned(),
            doubts => format!("there may be more ({})", doubts.join("; ")),
        };
        format!(
            "{:width$}  {} to put the same parts together at the design; {doubts}\n",
            "assemblies",
            counted(tally.real, "way")
        )
    }

    fn points(&self) -> String {
        let Names { chassis, free, .. } = &self.mechanism.names;
        let markers = self.mechanism.names.markers().len();
        format!("{chassis} on the chassis, {free} free, {markers} carried by bodies")
    }

    fn equations(&self) -> String {
        let Names {
            equations,
            unknowns,
            ..
        } = &self.mechanism.names;
        let drives = self.mechanism.names.drive_names();
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
        let drives = self.mechanism.names.drive_names();
        let left = self.mechanism.names.unknowns.len() - self.condition.rank;
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
        let count = self.mechanism.names.unknowns.len();
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
        } = &self.mechanism.names;
        let health = if elimination.growth < elimination.allowed {
            let growth = rounded(elimination.growth, DIGITS);
            let allowed = rounded(elimination.allowed, DIGITS + 1);
            format!(
                "pivot growth {growth}: elimination magnifies rounding errors about {growth} times, which is good up to {allowed}; above that \
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
    fn reach<'r>(&self, range: &'r DriveRange) -> [(&'r str, String); 2] {
        let (dimension, unit) = (Dimension::from(range.kind), self.mechanism.unit);
        let (symbol, scale) = (dimension.symbol(unit), unit.file_factor(dimension));
        let end = |what: &'r str, end: &RangeEnd| {
            let change = describe_change_from_design(end.value - range.start, range.kind, unit);
            let value = rounded(end.value * scale, DIGITS_OF_END);
            let limit = end.limit.in_words(unit);
            let end = format!("ends at {value} {symbol}, {change}: {limit}");
            (what, end)
        };
        let [lower, upper] = &range.ends;
        [end(&range.name, lower), end("", upper)]
    }
}
