//! As TOML.

use std::fmt::Write;

use crate::bake::scheme::TERMS;
use crate::bake::source::Sheet;

/// The text of a file.
pub(super) fn text(sheet: &Sheet, name: &str) -> String {
    let mut text = String::new();
    for line in sheet.header() {
        text += format!("# {line}").trim_end();
        text.push('\n');
    }
    let reached = sheet.baked.reached;
    let [from, to] = sheet.baked.wanted.range;
    let _ = write!(
        text,
        "
name = {name:?}
linkage = {linkage:?}
drive = {drive:?}
drive_unit = {drive_unit:?}
unit = {unit:?}
range = [{from:?}, {to:?}]
tolerance = {tolerance:?}
reached = {{ position = {:?}, first = {:?}, second = {:?} }}
segments_per_unit = {per_unit:?}
terms = {TERMS}
outputs = {outputs:?}
# By segment, power and output, constants first; the variable of a segment runs from 0 to 1.
segments = [
{segments}]
",
        reached.position,
        reached.first,
        reached.second,
        linkage = sheet.linkage,
        drive = sheet.drive,
        drive_unit = sheet.drive_unit,
        unit = sheet.unit,
        tolerance = sheet.baked.wanted.tolerance,
        per_unit = sheet.baked.segments_per_unit(),
        outputs = sheet.output_names(),
        segments = sheet.coefficients(["[", "]"]),
    );
    text
}
