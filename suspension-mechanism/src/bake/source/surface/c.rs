//! Baked surfaces as a header in C99.

use crate::bake::scheme::TERMS;
use crate::bake::source::c::header;
use crate::bake::source::surface::SurfaceFile;

pub(super) fn text(file: &SurfaceFile<'_>) -> String {
    let patches = file.coefficients(["{", "}"]);
    let name = &file.titled.name;
    let function = function(name, file.titled.outputs.len());
    let code = [numbers(file, &patches), polynomial(name), function];
    header(&file.titled, &file.header(), &patches, &code.join("\n"))
}

fn numbers(file: &SurfaceFile<'_>, patches: &str) -> String {
    let name = &file.titled.name;
    let upper = name.to_uppercase();
    let width = file.titled.outputs.len();
    let [along, across] = file.baked.counts;
    let count = along * across;
    let [[from, to], [second_from, second_to]] = file.baked.wanted.ranges;
    let [per_unit, second_per_unit] = file.baked.patches_per_unit();
    format!(
        "\
enum {{ {upper}_OUTPUTS = {width}, {upper}_ALONG = {along}, {upper}_ACROSS = {across} }};

static const {name}_number {name}_ranges[2][2] = {{{{{from:?}, {to:?}}}, {{{second_from:?}, {second_to:?}}}}};

static const {name}_number {name}_patches_per_unit[2] = {{{per_unit:?}, {second_per_unit:?}}};

/*
 * By patch, those along the second drive side by side; by power of the first drive, of the second, and output,
 * constants first. The variables of a patch run from 0 to 1.
 */
static const {name}_number {name}_patches[{count}][{TERMS}][{TERMS}][{width}] = {{
{patches}}};
"
    )
}

/// A function for the value and the derivatives of a polynomial.
fn polynomial(name: &str) -> String {
    let degree = TERMS - 1;
    format!(
        "\
/* The value of a polynomial, its derivative, and half its second derivative. */
static inline void {name}_polynomial(const {name}_number terms[{TERMS}], {name}_number variable,
        {name}_number orders[3])
{{
    orders[0] = orders[1] = orders[2] = terms[{degree}];
    for (int power = {degree} - 1; power >= 0; power--) {{
        orders[0] = orders[0] * variable + terms[power];
        if (power >= 1)
            orders[1] = orders[1] * variable + orders[0];
        if (power >= 2)
            orders[2] = orders[2] * variable + orders[1];
    }}
}}
"
    )
}

/// The function that programs call.
fn function(name: &str, width: usize) -> String {
    let upper = name.to_uppercase();
    let outputs = outputs(name, width);
    format!(
        "\
/*
 * Position, velocity and acceleration where the drives have the values `drives` and move at `rates` per second and
 * `second_rates` per second squared. NULL in place of rates stands for zeros. Where `velocity` or `acceleration`
 * is NULL it is not written. Returns 0; or 1 where a drive is outside its range, and then writes nothing.
 */
static inline int {name}(const {name}_number drives[2], const {name}_number rates[2],
        const {name}_number second_rates[2], {name}_number position[{width}],
        {name}_number velocity[{width}], {name}_number acceleration[{width}])
{{
    const int counts[2] = {{{upper}_ALONG, {upper}_ACROSS}};
    int place[2];
    {name}_number variable[2], rate[2], second_rate[2];
    for (int way = 0; way < 2; way++) {{
        if (!(drives[way] >= {name}_ranges[way][0] && drives[way] <= {name}_ranges[way][1]))
            return 1;
        const {name}_number per_unit = {name}_patches_per_unit[way];
        const {name}_number along = (drives[way] - {name}_ranges[way][0]) * per_unit;
        place[way] = (int)along < counts[way] ? (int)along : counts[way] - 1;
        variable[way] = along - place[way];
        rate[way] = rates != NULL ? rates[way] * per_unit : 0;
        second_rate[way] = second_rates != NULL ? second_rates[way] * per_unit : 0;
    }}
    const {name}_number (*patch)[{TERMS}][{width}] = {name}_patches[place[0] * {upper}_ACROSS + place[1]];
{outputs}    return 0;
}}
"
    )
}

/// Its loop over the outputs.
fn outputs(name: &str, width: usize) -> String {
    format!(
        "    for (int i = 0; i < {width}; i++) {{
        {name}_number across[3][{TERMS}], by[3][3];
        for (int power = 0; power < {TERMS}; power++) {{
            {name}_number terms[{TERMS}], orders[3];
            for (int second = 0; second < {TERMS}; second++)
                terms[second] = patch[power][second][i];
            {name}_polynomial(terms, variable[1], orders);
            for (int order = 0; order < 3; order++)
                across[order][power] = orders[order];
        }}
        for (int order = 0; order < 3; order++)
            {name}_polynomial(across[order], variable[0], by[order]);
        const {name}_number first = by[0][1], second = by[1][0];
        position[i] = by[0][0];
        if (velocity != NULL)
            velocity[i] = first * rate[0] + second * rate[1];
        if (acceleration != NULL) {{
            {name}_number sum = by[0][2] * ((rate[0] + rate[0]) * rate[0]);
            sum += by[1][1] * ((rate[0] + rate[0]) * rate[1]);
            sum += by[2][0] * ((rate[1] + rate[1]) * rate[1]);
            sum += first * second_rate[0];
            sum += second * second_rate[1];
            acceleration[i] = sum;
        }}
    }}
"
    )
}
