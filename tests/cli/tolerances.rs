//! The scatter of quantities due to hardpoints and lengths, and the effect of named moves.

use std::collections::BTreeMap;

use super::program::{CORNER, folder, run, text};

/// Returns the rows of the table, by the changed coordinate or length.
fn table(file: &str, more: &[&str]) -> BTreeMap<String, BTreeMap<String, f64>> {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), file).expect("written");
    let arguments = ["sensitivities", "a.toml", "--csv", "-"];
    let output = run(folder.path(), &[&arguments, more].concat());
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let mut reader = csv::Reader::from_reader(output.stdout.as_slice());
    let headings = reader.headers().expect("headings").clone();
    let row = |record: csv::StringRecord| {
        let numbers = headings.iter().zip(record.iter()).skip(1);
        let numbers =
            numbers.map(|(name, number)| (name.to_owned(), number.parse().expect("a number")));
        (record[0].to_owned(), numbers.collect())
    };
    reader
        .records()
        .map(|record| row(record.expect("a row")))
        .collect()
}

const TOLERANCES: &str =
    "[tolerances]\naxle = 0.0005\nwheel_centre = 0.0005\nlower_ball = 0.001\ntie_rod = 0.0002\n";

/// Camber is the slope of a line 0.1 m long, each end of which varies by half a millimetre vertically.
#[test]
fn scatter_of_camber_matches_the_ends_of_the_spin_axis() {
    let points = TOLERANCES.replace("tie_rod = 0.0002\n", "");
    let rows = table(&format!("{CORNER}{points}"), &["--samples", "300"]);
    let expected = 0.0005 * 2.0_f64.sqrt() / 0.1;
    let first_order = rows["standard_deviation"]["camber_rad"];
    assert!(
        (first_order - expected).abs() < 1e-9,
        "{first_order} {expected}"
    );
    // Three hundred samples know a standard deviation to 4 % of it.
    let sampled = rows["standard_deviation_of_samples"]["camber_rad"];
    assert!(
        (sampled / expected - 1.0).abs() < 0.15,
        "{sampled} {expected}"
    );
    assert!(sampled != expected);
}

/// The root of the sum of squares, of bump steer too.
#[test]
fn independent_tolerances_add_by_their_squares() {
    let rows = table(
        &format!("{CORNER}{TOLERANCES}"),
        &["--samples", "400", "--seed", "7"],
    );
    for name in [
        "toe_rad",
        "toe_rad_per_bump",
        "damper_m_per_bump",
        "caster_rad",
    ] {
        let parts = [
            ("axle", 0.0005),
            ("wheel_centre", 0.0005),
            ("lower_ball", 0.001),
        ];
        let points = parts.iter().flat_map(|(point, deviation)| {
            ["x", "y", "z"].map(|axis| rows[&format!("{point}.{axis}")][name] * deviation)
        });
        let squares: f64 = points
            .chain([rows["length tie_rod"][name] * 0.0002])
            .map(|part| part * part)
            .sum();
        let found = rows["standard_deviation"][name];
        assert!((found - squares.sqrt()).abs() <= 1e-12 * found, "{name}");
        let sampled = rows["standard_deviation_of_samples"][name];
        assert!(
            (sampled / found - 1.0).abs() < 0.2,
            "{name}: {sampled} {found}"
        );
    }
    let again = table(
        &format!("{CORNER}{TOLERANCES}"),
        &["--samples", "400", "--seed", "7"],
    );
    assert_eq!(
        rows["standard_deviation_of_samples"],
        again["standard_deviation_of_samples"]
    );
}

/// A move of several points has the sum of its parts' effects.
#[test]
fn the_effect_of_a_named_move_is_the_sum_of_its_points() {
    let moves = "[tune.moves.rack_height]\npoints = [\"rack\", \"tie_ball\"]\nalong = \"z\"\nby = [-0.01, 0.01]\n\
                 [tune.targets.toe]\nof = \"toe\"\nvalue = 0.0\nwithin = 1.0\n";
    let rows = table(&format!("{CORNER}{moves}"), &[]);
    for name in [
        "toe_rad_per_bump",
        "virtual_caster_rad",
        "toe_rad_per_steer",
    ] {
        let expected = rows["rack.z"][name] + rows["tie_ball.z"][name];
        let found = rows["rack_height"][name];
        assert!(
            (found - expected).abs() <= 1e-7 * (1.0 + expected.abs()),
            "{name}: {found} {expected}"
        );
    }
}

#[test]
fn both_deviations_are_printed_and_wrong_tolerances_refused() {
    let folder = folder();
    std::fs::write(
        folder.path().join("a.toml"),
        format!("{CORNER}{TOLERANCES}"),
    )
    .expect("written");
    let output = run(
        folder.path(),
        &["sensitivities", "a.toml", "--of", "camber"],
    );
    let report = text(&output.stdout);
    assert!(
        report.contains("\n  standard deviation 0.4052 deg; of 1000 samples (seed 1) 0."),
        "{report}"
    );
    for (stated, expected) in [
        ("axel = 0.001", "unknown point or link `axel`; known are "),
        (
            "axle = -0.001",
            "a tolerance must be zero or a positive number: the standard deviation in the unit of lengths",
        ),
    ] {
        let file = format!("{CORNER}[tolerances]\n{stated}\n");
        std::fs::write(folder.path().join("a.toml"), file).expect("written");
        let output = run(folder.path(), &["sensitivities", "a.toml"]);
        assert_eq!(output.status.code(), Some(2), "{output:?}");
        assert!(
            text(&output.stderr).contains(expected),
            "{expected}: {output:?}"
        );
    }
}

/// In a file in metres a tolerance in millimetres is noted; a zero tolerance, for a point that does not scatter, is not.
#[test]
fn a_tolerance_in_another_unit_is_noted() {
    for (stated, expected) in [
        ("0.0005", None),
        ("0.0", None),
        (
            "0.5",
            Some(
                "note: a.toml: the tolerance of `tie_rod` is 0.5 m: is it in mm? The file is in m",
            ),
        ),
    ] {
        let folder = folder();
        let file = format!("{CORNER}[tolerances]\ntie_rod = {stated}\n");
        std::fs::write(folder.path().join("a.toml"), file).expect("written");
        let output = run(
            folder.path(),
            &["sensitivities", "a.toml", "--samples", "10"],
        );
        let messages = text(&output.stderr);
        let note = messages.lines().find(|line| line.starts_with("note: "));
        assert_eq!(note, expected, "{messages}");
    }
}
