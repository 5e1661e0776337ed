//! Baked curves as TOML.

use std::fmt::Write;

use crate::bake::scheme::TERMS;
use crate::bake::source::about::commented;
use crate::bake::source::curve::Sheet;

pub(super) fn text(sheet: &Sheet<'_>) -> String {
    let mut text = commented("#", &sheet.header());
    let reached = sheet.baked.reached;
    let [from, to] = sheet.baked.wanted.range;
    let argument = sheet.argument;
    let in_place_of = argument.in_place_of.iter();
    let in_place_of: String = in_place_of
        .map(|drive| format!("in_place_of = {drive:?}\n"))
        .collect();
    let _ = write!(
        text,
        "
name = {name:?}
linkage = {linkage:?}
{kind} = {name_of:?}
{kind}_unit = {unit_of:?}
{in_place_of}unit = {unit:?}
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
        name = sheet.titled.name,
        linkage = sheet.titled.about.linkage,
        kind = argument.kind(),
        name_of = argument.name,
        unit_of = argument.unit,
        unit = sheet.titled.about.unit,
        tolerance = sheet.baked.wanted.tolerance,
        per_unit = sheet.baked.segments_per_unit(),
        outputs = sheet.titled.outputs,
        segments = sheet.coefficients(["[", "]"]),
    );
    text
}
