//! Angles in degrees.

use std::f64::consts::TAU;

use super::program::{Rows, folder, rows, run, text};

const FIVE_LINK: &str = include_str!("../../examples/five_link.toml");

/// The example in degrees, its drive at the same angles.
fn in_degrees() -> String {
    let [start, rate] = [0.8_f64, 0.6].map(f64::to_degrees);
    let turned = FIVE_LINK.replace("unit = \"mm\"", "unit = \"mm\"\nangle = \"deg\"");
    let turned = turned.replace(
        "theta = [0.8, 0.6]",
        &format!("theta = [{start:?}, {rate:?}]"),
    );
    assert!(turned.contains("\"deg\"") && !turned.contains("[0.8, 0.6]"));
    turned
}

fn degrees(radians: f64) -> String {
    format!("{:?}", radians.to_degrees())
}

/// Both tables of a command, in radians and in degrees.
fn rows_of_both(in_radians: &[&str], with_degrees: &[&str]) -> [Rows; 2] {
    let folder = folder();
    std::fs::write(folder.path().join("rad.toml"), FIVE_LINK).expect("written");
    std::fs::write(folder.path().join("deg.toml"), in_degrees()).expect("written");
    [("rad.toml", in_radians), ("deg.toml", with_degrees)].map(|(file, arguments)| {
        let arguments = [&arguments[..1], &[file], &arguments[1..], &["--csv", "-"]].concat();
        let output = run(folder.path(), &arguments);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        rows(&output.stdout)
    })
}

/// Asserts that the numbers are equal, those in degrees in their own columns.
fn assert_same_rows([radians, degrees]: &[Rows; 2]) {
    assert_eq!(radians.len(), degrees.len());
    let mut angles = 0;
    for (radians, degrees) in radians.iter().zip(degrees) {
        assert_eq!(radians.len(), degrees.len());
        for (name, value) in radians {
            let is_rate = ["omega_", "alpha_"]
                .iter()
                .any(|rate| name.starts_with(rate));
            let (quantity, drive) = name.split_once("_per_").unwrap_or((name, ""));
            let mut scale = match quantity.strip_suffix("_rad").is_some() || is_rate {
                true => 1_f64.to_degrees(),
                false => 1.0,
            };
            scale *= match drive {
                "" => 1.0,
                "theta" => 1_f64.to_radians(),
                _ => 1_f64.to_radians().powi(2),
            };
            let found = degrees[&name.replace("_rad", "_deg")];
            let expected = value * scale;
            let are_close = (found - expected).abs() <= 1e-9 * (1e-3 + expected.abs());
            assert!(
                are_close || (found.is_nan() && expected.is_nan()),
                "{name}: {found} {expected}"
            );
            angles += usize::from(scale != 1.0);
        }
    }
    assert!(angles > 0);
}

#[test]
fn a_motion_in_degrees_equals_that_in_radians() {
    assert_same_rows(&rows_of_both(&["motion"], &["motion"]));
}

#[test]
fn a_sweep_with_derivatives_in_degrees_equals_that_in_radians() {
    let [from, to] = [-0.1, 0.3].map(degrees);
    let in_degrees = format!("theta={from}:{to}:5");
    assert_same_rows(&rows_of_both(
        &["sweep", "--derivatives", "2", "--drive", "theta=-0.1:0.3:5"],
        &["sweep", "--derivatives", "2", "--drive", &in_degrees],
    ));
}

#[test]
fn assemblies_in_degrees_equal_those_in_radians() {
    let at = degrees(1.1);
    assert_same_rows(&rows_of_both(
        &["assemblies", "--at", "1.1"],
        &["assemblies", "--at", &at],
    ));
}

#[test]
fn loads_in_degrees_equal_those_in_radians() {
    let folder = folder();
    let case = "\n[loads.weight]\nwheel_centre = [0.0, 0.0, 3000.0]\n";
    let found = [FIVE_LINK.to_owned(), in_degrees()].map(|file| {
        std::fs::write(folder.path().join("a.toml"), file + case).expect("written");
        rows(&run(folder.path(), &["loads", "a.toml", "--csv", "-"]).stdout)[0]["weight_theta_Nm"]
    });
    assert!(
        (found[0] - found[1]).abs() < 1e-9 * found[0].abs(),
        "{found:?}"
    );
}

/// Baked files are for programs, so their angles are in radians.
#[test]
fn a_file_in_degrees_is_baked_in_radians() {
    let [from, to] = [0.9, 1.5].map(degrees);
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), FIVE_LINK).expect("written");
    let bake = |from: &str, to: &str| {
        let arguments = [
            "bake", "a.toml", "--from", from, "--to", to, "--out", "a.rs",
        ];
        let output = run(folder.path(), &arguments);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        std::fs::read_to_string(folder.path().join("a.rs")).expect("a file")
    };
    let in_radians = bake("0.9", "1.5");
    std::fs::write(folder.path().join("a.toml"), in_degrees()).expect("written");
    let found = bake(&from, &to);
    let head = |text: &str| {
        text.lines()
            .take_while(|line| line.starts_with("//"))
            .map(str::to_owned)
            .collect::<Vec<_>>()
    };
    let rad = |lines: Vec<String>| {
        lines
            .into_iter()
            .filter(|line| line.contains(" rad"))
            .count()
    };
    assert_eq!(rad(head(&in_radians)), rad(head(&found)));
    assert_eq!(in_radians.lines().count(), found.lines().count());
}

#[test]
fn comparing_files_in_degrees_and_radians_finds_no_difference() {
    let folder = folder();
    let travel = "\nvehicle = { travel = \"theta\" }\n";
    let with = |file: String| file.replacen("unit = \"mm\"", &format!("unit = \"mm\"{travel}"), 1);
    std::fs::write(folder.path().join("rad.toml"), with(FIVE_LINK.to_owned())).expect("written");
    std::fs::write(folder.path().join("deg.toml"), with(in_degrees())).expect("written");
    let output = run(
        folder.path(),
        &["compare", "rad.toml", "deg.toml", "--csv", "-"],
    );
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let mut reader = csv::Reader::from_reader(output.stdout.as_slice());
    let mut count = 0;
    for record in reader.records() {
        let record = record.expect("a row");
        let [a, b]: [f64; 2] = [4, 5].map(|column| record[column].parse().expect("a number"));
        assert!((a - b).abs() <= 1e-8 * (1e-3 + a.abs()), "{record:?}");
        count += 1;
    }
    assert!(count > 10, "{count}");
}

#[test]
fn messages_about_a_file_in_degrees_are_in_degrees() {
    let folder = folder();
    let path = folder.path().join("a.toml");
    std::fs::write(&path, in_degrees()).expect("written");
    let check = run(folder.path(), &["check", "a.toml"]);
    let report = text(&check.stdout);
    assert!(report.contains("theta = 90 deg"), "{report}");
    assert!(report.contains(" deg from the design"), "{report}");
    let locked = run(folder.path(), &["sweep", "a.toml", "--drive", "theta=80.0"]);
    assert_eq!(locked.status.code(), Some(3), "{locked:?}");
    assert!(
        text(&locked.stderr).contains(" deg from the design (theta = 12"),
        "{locked:?}"
    );
    let beyond = run(folder.path(), &["assemblies", "a.toml", "--at", "200"]);
    assert!(
        text(&beyond.stderr)
            .contains("--at 200: the angle of a link from an axis must lie between 0 and 180 deg"),
        "{beyond:?}"
    );
    std::fs::write(&path, in_degrees().replace("\"deg\"", "\"grad\"")).expect("written");
    let refused = run(folder.path(), &["check", "a.toml"]);
    assert_eq!(refused.status.code(), Some(2), "{refused:?}");
    assert!(
        text(&refused.stderr).contains("unknown word `grad`, expected `rad` or `deg`"),
        "{refused:?}"
    );
}

/// The header of JSON rows states the unit of angles.
#[test]
fn the_json_header_names_the_unit_of_angles() {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), in_degrees()).expect("written");
    let output = run(folder.path(), &["motion", "a.toml", "--json", "-"]);
    assert!(
        text(&output.stdout).contains("\"angle\":\"deg\""),
        "{output:?}"
    );
}

/// A hinge whose arm is driven about its axis.
const HINGE: &str = "statements = '''
fixed: a at [0.0, 0.0, 0.3], ahead at [0.2, 0.0, 0.3], mark at [0.0, 0.3, 0.3];
free: p at [0.1, 0.0, 0.5];
hinge arm: a, ahead -> p;
drive turn: angle(a -> mark, a -> p about a -> ahead);
'''
unit = \"m\"
time = { instants = [0.0, 1.0] }
";

/// Beyond a whole turn the equations have the sine and cosine of an angle on its way back.
#[test]
fn driving_an_angle_about_an_axis_past_a_whole_turn_is_refused() {
    let folder = folder();
    for start in 0..40 {
        let start = 5.4 + 0.02 * f64::from(start);
        let file = format!("{HINGE}[drives]\nturn = [{start:?}, 1.0]\n");
        std::fs::write(folder.path().join("a.toml"), file).expect("written");
        let output = run(folder.path(), &["motion", "a.toml", "--csv", "-"]);
        let passes = start + 1.0 >= TAU;
        assert_eq!(
            output.status.code(),
            Some(if passes { 3 } else { 0 }),
            "{start}: {output:?}"
        );
        let is_reported = text(&output.stderr).contains(
            "the angle `turn` ends at 6.28319 rad, and beyond it the same positions repeat",
        );
        assert_eq!(is_reported, passes, "{start}: {output:?}");
    }
    let output = run(
        folder.path(),
        &["sweep", "a.toml", "--drive", "turn=6.65", "--csv", "-"],
    );
    assert_eq!(output.status.code(), Some(3), "{output:?}");
}

/// The equation of an angle between a link and an axis contains its cosine, which does not change near the axis.
#[test]
fn an_angle_at_its_end_is_refused_with_an_angle_about_a_line() {
    let at_end = |arm: &str, turn: &str| {
        let listing = [
            (
                "angle(a -> mark, a -> p about a -> ahead)",
                "angle(a -> p, z)",
            ),
            (", mark at [0.0, 0.3, 0.3]", ""),
            ("[0.1, 0.0, 0.5]", arm),
        ];
        let listing = listing
            .into_iter()
            .fold(HINGE.to_owned(), |listing, (old, new)| {
                listing.replace(old, new)
            });
        format!("{listing}[drives]\nturn = {turn}\n")
    };
    let beside_another = |file: String| {
        let other = "fixed: b at [1.0, 0.0, 0.3], beside at [1.5, 0.0, 0.3];\nfree: s at [1.0, 0.1, 0.5];\n\
                     hinge second: b, beside -> s;\ndrive lift: s.z;\n";
        file.replacen("fixed:", &format!("{other}fixed:"), 1) + "lift = 0.5\n"
    };
    let expected = "the angle `turn` ends at 0 rad, and beyond it the same positions repeat; to drive it beyond, write it in the listing as \
                an angle about a line: `angle(p -> q, r -> s about t -> u)`";
    let stands = || at_end("[0.0, 0.0, 0.5]", "0.0");
    for (file, command, code) in [
        (at_end("[0.0, 0.0, 0.5]", "[0.0, 0.5]"), "motion", 3),
        (stands(), "check", 3),
        (stands(), "range", 0),
        (beside_another(stands()), "range", 3),
        (at_end("[0.0, 0.1, 0.5]", "0.0"), "motion", 3),
        (at_end("[0.0, 0.1, 0.5]", "[0.3, -0.5]"), "motion", 3),
    ] {
        let folder = folder();
        std::fs::write(folder.path().join("a.toml"), &file).expect("written");
        let output = run(folder.path(), &[command, "a.toml"]);
        assert_eq!(output.status.code(), Some(code), "{file}: {output:?}");
        let message = text(&output.stderr);
        assert!(
            message.contains(expected) && !message.contains("pivot"),
            "{file}: {message}"
        );
        assert!(!text(&output.stdout).contains("NaN"), "{output:?}");
    }
}

/// The design value is more than half a turn from the points, and the mechanism cannot be assembled there.
#[test]
fn a_drive_angle_on_another_turn_than_its_design_is_named() {
    let folder = folder();
    let statements = "fixed: af at [0.3, 0.3, 0.2], ar at [-0.25, 0.28, 0.18], uf at [0.15, 0.42, 0.42], ur at [-0.15, 0.42, 0.44];
fixed: rk at [0.12, 0.33, 0.2], mark at [0.0, 0.5, 0.35];
free: lb at [0.0, 0.7, 0.16], ub at [-0.02, 0.66, 0.44], tb at [0.12, 0.67, 0.21], wc at [0.0, 0.75, 0.3];
hinge lower: af, ar -> lb;
hinge upper: uf, ur -> ub;
body knuckle: lb, ub, tb, wc;
link tie: rk -> tb;
drive bar: angle(af -> mark, af -> lb about ar -> af);
";
    let file = |bar: f64| {
        format!(
            "statements = '''\n{statements}'''\nunit = \"m\"\nangle = \"deg\"\ntime = {{ instants = [0.0] }}\n\
             [design]\nbar = {bar}\n[drives]\nbar = {bar}\n"
        )
    };
    for (bar, code) in [(-41.418_160_4, 0), (-41.418_160_4 + 360.0, 3)] {
        std::fs::write(folder.path().join("a.toml"), file(bar)).expect("written");
        let output = run(folder.path(), &["check", "a.toml"]);
        assert_eq!(output.status.code(), Some(code), "{bar}: {output:?}");
        let expected = "`bar` is -41.4182 deg at the points, and [design] must state a value less than half a turn from it";
        assert_eq!(
            text(&output.stderr).contains(expected),
            code == 3,
            "{output:?}"
        );
    }
}
