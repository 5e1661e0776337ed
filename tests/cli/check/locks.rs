//! Messages about locks, and about motions that lock.

use super::super::program::{CORNER, folder, run, text};
use super::{arm, check, line};

/// If the motion locks between two instants, the message names the later one, like that of `motion`; `range` prints the
/// reach of each drive nevertheless.
#[test]
fn check_and_motion_report_the_same_lock_and_range_succeeds() {
    let folder = folder();
    let time = "{ start = 0.0, stop = 1.0, step = 0.28 }";
    let file = CORNER
        .replace("{ instants = [0.0] }", time)
        .replace("bump = 0.3", "bump = [0.3, 0.25]");
    std::fs::write(folder.path().join("a.toml"), file).expect("written");
    let [motion, check, range] =
        ["motion", "check", "range"].map(|command| run(folder.path(), &[command, "a.toml"]));
    let expected = "no configuration at t = 0.56 s with ";
    let message = text(&motion.stderr);
    assert_eq!(motion.status.code(), Some(3), "{message}");
    assert!(message.contains(expected), "{message}");
    assert_eq!(check.status.code(), Some(3), "{check:?}");
    let motion_line = line(&check, "motion ");
    assert!(motion_line.contains(expected), "{motion_line}");
    assert_eq!(range.status.code(), Some(0), "{range:?}");
}

/// A file whose own motion locks may have a regular design position: check and sheet report both.
#[test]
fn a_motion_out_of_reach_is_reported_beside_a_healthy_design() {
    let moved = "start = 0.0\nstop = 1.0\nstep = 0.5";
    let file = |bump: &str| {
        let timed = CORNER.replace(
            "{ instants = [0.0] }",
            &format!("{{ {} }}", moved.replace('\n', ", ")),
        );
        timed.replace("bump = 0.3", bump)
    };
    let folder = folder();
    for (bump, expected) in [
        ("bump = [0.3, 0.05]", None),
        ("bump = [0.3, 0.5]", Some("the motion ends at t = ")),
        (
            "bump = [30.0, 0.5]",
            Some("the first instant, t = 0 s with bump = 30 m"),
        ),
    ] {
        let content = file(bump);
        let output = check(&content, &[]);
        let code = if expected.is_some() { 3 } else { 0 };
        assert_eq!(output.status.code(), Some(code), "{output:?}");
        let motion = line(&output, "motion ");
        std::fs::write(folder.path().join("a.toml"), content).expect("written");
        let output = run(folder.path(), &["sheet", "a.toml", "--out", "a.html"]);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        let page = std::fs::read_to_string(folder.path().join("a.html")).expect("a page");
        let printed = [motion, text(&output.stderr), page.as_str()];
        let Some(expected) = expected else {
            assert!(motion.contains("is within reach"), "{motion}");
            assert_eq!(text(&output.stderr), "wrote a.html\n");
            continue;
        };
        for printed in printed {
            assert!(printed.contains(expected), "{printed}");
        }
        assert!(motion.contains("OUT OF REACH") && page.contains("own motion is out of reach"));
    }
}

/// Neither the reason nor a note is repeated after the report.
#[test]
fn a_motion_out_of_reach_is_reported_once() {
    let output = check(&CORNER.replace("bump = 0.3", "bump = 0.0"), &[]);
    assert_eq!(output.status.code(), Some(3), "{output:?}");
    let (report, error) = (text(&output.stdout), text(&output.stderr));
    for once in [
        "is out of reach from the design",
        "takes the drive's own value",
    ] {
        assert_eq!(report.matches(once).count(), 1, "{report}");
        assert!(!error.contains(once), "{error}");
    }
    let expected = "a.toml: the file's own motion is out of reach; the report says why\n";
    assert_eq!(error, expected);
}

/// No link is too long or too short: the arm that the drive lifts is perpendicular to the axis of its hinge.
#[test]
fn a_locking_hinge_is_named_with_its_axis() {
    let content = CORNER.replace("double_wishbone_pushrod", "trailing_arm");
    let content = content
        .replace("steer = 0.34\n", "")
        .replace("bump = 0.3", "bump = 0.29");
    let output = check(&content, &[]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let fault = ": `arm` on its hinge `pivot_inner`, `pivot_outer` reaches no further";
    assert_eq!(text(&output.stdout).matches(fault).count(), 2, "{output:?}");
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), content).expect("written");
    let range = run(folder.path(), &["range", "a.toml"]);
    assert_eq!(text(&range.stdout).matches(fault).count(), 2, "{range:?}");
}

/// An arm of a twist beam turns about its bush, a point: straight up or down it goes no further.
#[test]
fn a_locking_arm_is_named_with_its_joint() {
    let drives = "drives = { bump_left = 0.29, bump_right = 0.29 }\n";
    let content =
        format!("linkage = \"twist_beam\"\nunit = \"m\"\ntime = {{ instants = [0.0] }}\n{drives}");
    let output = check(&content, &[]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    for side in ["left", "right"] {
        let fault = format!(": `{side}_arm` on its joint `{side}_bush` reaches no further");
        assert_eq!(
            text(&output.stdout).matches(&fault).count(),
            2,
            "{output:?}"
        );
    }
}

/// Straight down the arm's tip is at a height of -0.2 m; the suspension is 0.64 m large.
#[test]
fn a_lock_very_near_the_design_is_noted() {
    let low = |height: f64| {
        let across = (0.25 - (height - 0.3).powi(2)).sqrt();
        let at_height = format!("drives = {{ bump = {height:?} }}");
        let file = arm(&format!("[0.0, {across:?}, {height:?}]"));
        check(&file.replace("drives = { bump = 0.0 }", &at_height), &[])
    };
    let output = low(-0.1995);
    let note = line(&output, "note");
    let expected = "a.toml: `bump` reaches a lock at -0.0005 m from the design, ";
    assert!(note.contains(expected), "{note}");
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let output = low(-0.199);
    assert!(line(&output, "notes").ends_with("none"), "{output:?}");
}

/// The arm of a Dubonnet suspension turns about two points of a casing that the steering holds: the arm reaches no further.
#[test]
fn a_locking_arm_on_a_moving_body_is_named_with_its_hinge() {
    let output = check(
        "statements = '''
fixed: low at [0.0, 0.6, 0.2], high at [0.0, 0.55, 0.42], straight at [-0.15, 0.55, 0.3];
free: inner at [0.08, 0.6, 0.31], outer at [0.08, 0.72, 0.31], steer_arm at [-0.15, 0.55, 0.3], seat at [-0.1, 0.62, 0.36],
      hub at [0.26, 0.68, 0.3], wheel_centre at [0.26, 0.76, 0.3], spring_arm at [0.05, 0.66, 0.37];
hinge casing: low, high -> inner, outer, steer_arm, seat;
body arm: inner, outer, hub, wheel_centre, spring_arm;
drive steer: angle(low -> straight, low -> steer_arm about low -> high);
drive bump: length(seat -> spring_arm);
wheel: hub -> wheel_centre;
'''
unit = \"m\"
time = { instants = [0.0] }
drives = { steer = 0.0, bump = 0.155 }
",
        &[],
    );
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let fault = ": `arm` on its hinge `inner`, `outer` reaches no further";
    assert_eq!(text(&output.stdout).matches(fault).count(), 2, "{output:?}");
}

/// An actuator that is driven to length zero: its points meet, and no direction is left in which it could grow.
#[test]
fn a_driven_length_of_zero_names_the_points_that_meet() {
    let folder = folder();
    for (anchor, free) in [
        (
            "anchor at [0.0, 0.3, 0.4]",
            "hinge rocker: front, rear -> push;",
        ),
        (
            "anchor at [-0.1, 0.0, 0.0]",
            "slide guide: push on rear -> front;",
        ),
    ] {
        let at = if free.starts_with("hinge") {
            "[0.0, 0.5, 0.0]"
        } else {
            "[0.3, 0.0, 0.0]"
        };
        let file = format!(
            "unit = \"m\"\ntime = {{ start = 0.0, stop = 1.0, step = 0.1 }}\ndrives = {{ actuator = [0.4, -0.4] }}\nstatements = '''\n\
             fixed: front at [0.1, 0.0, 0.0], rear at [-0.1, 0.0, 0.0], {anchor};\nfree: push at {at};\n{free}\n\
             drive actuator: length(anchor -> push);\n'''\n"
        );
        std::fs::write(folder.path().join("a.toml"), file).expect("written");
        let [motion, check, range] =
            ["motion", "check", "range"].map(|command| run(folder.path(), &[command, "a.toml"]));
        let meet = "the length is zero, where `anchor` and `push` meet, and cannot be less";
        let message = text(&motion.stderr);
        assert!(
            message.contains(&format!("the drive `actuator` ends: {meet}")),
            "{message}"
        );
        for message in [line(&check, "actuator "), line(&range, "  lower end")] {
            assert!(message.contains(&format!(": {meet}")), "{message}");
        }
        let message = [&motion.stderr, &check.stdout, &range.stdout].map(|message| text(message));
        let message = message.concat();
        assert!(
            !message.contains("bifurcation") && !message.contains("pivot, "),
            "{message}"
        );
    }
}

/// At the lock the lower wishbone bears more than the tie rod, but the tie rod, or the upper wishbone, reaches no
/// further. Links and hinges are treated alike.
#[test]
fn at_a_lock_the_link_out_of_reach_is_named_not_the_most_loaded() {
    let listing = include_str!("../../../suspension-core/src/linkages/double_wishbone.linkage");
    let links =
        "link upper_fore: upper_front -> upper_ball;\nlink upper_aft: upper_rear -> upper_ball;\n";
    let hinges = "hinge upper: upper_front, upper_rear -> upper_ball;\n";
    let without = |begins: [&str; 2]| {
        let lines = listing.lines();
        let others = lines.filter(|line| !begins.iter().any(|begin| line.starts_with(begin)));
        others.collect::<Vec<_>>().join("\n")
    };
    let statements = without(["link upper_fore", "link upper_aft"]);
    let upper = "`upper` on its hinge `upper_front`, `upper_rear` reaches no further";
    for (rack, upper_wishbone, ends) in [
        (
            "[0.11, 0.34, 0.20]",
            links,
            ["`upper_aft` and `upper_fore` are too short"; 2],
        ),
        ("[0.11, 0.34, 0.20]", hinges, [upper; 2]),
        (
            "[0.11, 0.50, 0.35]",
            links,
            ["`tie_rod` is too short", "`tie_rod` is too long"],
        ),
        (
            "[0.11, 0.50, 0.35]",
            hinges,
            ["`tie_rod` is too short", "`tie_rod` is too long"],
        ),
    ] {
        let at = "[0.11, 0.34, 0.20]";
        assert!(statements.contains(at), "{statements}");
        let steer = if rack == at { "0.34" } else { "0.50" };
        let file = format!(
            "unit = \"m\"\ntime = {{ instants = [0.0] }}\ndrives = {{ bump = 0.3, steer = {steer} }}\nstatements = '''\n{}\n{upper_wishbone}'''\n",
            statements.replace(at, rack)
        );
        let output = check(&file, &[]);
        let report = text(&output.stdout);
        let lines = report.lines().skip_while(|line| !line.starts_with("bump "));
        for (line, end) in lines.zip(ends) {
            assert!(line.ends_with(&format!(": {end}")), "{rack}: {line}");
        }
        assert!(report.contains("\nbump "), "{report}");
    }
}
