//! Code common to the headers in C99.

use crate::bake::source::Titled;
use crate::bake::source::about::commented;

/// The text of a header around its code. Its guard has a value of its own, made from the coefficients: another header
/// with the same name causes an error and is not silently ignored.
pub(super) fn header(
    titled: &Titled<'_>,
    head: &[String],
    coefficients: &str,
    code: &str,
) -> String {
    let name = &titled.name;
    let upper = name.to_uppercase();
    let comment = comment(head);
    let outputs = titled.outputs.join(", ");
    let checksum = checksum(coefficients);
    format!(
        "\
{comment} *
 * Outputs: {outputs}.
 * For the same digits as in Rust compile without contraction (-std=c99 or -ffp-contract=off).
 * In float where {upper}_NUMBER is defined as such: rounding adds some 1e-7 of the largest output.
 */
#if !defined {upper}_H
#define {upper}_H {checksum:#010x}

#include <stddef.h>

/* Where numbers are float, those in this file are rounded. */
#if defined __GNUC__
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored \"-Wconversion\"
#pragma GCC diagnostic ignored \"-Wfloat-conversion\"
#endif

#ifndef {upper}_NUMBER
#define {upper}_NUMBER double
#endif
typedef {upper}_NUMBER {name}_number;

{code}
#if defined __GNUC__
#pragma GCC diagnostic pop
#endif

#elif {upper}_H != {checksum:#010x}
#error \"another baked header has the name {name}: bake to a file of another name\"
#endif
"
    )
}

/// The head of a comment in C; the name of a file may contain the characters that end one.
fn comment(lines: &[String]) -> String {
    let lines: Vec<String> = lines.iter().map(|line| line.replace("*/", "* /")).collect();
    format!("/*\n{}", commented(" *", &lines))
}

/// The checksum of a text by Fowler, Noll and Vo (FNV-1a), in the range that every preprocessor knows.
fn checksum(text: &str) -> u32 {
    let hash = text.bytes().fold(0x811c_9dc5_u32, |hash, byte| {
        (hash ^ u32::from(byte)).wrapping_mul(0x0100_0193)
    });
    hash >> 1
}
