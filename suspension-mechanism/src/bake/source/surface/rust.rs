//! Baked surfaces as Rust.

use crate::bake::source::rust::module;
use crate::bake::source::surface::Sheet;

pub(super) fn text(sheet: &Sheet<'_>) -> String {
    let ranges = sheet.baked.wanted.ranges;
    let per_unit = sheet.baked.patches_per_unit();
    let [_, across] = sheet.baked.counts;
    let patches = sheet.coefficients(["[", "]"]);
    let fields = format!(
        "    ranges: {ranges:?},
    patches_per_unit: {per_unit:?},
    across: {across},
    patches: &[
{patches}    ],
"
    );
    module(&sheet.titled, &sheet.header(), "Surface", &fields)
}
