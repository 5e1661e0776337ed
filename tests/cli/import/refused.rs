//! Files that are refused, and notes on accepted ones.

use super::super::program::{folder, run, text};
use super::{CORNER, import, table};

/// The corner without some points.
fn without(names: &[&str]) -> String {
    let points = CORNER.into_iter();
    let points: Vec<_> = points.filter(|(name, _)| !names.contains(name)).collect();
    table(&points)
}

/// Returns the message for a file that is refused.
pub(super) fn refusal(name: &str, content: &str, options: &[&str]) -> String {
    let folder = folder();
    std::fs::write(folder.path().join(name), content).expect("written");
    let output = run(folder.path(), &[&["import", name], options].concat());
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    let message = text(&output.stderr);
    let last = message.lines().next_back().expect("a message").to_owned();
    assert!(!folder.path().join("a.toml").exists());
    last
}

#[test]
fn all_missing_points_are_named_at_once_with_accepted_names() {
    let message = refusal(
        "a.csv",
        &without(&["tierod_outer", "shock_to_chassis"]),
        &["--linkage", "double_wishbone_rocker"],
    );
    assert!(
        message.starts_with(
            "a.csv: double_wishbone_rocker lacks `damper_inner`; `tie_ball` (or tie_rod_outer, "
        ),
        "{message}"
    );
    let message = refusal("a.csv", &without(&["lca_rear"]), &[]);
    assert!(
        message.contains("no layout has all its points here; the nearest, double_wishbone"),
        "{message}"
    );
    assert!(
        message.contains("lacks `lower_rear` (or lower_wishbone_rear, "),
        "{message}"
    );
}

#[test]
fn a_point_placed_by_a_missing_point_is_not_reported_as_missing() {
    let message = refusal("a.csv", &without(&["wheel_center"]), &[]);
    assert!(
        message.contains(" lacks `wheel_centre` (or hub_centre, wheel_hub_centre); "),
        "{message}"
    );
    assert!(!message.contains("axle"), "{message}");
}

/// `strut_high` is placed from the other two points of the strut.
#[test]
fn the_nearest_layout_needs_the_fewest_points() {
    let message = refusal(
        "a.csv",
        &without(&["uca_front", "uca_rear", "uca_outer"]),
        &[],
    );
    let expected = "the nearest, macpherson, lacks `top` (or top_mount, ";
    assert!(message.contains(expected), "{message}");
}

/// `left_wheel_centre` has no other names.
#[test]
fn a_row_with_the_own_name_of_a_point_needs_three_numbers() {
    let message = refusal("a.csv", "Left wheel center; 0; 740\n", &[]);
    let expected = "a.csv:1:1: point `left_wheel_center` needs three numbers in a row";
    assert!(message.starts_with(expected), "{message}");
}

#[test]
fn a_layout_without_any_point_of_the_file_is_refused() {
    let message = refusal("a.csv", &table(&CORNER), &["--linkage", "twist_beam"]);
    let expected = "a.csv: twist_beam has none of the file's points, `lca_front` for one; without --linkage they choose the layout";
    assert_eq!(message, expected);
}

#[test]
fn a_mistyped_name_is_reported_with_line_and_suggestion() {
    let message = refusal(
        "a.csv",
        &(table(&CORNER).replace("uca_outer", "hpl_uca_outr") + "ballast, 1, 2, 3\n"),
        &["--linkage", "double_wishbone"],
    );
    assert!(
        message.starts_with("a.csv: double_wishbone lacks `upper_ball` (or upper_wishbone_outer, "),
        "{message}"
    );
    let unknown = "); not known: `hpl_uca_outr` (a.csv:6), did you mean uca_outer?; `ballast` (a.csv:16); suspension import --names lists all names, suspension list double_wishbone says what the points are";
    assert!(message.ends_with(unknown), "{message}");
}

#[test]
fn unused_points_and_missing_parts_are_noted() {
    let folder = folder();
    let file = without(&["shock_to_chassis"]) + "hps_global, 0, 0, 0\n";
    let imported = import(folder.path(), "a.csv", &file, &[]);
    assert_eq!(imported.text("linkage"), "double_wishbone");
    let unused = "not used: prod_outboard, prod_inboard, bellcrank_pivot, bellcrank_axis, shock_to_bellcrank, hps_global\n";
    assert!(imported.notes.contains(unused), "{}", imported.notes);
    assert!(
        imported
            .notes
            .contains("the file does not have the point `axle`, which is placed on the spin axis"),
        "{}",
        imported.notes
    );
    assert!(
        imported.notes.contains("no tire_radius"),
        "{}",
        imported.notes
    );
}

/// File, its content, options, and the beginning or a part of the last line of the message.
#[test]
fn an_ambiguous_file_is_refused() {
    let corner = table(&CORNER);
    let labelled = corner.replace("wheel_center", "hpl_wheel_center");
    let without_names = "-140, -170, 125\n150, -175, 120\n";
    let motion = "linkage = \"double_wishbone\"\nunit = \"m\"\n".to_owned();
    let listing = "fixed: a at [0.0, 0.0, 0.0];\n".to_owned();
    let cases = [
        (
            "b.toml",
            motion,
            vec![],
            "b.toml:1:1: this is a motion file already",
        ),
        (
            "a.csv",
            listing,
            vec![],
            "a.csv:1:1: this is a listing; a motion file names it",
        ),
        (
            "a.csv",
            "".to_owned(),
            vec![],
            "a.csv:1:1: there are no hardpoints here",
        ),
        (
            "a.csv",
            without_names.to_owned(),
            vec![],
            "a.csv:1:1: there are no hardpoints here",
        ),
        (
            "a.csv",
            "foo, 1, 2, 3\n".to_owned(),
            vec![],
            "a.csv: no point has a known name, for example `foo` has none",
        ),
        // Another layout than the nearest has eight of thirteen points.
        (
            "a.csv",
            "wheel_centre, 0, 765, 320\ndamper_upper, -30, 560, 700\ndamper_lower, -50, 670, 240\nlower_front_inner, 280, 380, 240\n\
             lower_front_outer, 40, 680, 200\nupper_front_inner, 150, 400, 470\nupper_front_outer, 30, 670, 470\n\
             track_rod_inner, -180, 330, 275\n"
                .to_owned(),
            vec![],
            "a.csv: no layout has all its points here; the nearest, trailing_arm, lacks `pivot_inner`",
        ),
        (
            "a.csv",
            "upper_ball, 1, 2, 3\n".to_owned(),
            vec![],
            "a.csv: no layout has half of its points here under known names; a suspension of another kind needs a listing of its own, see suspension motion --help; the nearest, double_wishbone, lacks `lower_front`",
        ),
        (
            "a.csv",
            format!("name, y, x, z\n{corner}"),
            vec![],
            "a.csv:1:1: the columns are y, x, z",
        ),
        (
            "a.csv",
            corner.clone(),
            vec!["--linkage", "strut"],
            "a.csv: unknown linkage `strut`; known are attia2003, ",
        ),
        (
            "a.csv",
            corner.clone(),
            vec!["--linkage", "macpherson"],
            "a.csv: macpherson lacks `top` (or top_mount, ",
        ),
        (
            "a.csv",
            corner.clone(),
            vec!["--out", "a.csv"],
            "a.csv: this is the file that is read, which --out would",
        ),
        (
            "a.csv",
            labelled.clone(),
            vec!["--axes", "iso"],
            "a.csv: `hpl_wheel_center` is on the left by its name, and on the right",
        ),
        (
            "a.csv",
            labelled.replace(", -", ", "),
            vec![],
            "a.csv: the axes are none of iso, adams, sae",
        ),
        (
            "a.csv",
            labelled
                .replace("lca_front", "other")
                .replace("lca_rear", "lca_front")
                .replace("other", "lca_rear"),
            vec![],
            "; for iso change the signs of y, or exchange two points that have each other's names, or say --axes, and --side for the corner that it is",
        ),
        (
            "a.shk",
            corner.clone(),
            vec![],
            "a.shk:1:1: this is no .shk file of a known layout",
        ),
        (
            "a.shk",
            "TEMP_SETTINGS\n 14\nDouble Wishbone\n 1e300 1e300\n".to_owned(),
            vec![],
            "a.shk:1:1: this is no .shk file of a known layout",
        ),
        (
            "a.sub",
            "[MDI_HEADER]\n[UNITS]\n LENGTH = 'cm'\n".to_owned(),
            vec![],
            "a.sub:3:2: lengths are in `cm`; convert them to mm, m or in",
        ),
        (
            "a.csv",
            corner.replace(
                "tierod_inner, -72, -190, 152",
                "tierod_inner, -68, -552, 166",
            ),
            vec![],
            "a.toml is not written; its line 25 would be: tie_ball = [68.0, 552.0, 166.0]  # tierod_outer, a.csv:8",
        ),
    ];
    for (name, content, options, expected) in cases {
        let message = refusal(name, &content, &options);
        assert!(message.contains(expected), "{expected}: {message}");
    }
}

#[test]
fn import_does_not_replace_a_motion_file_without_out() {
    let folder = folder();
    std::fs::write(folder.path().join("a.csv"), table(&CORNER)).expect("written");
    std::fs::write(folder.path().join("a.toml"), "mine").expect("written");
    let output = run(folder.path(), &["import", "a.csv"]);
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    assert_eq!(
        text(&output.stderr),
        "a.toml: exists already; --out a.toml replaces it\n"
    );
    let kept = std::fs::read_to_string(folder.path().join("a.toml")).expect("there");
    assert_eq!(kept, "mine");
    let output = run(folder.path(), &["import", "a.csv", "-o", "a.toml"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
}

/// An axle is a motion file and a listing: both have no place on standard output.
#[test]
fn standard_output_is_refused_as_the_place_of_a_motion_file() {
    let folder = folder();
    let hardpoints = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/hardpoints.csv");
    for out in ["-", "/dev/stdout"] {
        let output = run(folder.path(), &["import", hardpoints, "--out", out]);
        assert_eq!(output.status.code(), Some(2), "{output:?}");
        let expected = "--out: import does not write to standard output, since an axle is two files; state the path of a file\n";
        assert_eq!(text(&output.stderr), expected);
        assert!(output.stdout.is_empty() && !folder.path().join("-").exists());
    }
}

/// The point on the ground is not the wheel centre.
#[test]
fn a_remark_on_the_ground_names_another_point() {
    let folder = folder();
    let plain = import(folder.path(), "a.csv", &table(&CORNER), &[]);
    for remark in ["contact patch", "ground contact"] {
        let patch = format!("Wheel centre ({remark}), 0, -612, 0\n");
        let both = import(folder.path(), "a.csv", &(table(&CORNER) + &patch), &[]);
        assert_eq!(both.points(), plain.points());
        assert!(!both.notes.contains("did you mean"), "{}", both.notes);
        let said = refusal("a.csv", &(without(&["wheel_center"]) + &patch), &[]);
        assert!(said.contains("lacks `wheel_centre`"), "{said}");
    }
}

/// Limits beside the value of an angle would have been the coordinates of a point that is not used.
#[test]
fn a_number_with_limits_is_refused() {
    let corner = table(&CORNER);
    let said = refusal("a.csv", &format!("{corner}Static toe,-0.1,-0.4,0.4\n"), &[]);
    let expected = "a.csv:16:1: `Static toe` needs one number after it, with a decimal point";
    assert_eq!(said, expected);
    let said = refusal("a.csv", &format!("{corner}Toe, -0.1, min -0.4\n"), &[]);
    let expected = "says `min`, for minutes or a limit: write";
    assert!(said.contains(expected), "{said}");
}
