//! An angle about an axis that is half a turn at the design position does not jump there. The same angle with one line reversed
//! is zero there, and gives the same numbers.

use std::path::Path;

use super::program::{folder, rows, run, text};

/// A trailing arm with a bar about its axis; `line` is the chassis line of the angle, in mm and degrees.
fn arm(line: &str, more: &str) -> String {
    format!(
        "unit = \"mm\"\nangle = \"deg\"\nstatements = '''
fixed: front at [100.0, 350.0, 300.0], rear at [-100.0, 350.0, 300.0], inboard at [100.0, 150.0, 300.0];
free:  wheel_centre at [0.0, 750.0, 300.0];
hinge arm: front, rear -> wheel_centre;
point axle: arm at [0.0, 650.0, 300.0];
drive bump: wheel_centre.z;
measure twist: angle({line}, front -> wheel_centre about rear -> front);
wheel: axle -> wheel_centre;
'''
time = {{ start = 0.0, stop = 1.0, step = 0.5 }}
[vehicle]
wheel_radius = 300.0
[drives]
bump = [300.0, 20.0]
[springs.bar]
along = \"twist\"
rate = 50.0
{more}"
    )
}

/// Half a turn at the design, and zero there.
const LINES: [&str; 2] = ["front -> inboard", "inboard -> front"];

fn printed(folder: &Path, file: &str, arguments: &[&str]) -> String {
    std::fs::write(folder.join("a.toml"), file).expect("written");
    let output = run(folder, arguments);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    text(&output.stdout).to_owned()
}

#[test]
fn a_bar_at_half_a_turn_has_the_moment_of_the_reversed_line() {
    let folder = folder();
    let sweep = ["sweep", "a.toml", "--drive", "bump=-20:20:5", "--csv", "-"];
    let [half, zero] =
        LINES.map(|line| rows(printed(folder.path(), &arm(line, ""), &sweep).as_bytes()));
    // The arm turns by the arcsine of 20 / 400.
    let largest = 50.0 * (0.05_f64).asin().to_degrees();
    assert!(
        (half[0]["bar_moment_Nm"] - largest).abs() < 1e-9,
        "{half:?}"
    );
    for (half, zero) in half.iter().zip(&zero) {
        for column in ["bar_moment_Nm", "spring_load_N", "wheel_rate_N_mm"] {
            let off = half[column] - zero[column];
            assert!(off.abs() < 1e-9 * largest, "{column}: {half:?} {zero:?}");
        }
        assert!((half["twist_deg"].abs() - 180.0).abs() < 3.0, "{half:?}");
    }
    let jumps = half
        .windows(2)
        .map(|pair| pair[1]["twist_deg"] - pair[0]["twist_deg"]);
    assert!(jumps.into_iter().all(|jump| jump.abs() < 2.0), "{half:?}");
}

#[test]
fn tuning_and_tolerances_work_through_half_a_turn() {
    let folder = folder();
    let target = "[tune.moves.front_height]\npoints = [\"front\"]\nalong = \"z\"\nby = [-1.0, 1.0]
[tune.targets.twist]\nof = \"twist\"\nover = { bump = [-20.0, 20.0] }\nchange = [-2.8659839825988617, 0.0, 2.8659839825988617]\nwithin = 0.001\n";
    let tuned = printed(
        folder.path(),
        &arm(LINES[0], target),
        &["tune", "a.toml", "--out", "b.toml"],
    );
    assert!(!tuned.contains("not met"), "{tuned}");
    let scattering = "[tolerances]\nwheel_centre = 0.5\nfront = 0.5\n";
    let arguments = ["sensitivities", "a.toml", "--of", "twist"];
    let scattered = printed(folder.path(), &arm(LINES[0], scattering), &arguments);
    let line = scattered.lines().find(|line| line.contains("samples"));
    let numbers = line.into_iter().flat_map(|line| {
        let words = line.split_whitespace();
        words.filter_map(|word| word.parse::<f64>().ok())
    });
    let numbers: Vec<f64> = numbers.collect();
    let [deviation, _, of_samples] = numbers.as_slice() else {
        panic!("{scattered}");
    };
    assert!((of_samples / deviation - 1.0).abs() < 0.15, "{scattered}");
}

#[test]
fn a_measured_angle_is_baked_through_half_a_turn() {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), arm(LINES[0], "")).expect("written");
    let arguments = ["bake", "a.toml", "--along", "twist=178:182", "--out", "-"];
    let output = run(folder.path(), &arguments);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
}
