//! As a header in C99.

use std::fmt::Write;

use crate::bake::scheme::TERMS;
use crate::bake::source::about::{END_IGNORE, IGNORE_CONVERSIONS, checksum, comment_in_c};
use crate::bake::source::curve::Sheet;

/// The text of a header. Its guard has a value of the header's own: another header under the same
/// name is an error and not left out in silence.
pub(super) fn text(sheet: &Sheet<'_>, name: &str) -> String {
    let mut text = comment_in_c(&sheet.header());
    let upper = name.to_uppercase();
    let width = sheet.width();
    let count = sheet.baked.segments.len();
    let [from, to] = sheet.baked.wanted.range;
    let per_unit = sheet.baked.segments_per_unit();
    let segments = sheet.coefficients(["{", "}"]);
    let outputs = sheet.output_names().join(", ");
    let kind = sheet.argument.kind();
    let _ = write!(
        text,
        " *
 * Outputs: {outputs}.
 * For the same digits as in Rust compile without contraction (-std=c99 or -ffp-contract=off).
 * In float where {upper}_NUMBER is defined as such: rounding adds some 1e-7 of the largest output.
 */
#if !defined {upper}_H
#define {upper}_H {checksum:#010x}

#include <stddef.h>

{IGNORE_CONVERSIONS}

#ifndef {upper}_NUMBER
#define {upper}_NUMBER double
#endif
typedef {upper}_NUMBER {name}_number;

enum {{ {upper}_OUTPUTS = {width}, {upper}_SEGMENTS = {count} }};

static const {name}_number {name}_range[2] = {{{from:?}, {to:?}}};

/* By segment, power and output, constants first; the variable of a segment runs from 0 to 1. */
static const {name}_number {name}_segments[{count}][{TERMS}][{width}] = {{
{segments}}};

/*
 * Position, velocity and acceleration where the {kind} has the value `{kind}` and moves at `rate`
 * per second and `second_rate` per second squared. Where `velocity` or `acceleration` is NULL
 * it is not computed. Returns 0; or 1 where the {kind} is outside the range, and then writes
 * nothing.
 */
static inline int {name}({name}_number {kind}, {name}_number rate, {name}_number second_rate,
        {name}_number position[{width}], {name}_number velocity[{width}],
        {name}_number acceleration[{width}])
{{
    if (!({kind} >= {name}_range[0] && {kind} <= {name}_range[1]))
        return 1;
    const {name}_number per_unit = {per_unit:?};
    const {name}_number along = ({kind} - {name}_range[0]) * per_unit;
    const int whole = (int)along < {count} ? (int)along : {last};
    const {name}_number variable = along - whole;
    const {name}_number (*terms)[{width}] = {name}_segments[whole];
    rate *= per_unit;
    second_rate *= per_unit;
    for (int i = 0; i < {width}; i++) {{
        {name}_number value = terms[{degree}][i], first = value, half_second = value;
        for (int power = {degree} - 1; power >= 0; power--) {{
            value = value * variable + terms[power][i];
            if (power >= 1)
                first = first * variable + value;
            if (power >= 2)
                half_second = half_second * variable + first;
        }}
        position[i] = value;
        if (velocity != NULL)
            velocity[i] = first * rate;
        if (acceleration != NULL)
            acceleration[i] = first * second_rate + half_second * ((rate + rate) * rate);
    }}
    return 0;
}}

{END_IGNORE}

#elif {upper}_H != {checksum:#010x}
#error \"another baked header has the name {name}: bake to a file of another name\"
#endif
",
        checksum = checksum(&segments),
        last = count - 1,
        degree = TERMS - 1,
    );
    text
}
