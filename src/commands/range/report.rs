//! The report of the drives' ranges as text.

use std::fmt::Write;

use suspension_core::listing::DriveKind;

use crate::mechanism::{Description, Unit, describe_change_from_design};
use crate::number::{counted, rounded};
use crate::reach::{
    CARRIED_ON, DriveRange, POOR, RangeEnd, holds, is_continued, meeting, moves_alone,
};

/// Digits of an end of a range in radians and of the instant of a lock: all that are correct.
const DIGITS: usize = 13;
/// Digits of an end of a range in degrees or a unit of length; --csv has all.
const FEWER: usize = 7;

pub(super) fn text(mechanism: &Description, ranges: &[DriveRange]) -> String {
    let mut out = format!(
        "Linkage {}, axes of {}\n",
        mechanism.linkage,
        mechanism.axes.in_words()
    );
    let unit = mechanism.unit;
    let start = if mechanism.drives_in_file(mechanism.first_drives()) == mechanism.design {
        "the design position"
    } else {
        "the first instant"
    };
    for range in ranges {
        let in_words = |value| value_in_words(range.kind, unit, value, DIGITS);
        let [lower, upper] = range.ends.each_ref().map(|end| {
            let change = change(mechanism, range, end);
            let limit = end.limit.in_words(unit);
            format!("{}, {change}: {limit}", in_words(end.value))
        });
        let _ = writeln!(
            out,
            "\nDrive {}, from {} at {start}, the other drives held as there\n  \
             lower end   {lower}\n  upper end   {upper}",
            range.name,
            in_words(range.start),
        );
        let _ = writeln!(out, "  motion      {}", motion(mechanism, range));
        let _ = writeln!(out, "  poor        {}", poor(range, unit));
        let _ = writeln!(out, "  curve       {}", curve(range, unit));
    }
    out
}

/// How far an end is from the design position, as `check` counts it.
fn change(mechanism: &Description, range: &DriveRange, end: &RangeEnd) -> String {
    let change = end.value - mechanism.design[range.index];
    describe_change_from_design(change, range.kind, mechanism.unit)
}

fn value_in_words(kind: DriveKind, unit: Unit, value: f64, digits: usize) -> String {
    match kind {
        DriveKind::Angle | DriveKind::Turn => format!(
            "{} deg ({} rad)",
            rounded(value.to_degrees(), digits.min(FEWER)),
            rounded(value, digits)
        ),
        DriveKind::Coordinate => {
            format!("{} {}", rounded(value, digits.min(FEWER)), unit.symbol())
        }
    }
}

/// Says when the file's motion reaches the end of the range.
fn motion(mechanism: &Description, range: &DriveRange) -> String {
    if mechanism.out_of_reach.is_some() {
        return "the file's motion begins out of reach".to_owned();
    }
    let ends = [range.ends[0].value, range.ends[1].value];
    let [first, last] = mechanism.instants.ends();
    match meeting(mechanism, range.index, ends) {
        Some((t, end)) => {
            let end = ["lower", "upper"][end];
            let is_later = (t - first).abs() > (last - first).abs();
            let t = rounded(t, DIGITS);
            if is_later {
                let last = rounded(last, DIGITS);
                format!(
                    "the file's motion stays in the range until its last instant, {last} s; continued, it would reach the {end} end at t = {t} s"
                )
            } else {
                format!("the file's motion reaches the {end} end at t = {t} s")
            }
        }
        None if mechanism.led_by.is_some() => {
            "the file's motion is led by a measure: its end is not looked for".to_owned()
        }
        None if holds(mechanism, range.index) => "the file's motion holds this drive".to_owned(),
        None if !moves_alone(mechanism, range.index) => {
            "the file's motion moves other drives as well, so that this range does not tell where it ends; `suspension motion` does"
                .to_owned()
        }
        None if is_continued(mechanism) => format!(
            "the file's motion, continued to {CARRIED_ON} times its duration, brings this drive to \
             neither end"
        ),
        None => "the file's motion brings this drive to neither end; it is not continued beyond a recording".to_owned(),
    }
}

fn poor(range: &DriveRange, unit: Unit) -> String {
    let intervals = range.poor();
    let what = format!(
        "the points move more than {POOR} times as far per unit of the drive as where they move \
         least"
    );
    if intervals.is_empty() {
        return format!("nowhere: {what}");
    }
    let each = intervals.iter().map(|ends| {
        let [low, high] = ends.map(|end| value_in_words(range.kind, unit, end, 5));
        format!("{low} to {high}")
    });
    let each: Vec<String> = each.collect();
    format!("{}: {what}", each.join(", "))
}

fn curve(range: &DriveRange, unit: Unit) -> String {
    let turns = counted(range.turns, "turning point");
    match range.gap {
        Some(gap) => format!(
            "closed to {} {}, with {turns} of the drive",
            rounded(gap, 2),
            unit.symbol()
        ),
        None => format!("open, with {turns} of the drive"),
    }
}
