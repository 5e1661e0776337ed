//! Drives that are sines or recordings.

use std::f64::consts::TAU;
use std::fmt::Write as _;

use super::program::{Rows, folder, run, table, table_in, text};

/// A corner whose bump is stated as `law`, between 0 and 1 s.
fn corner(law: &str) -> String {
    format!(
        "linkage = \"double_wishbone\"\nunit = \"m\"\n[time]\nstart = 0.0\nstop = 1.0\nstep = 0.05\n\
         [drives]\nsteer = 0.34\nbump = {law}\n"
    )
}

/// An arm about the x axis, with a tip whose height is stated as `law`.
fn arm(unit: &str, law: &str) -> String {
    format!(
        "unit = {unit:?}\nstatements = \"\"\"\nfixed: front at [30, 0, 0], rear at [-20, 0, 0];\nfree: tip at [0, 50, 0];\n\
         hinge arm: front, rear -> tip;\ndrive bump: tip.z;\n\"\"\"\n[time]\nstart = 0.0\nstop = 1.0\nstep = 0.5\n\
         [drives]\nbump = {law}\n"
    )
}

const SINE: &str = "{ mean = 0.30, amplitude = 0.05, frequency = 1.5, phase = 0.4 }";

/// The sine with its rates.
fn sine(t: f64) -> [f64; 3] {
    let rate = TAU * 1.5;
    let (sine, cosine) = (rate * t + 0.4).sin_cos();
    [
        0.30 + 0.05 * sine,
        0.05 * rate * cosine,
        -0.05 * rate * rate * sine,
    ]
}

/// Asserts that two tables have the same columns and numbers, within a part of their sizes.
fn assert_near(found: &Rows, expected: &Rows, within: f64) {
    assert_eq!(found.len(), expected.len());
    for (found, expected) in found.iter().zip(expected) {
        assert!(found.keys().eq(expected.keys()));
        for (name, number) in expected {
            let off = (found[name] - number).abs();
            assert!(off <= within * number.abs().max(1.0), "{name}: {off:e}");
        }
    }
}

/// At each instant the motion is that of the parabola with the same value and rates.
#[test]
fn a_sine_has_its_value_and_rates() {
    let all = table(&corner(SINE), &["motion"]);
    assert_eq!(all.len(), 21);
    for row in all.iter().step_by(5) {
        let [value, rate, second_rate] = sine(row["t_s"]);
        assert!((row["bump_m"] - value).abs() < 1e-15);
        let parabola = corner(&format!("[{value:?}, {rate:?}, {:?}]", second_rate / 2.0));
        let at_start = parabola.replace("stop = 1.0", "stop = 0.0");
        let mut alone = table(&at_start, &["motion"]);
        for name in ["t_s", "iterations", "residual_m"] {
            alone[0].insert(name.to_owned(), row[name]);
        }
        assert_near(&vec![row.clone()], &alone, 1e-11);
    }
}

#[test]
fn the_phase_of_a_sine_and_an_angle_are_in_the_unit_of_angles() {
    let five_link = include_str!("../../examples/five_link.toml");
    let in_degrees = five_link.replace("unit = \"mm\"", "unit = \"mm\"\nangle = \"deg\"");
    let [radians, degrees] = [
        (
            five_link,
            "{ mean = 1.5, amplitude = 0.5, frequency = 0.7, phase = 0.3 }".to_owned(),
        ),
        (
            in_degrees.as_str(),
            format!(
                "{{ mean = {:?}, amplitude = {:?}, frequency = 0.7, phase = {:?} }}",
                1.5_f64.to_degrees(),
                0.5_f64.to_degrees(),
                0.3_f64.to_degrees()
            ),
        ),
    ]
    .map(|(file, law)| table(&file.replace("[0.8, 0.6]", &law), &["motion"]));
    for (radians, degrees) in radians.iter().zip(&degrees) {
        assert!((radians["theta_rad"].to_degrees() - degrees["theta_deg"]).abs() < 1e-12);
        assert!((radians["lower_front_outer_az"] - degrees["lower_front_outer_az"]).abs() < 1e-7);
    }
}

#[test]
fn a_measure_is_led_by_a_sine() {
    let by_height = include_str!("../../examples/five_link_height.toml");
    let line = by_height.lines().find(|line| line.starts_with("height = "));
    let law = "height = { mean = 18.5, amplitude = 20.0, frequency = 0.5 }";
    let rows = table(&by_height.replace(line.expect("led"), law), &["motion"]);
    for row in rows {
        let height = 18.5 + 20.0 * (TAU * 0.5 * row["t_s"]).sin();
        assert!((row["height_mm"] - height).abs() < 1e-9, "{row:?}");
    }
}

/// The samples of a sine, as a spreadsheet with decimal commas writes them.
fn recording(count: u32) -> String {
    (0..=count).fold("t;travel\n".to_owned(), |mut all, k| {
        let t = f64::from(k) / f64::from(count);
        let line = format!("{t};{:.17}\n", sine(t)[0]).replace('.', ",");
        let _ = all.write_str(&line);
        all
    })
}

/// The error of a cubic spline falls with the fourth power of the distance of its points, that of its second derivative
/// with the second.
#[test]
fn a_recording_is_followed_smoothly() {
    let folder = folder();
    let write =
        |name: &str, text: &str| std::fs::write(folder.path().join(name), text).expect("written");
    write("sine.toml", &corner(SINE));
    write("logged.csv", &recording(400));
    write(
        "logged.toml",
        &corner("{ csv = \"logged.csv\", columns = [\"t\", \"travel\"] }"),
    );
    let sine = table_in(folder.path(), &["motion", "sine.toml"]);
    let logged = table_in(folder.path(), &["motion", "logged.toml"]);
    for (sine, logged) in sine.iter().zip(&logged) {
        for (name, within) in [
            ("lower_ball_z", 1e-9),
            ("lower_ball_vz", 1e-6),
            ("lower_ball_az", 1e-2),
        ] {
            let off = (sine[name] - logged[name]).abs();
            assert!(off < within, "{name} at {}: {off:e}", sine["t_s"]);
        }
    }
}

/// Beyond its ends a recording says nothing: the motion that `range` looks for ends there.
#[test]
fn a_recording_is_not_continued() {
    let folder = folder();
    let law = "{ csv = \"logged.csv\", columns = [\"t\", \"travel\"] }";
    std::fs::write(folder.path().join("logged.csv"), recording(100)).expect("written");
    std::fs::write(folder.path().join("a.toml"), corner(law)).expect("written");
    let output = run(folder.path(), &["range", "a.toml", "--drive", "bump"]);
    let report = text(&output.stdout);
    let expected = "  motion      the file's motion brings this drive to neither end; it is not continued beyond a recording\n";
    assert!(report.contains(expected), "{report}");
}

/// Logged files state units in headings or in a line below them; a unit that is not that of the file is refused.
#[test]
fn units_of_recordings_are_those_of_the_file() {
    let folder = folder();
    let write =
        |name: &str, text: &str| std::fs::write(folder.path().join(name), text).expect("written");
    let motion = |headings: [&str; 2], below: &str, more: &str| {
        let logged = format!(
            "{};{}\n{below}0;0,30\n500;0,31\n1000;0,30\n",
            headings[0], headings[1]
        );
        write("logged.csv", &logged);
        let law = format!("{{ csv = \"logged.csv\", columns = {headings:?}{more} }}");
        write("a.toml", &corner(&law));
        let output = run(folder.path(), &["motion", "a.toml"]);
        (output.status.code(), text(&output.stderr).to_owned())
    };
    for (headings, below) in [
        (["t", "travel"], ""),
        (["t_s", "travel_m"], ""),
        (["Zeit [s]", "travel (left)"], ""),
        (["Time (sec)", "travel"], ""),
        (["t", "travel"], "s;m\n"),
        (["t", "travel"], "[s];[m]\n"),
    ] {
        assert_eq!(motion(headings, below, ""), (Some(0), String::new()));
    }
    let factor = "state the factor between them, factor = 0.001\n";
    for (headings, below, at, stated) in [
        (["t_ms", "travel"], "", 1, "`t_ms` is in ms"),
        (["Zeit [ms]", "travel"], "", 1, "`Zeit [ms]` is in ms"),
        (["t", "travel [mm]"], "", 3, "`travel [mm]` is in mm"),
        (["t", "travel / mm"], "", 3, "`travel / mm` is in mm"),
        (["t", "travel in mm"], "", 3, "`travel in mm` is in mm"),
        (["t", "travel"], "s;mm\n", 3, "`travel` is in mm"),
    ] {
        let needed = match at {
            1 => "not in s: convert the column\n",
            _ => &format!("not in m: {factor}"),
        };
        let refused = format!("logged.csv:1:{at}: {stated}, {needed}");
        assert_eq!(motion(headings, below, ""), (Some(2), refused));
    }
    let scaled = motion(["t", "travel [mm]"], "", ", factor = 1.001");
    assert_eq!(scaled, (Some(0), String::new()));
    // The factor leads from the unit of the recording to that of the file.
    for (unit, heading, remedy) in [
        (
            "mm",
            "z [m]",
            "state the factor between them, factor = 1000\n",
        ),
        (
            "mm",
            "z [in]",
            "state the factor between them, factor = 25.4\n",
        ),
        (
            "in",
            "z [mm]",
            "state the factor between them, factor = 0.0393700787401574",
        ),
        (
            "mm",
            "z [cm]",
            "convert the column, or state the factor between them\n",
        ),
        (
            "mm",
            "z [deg]",
            "convert the column, or state the factor between them\n",
        ),
    ] {
        write("logged.csv", &format!("t,{heading}\n0,0.3\n1,0.3\n"));
        let law = format!("{{ csv = \"logged.csv\", columns = [\"t\", {heading:?}] }}");
        write("a.toml", &arm(unit, &law));
        let output = run(folder.path(), &["motion", "a.toml"]);
        assert_eq!(output.status.code(), Some(2), "{output:?}");
        let printed = text(&output.stderr);
        assert!(
            printed.contains(&format!(", not in {unit}: {remedy}")),
            "{printed}"
        );
    }
}

#[test]
fn mistakes_in_recordings_have_their_place() {
    let folder = folder();
    let write =
        |name: &str, text: &str| std::fs::write(folder.path().join(name), text).expect("written");
    write(
        "logged.csv",
        "t,bump,gap\n0,0.30,1\n0.5,0.31,\n0.9,0.30,2\n",
    );
    write("back.csv", "t,bump\n0,0.30\n0.5,0.31\n0.5,0.32\n2,0.30\n");
    write("one.csv", "t,bump\n0,0.30\n");
    let large = std::fs::File::create(folder.path().join("large.csv")).expect("a file");
    large.set_len((64 << 20) + 1).expect("a file with a hole");
    let refused = |law: &str, message: &str| {
        write("a.toml", &corner(law));
        let output = run(folder.path(), &["motion", "a.toml"]);
        assert_eq!(output.status.code(), Some(2), "{output:?}");
        let printed = text(&output.stderr);
        assert!(printed.starts_with(message), "{printed}");
    };
    refused(
        "{ csv = \"logged.csv\", columns = [\"t\", \"bump\"] }",
        "a.toml:9:16: logged.csv covers 0 to 0.9 s, but the motion takes 0 to 1 s; change [time]",
    );
    let forwards = "start = 0.0\nstop = 1.0\nstep = 0.05";
    let backwards = "start = 1.0\nstop = 0.0\nstep = -0.05";
    let law = "{ csv = \"logged.csv\", columns = [\"t\", \"bump\"] }";
    write("b.toml", &corner(law).replace(forwards, backwards));
    let output = run(folder.path(), &["motion", "b.toml"]);
    let expected =
        "b.toml:9:16: logged.csv covers 0 to 0.9 s, but the motion takes 1 to 0 s; change [time]";
    assert!(text(&output.stderr).starts_with(expected), "{output:?}");
    refused(
        "{ csv = \"back.csv\", columns = [\"t\", \"bump\"] }",
        "back.csv:4:1: times must increase, but 0.5 s follows 0.5 s; leave out one of the lines, or correct the time",
    );
    refused(
        "{ csv = \"one.csv\", columns = [\"t\", \"bump\"] }",
        "a.toml:9:16: one.csv needs at least two lines of numbers",
    );
    refused(
        "{ csv = \"logged.csv\", columns = [\"t\", \"bumb\"] }",
        "a.toml:9:46: unknown column of logged.csv: `bumb`; known are t, bump, gap; did you mean `bump`?",
    );
    refused(
        "{ csv = \"large.csv\", columns = [\"t\", \"bump\"] }",
        "a.toml:9:16: large.csv: is larger than 64 MiB; leave out columns and lines that are not needed",
    );
    refused(
        "{ csv = \"no.csv\", columns = [\"t\", \"bump\"] }",
        "a.toml:9:16: ",
    );
    refused(
        "{ csv = \"logged.csv\" }",
        "a.toml:9:8: missing field `columns`; write ",
    );
    refused(
        "{ csv = \"logged.csv\", columns = [\"t\", \"bump\"], mean = 0.3 }",
        "a.toml:9:8: a drive is a sine, with mean, amplitude, frequency and phase, or a recording, with csv, ",
    );
    refused(
        "{ csv = \"logged.csv\", columns = [\"t\"] }",
        "a.toml:9:40: `columns` are two headings",
    );
}

/// A log in millimetres of compression from the design position.
#[test]
fn a_recording_has_a_factor_and_an_offset() {
    let folder = folder();
    let write = |name: &str, text: &str| {
        std::fs::write(folder.path().join(name), text).expect("written");
    };
    write("logged.csv", "t,up\n0,0.30\n0.5,0.33\n1,0.29\n");
    write("mm.csv", "t,down\n0,0\n0.5,-30\n1,10\n");
    let law = "{ csv = \"logged.csv\", columns = [\"t\", \"up\"] }";
    write("own.toml", &corner(law));
    let law = "{ csv = \"mm.csv\", columns = [\"t\", \"down\"], factor = -0.001, offset = 0.30 }";
    write("mm.toml", &corner(law));
    let [own, mm] = ["own.toml", "mm.toml"].map(|file| table_in(folder.path(), &["motion", file]));
    let compared = ["bump_m", "lower_ball_vz", "lower_ball_az"];
    for (own, mm) in own.iter().zip(&mm) {
        assert!(
            compared
                .iter()
                .all(|name| (own[*name] - mm[*name]).abs() < 1e-11)
        );
    }
    write("mm.toml", &corner(&law.replace(", offset = 0.30", "")));
    let refused = run(folder.path(), &["motion", "mm.toml"]);
    let note = "`bump` takes the drive's own value, not a change from the design position: `bump` is 0.3 m at the design \
                position; write offset = 0.3\n";
    assert!(text(&refused.stderr).ends_with(note), "{refused:?}");
}

/// A recording is an input, onto which no result is written.
#[test]
fn a_recording_is_not_overwritten() {
    let folder = folder();
    let path = folder.path().join("logged.csv");
    std::fs::write(&path, recording(40)).expect("written");
    let law = "{ csv = \"logged.csv\", columns = [\"t\", \"travel\"] }";
    std::fs::write(folder.path().join("a.toml"), corner(law)).expect("written");
    let output = run(folder.path(), &["motion", "a.toml", "--csv", "logged.csv"]);
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    assert_eq!(std::fs::read_to_string(path).expect("there"), recording(40));
}
