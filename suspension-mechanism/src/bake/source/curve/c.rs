//! Baked curves as a header in C99.

use crate::bake::scheme::TERMS;
use crate::bake::source::c::header;
use crate::bake::source::curve::CurveFile;

pub(super) fn text(file: &CurveFile<'_>) -> String {
    let segments = file.coefficients(["{", "}"]);
    let code = [numbers(file, &segments), function(file)];
    header(&file.titled, &file.header(), &segments, &code.join("\n"))
}

fn numbers(file: &CurveFile<'_>, segments: &str) -> String {
    let name = &file.titled.name;
    let upper = name.to_uppercase();
    let width = file.titled.outputs.len();
    let count = file.baked.segments.len();
    let [from, to] = file.baked.wanted.range;
    format!(
        "\
enum {{ {upper}_OUTPUTS = {width}, {upper}_SEGMENTS = {count} }};

static const {name}_number {name}_range[2] = {{{from:?}, {to:?}}};

/* By segment, power and output, constants first; the variable of a segment runs from 0 to 1. */
static const {name}_number {name}_segments[{count}][{TERMS}][{width}] = {{
{segments}}};
"
    )
}

/// The function that programs call.
fn function(file: &CurveFile<'_>) -> String {
    let name = &file.titled.name;
    let width = file.titled.outputs.len();
    let count = file.baked.segments.len();
    let per_unit = file.baked.segments_per_unit();
    let kind = file.argument.kind();
    format!(
        "\
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
",
        last = count - 1,
        degree = TERMS - 1,
    )
}
