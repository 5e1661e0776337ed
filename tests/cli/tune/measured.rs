//! Targets from measured points.

use super::super::program::{folder, run, text};
use super::{DRIVES, file, met, swept, tuned};

const MOVE: &str = "\
[tune.moves.upper_arm]
points = [\"upper_rear\", \"upper_front\"]
along = \"z\"
by = [-0.03, 0.03]
";

/// A target of camber over 60 mm either way.
fn camber(value: &str) -> String {
    format!(
        "{MOVE}[tune.targets.camber]\nof = \"camber\"\nover = {{ bump = [-0.06, 0.06] }}\nvalue = {value}\nwithin = 1e-4\n"
    )
}

/// Points of a known design's curve, at uneven places and in no order, lead to the design; points outside the range do not
/// count.
#[test]
fn measured_points_of_a_known_design_find_the_design() {
    let folder = folder();
    let known = "[points]\nupper_front = [0.15, 0.42, 0.432]\nupper_rear = [-0.15, 0.42, 0.432]\n";
    let known = file("double_wishbone", DRIVES, known);
    std::fs::write(folder.path().join("a_tuned.toml"), known).expect("written");
    let rows = swept(folder.path());
    let mut points: Vec<[f64; 2]> = [44, 0, 3, 30, 31]
        .map(|row: usize| [rows[row]["bump_m"] - 0.3, rows[row]["camber_deg"]])
        .into();
    points.push([0.07, 100.0]);
    // As a spreadsheet in Germany writes it.
    let lines = points
        .iter()
        .map(|[at, camber]| format!("{camber:?}; left;{at:?}\r\n").replace('.', ","));
    let csv = format!(
        "\u{feff}\"camber, left\";wheel;travel\r\n\r\n{}",
        lines.collect::<String>()
    );
    std::fs::write(folder.path().join("measured.csv"), &csv).expect("written");
    let with_units = csv.replacen("\r\n\r\n", "\r\n[\u{b0}];-;(m)\r\n", 1);
    std::fs::write(folder.path().join("units.csv"), with_units).expect("written");
    let columns = "columns = [\"travel\", \"camber, left\"]";
    for value in [
        format!("{points:?}"),
        format!("{{ csv = \"units.csv\", {columns} }}"),
        format!("{{ csv = \"measured.csv\", {columns} }}"),
    ] {
        let output = met(
            folder.path(),
            &file("double_wishbone", DRIVES, &camber(&value)),
        );
        let expected = "upper_arm  0.012 m";
        assert!(text(&output.stdout).contains(expected), "{output:?}");
    }
    let output = run(folder.path(), &["tune", "a.toml", "--out", "measured.csv"]);
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    let output = run(folder.path(), &["tune", "a.toml", "--out", "sub/b.toml"]);
    let expected = "--out sub/b.toml: the file would not be read there: ";
    assert!(text(&output.stderr).starts_with(expected), "{output:?}");
}

#[test]
fn mistakes_in_measured_points_are_located() {
    let csv = "{ csv = \"measured.csv\", columns = [\"travel\", \"toe\"] }";
    for (value, content, expected) in [
        (
            "[[0.0, 1.0, 2.0]]",
            "",
            "a.toml:16:10: a point is 2 numbers, [drive, value], not 3",
        ),
        (
            "[[0.0, 1.0], 2.0]",
            "",
            "a.toml:16:9: a list has numbers for evenly spaced values of the drive, or points [drive, value], not both",
        ),
        ("[[0.0, nan]]", "", "a.toml:16:9: the target is not finite"),
        (
            "[[nan, 0.1], [0.0, 0.2]]",
            "",
            "a.toml:16:9: the place of a measured point is not finite",
        ),
        (
            "[[-61.0, 0.5], [70.0, 1.0]]",
            "",
            "a.toml:16:9: no measured point is within the range of `over`, from -0.06 to 0.06; the points are from -61 to 70",
        ),
        (
            "[]",
            "",
            "a.toml:13:15: a list of numbers needs exactly one drive",
        ),
        (
            "\"measured.csv\"",
            "",
            "a.toml:16:9: invalid type: string \"measured.csv\", expected a number, ",
        ),
        (
            "{ csv = \"other.csv\", columns = [\"travel\", \"toe\"] }",
            "",
            "a.toml:16:17: other.csv: cannot be read: ",
        ),
        (
            "{ csv = \"measured.csv\", columns = [\"travel\"] }",
            "",
            "a.toml:16:43: `columns` are two headings of the file",
        ),
        (
            csv,
            "travel,camber\n",
            "a.toml:16:54: unknown column of measured.csv: `toe`; known are travel, camber",
        ),
        (
            csv,
            "travel,toe\n",
            "a.toml:16:9: no measured point is within the range of `over`, from -0.06 to 0.06",
        ),
        (
            csv,
            "travel;toe\r\n0,0;1,0\r\n\r\n0,01;0,5,1\r\n",
            "measured.csv:4:6: `0,5,1` in column `toe` is not a finite number, as -0.5",
        ),
        (
            csv,
            "",
            "measured.csv:1:1: the file is empty; it needs a line of headings and lines of numbers",
        ),
        (
            csv,
            "travel,\"camber, left\",toe\n0.0,\"a,b\", wide\n",
            "measured.csv:2:12: `wide` in column `toe`",
        ),
        (
            csv,
            "travel,toe\n0.0,1.0\n0.01\n",
            "measured.csv:3:5: the line has no number in column `toe`",
        ),
        (
            csv,
            "toe,travel\nmm,deg\n",
            "measured.csv:1:5: `travel` is in deg, not in m: convert the column",
        ),
        (
            csv,
            "travel [m],toe\n0,0\n",
            "a.toml:16:44: unknown column of measured.csv: `travel`; known are travel [m], toe",
        ),
        (
            "{ csv = \"measured.csv\", columns = [\"travel\", \"toe_rad\"] }",
            "travel,toe_rad\n0,0\n",
            "measured.csv:1:8: `toe_rad` is in rad, not in deg: convert the column",
        ),
        (
            csv,
            "travel,toe,gap,toe\n0,0,1,0\n",
            "a.toml:16:54: columns 2 and 4 of measured.csv are both called `toe`; rename one",
        ),
        (
            csv,
            "Rig 17,front,,\n\ngap,travel,toe,load\n0,0,0,0\n",
            "a.toml:16:44: `travel` is in line 3 of measured.csv, below the first line of several fields, which has the headings; \
             begin the lines above it with #",
        ),
    ] {
        let folder = folder();
        std::fs::write(folder.path().join("measured.csv"), content).expect("written");
        let output = tuned(
            folder.path(),
            &file("double_wishbone", DRIVES, &camber(value)),
        );
        assert_eq!(output.status.code(), Some(2), "{value}: {output:?}");
        let message = text(&output.stderr);
        assert!(message.starts_with(expected), "{expected}\n{message}");
    }
}

/// Points belong to one curve: without a drive, or over a grid, there is no place for them.
#[test]
fn measured_points_without_a_single_drive_are_refused() {
    let folder = folder();
    let points = camber("[[0.0, 1.0]]");
    let over = "over = { bump = [-0.06, 0.06] }\n";
    let grid = "over = { bump = [-0.06, 0.06], steer = [-0.01, 0.01] }\n";
    for tune in [points.replace(over, ""), points.replace(over, grid)] {
        let output = tuned(folder.path(), &file("double_wishbone", DRIVES, &tune));
        assert_eq!(output.status.code(), Some(2), "{output:?}");
        let expected = "a.toml:13:15: measured points need exactly one drive under `over`";
        assert!(text(&output.stderr).starts_with(expected), "{output:?}");
    }
}
