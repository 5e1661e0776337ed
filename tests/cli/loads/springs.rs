//! Springs of the file: the messages if they bear a load, if they do not, and if a case names them in the wrong order.

use super::super::program::{folder, run, text};
use super::loaded;

const SPRINGS: &str = "[springs.coil]\nalong = \"damper\"\nrate = 28000.0\nload = 3800.0\n";
const CASE: &str = "[loads.a]\ncontact = [0.0, 0.0, 4000.0]\n";

/// Returns the output and the messages for a file.
fn run_loads(file: &str, more: &[&str]) -> (String, String) {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), file).expect("written");
    let output = run(folder.path(), &[&["loads", "a.toml"], more].concat());
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let printed = text(&output.stdout).to_owned();
    // The shares of hinges are another note.
    let notes = text(&output.stderr).split_inclusive('\n');
    let notes = notes
        .filter(|line| !line.contains("each of the two bushes"))
        .collect();
    (printed, notes)
}

#[test]
fn the_row_of_a_measure_names_the_spring_that_bears_the_load() {
    let helper = "[springs.helper]\nalong = \"damper\"\nrate = 1000.0\n";
    for (springs, expected) in [
        ("", "\ndamper  "),
        (SPRINGS, "\ndamper (spring coil)  "),
        (
            &format!("{SPRINGS}{helper}"),
            "\ndamper (springs coil and helper)  ",
        ),
    ] {
        for by in ["coil", "damper"] {
            if springs.is_empty() && by == "coil" {
                continue;
            }
            let (report, notes) =
                run_loads(&loaded(&format!("{springs}{CASE}bump = \"{by}\"\n")), &[]);
            assert!(report.contains(expected), "{report}");
            assert_eq!(notes, "");
        }
    }
}

/// If a drive bears the load, the springs bear nothing: one note says so for all cases.
#[test]
fn springs_without_load_are_noted_once() {
    let second = "[loads.b]\ncontact = [0.0, 3500.0, 5000.0]\n";
    let expected = "note: a.toml: the drive `bump` bears the load of [loads.a] and [loads.b], and no spring does; write bump = \"coil\" there for \
                    the spring to bear it\n";
    let both = loaded(&format!("{SPRINGS}{CASE}{second}"));
    for more in [
        &[][..],
        &["--csv", "-"],
        &["--drive", "bump=-0.04:0.04:3", "--json", "-"],
        &["--motion", "--csv", "-"],
    ] {
        let (_, notes) = run_loads(&both, more);
        assert_eq!(notes, expected, "{more:?}");
    }
    let (_, notes) = run_loads(
        &loaded(&format!("{SPRINGS}{CASE}bump = \"coil\"\n{second}")),
        &[],
    );
    assert!(notes.contains("the load of [loads.b], and no"), "{notes}");
    for no_note in [
        format!("{SPRINGS}{CASE}damper = 3800.0\n"),
        format!("{SPRINGS}{CASE}coil = 3800.0\n"),
        format!("{SPRINGS}[loads.a]\nrack = [0.0, 100.0, 0.0]\n"),
        CASE.to_owned(),
    ] {
        let (_, notes) = run_loads(&loaded(&no_note), &[]);
        assert_eq!(notes, "", "{no_note}");
    }
}

/// Each drive of an axle has the spring of its own side, and not the bar.
#[test]
fn the_note_on_springs_names_the_spring_of_each_wheel() {
    let file = "linkage = \"live_axle_panhard\"\nunit = \"m\"\nvehicle = { wheel_radius = 0.3 }\ntime = { instants = [0.0] }\n\
                drives = { bump_left = 0.31, bump_right = 0.31 }\n\
                springs.bar = { along = \"roll_travel\", rate = 90000.0 }\n\
                springs.left = { along = \"damper_left\", rate = 30000.0 }\n\
                springs.right = { along = \"damper_right\", rate = 30000.0 }\n\
                loads.a = { left_contact = [0.0, 0.0, 3000.0], right_contact = [0.0, 0.0, 2000.0] }\n";
    let (_, notes) = run_loads(file, &[]);
    let expected = "note: a.toml: the drives `bump_left` and `bump_right` bear the load of [loads.a], and no spring does; write bump_left = \
                    \"left\" and bump_right = \"right\" there for the springs to bear it\n";
    assert_eq!(notes, expected);
}

#[test]
fn drive_and_spring_in_the_wrong_order_are_refused_with_the_right_one() {
    for (line, expected) in [
        (
            "spring = \"damper\"",
            "`spring` is not a drive; the drives are bump, steer; first comes the drive whose load `damper` bears: write bump = \"damper\"",
        ),
        (
            "damper = \"coil\"",
            "`damper` is not a drive; the drives are bump, steer; first comes the drive whose load `coil` bears: write bump = \"coil\"",
        ),
        (
            "coil = \"bump\"",
            "`coil` is a spring and `bump` is a drive; the drive comes first: write bump = \"coil\"",
        ),
        (
            "damper = \"bump\"",
            "`damper` is a measure and `bump` is a drive; the drive comes first: write bump = \"damper\"",
        ),
        (
            "bump = 4000.0",
            "`bump` is a drive: write the name of the measure or spring that bears its load, or a force where it acts; measures and springs \
             are damper, bar_arm, coil",
        ),
        (
            "coil = [0.0, 0.0, 4000.0]",
            "`coil` is a spring: write one number, positive where it makes the measure larger",
        ),
    ] {
        let folder = folder();
        let file = loaded(&format!("{SPRINGS}{CASE}{line}\n"));
        std::fs::write(folder.path().join("a.toml"), file).expect("written");
        let output = run(folder.path(), &["loads", "a.toml"]);
        assert_eq!(output.status.code(), Some(2), "{line}: {output:?}");
        let notes = text(&output.stderr);
        assert!(notes.contains(expected), "{expected}: {notes}");
    }
}

/// The contact points of an axle have the names of its wheels.
#[test]
fn without_a_load_case_the_proposal_names_contact_points_of_the_file() {
    for (layout, drives, expected) in [
        (
            "live_axle_panhard",
            "bump_left = 0.31, bump_right = 0.31",
            "as left_contact = [-3000.0, 0.0, 4000.0]",
        ),
        (
            "trailing_arm",
            "bump = 0.29",
            "as contact = [-3000.0, 0.0, 4000.0]",
        ),
    ] {
        let file = format!(
            "linkage = \"{layout}\"\nunit = \"m\"\nvehicle = {{ wheel_radius = 0.3 }}\ntime = {{ instants = [0.0] }}\n\
             drives = {{ {drives} }}\n"
        );
        let folder = folder();
        std::fs::write(folder.path().join("a.toml"), file).expect("written");
        let output = run(folder.path(), &["loads", "a.toml"]);
        assert_eq!(output.status.code(), Some(2), "{output:?}");
        let notes = text(&output.stderr);
        assert!(notes.contains(expected), "{expected}: {notes}");
    }
}

/// A spring of one side does not bear the load of the other one: a note names the measure of that side, once for all cases.
#[test]
fn a_spring_on_one_side_alone_is_noted_with_the_other_measure() {
    let left = "springs.left = { along = \"damper_left\", rate = 30000.0, load = 2000.0 }\n";
    let right = "springs.right = { along = \"damper_right\", rate = 30000.0, load = 2000.0 }\n";
    let loads = "left_contact = [0.0, 0.0, 3000.0], right_contact = [0.0, 0.0, 3000.0]";
    let expected = "note: a.toml: the drive `bump_right` bears the load of [loads.a] and [loads.b]: no spring of the file moves with it as \
                    `left` with `bump_left` does; state the other side's too, under [springs.NAME] with along = \"damper_right\", and write \
                    bump_right = \"damper_right\" there\n";
    for layout in ["twist_beam", "live_axle_panhard", "live_axle_splayed"] {
        let file = |springs: &str, by: &str| {
            format!(
                "linkage = \"{layout}\"\nunit = \"m\"\nvehicle = {{ wheel_radius = 0.29 }}\ntime = {{ instants = [0.0] }}\n\
                 drives = {{ bump_left = 0.3, bump_right = 0.3 }}\n{springs}loads.a = {{ {loads}{by} }}\nloads.b = {{ {loads}{by} }}\n"
            )
        };
        let (_, notes) = run_loads(&file(left, ", bump_left = \"left\""), &[]);
        assert_eq!(notes, expected, "{layout}");
        let (_, notes) = run_loads(&file(left, ""), &[]);
        assert!(
            notes.contains("write bump_left = \"left\" there"),
            "{notes}"
        );
        assert!(notes.ends_with(expected), "{layout}: {notes}");
        let by = ", bump_left = \"left\", bump_right = \"damper_right\"";
        let both = format!("{left}{right}");
        for (springs, by) in [(left, by), (&both, by)] {
            let (_, notes) = run_loads(&file(springs, by), &[]);
            assert_eq!(notes, "", "{layout}");
        }
    }
}

/// The load of a spring of both wheels is not the load of one wheel.
#[test]
fn a_spring_of_both_wheels_is_not_proposed_for_one_wheel() {
    let file = "linkage = \"steered_axle\"\nunit = \"m\"\nvehicle = { wheel_radius = 0.3 }\ntime = { instants = [0.0] }\n\
                drives = { bump_left = 0.3, bump_right = 0.3, steer = 0.34 }\n\
                springs.bar = { along = \"roll_travel\", rate = 90000.0 }\n\
                loads.a = { left_contact = [0.0, 0.0, 3000.0] }\n";
    let (_, notes) = run_loads(file, &[]);
    assert_eq!(notes, "");
}

/// A heave spring between the arms moves with both wheels, if not alike where one of them stands higher.
#[test]
fn a_heave_spring_is_not_proposed_for_the_wheel_that_stands_higher() {
    let file = "unit = \"m\"\nstatements = \"\"\"\nmirror: left -> right;\n\
                fixed: left_front at [0.3, 0.3, 0.3], left_rear at [-0.3, 0.3, 0.3];\n\
                free: left_hub at [0.0, 0.7, 0.3], left_end at [0.0, 0.25, 0.45];\n\
                hinge left_arm: left_front, left_rear -> left_hub, left_end;\n\
                point left_axle: left_arm at [0.0, 0.6, 0.3];\ndrive left_bump: left_hub.z;\nwheel left: left_axle -> left_hub;\n\
                measure heave: length(left_end -> right_end);\n\"\"\"\nvehicle = { wheel_radius = 0.3 }\n\
                time = { instants = [0.0] }\ndrives = { left_bump = 0.3, right_bump = 0.3 }\n\
                springs.third = { along = \"heave\", rate = 90000.0, load = 2000.0 }\n\
                loads.a = { left_contact = [0.0, 0.0, 3000.0], right_contact = [0.0, 0.0, 3000.0] }\n";
    let (_, notes) = run_loads(file, &["--drive", "left_bump=0.03", "--csv", "-"]);
    let expected = "note: a.toml: the spring `third` does not act in [loads.a], although its measure changes; write acting = [\"third\"] there \
                    for it to act by its rate\n";
    assert_eq!(notes, expected);
}
