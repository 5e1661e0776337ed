//! Code common to the Rust modules.

use crate::bake::scheme::TERMS;
use crate::bake::source::Titled;
use crate::bake::source::about::commented;

/// The text of a module with one `static` of a kind and its fields.
pub(super) fn module(titled: &Titled<'_>, head: &[String], kind: &str, fields: &str) -> String {
    let comment = commented("//", head);
    let name = titled.name.to_uppercase();
    let names = &titled.outputs;
    let width = names.len();
    format!(
        "\
{comment}
use suspension_core::baked::{kind};

/// What the outputs of [`{name}`] are.
#[allow(dead_code)]
pub const {name}_OUTPUTS: [&str; {width}] = {names:?};

/// See the head of this file.
#[allow(clippy::approx_constant, clippy::unreadable_literal)]
#[rustfmt::skip]
pub static {name}: {kind}<'static, f64, {width}, {TERMS}> = {kind} {{
{fields}}};
"
    )
}
