//! The quantities that may be targets.

use super::super::program::{folder, run, text};
use super::{file, met, target, tuned};

/// A name may begin with a shorter one: `camber_to_ground`, `kingpin_offset`.
#[test]
fn every_quantity_of_sensitivities_may_be_a_target() {
    let folder = folder();
    let drives = "steer = 0.34\nbump_left = 0.3\nbump_right = 0.3";
    let axle =
        |tune: &str| file("steered_axle", drives, tune).replace("0.3 }", "0.3, wheelbase = 2.6 }");
    std::fs::write(folder.path().join("a.toml"), axle("")).expect("written");
    let sensitivities = run(folder.path(), &["sensitivities", "a.toml"]);
    let lines = text(&sensitivities.stdout)
        .lines()
        .filter(|line| !line.starts_with(' '));
    let names = lines.filter_map(|line| Some(line.split_once(": ")?.0));
    let names: Vec<&str> = names
        .filter(|name| !name.contains(' ') && !name.ends_with(".toml"))
        .collect();
    assert!(names.contains(&"left_camber_to_ground"), "{names:?}");
    let moves =
        "[tune.moves.rack]\npoints = [\"rack_left\"]\nalong = \"z\"\nby = [-0.001, 0.001]\n";
    let targets: String = names.iter().map(|name| target(name, 0.0, 1e9)).collect();
    let output = met(folder.path(), &axle(&(moves.to_owned() + &targets)));
    let outcome = format!("tuned, {} targets met", names.len());
    assert!(text(&output.stdout).contains(&outcome), "{output:?}");
}

/// There is no Ackermann percentage if the wheels are hardly steered.
#[test]
fn a_target_at_a_place_without_value_is_refused() {
    let folder = folder();
    let drives = "steer = 0.34\nbump_left = 0.3\nbump_right = 0.3";
    let moves =
        "[tune.moves.rack]\npoints = [\"rack_left\"]\nalong = \"z\"\nby = [-0.001, 0.001]\n";
    for (from, wanted, place) in [
        (
            0.0,
            "value",
            "steer = 0.34 m, bump_left = 0.3 m, bump_right = 0.3 m",
        ),
        (
            0.02,
            "change",
            "the design position, which `change` counts from",
        ),
    ] {
        let over = format!("over = {{ steer = [{from:?}, 0.03] }}\n{wanted}");
        let target = target("ackermann", 0.0, 1.0).replace("value", &over);
        let file = file("steered_axle", drives, &(moves.to_owned() + &target));
        let file = file.replace("0.3 }", "0.3, wheelbase = 2.6 }");
        let output = tuned(folder.path(), &file);
        assert_eq!(output.status.code(), Some(3), "{output:?}");
        let messages = text(&output.stderr);
        let expected = format!(
            "a.toml: target `ackermann`: `ackermann` has no value at {place}; suspension motion --help says where it has one\n"
        );
        assert!(messages.ends_with(&expected), "{messages}");
    }
}
