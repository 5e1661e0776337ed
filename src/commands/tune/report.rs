//! The report of tuning as text: the moves and the results.

use crate::mechanism::{Description, listed};
use crate::number::{counted, number, rounded};
use crate::output::text_table::{TextColumn, laid_out};
use crate::tune::{Deviations, Move, Target, Tuned, Wanted};

/// Digits of moves and of deviations from targets.
const DIGITS: usize = 4;

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
        let moves = self.moves.iter().zip(&self.tuned.moved).enumerate();
        let moves = moves.map(|(index, (each, by))| {
            let [least, greatest] = each.by.map(number);
            let end = if self.is_at_end(index) {
                ", at its end"
            } else {
                ""
            };
            let rest = format!("{unit}, box from {least} to {greatest} {unit}{end}");
            (each.name.clone(), rounded(*by, DIGITS), rest)
        });
        let targets = self.targets.iter().zip(&self.tuned.targets);
        let targets = targets.map(|(target, [before, after])| self.line(target, before, after));
        let moves = table(["move", "by"], &moves.collect::<Vec<_>>());
        let targets = table(["target", "off by at most"], &targets.collect::<Vec<_>>());
        let (file, outcome) = (self.file, self.outcome());
        format!("{file}: {outcome}\n\n{moves}\n{targets}\n")
    }

    /// Says how many targets are met.
    fn outcome(&self) -> String {
        let all = counted(self.targets.len(), "target");
        match self.unmet_targets().len() {
            0 => format!("tuned, {all} met"),
            unmet => format!("{unmet} of {all} not met"),
        }
    }

    fn unmet_targets(&self) -> Vec<&str> {
        let targets = self.targets.iter().zip(&self.tuned.targets);
        let unmet = targets.filter(|(target, [_, after])| !target.is_met_by(after));
        unmet.map(|(target, _)| target.name.as_str()).collect()
    }

    fn line(
        &self,
        target: &Target,
        before: &Deviations,
        after: &Deviations,
    ) -> (String, String, String) {
        let (scale, symbol) = target.reading.display_scale(self.mechanism);
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

    /// Whether a move that changes a target ends at an end of its box: one that changes none stays where it began.
    fn is_at_end(&self, index: usize) -> bool {
        let (by, [least, greatest]) = (self.tuned.moved[index], self.moves[index].by);
        !self.tuned.idle.contains(&index) && (by <= least || by >= greatest)
    }

    /// Names the points that did not follow their moves.
    pub(super) fn held(&self) -> Option<String> {
        let names = &self.mechanism.names.points;
        let held = self.tuned.held.iter();
        let held: Vec<String> = held.map(|point| format!("`{}`", names[*point])).collect();
        (!held.is_empty()).then(|| {
            format!(
                "{} did not go where the moves say: the design is assembled again, and the statement that holds a point, for \
                 example the line of a slide, stays where it was; move its points too",
                held.join(", ")
            )
        })
    }

    /// Names the moves that change no target.
    pub(super) fn idle(&self) -> Option<String> {
        let idle = self.tuned.idle.iter();
        let idle: Vec<String> = idle
            .map(|each| format!("`{}`", self.moves[*each].name))
            .collect();
        let change = match idle.as_slice() {
            [] => return None,
            [_] => "changes",
            _ => "change",
        };
        Some(format!(
            "{} {change} no target: a move that does nothing may be left out",
            idle.join(", ")
        ))
    }

    /// Names the targets that are not met, and why: no move changes them, or boxes may have stopped the moves.
    pub(super) fn unmet(&self) -> Option<String> {
        let unmet = self.unmet_targets();
        if unmet.is_empty() {
            return None;
        }
        let ends = (0..self.moves.len()).filter(|each| self.is_at_end(*each));
        let ends: Vec<&str> = ends.map(|each| self.moves[each].name.as_str()).collect();
        let unaffected = self.tuned.unaffected.iter();
        let unaffected = unaffected.map(|target| self.targets[*target].name.as_str());
        let unaffected: Vec<&str> = unaffected.filter(|name| unmet.contains(name)).collect();
        let mut others = unmet.clone();
        others.retain(|name| !unaffected.contains(name));
        let reasons = [
            (!unaffected.is_empty()).then(|| {
                let names = unaffected.join(", ");
                format!("no move changes {names}: move points, or lengths, that do")
            }),
            (!ends.is_empty()).then(|| format!("at the end of their boxes: {}", ends.join(", "))),
            (ends.is_empty() && !others.is_empty()).then(|| {
                let names = listed(others.iter().map(|name| (*name).to_owned()));
                format!("no move is at the end of its box: more moves or others are needed for {names}, or targets contradict each other")
            }),
        ];
        let reasons: Vec<String> = reasons.into_iter().flatten().collect();
        Some(format!(
            "not met: {}; {}",
            unmet.join(", "),
            reasons.join("; ")
        ))
    }
}

fn greatest(off: &Deviations) -> f64 {
    off.iter().fold(0.0, |most, off| f64::max(most, off.abs()))
}

/// Lays out names, aligned numbers, and the text after them.
fn table([what, heading]: [&str; 2], lines: &[(String, String, String)]) -> String {
    let names = TextColumn::left(lines.iter().map(|(name, ..)| name));
    let numbers = TextColumn::numbers(lines.iter().map(|(_, number, _)| number.clone()));
    let rest = TextColumn::left(lines.iter().map(|(.., rest)| rest));
    let numbers = numbers.joined(" ", rest).headed(heading);
    laid_out(0, [names.headed(what), numbers])
}
