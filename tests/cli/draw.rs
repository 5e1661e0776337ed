//! `suspension draw`.

use std::path::Path;

use super::program::{folder, run, text};

/// A swing arm with a damper, driven by one of its drives.
fn drawn(drive: &str, at: f64) -> String {
    let folder = folder();
    let file = format!(
        "unit = 'm'\nstatements = '''\nfixed: front at [0.2, 0.3, 0.2], rear at [-0.2, 0.3, 0.2], top at [0.0, 0.5, 0.6];\n\
         free: low at [0.0, 0.5, 0.2], centre at [0.0, 0.7, 0.2];\nhinge arm: front, rear -> centre, low;\n{drive}\n'''\n\
         time = {{ instants = [0.0] }}\ndrives = {{ led = {at} }}\n"
    );
    std::fs::write(folder.path().join("a.toml"), file).expect("written");
    let output = run(folder.path(), &["draw", "a.toml", "--out", "-"]);
    assert!(output.status.success(), "{output:?}");
    String::from_utf8(output.stdout).expect("text")
}

#[test]
fn a_damper_is_drawn_alike_whether_driven_or_measured() {
    let measured = drawn(
        "measure damper: length(low -> top);\ndrive led: centre.z;",
        0.2,
    );
    let driven = drawn("drive led: length(low -> top);", 0.4);
    let lines = |svg: &str| svg.matches("<polyline").count();
    assert_eq!(lines(&driven), lines(&measured));
}

/// The colour of a mark, which is drawn once in the legend.
const RACK: &str = "#785A14";
const BAR: &str = "#008CA0";

#[test]
fn racks_and_bars_are_drawn_where_the_listing_has_them() {
    let folder = folder();
    for (linkage, drives, racks, bars) in [
        ("double_wishbone_pushrod", "bump = 0.3", 1, 2),
        ("double_wishbone", "bump = 0.3", 1, 0),
        ("steered_axle", "bump_left = 0.31\nbump_right = 0.28", 1, 0),
    ] {
        let file = format!(
            "unit = 'm'\nlinkage = '{linkage}'\ntime = {{ instants = [0.0] }}\n[drives]\n{drives}\nsteer = 0.35\n"
        );
        std::fs::write(folder.path().join("a.toml"), file).expect("written");
        let output = run(folder.path(), &["draw", "a.toml", "--out", "-"]);
        assert!(output.status.success(), "{output:?}");
        let svg = text(&output.stdout);
        for (name, colour, count) in [
            ("steering rack", RACK, racks),
            ("bar or measured angle", BAR, bars),
        ] {
            let is_in_legend = svg.contains(&format!("\n{name}\n"));
            assert_eq!(is_in_legend, count > 0, "{linkage}: {name}");
            let lines = count + usize::from(is_in_legend);
            assert_eq!(svg.matches(colour).count(), lines, "{linkage}: {name}");
        }
    }
}

#[test]
fn a_line_that_arms_turn_about_is_drawn_whatever_its_name() {
    for (lines, drawn_lines) in [
        ("front -> centre, rear -> low", 3),
        ("top -> centre, rear -> low", 2),
        ("top -> centre, top -> low", 0),
    ] {
        let measures = format!(
            "measure swing: angle({lines} about front -> rear);\nmeasure damper: length(low -> top);"
        );
        let svg = drawn(&format!("{measures}\ndrive led: centre.z;"), 0.2);
        let in_legend = usize::from(drawn_lines > 0);
        assert_eq!(svg.matches(BAR).count(), drawn_lines + in_legend, "{lines}");
    }
}

/// The number of racks in the drawing of the catalogue's steered axle with another linkage that steers it.
fn racks_of_an_axle(steered_by: &str) -> usize {
    let listing = include_str!("../../suspension-core/src/linkages/steered_axle.linkage");
    let (_, wishbones) = listing
        .split_once("fixed: left_lower_front")
        .expect("wishbones");
    let file = format!(
        "unit = 'm'\nstatements = '''\nmirror: left -> right;\n{steered_by}fixed: left_lower_front{wishbones}'''
time = {{ instants = [0.0] }}\ndrives = {{ bump_left = 0.3, bump_right = 0.3, steer = 0.25 }}\n"
    );
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), file).expect("written");
    let output = run(folder.path(), &["draw", "a.toml", "--out", "-"]);
    assert!(output.status.success(), "{output:?}");
    let svg = text(&output.stdout);
    svg.matches(RACK).count() - usize::from(svg.contains("\nsteering rack\n"))
}

/// Steering alone moves the cranks too, which are stated first.
#[test]
fn a_rack_between_bell_cranks_is_drawn() {
    let racks = racks_of_an_axle(
        "fixed: left_low at [0.25, 0.30, 0.20], left_high at [0.25, 0.30, 0.30], left_end at [0.15, 0.20, 0.20];
free:  rack_left at [0.11, 0.34, 0.20], left_arm at [0.15, 0.31, 0.20], left_rack at [0.15, 0.25, 0.20];
hinge left_crank: left_low, left_high -> rack_left, left_arm;
slide left_guide: left_rack on right_end -> left_end;
link rack: left_rack -> right_rack;
link left_drag: left_rack -> left_arm;
drive steer: left_rack.y;
",
    );
    assert_eq!(racks, 1);
}

/// Both ends of the rod between pitman and idler arm move equally, but on arcs.
#[test]
fn a_relay_rod_is_no_rack() {
    let racks = racks_of_an_axle(
        "fixed: left_low at [0.25, 0.25, 0.20], left_high at [0.25, 0.25, 0.30];
free:  rack_left at [0.11, 0.25, 0.20];
hinge left_arm: left_low, left_high -> rack_left;
link relay_rod: rack_left -> rack_right;
drive steer: rack_left.y;
",
    );
    assert_eq!(racks, 0);
}

#[test]
fn each_of_two_racks_on_one_drive_is_drawn() {
    let racks = racks_of_an_axle(
        "fixed: housing_left at [0.11, 0.15, 0.20], left_rear_housing at [-0.4, 0.15, 0.20];
free:  rack_left at [0.11, 0.25, 0.20], left_rear at [-0.4, 0.2, 0.20];
slide left_guide: rack_left on housing_right -> housing_left;
slide left_rear_guide: left_rear on right_rear_housing -> left_rear_housing;
link rack: rack_left -> rack_right;
link rear_rack: left_rear -> right_rear;
couple racks: rack_left.y = left_rear.y;
drive steer: rack_left.y;
",
    );
    assert_eq!(racks, 2);
}

/// A drawing helps to find the cause of a position out of reach.
#[test]
fn with_the_first_instant_out_of_reach_the_design_is_drawn() {
    let folder = folder();
    let file = "unit = 'm'\nstatements = '''\nfixed: front at [0.2, 0.3, 0.2], rear at [-0.2, 0.3, 0.2];\nfree: centre at [0.0, 0.7, 0.2];\n\
                hinge arm: front, rear -> centre;\ndrive bump: centre.z;\n'''\ntime = { instants = [0.0] }\ndrives = { bump = AT }\n";
    let drawn = |at: &str| {
        std::fs::write(folder.path().join("a.toml"), file.replace("AT", at)).expect("written");
        let output = run(folder.path(), &["draw", "a.toml", "--out", "-"]);
        assert!(output.status.success(), "{output:?}");
        output
    };
    let (design, beyond) = (drawn("0.2"), drawn("0.9"));
    assert_eq!(text(&design.stdout), text(&beyond.stdout));
    let messages = text(&beyond.stderr);
    assert!(
        messages.contains("\nnote: a.toml: the first instant"),
        "{messages}"
    );
    assert!(
        messages.ends_with("it stays at the design position\n"),
        "{messages}"
    );
}

/// The knife edge of an arm, on which a pull rod bears, belongs to the arm's outline; a marker where nothing ends does not.
#[test]
fn the_outline_of_a_body_contains_the_ends_of_its_measured_lines() {
    let corners = |measure: &str| {
        let folder = folder();
        let file = format!(
            "unit = \"m\"\ntime = {{ instants = [0.0] }}\ndrives = {{ bump = 0.3 }}\nstatements = \"\"\"\n\
             fixed: inner at [0.0, 0.2, 0.3], outer at [0.0, 0.5, 0.3], pot at [-0.5, 0.5, 0.1];\n\
             free: hub at [0.6, 0.6, 0.3];\nhinge arm: inner, outer -> hub;\n\
             point knife: arm at [0.0, 0.5, 0.0];\ndrive bump: hub.z;\n{measure}\"\"\"\n"
        );
        std::fs::write(folder.path().join("a.toml"), file).expect("written");
        let output = run(folder.path(), &["draw", "a.toml", "--out", "-"]);
        assert!(output.status.success(), "{output:?}");
        // The first outline is the arm's; that of the legend follows.
        let (_, outline) = text(&output.stdout)
            .split_once("<polygon")
            .expect("an outline");
        let (_, points) = outline.split_once("points=\"").expect("its points");
        let (points, _) = points.split_once('"').expect("their end");
        points.split_whitespace().count()
    };
    assert_eq!(corners("measure spring: length(hub -> pot);\n"), 3);
    assert_eq!(corners("measure spring: length(knife -> pot);\n"), 4);
    assert_eq!(
        corners("measure turn: angle(outer -> knife, outer -> pot about inner -> outer);\n"),
        4
    );
}

#[test]
fn a_wheel_radius_that_is_no_number_is_refused_with_its_format() {
    let folder = folder();
    let output = run(folder.path(), &["draw", "a.toml", "--wheel-radius", "x"]);
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    let wanted = "LENGTH is a positive number in the unit of the file, as 0.3";
    assert!(text(&output.stderr).contains(wanted), "{output:?}");
}

/// The listing and the motion file of the README give the picture that it shows.
#[test]
fn the_picture_of_the_readme_is_up_to_date() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let readme = std::fs::read_to_string(root.join("README.md")).expect("a README");
    let block = |language: &str| {
        let (_, rest) = readme.split_once(language).expect(language);
        rest.split_once("```").expect("the end of the block").0
    };
    let folder = folder();
    for (name, language) in [
        ("corner.linkage", "```text\n"),
        ("corner.toml", "```toml\n"),
    ] {
        std::fs::write(folder.path().join(name), block(language)).expect("written");
    }
    let output = run(folder.path(), &["draw", "corner.toml", "--out", "-"]);
    let drawn = text(&output.stdout);
    let picture = root.join("docs/double_wishbone.svg");
    if std::env::var_os("UPDATE_SNAPSHOTS").is_some_and(|value| value == "1") {
        std::fs::write(&picture, drawn).expect("written");
    }
    let shown = std::fs::read_to_string(picture).expect("a picture");
    assert!(
        shown == drawn,
        "another picture is drawn; take it over with `UPDATE_SNAPSHOTS=1 cargo test --test cli draw::`"
    );
}
