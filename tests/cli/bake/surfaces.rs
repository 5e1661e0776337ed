//! Motions of two drives: the files in all languages against the solver and each other, and refusals.

use std::path::Path;

use suspension_core::baked::{Patch, Surface};
use suspension_core::linkages::double_wishbone::{Corner, Drives};
use suspension_core::{Signal, Values};

use super::super::program::{folder, run, text};
use super::c::{assert_converts, exit_of_c, has_c_compiler};
use super::kept::is_as_kept;
use super::kept::wheel_by_bump_and_steer::{
    WHEEL_BY_BUMP_AND_STEER, WHEEL_BY_BUMP_AND_STEER_OUTPUTS,
};
use super::languages::numbers;

/// A double wishbone of two drives, with the hardpoints of its listing.
const FILE: &str = "linkage = \"double_wishbone\"\nunit = \"m\"\n[time]\ninstants = [0.0]\n[drives]\nbump = 0.3\nsteer = 0.34\n";

/// The largest error of the wheel centre, m.
const TOLERANCE: f64 = 1e-5;

/// The drives' ranges: height of the wheel centre and lateral position of the rack, m.
const RANGES: [[f64; 2]; 2] = [[0.24, 0.36], [0.32, 0.36]];

/// Rates of the drives, first and second.
const RATES: [[f64; 2]; 2] = [[0.5, -0.2], [3.0, 1.5]];

const ORDER: [&str; 8] = [
    "bake",
    "double_wishbone.toml",
    "--drive",
    "bump=0.24:0.36",
    "--drive",
    "steer=0.32:0.36",
    "--tolerance",
    "1e-5",
];

fn baked(folder: &Path, arguments: &[&str]) -> String {
    std::fs::write(folder.join("double_wishbone.toml"), FILE).expect("written");
    let output = ["--out", "wheel_by_bump_and_steer"];
    let done = run(folder, &[&ORDER, &output[..], arguments].concat());
    assert_eq!(done.status.code(), Some(0), "{}", text(&done.stderr));
    let message = text(&done.stderr);
    assert!(message.contains(" patches"), "{message}");
    std::fs::read_to_string(folder.join("wheel_by_bump_and_steer")).expect("a file")
}

/// Places all over the ranges, the corners among them.
fn places() -> Vec<[f64; 2]> {
    let along =
        |[from, to]: [f64; 2], part: u32| (from + (to - from) * f64::from(part) / 10.0).min(to);
    let all = (0..=10).flat_map(|first| (0..=10).map(move |second| (first, second)));
    all.map(|(first, second)| [along(RANGES[0], first), along(RANGES[1], second)])
        .collect()
}

/// Returns places with the core's results from the numbers in TOML.
fn expected(folder: &Path) -> Vec<([f64; 2], [[f64; 6]; 3])> {
    let table: toml::Table = baked(folder, &["--as", "toml"]).parse().expect("TOML");
    let pair = |value: &toml::Value| -> [f64; 2] { numbers(value).try_into().expect("two") };
    let flat = numbers(&table["patches"]);
    let (rows, _) = flat.as_chunks::<6>();
    let (by_first, _) = rows.as_chunks::<6>();
    let (patches, rest) = by_first.as_chunks::<6>();
    assert!(rest.is_empty());
    let patches: Vec<Patch<f64, 6, 6>> = patches.to_vec();
    let across = table["across"].as_integer().expect("a number");
    let surface = Surface {
        ranges: RANGES,
        patches_per_unit: pair(&table["patches_per_unit"]),
        across: usize::try_from(across).expect("a count"),
        patches: &patches,
    };
    let read = |at| {
        surface
            .at(at)
            .expect("inside")
            .acceleration(RATES[0], RATES[1])
    };
    places().into_iter().map(|at| (at, read(at))).collect()
}

#[test]
fn a_baked_surface_is_within_tolerance_of_the_solver() {
    let folder = folder();
    let mut worst = [0.0_f64; 3];
    for ([bump, steer], found) in expected(folder.path()) {
        let mut corner: Corner = Corner::design().expect("a corner");
        let start = corner.drives();
        let end = Drives { bump, steer };
        corner
            .advance(1.0, |t| {
                let at = |from: f64, to: f64| from + (to - from) * t;
                Signal::still(Drives {
                    bump: at(start.bump, end.bump),
                    steer: at(start.steer, end.steer),
                })
            })
            .expect("within reach");
        let [rates, second_rates] = RATES.map(Drives::from_values);
        let moved = Signal {
            value: end,
            rate: rates,
            second_rate: second_rates,
        };
        corner.step(1e-9, moved).expect("it is there");
        let points = corner.points();
        let centre = [
            points.value.wheel_centre,
            points.rate.wheel_centre,
            points.second_rate.wheel_centre,
        ];
        for ((worst, found), centre) in worst.iter_mut().zip(found).zip(centre) {
            for axis in 0..3 {
                *worst = worst.max((found[axis] - centre[axis]).abs());
            }
        }
    }
    let [position, velocity, acceleration] = worst;
    assert!(position < TOLERANCE, "{worst:?}");
    assert!(velocity < 2e-3 && acceleration < 0.2, "{worst:?}");
}

#[test]
fn a_baked_rust_surface_gives_the_same_digits() {
    let folder = folder();
    is_as_kept(&baked(folder.path(), &[]), "wheel_by_bump_and_steer.rs");
    for (at, expected) in expected(folder.path()) {
        let found = WHEEL_BY_BUMP_AND_STEER.at(at).expect("inside");
        let found = found.acceleration(RATES[0], RATES[1]);
        assert_eq!(
            found.map(|x| x.map(f64::to_bits)),
            expected.map(|x| x.map(f64::to_bits)),
            "at {at:?}"
        );
    }
    assert!(WHEEL_BY_BUMP_AND_STEER.at([0.3, 0.37]).is_err());
    assert_eq!(WHEEL_BY_BUMP_AND_STEER_OUTPUTS[5], "spin_axis_z");
}

#[test]
fn a_baked_c_surface_gives_the_same_digits() {
    if !has_c_compiler("a_baked_c_surface_gives_the_same_digits") {
        return;
    }
    let folder = folder();
    let mut rows = String::new();
    for ([bump, steer], values) in expected(folder.path()) {
        let each = values.as_flattened().iter();
        let bits: String = each.map(|x| format!("{:#x}, ", x.to_bits())).collect();
        rows += &format!("    {{{{{bump:e}, {steer:e}}}, {{{bits}}}}},\n");
    }
    let [[r0, r1], [s0, s1]] = RATES;
    let header = baked(folder.path(), &["--as", "c"]);
    is_as_kept(&header, "wheel_by_bump_and_steer.h");
    std::fs::write(folder.path().join("wheel.h"), header).expect("written");
    let program = format!(
        r#"#include "wheel.h"
#include <stdint.h>
#include <string.h>
static const struct {{ double at[2]; uint64_t bits[18]; }} rows[] = {{
{rows}}};
int main(void)
{{
    const double rates[2] = {{{r0:?}, {r1:?}}}, second_rates[2] = {{{s0:?}, {s1:?}}}, outside[2] = {{0.3, 0.37}};
    double found[18];
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {{
        if (wheel_by_bump_and_steer(rows[i].at, rates, second_rates, found, found + 6, found + 12) != 0)
            return 1;
        if (memcmp(found, rows[i].bits, sizeof found) != 0)
            return 2;
    }}
    if (wheel_by_bump_and_steer(outside, rates, second_rates, found, NULL, NULL) != 1)
        return 3;
    /* a look-up of the position alone, and one at rest */
    if (wheel_by_bump_and_steer(rows[0].at, NULL, NULL, found, NULL, NULL) != 0 || memcmp(found, rows[0].bits, 48) != 0)
        return 4;
    if (wheel_by_bump_and_steer(rows[0].at, NULL, NULL, found, found + 6, found + 12) != 0)
        return 5;
    for (int i = 6; i < 18; i++)
        if (found[i] != 0.0)
            return 6;
    return 0;
}}
"#
    );
    assert_eq!(exit_of_c(folder.path(), &program), Some(0));
    for number in ["double", "float"] {
        assert_converts(folder.path(), "WHEEL_BY_BUMP_AND_STEER", number);
    }
}

#[test]
fn an_impossible_surface_is_refused_in_one_sentence() {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), FILE).expect("written");
    for (arguments, code, expected) in [
        (
            &["--drive", "bump=0.24:0.36", "--drive", "bump=0.24:0.36"][..],
            2,
            "--drive names one drive, or two different ones",
        ),
        (
            &["--drive", "bump", "--drive", "steer", "--from", "0.3"],
            2,
            "--from and --to give the range of one drive",
        ),
        (
            &["--drive", "bump=0.24:0.36", "--to", "0.3"],
            2,
            "give only one of the two",
        ),
        (
            &[
                "--drive",
                "bump=0.24:0.36",
                "--drive",
                "steer=0.32:0.36",
                "--continuity",
                "2",
            ],
            2,
            "over two drives --continuity is 0 or 1",
        ),
        (
            &["--drive", "bump=0.24:0.36", "--drive", "steer=0.1:0.36"],
            3,
            "bump = 0.24 to 0.36 m, steer = 0.1 to 0.36 m cannot be baked: the mechanism does not reach",
        ),
        (
            &["--drive", "bump=0.36:0.24"],
            2,
            "FROM must be less than TO",
        ),
    ] {
        let output = run(folder.path(), &[&["bake", "a.toml"], arguments].concat());
        let message = text(&output.stderr);
        assert_eq!(output.status.code(), Some(code), "{message}");
        assert!(message.contains(expected), "{message}");
    }
}
