//! Baked surfaces as TOML.

use std::fmt::Write;

use crate::bake::scheme::TERMS;
use crate::bake::source::about::commented;
use crate::bake::source::surface::Sheet;

pub(super) fn text(sheet: &Sheet<'_>) -> String {
    let mut text = commented("#", &sheet.header());
    let drives = &sheet.titled.about.arguments;
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
reached = {reached:?}
patches_per_unit = {per_unit:?}
across = {across}
terms = {TERMS}
outputs = {outputs:?}
# By patch, those along the second drive side by side; by power of the first drive, of the second, and output,
# constants first. The variables of a patch run from 0 to 1.
patches = [
{patches}]
",
        name = sheet.titled.name,
        linkage = sheet.titled.about.linkage,
        unit = sheet.titled.about.unit,
        ranges = sheet.baked.wanted.ranges,
        tolerance = sheet.baked.wanted.tolerance,
        reached = sheet.baked.reached,
        per_unit = sheet.baked.patches_per_unit(),
        across = sheet.baked.counts[1],
        outputs = sheet.titled.outputs,
        patches = sheet.coefficients(["[", "]"]),
    );
    text
}
