//! Derivatives where the drive of travel counts downwards, as z does in SAE axes.

use super::super::program::{folder, run, text};

/// An arm of 0.5 m across the vehicle, level at the design position: camber changes by -1 / 0.5 rad per m that the wheel rises.
const ARM: &str = "\
unit = \"m\"
axes = \"SAE\"
time = { instants = [0.0] }
drives.bump = -0.3
statements = '''
fixed: front at [0.2, -0.3, -0.3], rear at [-0.2, -0.3, -0.3];
free: hub at [0.0, -0.8, -0.3];
hinge arm: front, rear -> hub;
point axle: arm at [0.0, -0.7, -0.3];
drive bump: hub.z;
wheel: axle -> hub;
'''
";

fn stdout(arguments: &[&str]) -> String {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), ARM).expect("written");
    let output = run(folder.path(), arguments);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    text(&output.stdout).to_owned()
}

#[test]
fn the_sheet_has_derivatives_per_rise_of_the_wheel_beside_those_per_drive() {
    let page = stdout(&["sheet", "a.toml", "--out", "-"]);
    let (_, row) = page
        .split_once("<td>camber angle</td>")
        .expect("a row of camber");
    let (row, _) = row.split_once("</tr>").expect("its end");
    let cells = row
        .split("</td>")
        .filter_map(|cell| cell.rsplit('>').next());
    let cells: Vec<&str> = cells.map(str::trim).collect();
    let rate = (1.0 / 0.5_f64).to_degrees();
    let [per_bump, per_rise] = [rate, -rate].map(|rate| format!("{rate:.3}"));
    assert_eq!(cells[2..6], [&per_bump, "deg/m", &per_rise, "deg/m"]);
    let headings = [">per bump<", ">per wheel travel (bump)<"];
    let places = headings.map(|heading| page.find(heading).expect(heading));
    assert!(places.is_sorted(), "{places:?}");
    assert!(!page.contains("Over wheel travel"), "as over bump upwards");
}

#[test]
fn compared_derivatives_per_drive_are_not_called_those_of_the_wheel() {
    let report = stdout(&["compare", "a.toml", "a.toml"]);
    assert!(
        report.contains("At the design position, per change of bump at the wheel\n"),
        "{report}"
    );
    assert!(!report.contains("per travel of the wheel"), "{report}");
}

#[test]
fn reports_of_derivatives_per_drive_say_that_it_counts_downwards() {
    let note = "As the wheel rises, `bump` becomes less: derivatives per `bump` have the opposite sign of those per wheel travel.\n";
    for arguments in [
        &["vary", "a.toml", "front.z=0.01"][..],
        &["sensitivities", "a.toml"],
    ] {
        let report = stdout(arguments);
        assert!(report.contains(note), "{report}");
    }
}
