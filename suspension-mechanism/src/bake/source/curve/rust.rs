//! Baked curves as Rust.

use crate::bake::source::curve::CurveFile;
use crate::bake::source::rust::module;

pub(super) fn text(file: &CurveFile<'_>) -> String {
    let [from, to] = file.baked.wanted.range;
    let per_unit = file.baked.segments_per_unit();
    let segments = file.coefficients(["[", "]"]);
    let fields = format!(
        "    range: [{from:?}, {to:?}],
    segments_per_unit: {per_unit:?},
    segments: &[
{segments}    ],
"
    );
    module(&file.titled, &file.header(), "Curve", &fields)
}
