//! Baked curves as TOML.

use std::fmt::Write;

use crate::bake::scheme::TERMS;
use crate::bake::source::about::commented;
use crate::bake::source::curve::CurveFile;

pub(super) fn text(file: &CurveFile<'_>) -> String {
    let mut text = commented("#", &file.header());
    let reached = file.baked.reached;
    let [from, to] = file.baked.wanted.range;
    let argument = file.argument;
    let in_place_of = argument.in_place_of.iter();
    let in_place_of: String = in_place_of
        .map(|replaced| format!("in_place_of = {:?}\n", replaced.drive))
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
        name = file.titled.name,
        linkage = file.titled.about.linkage,
        kind = argument.kind(),
        name_of = argument.name,
        unit_of = argument.unit,
        unit = file.titled.about.unit.symbol(),
        tolerance = file.baked.wanted.tolerance,
        per_unit = file.baked.segments_per_unit(),
        outputs = file.titled.outputs,
        segments = file.coefficients(["[", "]"]),
    );
    text
}
