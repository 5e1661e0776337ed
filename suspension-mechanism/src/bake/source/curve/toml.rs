//! As TOML.

use std::fmt::Write;

use crate::bake::scheme::TERMS;
use crate::bake::source::about::commented;
use crate::bake::source::curve::Sheet;

/// The text of a file.
pub(super) fn text(sheet: &Sheet<'_>, name: &str) -> String {
    let mut text = commented("#", &sheet.header());
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
        linkage = sheet.about.linkage,
        drive = sheet.drive.name,
        drive_unit = sheet.drive.unit,
        unit = sheet.about.unit,
        tolerance = sheet.baked.wanted.tolerance,
        per_unit = sheet.baked.segments_per_unit(),
        outputs = sheet.output_names(),
        segments = sheet.coefficients(["[", "]"]),
    );
    text
}
