//! The units of length that a motion file may have.

use std::fmt::Write;

use suspension_core::linkages::LISTINGS;
use suspension_core::listing::{Part, Parts};
use suspension_runtime::Listing;

use super::program::{Rows, folder, rows, run, text};

/// The catalogue's double wishbone as a motion file, with its hardpoints in a unit of which `metre` is one metre.
fn in_unit(unit: &str, metre: f64) -> String {
    let mut texts = LISTINGS.iter();
    let (_, listing) = texts.find(|(name, _)| *name == "double_wishbone").unwrap();
    let listing = Listing::parse(listing).expect("a listing");
    let mut file = format!("linkage = \"double_wishbone\"\nunit = \"{unit}\"\n");
    file += "vehicle = { wheel_radius = RADIUS }\ntime = { instants = [0.0] }\n[points]\n";
    file = file.replace("RADIUS", &format!("{:?}", 0.3 * metre));
    for (point, at) in listing.stated() {
        let [x, y, z] = (at * metre).into();
        let name = listing.name(Part::Point(point));
        writeln!(file, "{name} = [{x:?}, {y:?}, {z:?}]").unwrap();
    }
    let [bump, steer] = [0.30, 0.34].map(|value: f64| value * metre);
    writeln!(file, "[drives]\nbump = {bump:?}\nsteer = {steer:?}").unwrap();
    file
}

/// Returns a sweep of it.
fn swept(unit: &str, metre: f64) -> Rows {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), in_unit(unit, metre)).expect("written");
    let travel = format!("bump={:?}:{:?}:7", -0.06 * metre, 0.06 * metre);
    let arguments = ["sweep", "a.toml", "--drive", &travel, "--csv", "-"];
    let output = run(folder.path(), &arguments);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    assert_eq!(text(&output.stderr), "");
    rows(&output.stdout)
}

#[test]
fn results_are_equal_in_metres_millimetres_and_inches() {
    let metres = swept("m", 1.0);
    assert_eq!(metres.len(), 7);
    for (unit, metre) in [("mm", 1e3), ("in", 1.0 / 0.0254)] {
        for (row, expected) in swept(unit, metre).iter().zip(&metres) {
            let close = |name: &str, expected: f64| {
                let off = (row[name] - expected).abs();
                assert!(off <= 1e-11 * expected.abs().max(1.0), "{name}: {off:.1e}");
            };
            close("camber_rad", expected["camber_rad"]);
            let scrub = expected["scrub_radius_m"] * metre;
            close(&format!("scrub_radius_{unit}"), scrub);
            close("upper_ball_z", expected["upper_ball_z"] * metre);
        }
    }
}

#[test]
fn inches_are_a_word_in_sentences() {
    let folder = folder();
    let file = in_unit("in", 1.0 / 0.0254);
    std::fs::write(folder.path().join("a.toml"), &file).expect("written");
    let bake = ["bake", "a.toml", "--drive", "bump=11:12", "--out", "-"];
    for arguments in [
        &["check", "a.toml"][..],
        &["sheet", "a.toml", "--out", "-"],
        &bake,
    ] {
        let output = run(folder.path(), arguments);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        let printed = text(&output.stdout).to_lowercase();
        assert!(printed.contains("lengths in inches"), "{arguments:?}");
    }
    let lines = file.lines().filter(|line| !line.starts_with("rack"));
    let missing = lines.collect::<Vec<_>>().join("\n");
    std::fs::write(folder.path().join("a.toml"), missing).expect("written");
    let output = run(folder.path(), &["check", "a.toml"]);
    let message = text(&output.stderr);
    assert!(message.ends_with("state all in inches\n"), "{message}");
}
