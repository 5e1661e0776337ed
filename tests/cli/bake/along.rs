//! Motions baked along a measure that leads in place of a drive.

use std::path::Path;

use suspension_core::baked::Curve;

use super::super::program::{Rows, example, folder, rows, run, table_in, text};
use super::c::{exit_of_c, has_c_compiler};
use super::kept::is_as_kept;
use super::kept::wheel_by_damper::{WHEEL_BY_DAMPER, WHEEL_BY_DAMPER_OUTPUTS};
use super::languages::{bits, numbers, table};

const DOUBLE_WISHBONE: &str = include_str!("../../../examples/double_wishbone_pushrod.toml");

/// The range, and the speed of the damper in the motion for comparison.
const ALONG: [&str; 4] = ["--along", "damper=0.21:0.26", "--drive", "bump"];
const RATE: f64 = 0.05;

/// The example, and its motion led by the damper through the range.
fn written() -> tempfile::TempDir {
    let folder = folder();
    let led = DOUBLE_WISHBONE
        .replace("bump = [0.30, 0.05]", "damper = [0.21, 0.05]")
        .replace("steer = [0.34, 0.01]", "steer = 0.34");
    assert!(led.contains("damper =") && led.contains("steer = 0.34\n"));
    for (name, content) in [("a.toml", DOUBLE_WISHBONE), ("led.toml", &led)] {
        std::fs::write(folder.path().join(name), content).expect("written");
    }
    folder
}

fn baked(folder: &Path, language: &str) -> String {
    let to = [
        "bake",
        "a.toml",
        "--as",
        language,
        "--out",
        "wheel_by_damper",
    ];
    let output = run(folder, &[&to, &ALONG[..]].concat());
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    std::fs::read_to_string(folder.join("wheel_by_damper")).expect("a file")
}

fn led(folder: &Path) -> Rows {
    table_in(folder, &["motion", "led.toml"])
}

/// Positions agree with the motion that the damper leads within the tolerance, rates and second rates within the errors that
/// the file states.
#[test]
fn a_wheel_baked_along_the_damper_equals_the_led_motion() {
    let folder = written();
    let (table, segments) = table(&baked(folder.path(), "toml"));
    let text_of = |key: &str| table[key].as_str().expect("a text").to_owned();
    let named = ["measure", "measure_unit", "in_place_of"].map(text_of);
    assert_eq!(named, ["damper", "m", "bump"].map(str::to_owned));
    let range: [f64; 2] = numbers(&table["range"]).try_into().expect("two ends");
    let reached = |order: &str| table["reached"][order].as_float().expect("a number");
    let curve = Curve {
        range,
        segments_per_unit: table["segments_per_unit"].as_float().expect("a number"),
        segments: &segments,
    };
    let led = led(folder.path());
    assert_eq!((led.len(), range), (51, [0.21, 0.26]));
    let mut worst = [0.0_f64; 3];
    for row in &led {
        let at = row["damper_m"].clamp(range[0], range[1]);
        let found = curve.at(at).expect("inside").acceleration(RATE, 0.0);
        for (order, kind) in ["", "v", "a"].into_iter().enumerate() {
            for (axis, found) in ["x", "y", "z"].iter().zip(found[order]) {
                let off = (found - row[&format!("wheel_centre_{kind}{axis}")]).abs();
                worst[order] = worst[order].max(off / RATE.powi(order as i32));
            }
        }
    }
    let [position, first, second] = worst;
    assert!(
        position <= 1e-6 && position <= reached("position"),
        "{worst:?}"
    );
    assert!(
        first <= reached("first") && second <= reached("second"),
        "{worst:?}"
    );
    // The bounds are not zero.
    assert!(position > 1e-9 && first > 1e-7, "{worst:?}");
}

/// Places, with the position, velocity and acceleration that the core reads there.
fn expected(folder: &Path) -> Vec<(f64, [[f64; 6]; 3])> {
    let (of_toml, segments) = table(&baked(folder, "toml"));
    let curve = Curve {
        range: [0.21, 0.26],
        segments_per_unit: of_toml["segments_per_unit"].as_float().expect("a number"),
        segments: &segments,
    };
    let places = (0..=20).map(|part| (0.21 + 0.05 * f64::from(part) / 20.0).min(0.26));
    let read = |at| curve.at(at).expect("inside").acceleration(1.5, -0.7);
    places.map(|at| (at, read(at))).collect()
}

#[test]
fn a_rust_file_baked_along_a_measure_gives_the_same_digits() {
    let folder = written();
    let file = baked(folder.path(), "rust");
    assert!(
        file.contains("as a function of measure damper.\n"),
        "{file}"
    );
    assert!(
        file.contains("// Measure: damper from 0.21 to 0.26 m, in place of drive bump, on the branch of bump = 0.3 m.\n"),
        "{file}"
    );
    is_as_kept(&file, "wheel_by_damper.rs");
    for (at, expected) in expected(folder.path()) {
        let found = WHEEL_BY_DAMPER
            .at(at)
            .expect("inside")
            .acceleration(1.5, -0.7);
        let [found, expected] = [found, expected].map(|numbers| bits(&numbers, |x| x.to_bits()));
        assert_eq!(found, expected, "at {at}");
    }
    assert!(WHEEL_BY_DAMPER.at(0.27).is_err());
    assert_eq!(WHEEL_BY_DAMPER_OUTPUTS[5], "spin_axis_z");
}

#[test]
fn a_c_header_baked_along_a_measure_gives_the_same_digits() {
    if !has_c_compiler("a_c_header_baked_along_a_measure_gives_the_same_digits") {
        return;
    }
    let folder = written();
    let mut lines = String::new();
    for (at, values) in expected(folder.path()) {
        let bits = bits(&values, |x| x.to_bits());
        lines += &format!("    {{{at:e}, {{{bits}}}}},\n");
    }
    let header = baked(folder.path(), "c");
    assert!(header.contains("where the measure has the value `measure`"));
    std::fs::write(folder.path().join("wheel.h"), header).expect("written");
    let program = format!(
        r#"#include "wheel.h"
#include <stdint.h>
#include <string.h>
static const struct {{ double at; uint64_t bits[18]; }} rows[] = {{
{lines}}};
int main(void)
{{
    double found[18];
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {{
        if (wheel_by_damper(rows[i].at, 1.5, -0.7, found, found + 6, found + 12) != 0)
            return 1;
        if (memcmp(found, rows[i].bits, sizeof found) != 0)
            return 2;
    }}
    return wheel_by_damper(0.27, 1.5, -0.7, found, NULL, NULL) == 1 ? 0 : 3;
}}
"#
    );
    assert_eq!(exit_of_c(folder.path(), &program), Some(0));
}

#[test]
fn a_range_past_a_turning_point_is_refused_with_a_possible_one() {
    let folder = written();
    let bake = ["bake", "a.toml", "--drive", "bump"];
    let output = run(
        folder.path(),
        &[&bake[..], &["--along", "damper=0.3:0.4"]].concat(),
    );
    let message = text(&output.stderr).trim_end();
    let begin = "a.toml: damper cannot be baked from 0.3 to 0.4: the measure turns back at damper = 0.375799 m, there is none \
                 beyond on this branch; possible is ";
    let possible = message.strip_prefix(begin).expect(message);
    assert!(
        possible.starts_with("--along damper=0.3:0.37"),
        "{possible}"
    );
    assert_eq!(output.status.code(), Some(3));
    let possible: Vec<&str> = possible.split_whitespace().collect();
    let output = run(folder.path(), &[&bake[..], &possible].concat());
    assert_eq!(output.status.code(), Some(0), "{output:?}");
}

#[test]
fn invalid_arguments_of_bake_along_are_refused() {
    let folder = written();
    for (arguments, message) in [
        (
            &["--along", "damper=0.21:0.26"][..],
            "a.toml: --drive must say in place of which drive `damper` leads: bump, steer",
        ),
        (
            &["--along", "spring=0.21:0.26", "--drive", "bump"],
            "a.toml: unknown measure `spring`; the measures are damper, bar_arm",
        ),
        (
            &["--along", "steer=0.3:0.4", "--drive", "bump"],
            "a.toml: `steer` is a drive; --drive steer=FROM:TO bakes along it",
        ),
        (
            &["--along", "damper=0.21:0.26", "--drive", "bump=0.2:0.4"],
            "--along takes the place of one drive; name this drive without a range: --drive NAME",
        ),
        (
            &[
                "--along",
                "damper=0.21:0.26",
                "--drive",
                "bump",
                "--drive",
                "steer",
            ],
            "--along takes the place of one drive; name this drive without a range: --drive NAME",
        ),
        (
            &["--along", "damper", "--drive", "bump"],
            "error: invalid value 'damper' for '--along <MEASURE=FROM:TO>': write MEASURE=FROM:TO, as damper=0.30:0.40",
        ),
        (
            &["--along", "damper=0.26:0.21", "--drive", "bump"],
            "error: invalid value 'damper=0.26:0.21' for '--along <MEASURE=FROM:TO>': FROM must be less than TO",
        ),
        (
            &[
                "--along",
                "damper=0.21:0.26",
                "--drive",
                "bump",
                "--from",
                "0.2",
            ],
            "error: the argument '--along <MEASURE=FROM:TO>' cannot be used with '--from <X>'",
        ),
    ] {
        let output = run(folder.path(), &[&["bake", "a.toml"], arguments].concat());
        let found = text(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{found}");
        assert!(found.starts_with(message), "{found}");
    }
}

/// In a file in degrees ranges are in degrees, and what is baked in radians.
#[test]
fn the_range_of_a_measured_angle_is_in_the_unit_of_the_file() {
    let folder = written();
    let by_angle = DOUBLE_WISHBONE.replace("unit = \"m\"", "unit = \"m\"\nangle = \"deg\"");
    std::fs::write(folder.path().join("deg.toml"), by_angle).expect("written");
    let rows = |file| {
        let sweep = ["sweep", file, "--drive", "bump=0:0.01:2", "--csv", "-"];
        rows(&run(folder.path(), &sweep).stdout)[0].clone()
    };
    let (degrees, radians) = (
        rows("deg.toml")["bar_arm_deg"],
        rows("a.toml")["bar_arm_rad"],
    );
    assert!((degrees - radians.to_degrees()).abs() < 1e-9);
    let along = format!("bar_arm={:?}:{:?}", degrees - 1.0, degrees + 1.0);
    let arguments = [
        "--drive", "bump", "--along", &along, "--as", "toml", "--out", "a",
    ];
    let output = run(
        folder.path(),
        &[&["bake", "deg.toml"][..], &arguments].concat(),
    );
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let file = std::fs::read_to_string(folder.path().join("a")).expect("a file");
    let (table, _) = table(&file);
    assert_eq!(table["measure_unit"].as_str(), Some("rad"));
    let [from, to] = numbers(&table["range"])[..] else {
        panic!("two ends")
    };
    let off = [
        from - radians + 1_f64.to_radians(),
        to - radians - 1_f64.to_radians(),
    ];
    assert!(off.iter().all(|off| off.abs() < 1e-12), "{off:?}");
}

/// The advice for a drive's range is in the file's units too.
#[test]
fn the_possible_range_of_a_file_in_degrees_is_printed_in_degrees() {
    let folder = folder();
    let [start, rate] = [0.8_f64, 0.6].map(f64::to_degrees);
    let file = example("five_link.toml").replace("unit = \"mm\"", "unit = \"mm\"\nangle = \"deg\"");
    let file = file.replace(
        "theta = [0.8, 0.6]",
        &format!("theta = [{start:?}, {rate:?}]"),
    );
    std::fs::write(folder.path().join("a.toml"), file).expect("written");
    let output = run(
        folder.path(),
        &["bake", "a.toml", "--from", "30", "--to", "140"],
    );
    let message = text(&output.stderr);
    assert!(
        message.starts_with("a.toml: theta cannot be baked from 30 to 140: "),
        "{message}"
    );
    let (_, possible) = message
        .trim_end()
        .split_once("possible is ")
        .expect("advice");
    let possible: Vec<&str> = possible.split_whitespace().collect();
    let output = run(
        folder.path(),
        &[&["bake", "a.toml"], possible.as_slice()].concat(),
    );
    assert_eq!(output.status.code(), Some(0), "{message} {output:?}");
}
