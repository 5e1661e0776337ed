//! Baked files: what they say, that they compile, and that all languages give the same digits.

use std::path::Path;
use std::process::{Command, Output};

use suspension_core::baked::{Curve, Split};

use super::program::{example, folder, run, text};

const RANGE: [&str; 4] = ["--from", "0.75", "--to", "2"];

fn baked(folder: &Path, arguments: &[&str]) -> String {
    std::fs::write(folder.join("a.toml"), example("published_five_link.toml")).expect("written");
    let fixed = ["bake", "a.toml", "--output", "wheel_by_theta"];
    let output = run(folder, &[&fixed, arguments].concat());
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    std::fs::read_to_string(folder.join("wheel_by_theta")).expect("a file")
}

fn numbers(value: &toml::Value) -> Vec<f64> {
    match value {
        toml::Value::Array(values) => values.iter().flat_map(numbers).collect(),
        value => vec![value.as_float().expect("a number")],
    }
}

/// The segments of a file in TOML.
fn table(text: &str) -> (toml::Table, Vec<[[f64; 6]; 6]>) {
    let table: toml::Table = text.parse().expect("TOML");
    let flat = numbers(&table["segments"]);
    let (rows, rest) = flat.as_chunks::<6>();
    let (segments, more) = rows.as_chunks::<6>();
    assert!(rest.is_empty() && more.is_empty());
    let segments = segments.to_vec();
    (table, segments)
}

/// Places, with the position, velocity and acceleration that the core reads there.
fn expected<T: Split>(folder: &Path, arguments: &[&str]) -> Vec<(T, [[T; 6]; 3])> {
    let (table, segments) = table(&baked(folder, &[arguments, &["--as", "toml"]].concat()));
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

/// Of the bits of a number, as a hexadecimal literal.
fn bits<T>(numbers: &[[T; 6]; 3], bits: fn(&T) -> u64) -> String {
    let each = numbers.as_flattened().iter();
    each.map(|x| format!("{:#x}, ", bits(x))).collect()
}

#[test]
fn the_rust_file_compiles_and_reads_the_same_digits() {
    let folder = folder();
    let mut asserts = String::new();
    for (at, values) in expected::<f64>(folder.path(), &RANGE) {
        let bits = bits(&values, |x| x.to_bits());
        asserts += &format!("    check({at:?}, [{bits}]);\n");
    }
    let file = baked(folder.path(), &RANGE);
    let program = format!(
        "mod baked {{\n{file}}}
fn check(at: f64, expected: [u64; 18]) {{
    let found = baked::WHEEL_BY_THETA.at(at).unwrap().acceleration(1.5, -0.7);
    let bits: Vec<u64> = found.as_flattened().iter().map(|x| x.to_bits()).collect();
    assert_eq!(bits, expected);
}}
fn main() {{
    assert!(baked::WHEEL_BY_THETA.at(2.1).is_err());
    assert_eq!(baked::WHEEL_BY_THETA_OUTPUTS[5], \"spin_axis_z\");
{asserts}}}
"
    );
    let ran = run_with_the_core(folder.path(), &program);
    assert!(ran.status.success(), "{}", text(&ran.stderr));
}

/// Compiles a program that depends on the core alone, with the versions of this package, and runs
/// it.
fn run_with_the_core(folder: &Path, program: &str) -> Output {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let manifest = format!(
        r#"[package]
name = "reader"
edition = "2024"
[[bin]]
name = "reader"
path = "main.rs"
[dependencies]
suspension-core.path = {:?}
[workspace]
"#,
        here.join("suspension-core")
    );
    std::fs::write(folder.join("Cargo.toml"), manifest).expect("written");
    std::fs::write(folder.join("main.rs"), program).expect("written");
    std::fs::copy(here.join("Cargo.lock"), folder.join("Cargo.lock")).expect("copied");
    Command::new(env!("CARGO"))
        .current_dir(folder)
        .args(["run", "--quiet", "--offline", "--target-dir"])
        .arg(Path::new(env!("CARGO_TARGET_TMPDIR")).join("reader"))
        .output()
        .expect("cargo runs")
}

#[test]
fn the_c_header_compiles_without_warnings_and_reads_the_same_digits() {
    the_c_header_reads::<f64>("double", |x| x.to_bits());
    the_c_header_reads::<f32>("float", |x| x.to_bits().into());
}

fn the_c_header_reads<T: Split + std::fmt::LowerExp>(number: &str, to_bits: fn(&T) -> u64) {
    let folder = folder();
    let mut rows = String::new();
    for (at, values) in expected(folder.path(), &RANGE) {
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
    {number} found[18];
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {{
        if (wheel_by_theta(rows[i].at, 1.5, -0.7, found, found + 6, found + 12) != 0)
            return 1;
        if (memcmp(found, rows[i].bits, sizeof found) != 0)
            return 2;
    }}
    if (wheel_by_theta(2.1, 1.5, -0.7, found, found + 6, NULL) != 1)
        return 3;
    return wheel_by_theta(1.0, 1.5, -0.7, found, NULL, NULL);
}}
"#
    );
    std::fs::write(folder.path().join("main.c"), program).expect("written");
    let flags = [
        "-std=c99",
        "-O2",
        "-Wall",
        "-Wextra",
        "-Wdouble-promotion",
        "-Werror",
        "main.c",
        "-o",
        "main",
    ];
    let compiled = Command::new("cc")
        .current_dir(folder.path())
        .args(flags)
        .output()
        .expect("a C compiler: Rust links with one");
    assert!(compiled.status.success(), "{}", text(&compiled.stderr));
    let ran = Command::new(folder.path().join("main")).status();
    assert_eq!(ran.expect("a program").code(), Some(0), "{number}");
}

/// Bakes the wheel of two suspensions to C, whose motion files are of these names, and compiles a
/// program with both headers that gives 0 where they differ.
fn two_in_one_program(names: [&str; 2]) -> Output {
    let folder = folder();
    let mut program = String::new();
    let other = example("attia2003.toml").replace("[0.0, 0.1, 0.0]", "[0.0, 0.2, 0.0]");
    for (name, content) in names.into_iter().zip([example("attia2003.toml"), other]) {
        let file = folder.path().join(name);
        std::fs::create_dir_all(file.parent().expect("a folder")).expect("made");
        std::fs::write(&file, content).expect("written");
        let path = name.replace(".toml", "_wheel_by_theta.h");
        let arguments = ["bake", name, "--as", "c", "--output", &path];
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
        .expect("a C compiler: Rust links with one");
    if !compile.status.success() {
        return compile;
    }
    let program = Command::new(folder.path().join("main")).output();
    program.expect("a program")
}

#[test]
fn two_baked_headers_are_two_tables() {
    let ran = two_in_one_program(["front.toml", "rear.toml"]);
    assert_eq!(ran.status.code(), Some(0), "{}", text(&ran.stderr));
}

#[test]
fn two_baked_headers_of_one_name_do_not_compile() {
    let refused = two_in_one_program(["old/front.toml", "new/front.toml"]);
    let message = text(&refused.stderr);
    let expected = "another baked header has the name front_wheel_by_theta";
    assert!(message.contains(expected), "{message}");
}

/// Whatever a file is called, what is in it has a name that compilers take.
#[test]
fn names_in_a_file_are_made_of_its_own() {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), example("attia2003.toml")).expect("written");
    for (path, name) in [
        ("wheel_by_theta.toml", "wheel_by_theta"),
        ("out/rear left.toml", "rear_left_wheel_by_theta"),
        ("911.toml", "baked_911_wheel_by_theta"),
        ("\u{fc}ber.toml", "baked__ber_wheel_by_theta"),
        ("int.toml", "int_wheel_by_theta"),
    ] {
        let arguments = ["bake", "a.toml", "--as", "toml", "--output", path];
        let output = run(folder.path(), &[&arguments[..], &RANGE].concat());
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        let text = std::fs::read_to_string(folder.path().join(path)).expect("a file");
        let table: toml::Table = text.parse().expect("TOML");
        assert_eq!(table["name"].as_str(), Some(name));
    }
}

#[test]
fn the_header_has_the_range_to_its_last_digit() {
    let range = ["--from", "0.7500000000000001", "--to", "1.0123456789012344"];
    let file = baked(folder().path(), &range);
    let expected = "// Drive: theta from 0.7500000000000001 to 1.0123456789012344 rad.";
    assert!(file.contains(expected), "{}", &file[..400]);
}

#[test]
fn the_header_says_what_was_baked() {
    let folder = folder();
    let arguments = [
        "--tolerance",
        "1e-5",
        "--continuity",
        "2",
        "--points",
        "all",
    ];
    let file = baked(folder.path(), &[&RANGE[..], &arguments].concat());
    for line in [
        "// The 6 points of five_link as a function of drive theta.",
        "// Baked by `suspension bake` from a.toml.",
        "// Drive: theta from 0.75 to 2 rad.",
        "// Lengths in mm; axes x forward, y left, z up.",
        "// Continuous where segments join: position, first and second derivative.",
        "// Tolerance asked: 0.01 mm; reached: 0.00",
    ] {
        assert!(file.contains(line), "{line}\n{}", &file[..900]);
    }
    let segments = file.matches("    [\n").count();
    let bytes = segments * 6 * 18 * 8;
    assert!(file.contains(&format!(
        "// {segments} segments of degree 5, {bytes} bytes."
    )));
}

#[test]
fn without_options_the_motion_of_the_file_is_baked_under_out() {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), example("attia2003.toml")).expect("written");
    let output = run(folder.path(), &["bake", "a.toml"]);
    assert_eq!(output.status.code(), Some(0));
    let message = text(&output.stderr);
    assert!(
        message.starts_with("wrote out/a_wheel_by_theta.rs: "),
        "{message}"
    );
    let file = std::fs::read_to_string(folder.path().join("out/a_wheel_by_theta.rs"));
    let file = file.expect("a file");
    assert!(file.contains("// Drive: theta from 0.7 to 2.1503125 rad."));
    assert!(file.contains("// Tolerance asked: 1e-6 m; reached: "));
}

#[test]
fn a_range_that_is_refused_comes_with_one_that_is_possible() {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), example("attia2003.toml")).expect("written");
    for (ends, reason) in [
        (["0.5", "2.5"], "the drive `theta` locks at"),
        (
            ["0.663", "2"],
            "256 segments do not meet 1e-6 m about theta = 0.66",
        ),
        (["2.2", "3"], "the drive `theta` locks at"),
    ] {
        let [from, to] = ends;
        let output = run(
            folder.path(),
            &["bake", "a.toml", "--from", from, "--to", to],
        );
        let message = text(&output.stderr);
        assert_eq!(output.status.code(), Some(3), "{message}");
        assert_eq!(message.lines().count(), 1, "{message}");
        let begin = format!("a.toml: theta cannot be baked from {from} to {to}: {reason}");
        assert!(message.starts_with(&begin), "{message}");
        let (_, advice) = message.split_once("possible is ").expect("advice");
        let possible: Vec<&str> = advice.split_whitespace().collect();
        let output = run(
            folder.path(),
            &[&["bake", "a.toml"], &possible[..]].concat(),
        );
        assert_eq!(output.status.code(), Some(0), "{advice}");
    }
}

#[test]
fn wrong_orders_are_exit_code_2_and_one_sentence() {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), example("attia2003.toml")).expect("written");
    for (arguments, expected) in [
        (
            &["--drive", "bump"][..],
            "a.toml: unknown drive `bump`; known are theta",
        ),
        (
            &["--from", "2", "--to", "1"],
            "a.toml: theta = 2 rad to theta = 1 rad is no range",
        ),
        (
            &["--from", "nan"],
            "a.toml: theta = NaN rad to theta = 2.15031 rad is no range",
        ),
        (
            &["--from", "-0.1"],
            "a.toml: theta = -0.1 rad to theta = 2.15031 rad: the angle of a",
        ),
        (
            &["--tolerance", "0"],
            "a.toml: a tolerance is a positive number of metres",
        ),
        (
            &["--tolerance=-1"],
            "a.toml: a tolerance is a positive number of metres",
        ),
        (
            &["--output", "./a.toml"],
            "./a.toml: this is the file that is read, which --output would",
        ),
    ] {
        let output = run(folder.path(), &[&["bake", "a.toml"], arguments].concat());
        let message = text(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{message}");
        assert_eq!(message.lines().count(), 1, "{message}");
        assert!(message.starts_with(expected), "{message}");
    }
    let output = run(folder.path(), &["bake", "a.toml", "--tolerance", "1e-30"]);
    assert_eq!(output.status.code(), Some(3));
    let message = text(&output.stderr);
    assert!(
        message.ends_with("no part of the range can be baked\n"),
        "{message}"
    );
}

/// What the firmware looks up is written by the program, not by hand.
#[test]
fn the_firmwares_wheel_is_as_baked_today() {
    let folder = folder();
    std::fs::write(
        folder.path().join("attia2003.toml"),
        example("attia2003.toml"),
    )
    .expect("written");
    let arguments = ["bake", "attia2003.toml", "--output", "wheel_by_theta.rs"];
    let output = run(folder.path(), &arguments);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let [baked, kept] = [
        folder.path().join("wheel_by_theta.rs"),
        Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("tests/firmware/controller/src/wheel_by_theta.rs"),
    ]
    .map(|path| std::fs::read_to_string(path).expect("a source file"));
    // They differ in the path of the motion file alone.
    assert_eq!(
        baked,
        kept.replace("examples/attia2003.toml", "attia2003.toml")
    );
}
