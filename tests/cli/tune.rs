//! Hardpoints moved until curves are met.

mod both_sides;
mod measured;
mod offsets;
mod quantities;
mod units;
mod written;

use std::path::Path;
use std::process::Output;

use super::program::{Rows, folder, run, table_in, text};

/// Returns a motion file of a layout of the catalogue, with its lines on tuning.
fn file(layout: &str, drives: &str, tune: &str) -> String {
    let head = format!("linkage = \"{layout}\" # as drawn\nunit = \"m\"\nangle = \"deg\"\n");
    let rest = format!(
        "vehicle = {{ wheel_radius = 0.3 }}\ntime = {{ instants = [0.0] }}\n[drives]\n{drives}\n"
    );
    format!("{head}{rest}{tune}")
}

/// Both ends of the tie rod up and down, for the least toe change over 60 mm of bump and rebound.
const FLAT: &str = "\
[tune.moves.rack_height]
points = [\"rack\"]
along = \"z\"
by = [-0.03, 0.03]
[tune.moves.ball_height]
points = [\"tie_ball\"]
along = [0, 0, 2]
by = [-0.03, 0.03]
[tune.targets.bump_steer]
of = \"toe\"
over = { bump = [-0.06, 0.06] }
change = 0.0
within = 0.02
";

fn tuned(folder: &Path, file: &str) -> Output {
    std::fs::write(folder.join("a.toml"), file).expect("written");
    // The file of an earlier design.
    let _ = std::fs::remove_file(folder.join("a_tuned.toml"));
    run(folder, &["tune", "a.toml"])
}

/// Runs a tuning in which all targets must be met.
fn met(folder: &Path, file: &str) -> Output {
    let output = tuned(folder, file);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    output
}

/// A target at the design position.
fn target(of: &str, value: f64, within: f64) -> String {
    format!("[tune.targets.{of}]\nof = \"{of}\"\nvalue = {value:?}\nwithin = {within:?}\n")
}

/// The drives of corners of the catalogue at their design positions.
const DRIVES: &str = "bump = 0.3\nsteer = 0.34";

/// Returns the program's results for the file that it wrote, over bump.
fn swept(folder: &Path) -> Rows {
    table_in(
        folder,
        &["sweep", "a_tuned.toml", "--drive", "bump=-0.06:0.06:49"],
    )
}

#[test]
fn tuning_two_heights_flattens_bump_steer_of_three_layouts() {
    for (layout, drives) in [
        ("double_wishbone", "bump = 0.3\nsteer = 0.34"),
        ("macpherson", "bump = 0.31\nsteer = 0.33"),
        ("five_link_rack", "bump = 0.32\nsteer = 0.35"),
    ] {
        let folder = folder();
        met(folder.path(), &file(layout, drives, FLAT));
        let rows = swept(folder.path());
        let design = rows[24]["toe_deg"];
        let worst = rows.iter().map(|row| (row["toe_deg"] - design).abs());
        let worst = worst.fold(0.0, f64::max);
        assert!(worst <= 0.02, "{layout}: {worst}");
        let written = std::fs::read_to_string(folder.path().join("a_tuned.toml")).expect("a file");
        assert!(
            written.starts_with(&file(layout, drives, FLAT)),
            "{written}"
        );
        let added: Vec<&str> = written.lines().rev().take(2).collect();
        assert!(added[0].starts_with("tie_ball = [") && added[1].starts_with("rack = ["));
    }
}

/// A box that is too small stops a move, and the message says which.
#[test]
fn an_unmet_target_is_reported_with_the_move_at_its_limit() {
    let folder = folder();
    let small = FLAT.replacen("by = [-0.03, 0.03]", "by = [-0.001, 0.03]", 1);
    let output = tuned(
        folder.path(),
        &file("macpherson", "bump = 0.31\nsteer = 0.33", &small),
    );
    assert_eq!(output.status.code(), Some(3), "{output:?}");
    let expected = "a.toml: not met: bump_steer; at the end of their boxes: rack_height";
    assert!(text(&output.stderr).contains(expected), "{output:?}");
    let heading = text(&output.stdout).lines().next();
    assert_eq!(heading, Some("a.toml: 1 of 1 target not met"));
    assert!(
        text(&output.stdout).contains("rack_height  -0.001"),
        "{output:?}"
    );
    let rows = swept(folder.path());
    let off = rows
        .iter()
        .map(|row| (row["toe_deg"] - rows[24]["toe_deg"]).abs());
    assert!(off.fold(0.0, f64::max) > 0.02);
}

/// A chassis end of a wishbone, along the line that the wishbone turns about.
#[test]
fn a_move_without_effect_on_any_target_is_noted() {
    let folder = folder();
    let idle = "[tune.moves.bush]\npoints = [\"lower_front\"]\nalong = \"x\"\nby = [-0.01, 0.01]\n";
    let note = "note: a.toml: `bush` changes no target: a move that does nothing may be left out\n";
    let output = met(
        folder.path(),
        &file("double_wishbone", DRIVES, &format!("{idle}{FLAT}")),
    );
    assert!(text(&output.stderr).contains(note), "{output:?}");
    let output = met(folder.path(), &file("double_wishbone", DRIVES, FLAT));
    assert!(!text(&output.stderr).contains("note:"), "{output:?}");
}

/// It stays at zero, where its box begins: a wider box would change nothing.
#[test]
fn a_move_without_effect_is_not_at_the_end_of_its_box() {
    let folder = folder();
    let idle = "[tune.moves.bush]\npoints = [\"lower_front\"]\nalong = \"x\"\nby = [0.0, 0.01]\n";
    let output = met(
        folder.path(),
        &file("double_wishbone", DRIVES, &format!("{idle}{FLAT}")),
    );
    let report = text(&output.stdout);
    let line = report.lines().find(|line| line.starts_with("bush"));
    assert!(
        line.is_some_and(|line| line.ends_with("box from 0 to 0.01 m")),
        "{report}"
    );
    let small = FLAT.replace("by = [-0.03, 0.03]", "by = [-1e-4, 1e-4]");
    let output = tuned(
        folder.path(),
        &file("double_wishbone", DRIVES, &format!("{idle}{small}")),
    );
    let expected =
        "a.toml: not met: bump_steer; at the end of their boxes: rack_height, ball_height\n";
    assert!(text(&output.stderr).contains(expected), "{output:?}");
}

/// The rack's height turns the tie rod about its other end at the design position: toe is that of the tie rod's length, which
/// is built anew.
#[test]
fn an_unmet_target_without_effective_move_is_named() {
    let folder = folder();
    let moved = FLAT.split("[tune.targets").next().expect("moves");
    let toe = target("toe", 1.0, 0.01);
    let output = tuned(
        folder.path(),
        &file("double_wishbone", DRIVES, &format!("{moved}{toe}")),
    );
    assert_eq!(output.status.code(), Some(3), "{output:?}");
    let expected = "a.toml: not met: toe; no move changes toe: move points, or lengths, that do\n";
    assert!(text(&output.stderr).ends_with(expected), "{output:?}");
}

/// Together the two moves change nothing near the design position; each alone does.
#[test]
fn moves_that_cancel_each_other_are_not_reported_as_idle() {
    let folder = folder();
    let forth =
        "[tune.moves.forth]\npoints = [\"upper_ball\"]\nalong = [1, 0, 0]\nby = [-0.01, 0.01]\n";
    let back = forth.replace("forth", "back").replace("[1,", "[-1,");
    let target = target("caster", 89.0, 0.01);
    let output = tuned(
        folder.path(),
        &file("double_wishbone", DRIVES, &format!("{forth}{back}{target}")),
    );
    assert_eq!(output.status.code(), Some(3), "{output:?}");
    let expected = "a.toml: not met: caster; at the end of their boxes: forth, back\n";
    assert!(text(&output.stderr).ends_with(expected), "{output:?}");
}

/// Two targets contradict each other.
#[test]
fn contradicting_targets_are_named_as_a_possible_reason() {
    let folder = folder();
    let one = target("caster", 1.0, 0.01);
    let two = one
        .replace("targets.caster", "targets.other")
        .replace("1.0", "2.0");
    let moves =
        "[tune.moves.upper]\npoints = [\"upper_ball\"]\nalong = \"x\"\nby = [-0.03, 0.03]\n";
    let output = tuned(
        folder.path(),
        &file("double_wishbone", DRIVES, &format!("{moves}{one}{two}")),
    );
    assert_eq!(output.status.code(), Some(3), "{output:?}");
    let expected = "a.toml: not met: caster, other; no move is at the end of its box: more moves or others are needed for caster and \
                    other, or targets contradict each other\n";
    assert!(text(&output.stderr).ends_with(expected), "{output:?}");
}

/// The tables of a design with points elsewhere are reached by moving these there: a list has a number for each place, a
/// derivative is a target like a value.
#[test]
fn tuning_to_the_curves_of_a_known_design_finds_the_design() {
    let folder = folder();
    let known = "[points]\nupper_front = [0.15, 0.42, 0.432]\nupper_rear = [-0.15, 0.42, 0.432]\n";
    let known = file("double_wishbone", DRIVES, known);
    std::fs::write(folder.path().join("a_tuned.toml"), known).expect("written");
    let rows = swept(folder.path());
    let design = &rows[24];
    let camber =
        [0, 12, 24, 36, 48].map(|row: usize| rows[row]["camber_deg"] - design["camber_deg"]);
    let slope = design["camber_deg_per_bump"];
    let tune = format!(
        "\
[tune.moves.upper_arm]
points = [\"upper_rear\", \"upper_front\"]
along = \"z\"
by = [-0.03, 0.03]
[tune.targets.caster]
of = \"camber\"
over = {{ bump = [-0.06, 0.06] }}
change = {camber:?}
within = 1e-3
[tune.targets.slope]
of = \"camber\"
per = \"bump\"
value = {slope:?}
within = 0.1
"
    );
    let points =
        "[points]\nupper_front = [0.15, 0.42, 0.42]\nupper_rear = [-0.15, 0.42, 0.42] # both\n";
    let output = tuned(
        folder.path(),
        &file("double_wishbone", DRIVES, &format!("{points}{tune}")),
    );
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    assert!(
        text(&output.stdout).contains("upper_arm  0.012 m"),
        "{output:?}"
    );
    let written = std::fs::read_to_string(folder.path().join("a_tuned.toml")).expect("a file");
    assert!(
        written.contains(
            "upper_rear = [-0.15, 0.42, 0.432] # moved by tune from [-0.15, 0.42, 0.42]; both\n"
        ),
        "{written}"
    );
    let found = &swept(folder.path())[48];
    assert!(
        (found["camber_deg"] - rows[48]["camber_deg"]).abs() < 1e-6,
        "{found:?}"
    );
}

/// A turnbuckle: the tie rod's length sets the toe, and the rack stays.
#[test]
fn tuning_moves_a_length() {
    let folder = folder();
    let tune = "[tune.moves.turnbuckle]\nlength = \"tie_rod\"\nby = [-0.005, 0.005]\n".to_owned();
    let tune = tune + &target("toe", -0.25, 1e-5);
    met(folder.path(), &file("double_wishbone", DRIVES, &tune));
    let row = &swept(folder.path())[24];
    assert!((row["toe_deg"] + 0.25).abs() < 1e-5, "{row:?}");
    let written = std::fs::read_to_string(folder.path().join("a_tuned.toml")).expect("a file");
    assert!(written.contains(&format!("{DRIVES}\n")) && !written.contains("\nrack ="));
}

/// The rack slides on a line of the chassis, onto which it is assembled.
#[test]
fn a_move_that_a_slide_undoes_is_reported() {
    let moves = |points: &str, mirrored: &str| {
        format!(
            "[tune.moves.rack_height]\npoints = [{points}]\nmirrored = [{mirrored}]\nalong = \"z\"\nby = [-0.02, 0.02]\n\
             [tune.targets.bump_steer]\nof = \"left_toe\"\nper = \"bump_left\"\nvalue = 0.02\nwithin = 0.001\n"
        )
    };
    let drives = "steer = 0.34\nbump_left = 0.3\nbump_right = 0.3";
    let folder = folder();
    let alone = moves("\"rack_left\"", "\"rack_right\"");
    let output = tuned(folder.path(), &file("steered_axle", drives, &alone));
    let message = text(&output.stderr);
    assert!(
        message.contains("`rack_left`, `rack_right` did not go where the moves say"),
        "{message}"
    );
    let both = moves(
        "\"rack_left\", \"housing_left\"",
        "\"rack_right\", \"housing_right\"",
    );
    let output = met(folder.path(), &file("steered_axle", drives, &both));
    assert!(!text(&output.stderr).contains("did not go"), "{output:?}");
}

/// A point in two moves, and one that stays, are at their intended positions.
#[test]
fn a_point_of_several_moves_is_not_reported_as_held() {
    let each = |name: &str, along: &str| {
        format!(
            "[tune.moves.{name}]\npoints = [\"tie_ball\"]\nalong = \"{along}\"\nby = [-0.01, 0.01]\n"
        )
    };
    for value in [0.0, 0.002] {
        let folder = folder();
        let tune = each("up", "z") + &each("out", "y") + &target("toe", value, 0.0001);
        let output = tuned(folder.path(), &file("double_wishbone", DRIVES, &tune));
        assert!(!text(&output.stderr).contains("did not go"), "{output:?}");
    }
}

/// The user gave a number of places, or a single number, as for a sweep.
#[test]
fn a_range_of_tune_without_two_numbers_is_refused() {
    let folder = folder();
    let wanted = "2 numbers are wanted here, [from, to], not 3";
    for (stated, given, expected) in [
        ("by = [-0.03, 0.03]", "by = [-0.03, 0.03, 13]", wanted),
        (
            "over = { bump = [-0.06, 0.06] }",
            "over = { bump = [-0.06, 0.06, 13] }",
            wanted,
        ),
        (
            "by = [-0.03, 0.03]",
            "by = 5",
            "expected 2 numbers [from, to]",
        ),
    ] {
        assert!(FLAT.contains(stated), "{FLAT}");
        let wrong = FLAT.replacen(stated, given, 1);
        let output = tuned(folder.path(), &file("macpherson", DRIVES, &wrong));
        assert_eq!(output.status.code(), Some(2), "{output:?}");
        assert!(text(&output.stderr).contains(expected), "{output:?}");
    }
}
