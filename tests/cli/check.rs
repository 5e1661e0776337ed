//! The report on a design position.

mod analyses;
mod locks;
mod pulling;
mod unfollowed;
mod zero_length;

use std::process::Output;

use super::program::{CORNER, edited, folder, run, text};

/// An arm of 0.5 m about a line along x at a height of 0.3 m, driven by the height of its tip.
fn arm(tip: &str) -> String {
    format!(
        "unit = \"m\"\ntime = {{ instants = [0.0] }}\ndrives = {{ bump = 0.0 }}\nstatements = \"\"\"\n\
         fixed: front at [0.2, 0.0, 0.3], rear at [-0.2, 0.0, 0.3];\nfree: tip at {tip};\n\
         link fore: front -> tip;\nlink aft: rear -> tip;\ndrive bump: tip.z;\n\"\"\"\n"
    )
}

fn check(content: &str, options: &[&str]) -> Output {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), content).expect("written");
    run(folder.path(), &[&["check", "a.toml"], options].concat())
}

/// The line of a report under a heading.
fn line<'a>(output: &'a Output, heading: &str) -> &'a str {
    let report = text(&output.stdout);
    let line = report.lines().find(|line| line.starts_with(heading));
    line.unwrap_or_else(|| panic!("no {heading} in {report}"))
}

#[test]
fn a_slide_can_be_put_together_in_one_way() {
    let slide = "\
unit = \"m\"
time = { instants = [0.0] }
drives = { lift = 0.0 }
statements = \"\"\"
fixed: foot at [0, 0.2, -1], head at [0.1, 0.3, 1];
free: block at [0.05, 0.25, 0];
slide guide: block on foot -> head;
drive lift: block.z;\"\"\"
";
    let output = check(slide, &["--assemblies"]);
    let assemblies = line(&output, "assemblies");
    let expected =
        "  1 way to put the same parts together at the design; the search shows no sign of more";
    assert!(assemblies.ends_with(expected), "{assemblies}");
}

#[test]
fn the_report_on_a_healthy_arm_matches_a_calculation_by_hand() {
    let output = check(&arm("[0.0, 0.4, 0.0]"), &["--assemblies"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    for (heading, expected) in [
        ("points", "2 on the chassis, 1 free, 0 carried"),
        ("equations", "3 for 3 unknowns, 1 of them of drives"),
        ("freedom", "1 led by drives: bump"),
        ("design", "bump = 0 m"),
        ("rank", "3 of 3: no equation is redundant"),
        // The tip stays, or is on the other side.
        (
            "assemblies",
            "2 ways to put the same parts together at the design; the search shows no sign of more",
        ),
        ("notes", "none"),
    ] {
        let line = line(&output, heading);
        assert!(line.contains(expected), "{line}");
    }
    // Across, the two links leave the root of 2 (0.2 / L)^2; in the plane of the arm the squares of the singular
    // values are those of [[a, b], [0, 1]].
    let length = (0.2_f64.powi(2) + 0.25).sqrt();
    let across = 2_f64.sqrt() * 0.2 / length;
    let [a, b] = [0.4, 0.3].map(|part| 2_f64.sqrt() * part / length);
    let sum = a * a + b * b + 1.0;
    let largest = f64::midpoint(sum, (sum * sum - 4.0 * a * a).sqrt()).sqrt();
    let expected = format!("smallest singular value {across:.3}, largest {largest:.2}");
    let conditioning = line(&output, "conditioning");
    assert!(
        conditioning.contains(&expected),
        "{conditioning}, {expected}"
    );
    let ends = text(&output.stdout);
    for expected in [
        "-0.2 m from the design: turning point",
        "+0.8 m from the design: turning point",
    ] {
        assert!(ends.contains(expected), "{ends}");
    }
}

#[test]
fn a_singular_design_names_dependent_equations_and_loose_unknowns() {
    let output = check(&arm("[0.0, 0.0, -0.2]"), &[]);
    assert_eq!(output.status.code(), Some(3), "{output:?}");
    let rank = line(&output, "rank");
    let (redundant, undetermined) = rank.split_once("not determined: ").expect("both");
    assert!(redundant.contains("2 of 3"), "{rank}");
    for equation in ["`fore`", "`aft`", "`bump`"] {
        assert!(redundant.contains(equation), "{rank}");
    }
    assert_eq!(undetermined, "`tip.y`");
    assert!(line(&output, "freedom").contains("1 more that no drive leads"));
    assert!(text(&output.stderr).contains("the design position is singular"));
}

/// The links of an arm that hangs straight down do not hold its tip along y, and the tip cannot rise along them: no
/// derivative exists, and none is printed.
#[test]
fn commands_refuse_a_singular_design_and_name_the_report() {
    let folder = folder();
    let file = arm("[0.0, 0.0, -0.2]").replace("bump = 0.0", "bump = -0.2");
    std::fs::write(folder.path().join("a.toml"), file).expect("written");
    for (arguments, expected) in [
        (
            &["motion", "a.toml"][..],
            "is out of reach: the design position is singular: the drives do not determine the motion there; `suspension check a.toml` names",
        ),
        (
            &["sweep", "a.toml", "--drive", "bump=-0.1:0.1:3"],
            "none was solved:\n  the design position is singular: the drives do not determine the motion there;\n  `suspension check a.toml` names",
        ),
        (
            &["sensitivities", "a.toml"],
            "a.toml: the design position is singular, where quantities have no derivatives; `suspension check a.toml` names",
        ),
    ] {
        let output = run(folder.path(), arguments);
        assert_eq!(output.status.code(), Some(3), "{output:?}");
        let message = text(&output.stderr);
        assert!(message.contains(expected), "{message}");
        assert_eq!(message.matches("is singular").count(), 1, "{message}");
    }
}

/// Set free, a drive leaves the other side singular.
#[test]
fn a_range_at_a_singular_design_names_the_report() {
    let folder = folder();
    let axle = "unit = \"m\"\ntime = { instants = [0.0] }\ndrives = { left_bump = -0.2, right_bump = -0.2 }\n\
        statements = \"\"\"\nmirror: left -> right;\n\
        fixed: left_front at [0.2, 0.5, 0.3], left_rear at [-0.2, 0.5, 0.3];\nfree: left_tip at [0.0, 0.5, -0.2];\n\
        link left_fore: left_front -> left_tip;\nlink left_aft: left_rear -> left_tip;\n\
        drive left_bump: left_tip.z;\n\"\"\"\n";
    std::fs::write(folder.path().join("a.toml"), axle).expect("written");
    let output = run(folder.path(), &["range", "a.toml"]);
    assert_eq!(output.status.code(), Some(3), "{output:?}");
    let message = text(&output.stderr);
    for expected in [
        "a.toml: the curve of the drive `left_bump` has no start: ",
        "; `suspension check a.toml` names the equations that depend on each other there",
    ] {
        assert!(message.contains(expected), "{message}");
    }
}

/// Names of lengths that bodies keep are made like this.
#[test]
fn a_locking_link_named_after_its_points_is_named() {
    let links = arm("[0.0, 0.4, 0.0]").replace("fore", "arm_front_tip");
    let output = check(&links.replace("aft", "arm_rear_tip"), &[]);
    let travel = line(&output, "bump");
    let both = "`arm_front_tip` and `arm_rear_tip` are too short";
    assert!(travel.ends_with(both), "{travel}");
}

#[test]
fn check_prints_the_locks_and_notes_of_a_corner() {
    let output = check(&CORNER.replace("0.3 }", "300.0 }"), &[]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    assert!(line(&output, "note").contains("wheel_radius is 300 m"));
    assert_eq!(text(&output.stderr), "", "notes are told once");
    let travel = line(&output, "bump");
    assert!(travel.contains("-0.1115 m from the design"), "{travel}");
    assert!(travel.ends_with(": `pushrod` is too short"), "{travel}");
    let lines = text(&output.stdout).lines();
    let mut upper = lines.filter(|line| line.ends_with(": `pushrod` is too long"));
    assert!(upper.any(|line| line.contains("+0.1375 m from the design")));
    let steering = line(&output, "steer");
    assert!(steering.ends_with(": `tie_rod` is too short"), "{steering}");
}

#[test]
fn check_reports_points_that_do_not_assemble_and_wrong_input() {
    for (content, code, expected) in [
        (
            edited("d6_1", "d6_1 = 445.872"),
            3,
            "the points do not assemble",
        ),
        (arm("[0.0, 0.4]"), 2, "a.toml:"),
    ] {
        let output = check(&content, &[]);
        assert_eq!(output.status.code(), Some(code), "{output:?}");
        assert!(text(&output.stderr).contains(expected), "{output:?}");
        assert!(output.stdout.is_empty());
    }
}

#[test]
fn elimination_is_ordered_at_the_hardpoints_of_the_file() {
    // A rocker whose points are in a plane perpendicular to its axis, and a marker that is stated relative to another point.
    let file = CORNER.replace("double_wishbone_pushrod", "double_wishbone_rocker");
    let output = check(
        &format!(
            "{file}[points]\nrocker_front = [0.005, 0.35, 0.48]\nrocker_rear = [-0.045, 0.35, 0.48]\n\
             pushrod_upper = [0.005, 0.42, 0.5]\ndamper_outer = [0.005, 0.37, 0.56]\n\
             damper_inner = [0.005, 0.12, 0.54]\n\
             axle = {{ from = \"wheel_centre\", offset = [0.0, -0.1, 0.0] }}\n"
        ),
        &[],
    );
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let elimination = line(&output, "elimination");
    let (_, growth) = elimination.split_once("pivot growth ").expect("a growth");
    let (growth, meaning) = growth.split_once(": ").expect("a number");
    assert_eq!(
        meaning,
        format!(
            "elimination magnifies rounding errors about {growth} times, which is good up to 1000; above that a step changes to partial \
             pivoting and takes longer"
        )
    );
    assert!(
        growth.parse::<f64>().is_ok_and(|growth| growth < 1000.0),
        "{elimination}"
    );
}

/// A seat that is stated on the points of two parts is no point of either.
#[test]
fn a_marker_on_points_that_are_not_rigid_is_noted() {
    let seat = "point seat: front, rear, tip at [0.0, 0.3, 0.1];\nmeasure spring: length(seat -> front);\ndrive bump";
    let rigid = arm("[0.0, 0.4, 0.0]").replace("drive bump", seat);
    let output = check(&rigid, &[]);
    assert!(line(&output, "notes").ends_with("none"), "{output:?}");
    let loose = rigid.replace("link aft: rear -> tip;", "drive side: tip.x - rear.x;");
    let output = check(&loose.replace("bump = 0.0", "bump = 0.0, side = 0.2"), &[]);
    let note = line(&output, "note");
    let expected = "the distance of `rear` and `tip`, which carry `seat`, is not constant";
    assert!(note.contains(expected), "{note}");
}

/// Links keep a point to the chassis without a statement that names it and the marker's other points.
#[test]
fn a_marker_on_points_that_links_make_rigid_is_not_noted() {
    let links = "link one: front -> q;\nlink two: rear -> q;\nlink three: up -> q;\npoint mk: q, front, post at [0.1, 0.1, 0.6];\n\
                 measure high: mk.z;\ndrive bump";
    let points = "rear at [-0.2, 0.0, 0.3], up at [0.0, 0.0, 0.8], post at [0.1, 0.5, 0.5];\nfree: q at [0.1, 0.2, 0.4], tip";
    let file = arm("[0.0, 0.4, 0.0]").replace("rear at [-0.2, 0.0, 0.3];\nfree: tip", points);
    let output = check(&file.replace("drive bump", links), &[]);
    assert!(line(&output, "equations").contains("6 for 6"), "{output:?}");
    assert!(line(&output, "notes").ends_with("none"), "{output:?}");
    let links = links.replace("q, front, post", "q, post, tip");
    let output = check(&file.replace("drive bump", &links), &[]);
    let note = line(&output, "note");
    assert!(
        note.contains("the distance of `q` and `tip`, which carry `mk`, is not constant"),
        "{note}"
    );
}
