//! Baked Rust files and C headers compile and give the digits of the library, and two headers are two tables.

use std::process::{Command, Output};

use suspension_core::baked::{Curve, Split};

use super::super::program::{example, folder, rows, run, text};
use super::c::{assert_converts, exit_of_c, has_c_compiler};
use super::kept::wheel_by_theta::{WHEEL_BY_THETA, WHEEL_BY_THETA_OUTPUTS};
use super::{RANGE, baked, baked_of};

pub(super) fn numbers(value: &toml::Value) -> Vec<f64> {
    match value {
        toml::Value::Array(values) => values.iter().flat_map(numbers).collect(),
        value => vec![value.as_float().expect("a number")],
    }
}

/// The segments of a file in TOML.
pub(super) fn table(text: &str) -> (toml::Table, Vec<[[f64; 6]; 6]>) {
    let table: toml::Table = text.parse().expect("TOML");
    let flat = numbers(&table["segments"]);
    let (rows, rest) = flat.as_chunks::<6>();
    let (segments, more) = rows.as_chunks::<6>();
    assert!(rest.is_empty() && more.is_empty());
    let segments = segments.to_vec();
    (table, segments)
}

/// Places, with the position, velocity and acceleration that the core reads there of a file in TOML.
fn expected<T: Split>(text: &str) -> Vec<(T, [[T; 6]; 3])> {
    let (table, segments) = table(text);
    let range: [f64; 2] = numbers(&table["range"]).try_into().expect("two ends");
    let per_unit = table["segments_per_unit"].as_float().expect("a number");
    let number = T::constant;
    let segments: Vec<_> = segments
        .iter()
        .map(|terms| terms.map(|row| row.map(number)))
        .collect();
    let curve = Curve {
        range: range.map(number),
        segments_per_unit: number(per_unit),
        segments: &segments,
    };
    let [from, to] = range;
    (0..=100)
        .map(|part| number((from + (to - from) * f64::from(part) / 100.0).min(to)))
        .map(|at| {
            let place = curve.at(at).expect("inside");
            (at, place.acceleration(number(1.5), number(-0.7)))
        })
        .collect()
}

/// Returns the bits of a number as a hexadecimal literal.
pub(super) fn bits<T>(numbers: &[[T; 6]; 3], bits: fn(&T) -> u64) -> String {
    let each = numbers.as_flattened().iter();
    each.map(|x| format!("{:#x}, ", bits(x))).collect()
}

#[test]
fn a_baked_rust_file_gives_the_same_digits() {
    let file = baked_of("attia2003.toml", folder().path(), &["--as", "toml"]);
    for (at, expected) in expected::<f64>(&file) {
        let found = WHEEL_BY_THETA.at(at).expect("inside");
        let found = found.acceleration(1.5, -0.7);
        let [found, expected] = [found, expected].map(|numbers| bits(&numbers, |x| x.to_bits()));
        assert_eq!(found, expected, "at {at}");
    }
    assert!(WHEEL_BY_THETA.at(2.2).is_err());
    assert_eq!(WHEEL_BY_THETA_OUTPUTS[5], "spin_axis_z");
}

#[test]
fn a_baked_c_header_gives_the_same_digits_without_warnings() {
    if !has_c_compiler("a_baked_c_header_gives_the_same_digits_without_warnings") {
        return;
    }
    the_c_header_reads::<f64>("double", |x| x.to_bits());
    the_c_header_reads::<f32>("float", |x| x.to_bits().into());
}

fn the_c_header_reads<T: Split + std::fmt::LowerExp>(number: &str, to_bits: fn(&T) -> u64) {
    let folder = folder();
    let mut rows = String::new();
    let file = baked(folder.path(), &[&RANGE[..], &["--as", "toml"]].concat());
    for (at, values) in expected(&file) {
        rows += &format!("    {{{at:e}, {{{}}}}},\n", bits(&values, to_bits));
    }
    let width = 8 * size_of::<T>();
    let header = baked(folder.path(), &[&RANGE[..], &["--as", "c"]].concat());
    std::fs::write(folder.path().join("wheel.h"), header).expect("written");
    let program = format!(
        r#"#define WHEEL_BY_THETA_NUMBER {number}
#include "wheel.h"
#include <stdint.h>
#include <string.h>
static const struct {{ {number} at; uint{width}_t bits[18]; }} rows[] = {{
{rows}}};
int main(void)
{{
    {number} found[18], alone[12];
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {{
        if (wheel_by_theta(rows[i].at, 1.5, -0.7, found, found + 6, found + 12) != 0)
            return 1;
        if (memcmp(found, rows[i].bits, sizeof found) != 0)
            return 2;
        if (wheel_by_theta(rows[i].at, 1.5, -0.7, alone, NULL, alone + 6) != 0)
            return 4;
        if (memcmp(alone + 6, found + 12, sizeof alone / 2) != 0)
            return 5;
    }}
    if (wheel_by_theta(2.1, 1.5, -0.7, found, found + 6, NULL) != 1)
        return 3;
    return wheel_by_theta(1.0, 1.5, -0.7, found, NULL, NULL);
}}
"#
    );
    assert_eq!(exit_of_c(folder.path(), &program), Some(0), "{number}");
    assert_converts(folder.path(), "WHEEL_BY_THETA", number);
}

/// Compiles the lines of the page about controllers, and compares with the angles of the program.
#[test]
fn the_c_lines_of_the_controller_page_give_camber_and_toe() {
    if !has_c_compiler("the_c_lines_of_the_controller_page_give_camber_and_toe") {
        return;
    }
    let page = include_str!("../../../suspension-core/docs/controller.md");
    let lines = page.split("```c\n").nth(1);
    let lines = lines.and_then(|block| block.split("```").next());
    let lines = lines.expect("a block");
    let folder = folder();
    let file = example("double_wishbone_pushrod.toml");
    std::fs::write(folder.path().join("a.toml"), file).expect("written");
    let drive = "bump=0.25:0.35";
    let output = "my_wheel_by_bump.h";
    let bake = [
        "bake", "a.toml", "--drive", drive, "--as", "c", "--out", output,
    ];
    let output = run(folder.path(), &bake);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let sweep = ["sweep", "a.toml", "--drive", "bump=0.03", "--csv", "-"];
    let rows = rows(&run(folder.path(), &sweep).stdout);
    let [camber, toe] = ["camber_rad", "toe_rad"].map(|name| rows[0][name]);
    assert!(camber.abs() > 1e-3 && toe.abs() > 1e-4, "{camber} {toe}");
    let program = format!(
        r#"#include "my_wheel_by_bump.h"
#include <math.h>
int main(void)
{{
    double bump = 0.33;
{lines}
    return fabs(camber - {camber:e}) < 2e-6 && fabs(toe - {toe:e}) < 2e-6 ? 0 : 2;
}}
"#
    );
    assert_eq!(exit_of_c(folder.path(), &program), Some(0));
}

/// Bakes the wheel of two suspensions with motion files of these names to C, and compiles a program with both headers that
/// returns 0 if they differ.
fn two_in_one_program(names: [&str; 2]) -> Output {
    let folder = folder();
    let mut program = String::new();
    let other = example("attia2003.toml").replace("[0.0, 0.1, 0.0]", "[0.0, 0.2, 0.0]");
    for (name, content) in names.into_iter().zip([example("attia2003.toml"), other]) {
        let file = folder.path().join(name);
        std::fs::create_dir_all(file.parent().expect("a folder")).expect("made");
        std::fs::write(&file, content).expect("written");
        let path = name.replace(".toml", "_wheel_by_theta.h");
        let arguments = ["bake", name, "--as", "c", "--out", &path];
        let output = run(folder.path(), &[&arguments[..], &RANGE].concat());
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        program += &format!("#include \"{path}\"\n#include \"{path}\"\n");
    }
    program += "
int main(void)
{
    double front[6], rear[6];
    if (front_wheel_by_theta(1.0, 0.0, 0.0, front, NULL, NULL) != 0)
        return 1;
    if (rear_wheel_by_theta(1.0, 0.0, 0.0, rear, NULL, NULL) != 0)
        return 2;
    return rear[1] > front[1] + 0.09 ? 0 : 3;
}
";
    std::fs::write(folder.path().join("main.c"), program).expect("written");
    let compile = Command::new("cc")
        .current_dir(folder.path())
        .args(["-std=c99", "-Wall", "-Werror", "main.c", "-o", "main"])
        .output()
        .expect("a C compiler");
    if !compile.status.success() {
        return compile;
    }
    let program = Command::new(folder.path().join("main")).output();
    program.expect("a program")
}

#[test]
fn one_c_program_uses_two_baked_headers() {
    if !has_c_compiler("one_c_program_uses_two_baked_headers") {
        return;
    }
    let ran = two_in_one_program(["front.toml", "rear.toml"]);
    assert_eq!(ran.status.code(), Some(0), "{}", text(&ran.stderr));
}

#[test]
fn two_baked_headers_with_one_name_do_not_compile() {
    if !has_c_compiler("two_baked_headers_with_one_name_do_not_compile") {
        return;
    }
    let refused = two_in_one_program(["old/front.toml", "new/front.toml"]);
    let message = text(&refused.stderr);
    let expected = "another baked header has the name front_wheel_by_theta";
    assert!(message.contains(expected), "{message}");
}
