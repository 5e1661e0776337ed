//! Baked surfaces as Rust.

use crate::bake::source::rust::module;
use crate::bake::source::surface::SurfaceFile;

pub(super) fn text(file: &SurfaceFile<'_>) -> String {
    let ranges = file.baked.wanted.ranges;
    let per_unit = file.baked.patches_per_unit();
    let [_, across] = file.baked.counts;
    let patches = file.coefficients(["[", "]"]);
    let fields = format!(
        "    ranges: {ranges:?},
    patches_per_unit: {per_unit:?},
    across: {across},
    patches: &[
{patches}    ],
"
    );
    module(&file.titled, &file.header(), "Surface", &fields)
}
