//! The text of a motion file with changed points; everything else stays as written.

use std::ops::Range;

use nalgebra::Vector3;
use toml::Spanned;

use crate::file::{Dimension, MotionFile, Offset, Position, Recording, Source, StatedLaw};
use crate::mechanism::{Description, Drive};
use crate::number::exact;
use crate::prepare::Loaded;
use crate::tune::Tuned;

/// Changes of coordinates up to this size are rounding, in the unit of the file.
pub(super) const ROUNDING: f64 = 1e-9;

/// Decimals of written coordinates.
const DECIMALS: usize = 9;

/// Returns the text with the points and drives that were found, a marker with an offset with its new one. It also writes a
/// point whose stated coordinates differ from its assembled ones: from another start the others might assemble elsewhere.
pub(super) fn rewritten(
    source: &Source,
    file: &MotionFile,
    loaded: &Loaded<'_>,
    mechanism: &Description,
    tuned: &Tuned,
) -> String {
    let mut edits = Vec::new();
    let mut added = Vec::new();
    let names = &mechanism.names.points;
    let found = |name: &str| names.iter().position(|other| other == name);
    for (name, point) in names.iter().zip(&tuned.points) {
        let (before, after) = match loaded.stated_position(name) {
            Some(Position::At(at)) => (at, *point),
            Some(Position::Off(Offset { from, offset })) => {
                let Some(from) = found(from.get_ref()) else {
                    continue;
                };
                (offset.get_ref(), point - tuned.points[from])
            }
            None => continue,
        };
        if (after - Vector3::from(*before)).amax() < ROUNDING {
            continue;
        }
        match file.points.get_ref().get(name.as_str()) {
            Some(stated) => {
                let place = place(stated);
                edits.extend(remark(source.text(), &place));
                edits.push((place, coordinates(&after)));
            }
            None => added.push(format!("{name} = {}", coordinates(&after))),
        }
    }
    edits.extend(drives(source, file, mechanism, &tuned.drives));
    if !added.is_empty() {
        edits.push(addition(source.text(), file, &added));
    }
    edited(source.text(), edits)
}

/// Returns the place of the three numbers of a point's position.
fn place(stated: &Spanned<Position>) -> Range<usize> {
    match stated.get_ref() {
        Position::At(_) => stated.span(),
        Position::Off(Offset { offset, .. }) => offset.span(),
    }
}

/// How the remark on a point that has moved begins.
const MOVED: &str = "moved by tune from";

/// Returns the edit that adds the former position, at `place`, to a comment behind it, such as the one by which `import` says
/// where a point is from. A comment that has a former position keeps it.
fn remark(text: &str, place: &Range<usize>) -> Option<(Range<usize>, String)> {
    let line = &text[place.end..line_end(text, place.end)];
    let (between, comment) = line.split_once('#')?;
    let is_behind = between.chars().all(|c| matches!(c, ' ' | '\t' | '}'));
    let is_said = comment.trim_start().starts_with(MOVED);
    let at = place.end + between.len() + 1;
    let remark = format!(" {MOVED} {};", &text[place.clone()]);
    (is_behind && !is_said).then_some((at..at, remark))
}

fn coordinates(point: &Vector3<f64>) -> String {
    let [x, y, z] = [point.x, point.y, point.z].map(decimal);
    format!("[{x}, {y}, {z}]")
}

/// Formats a number with a decimal point, as TOML requires of floats.
fn decimal(value: f64) -> String {
    let text = format!("{value:.DECIMALS$}");
    let text = text.trim_end_matches('0');
    match text.strip_suffix('.') {
        Some("-0") => "0.0".to_owned(),
        Some(whole) => format!("{whole}.0"),
        None => text.to_owned(),
    }
}

/// Returns edits that shift the initial values of drives by the change of their values at the design position.
fn drives(
    source: &Source,
    file: &MotionFile,
    mechanism: &Description,
    tuned: &[f64],
) -> Vec<(Range<usize>, String)> {
    let edits = shifted(file, mechanism, tuned).filter_map(|(_, law, by)| {
        let (place, first, others) = match law.get_ref() {
            StatedLaw::Recorded(recording) => {
                // Without an offset it stays, as `left_recordings` says.
                let offset = recording.offset.as_ref()?;
                (offset.span(), offset.get_ref(), &[][..])
            }
            StatedLaw::Sine(sine) => (sine.mean.span(), sine.mean.get_ref(), &[][..]),
            StatedLaw::Polynomial(coefficients) => {
                let (first, others) = coefficients.split_first()?;
                (law.span(), first, others)
            }
        };
        let later = decimal(first + by);
        let is_list = source.text()[place.clone()].starts_with('[');
        let text = if is_list {
            let others = others.iter().map(|other| exact(*other));
            let all: Vec<String> = [later].into_iter().chain(others).collect();
            format!("[{}]", all.join(", "))
        } else {
            later
        };
        Some((place, text))
    });
    edits.collect()
}

/// Returns sentences on recordings without an offset whose drives have other values at the design position than before.
pub(super) fn left_recordings(
    file: &MotionFile,
    mechanism: &Description,
    tuned: &[f64],
) -> Vec<String> {
    let each = shifted(file, mechanism, tuned);
    let left = each.filter_map(|(drive, law, by)| {
        let StatedLaw::Recorded(Recording { offset: None, .. }) = law.get_ref() else {
            return None;
        };
        let symbol = Dimension::from(drive.kind).symbol(mechanism.unit);
        let (name, by) = (&drive.name, decimal(by));
        Some(format!(
            "at the design position that was found `{name}` has changed by {by} {symbol}; its recording stays as it is; to shift \
             it, write offset = {by}"
        ))
    });
    left.collect()
}

/// The drives of the file that have other values at the design position than before, each with its law and the change.
fn shifted<'a>(
    file: &'a MotionFile,
    mechanism: &'a Description,
    tuned: &'a [f64],
) -> impl Iterator<Item = (&'a Drive, &'a Spanned<StatedLaw>, f64)> {
    let each = mechanism.names.drives.iter();
    let each = each.zip(mechanism.design.iter().zip(tuned));
    each.filter_map(|(drive, (before, after))| {
        let law = file.drives.get_ref().get(drive.name.as_str())?;
        let by = (after - before) * mechanism.unit.file_factor(drive.kind);
        (by.abs() >= ROUNDING).then_some((drive, law, by))
    })
}

/// Returns the place and the text of points that the file does not state yet, in the form of its table, or in a new table.
fn addition(text: &str, file: &MotionFile, points: &[String]) -> (Range<usize>, String) {
    let newline = if text.contains("\r\n") { "\r\n" } else { "\n" };
    let lines = |before: &str| {
        let lines = points
            .iter()
            .map(|point| format!("{before}{point}{newline}"));
        lines.collect::<String>()
    };
    let table = file.points.span();
    let stated = file.points.get_ref().values();
    let last = stated.map(|point| point.span().end).max();
    let written = &text[table.clone()];
    let (at, new) = match (written.chars().next(), last) {
        (None, _) => (
            text.len(),
            format!("{newline}[points]{newline}{}", lines("")),
        ),
        (Some('{'), Some(last)) => (last, format!(", {}", points.join(", "))),
        (Some('{'), None) => (table.start + 1, format!(" {} ", points.join(", "))),
        (Some('['), last) => (line_end(text, last.unwrap_or(table.end)), lines("")),
        // In dotted keys: `points.ball = [...]`.
        (_, last) => (
            line_end(text, last.unwrap_or(table.end)),
            lines(&format!("{written}.")),
        ),
    };
    let is_behind_all = at == text.len() && !text.ends_with('\n');
    let before = if is_behind_all { newline } else { "" };
    (at..at, format!("{before}{new}"))
}

/// Returns the place where the next line begins.
fn line_end(text: &str, place: usize) -> usize {
    let end = text[place..].find('\n');
    end.map_or(text.len(), |end| place + end + 1)
}

fn edited(text: &str, mut edits: Vec<(Range<usize>, String)>) -> String {
    edits.sort_by_key(|(place, _)| place.start);
    let mut out = String::new();
    let mut done = 0;
    for (place, new) in edits {
        out.push_str(&text[done..place.start]);
        out.push_str(&new);
        done = place.end;
    }
    out.push_str(&text[done..]);
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tuned_coordinates_are_written_as_toml_decimals() {
        for (value, expected) in [
            (0.1 + 0.2, "0.3"),
            (-0.0312, "-0.0312"),
            (250.0, "250.0"),
            (-1e-12, "0.0"),
        ] {
            assert_eq!(decimal(value), expected);
        }
    }

    #[test]
    fn a_comment_behind_a_moved_point_gets_the_former_position() {
        let remarked = |text: &str| {
            let place = text.find('[').expect("a list")..text.find(']').expect("its end") + 1;
            remark(text, &place).map(|edit| edited(text, vec![edit]))
        };
        assert_eq!(
            remarked("a = [1, 2, 3]  # LCA front, h.csv:3\n# b").as_deref(),
            Some("a = [1, 2, 3]  # moved by tune from [1, 2, 3]; LCA front, h.csv:3\n# b")
        );
        assert_eq!(
            remarked("a = { from = \"b\", offset = [0, 1, 2] } # h.csv:3").as_deref(),
            Some(
                "a = { from = \"b\", offset = [0, 1, 2] } # moved by tune from [0, 1, 2]; h.csv:3"
            )
        );
        for unchanged in [
            "a = [1, 2, 3]\n# the next line",
            "a = [1, 2, 3] # moved by tune from [1, 2, 2]; h.csv:3",
            "points = { a = [1, 2, 3], b = [4, 5, 6] } # both",
        ] {
            assert_eq!(remarked(unchanged), None, "{unchanged}");
        }
    }

    #[test]
    fn edits_replace_their_own_ranges_of_the_text() {
        let edits = vec![(7..8, "3".to_owned()), (4..5, "22".to_owned())];
        assert_eq!(edited("a = 1, 2 # b", edits), "a = 22, 3 # b");
    }
}
