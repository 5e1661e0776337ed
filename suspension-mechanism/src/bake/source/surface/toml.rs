//! Baked surfaces as TOML.

use std::fmt::Write;

use crate::bake::scheme::TERMS;
use crate::bake::source::about::commented;
use crate::bake::source::surface::SurfaceFile;

pub(super) fn text(file: &SurfaceFile<'_>) -> String {
    let mut text = commented("#", &file.header());
    let drives = &file.titled.about.arguments;
    let names: Vec<&str> = drives.iter().map(|drive| drive.name.as_str()).collect();
    let units: Vec<&str> = drives.iter().map(|drive| &*drive.unit).collect();
    let _ = write!(
        text,
        "
name = {name:?}
linkage = {linkage:?}
drives = {names:?}
drive_units = {units:?}
unit = {unit:?}
ranges = {ranges:?}
tolerance = {tolerance:?}
reached = {{ position = {position:?}, first = {first:?} }}
patches_per_unit = {per_unit:?}
across = {across}
terms = {TERMS}
outputs = {outputs:?}
# By patch, those along the second drive side by side; by power of the first drive, of the second, and output,
# constants first. The variables of a patch run from 0 to 1.
patches = [
{patches}]
",
        name = file.titled.name,
        linkage = file.titled.about.linkage,
        unit = file.titled.about.unit.symbol(),
        ranges = file.baked.wanted.ranges,
        tolerance = file.baked.wanted.tolerance,
        position = file.baked.reached.position,
        first = file.baked.reached.first,
        per_unit = file.baked.patches_per_unit(),
        across = file.baked.counts[1],
        outputs = file.titled.outputs,
        patches = file.coefficients(["[", "]"]),
    );
    text
}
