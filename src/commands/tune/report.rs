//! What was moved and what was reached, for people.

use std::fmt::Write;

use crate::mechanism::Description;
use crate::number::{aligned, counted, number, rounded};
use crate::tune::{Deviations, Move, Target, Tuned, Wanted};

/// Digits of moves and of what targets are off.
const DIGITS: usize = 4;

/// What the text is about.
pub(super) struct Report<'a> {
    pub(super) file: &'a str,
    pub(super) mechanism: &'a Description,
    pub(super) moves: &'a [Move],
    pub(super) targets: &'a [Target],
    pub(super) tuned: &'a Tuned,
}

impl Report<'_> {
    pub(super) fn text(&self) -> String {
        let unit = self.mechanism.unit.symbol();
        let moves = self.moves.iter().zip(&self.tuned.moved);
        let moves = moves.map(|(each, by)| {
            let [least, greatest] = each.by.map(number);
            let end = if at_end(each, *by) {
                ", at its end"
            } else {
                ""
            };
            let rest = format!("{unit}, box from {least} to {greatest} {unit}{end}");
            (each.name.clone(), rounded(*by, DIGITS), rest)
        });
        let targets = self.targets.iter().zip(&self.tuned.targets);
        let targets = targets.map(|(target, [before, after])| self.line(target, before, after));
        let mut out = format!("{}: {}\n\n", self.file, self.outcome());
        table(&mut out, "move", "by", moves.collect());
        table(&mut out, "target", "off by at most", targets.collect());
        out
    }

    /// How many targets are met.
    fn outcome(&self) -> String {
        let targets = self.targets.iter().zip(&self.tuned.targets);
        let unmet = targets.filter(|(target, [_, after])| !target.is_met_by(after));
        let (unmet, all) = (unmet.count(), counted(self.targets.len(), "target"));
        match unmet {
            0 => format!("tuned, {all} met"),
            unmet => format!("not tuned, {unmet} of {all} not met"),
        }
    }

    fn line(
        &self,
        target: &Target,
        before: &Deviations,
        after: &Deviations,
    ) -> (String, String, String) {
        let (scale, symbol) = target.reading.for_people(self.mechanism);
        let [was, is] = [before, after].map(|off| rounded(greatest(off) * scale, DIGITS));
        let within = rounded(target.within * scale, DIGITS);
        let met = if target.is_met_by(after) {
            "met"
        } else {
            "not met"
        };
        let what = target.reading.title(self.mechanism);
        let what = match target.wanted {
            Wanted::Values(_) => what,
            Wanted::Changes(_) => format!("change of {what}"),
        };
        let rest = format!("{symbol}, {was} before, within {within}: {met} ({what})");
        (target.name.clone(), is, rest)
    }

    /// The points that did not go with their moves.
    pub(super) fn held(&self) -> Option<String> {
        let names = &self.mechanism.names.points;
        let held = self.tuned.held.iter();
        let held: Vec<String> = held.map(|point| format!("`{}`", names[*point])).collect();
        (!held.is_empty()).then(|| {
            format!(
                "note: {} did not go where the moves say: the design is assembled again, and what holds a point, the line of a \
                 slide say, stays; move that with it",
                held.join(", ")
            )
        })
    }

    /// The targets that are not met, and the boxes that may have stopped them.
    pub(super) fn unmet(&self) -> Option<String> {
        let targets = self.targets.iter().zip(&self.tuned.targets);
        let unmet = targets.filter(|(target, [_, after])| !target.is_met_by(after));
        let unmet: Vec<&str> = unmet.map(|(target, _)| target.name.as_str()).collect();
        if unmet.is_empty() {
            return None;
        }
        let moves = self.moves.iter().zip(&self.tuned.moved);
        let ends = moves.filter(|(each, by)| at_end(each, **by));
        let ends: Vec<&str> = ends.map(|(each, _)| each.name.as_str()).collect();
        let (unmet, ends) = (unmet.join(", "), ends.join(", "));
        Some(if ends.is_empty() {
            format!("not met: {unmet}; no box stops the moves: other ones, or more, are needed")
        } else {
            format!("not met: {unmet}; at the end of their boxes: {ends}")
        })
    }
}

fn at_end(each: &Move, by: f64) -> bool {
    by <= each.by[0] || by >= each.by[1]
}

fn greatest(off: &Deviations) -> f64 {
    off.iter().fold(0.0, |most, off| f64::max(most, off.abs()))
}

/// Names, numbers below each other, and what stands behind.
fn table(out: &mut String, what: &str, heading: &str, lines: Vec<(String, String, String)>) {
    let names = lines.iter().map(|(name, ..)| name.len());
    let width = names.chain([what.len()]).max().unwrap_or(0);
    let numbers = lines.iter().map(|(_, number, _)| number.clone());
    let numbers = aligned(numbers.collect(), [' ', ' ']);
    // Writing into a string has no way to fail.
    let _ = writeln!(out, "{what:width$}  {heading}");
    for ((name, _, rest), number) in lines.iter().zip(numbers) {
        let _ = writeln!(out, "{name:width$}  {number} {rest}");
    }
    out.push('\n');
}
