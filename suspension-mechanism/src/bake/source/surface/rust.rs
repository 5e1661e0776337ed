//! As Rust.

use std::fmt::Write;

use crate::bake::scheme::TERMS;
use crate::bake::source::about::commented;
use crate::bake::source::surface::Sheet;

/// The text of a module.
pub(super) fn text(sheet: &Sheet<'_>, name: &str) -> String {
    let mut text = commented("//", &sheet.header());
    let name = name.to_uppercase();
    let width = sheet.width();
    let ranges = sheet.baked.wanted.ranges;
    let per_unit = sheet.baked.patches_per_unit();
    let [_, across] = sheet.baked.counts;
    let patches = sheet.coefficients(["[", "]"]);
    let names = sheet.output_names();
    let _ = write!(
        text,
        "
use suspension_core::baked::Surface;

/// What the outputs of [`{name}`] are.
pub const {name}_OUTPUTS: [&str; {width}] = {names:?};

/// See the head of this file.
#[allow(clippy::approx_constant)]
#[rustfmt::skip]
pub static {name}: Surface<'static, f64, {width}, {TERMS}> = Surface {{
    ranges: {ranges:?},
    patches_per_unit: {per_unit:?},
    across: {across},
    patches: &[
{patches}    ],
}};
"
    );
    text
}
