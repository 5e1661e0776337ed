//! Baked curves as Rust.

use crate::bake::source::curve::Sheet;
use crate::bake::source::rust::module;

pub(super) fn text(sheet: &Sheet<'_>) -> String {
    let [from, to] = sheet.baked.wanted.range;
    let per_unit = sheet.baked.segments_per_unit();
    let segments = sheet.coefficients(["[", "]"]);
    let fields = format!(
        "    range: [{from:?}, {to:?}],
    segments_per_unit: {per_unit:?},
    segments: &[
{segments}    ],
"
    );
    module(&sheet.titled, &sheet.header(), "Curve", &fields)
}
