//! As Rust.

use std::fmt::Write;

use crate::bake::scheme::TERMS;
use crate::bake::source::about::commented;
use crate::bake::source::curve::Sheet;

/// The text of a module.
pub(super) fn text(sheet: &Sheet<'_>, name: &str) -> String {
    let mut text = commented("//", &sheet.header());
    let name = name.to_uppercase();
    let width = sheet.width();
    let [from, to] = sheet.baked.wanted.range;
    let per_unit = sheet.baked.segments_per_unit();
    let segments = sheet.coefficients(["[", "]"]);
    let names = sheet.output_names();
    let _ = write!(
        text,
        "
use suspension_core::baked::Curve;

/// What the outputs of [`{name}`] are.
pub const {name}_OUTPUTS: [&str; {width}] = {names:?};

/// See the head of this file.
#[allow(clippy::approx_constant)]
#[rustfmt::skip]
pub static {name}: Curve<'static, f64, {width}, {TERMS}> = Curve {{
    range: [{from:?}, {to:?}],
    segments_per_unit: {per_unit:?},
    segments: &[
{segments}    ],
}};
"
    );
    text
}
