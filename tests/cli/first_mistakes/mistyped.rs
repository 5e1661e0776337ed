//! Names that are mistyped, or are of another kind.

use suspension_core::linkages::LISTINGS;

use super::super::program::CORNER;
use super::refusal;

#[test]
fn for_a_mistyped_name_the_intended_one_is_suggested() {
    for (from, to, expected) in [
        ("[drives]", "[drive]", "; did you mean `drives`?"),
        (
            "double_wishbone_pushrod",
            "double_wishbone_pusrod",
            "; did you mean `double_wishbone_pushrod`?",
        ),
        ("steer =", "ster =", "; did you mean `steer`?"),
        (
            "wheel_radius",
            "tyre_radius",
            "; did you mean `wheel_radius`?",
        ),
        (
            "wheel_radius = 0.3",
            "travel = \"bumb\"",
            "; did you mean `bump`?",
        ),
    ] {
        let message = refusal("motion", &[("a.toml", &CORNER.replace(from, to))], &[]);
        assert!(
            message.starts_with("a.toml:") && message.ends_with(expected),
            "{message}"
        );
    }
}

#[test]
fn for_units_and_numbers_in_other_spellings_the_right_one_is_written() {
    for (from, to, expected) in [
        (
            "unit = \"m\"",
            "unit = \"Metres\"",
            "expected one of `m`, `mm`, `in`; write \"m\"",
        ),
        (
            "unit = \"m\"",
            "unit = \"inches\"",
            "expected one of `m`, `mm`, `in`; write \"in\"",
        ),
        (
            "unit = \"m\"",
            "unit = \"m\"\nangle = \"degrees\"",
            "expected `rad` or `deg`; write \"deg\"",
        ),
        (
            "wheel_radius = 0.3",
            "wheel_radius = \"0.3\"",
            "expected a number or { front = number, rear = number }; write 0.3 without quotes",
        ),
        (
            "wheel_radius = 0.3",
            "wheel_radius = 300 mm",
            "`300 mm` is no number; write 300 without the unit",
        ),
        (
            "unit = \"m\"",
            "unit = \"m\"\nsprings = { coil = { rate = 30000.0 } }",
            "missing field `along`; write the name of the measure that the spring acts along, as along = \"damper\"",
        ),
    ] {
        let message = refusal("motion", &[("a.toml", &CORNER.replace(from, to))], &[]);
        assert!(
            message.starts_with("a.toml:") && message.ends_with(expected),
            "{message}"
        );
    }
}

#[test]
fn for_a_mistyped_drive_of_an_option_the_intended_one_is_suggested() {
    for (command, options) in [
        ("sweep", ["--drive", "bumb=0:0.01:2"].as_slice()),
        ("range", &["--drive", "bumb"]),
        ("assemblies", &["--drive", "bumb", "--at", "0.3"]),
        ("bake", &["--drive", "bumb=0.29:0.31"]),
    ] {
        let message = refusal(command, &[("a.toml", CORNER)], options);
        let expected = "a.toml: unknown drive `bumb`; known are bump, steer; did you mean `bump`?";
        assert_eq!(message, expected);
    }
}

#[test]
fn for_a_mistyped_option_the_intended_one_is_suggested() {
    for (command, wrong, meant) in [
        ("motion", "--cvs", "--csv"),
        ("motion", "--jsno", "--json"),
        ("sweep", "--drives", "--drive"),
        ("sheet", "--otu", "--out"),
    ] {
        let message = refusal(command, &[("a.toml", CORNER)], &[wrong, "x"]);
        let expected = format!("tip: a similar argument exists: '{meant}'");
        assert!(message.contains(&expected), "{message}");
        assert!(!message.contains("to pass"), "{message}");
    }
}

#[test]
fn a_measure_used_as_a_drive_is_refused_with_the_drives() {
    let message = refusal("sweep", &[("a.toml", CORNER)], &["--drive", "damper=0:1:3"]);
    assert_eq!(
        message,
        "a.toml: `damper` is a measure, not a drive; the drives are bump, steer"
    );
    let message = refusal(
        "motion",
        &[("a.toml", &CORNER.replace("steer =", "heave ="))],
        &[],
    );
    let expected = "unknown drive `heave`; the drives are bump, steer, and one of them may be replaced by damper, bar_arm";
    assert!(message.contains(expected), "{message}");
}

#[test]
fn for_a_mistyped_key_a_similar_one_is_suggested() {
    for (mistyped, expected) in [
        (
            "linkag =",
            "a.toml:1:1: unknown field `linkag`; did you mean `linkage`?",
        ),
        (
            "speed =",
            "a.toml:1:1: unknown field `speed`, expected one of `linkage`, ",
        ),
    ] {
        let file = CORNER.replace("linkage =", mistyped);
        let message = refusal("motion", &[("a.toml", &file)], &[]);
        assert!(message.starts_with(expected), "{message}");
    }
}

#[test]
fn an_invalid_load_is_refused_with_its_syntax() {
    for (load, expected) in [
        (
            "[[loads.braking.forces]]\nat = \"contact\"\nforce = [100.0, 0.0, 3000.0]\n",
            "a.toml:8:1: invalid type: table, expected a number",
        ),
        (
            "[loads.braking]\ncontact = [100.0, \"none\", 3000.0]\n",
            "a.toml:9:11: invalid type: string \"none\", expected a number",
        ),
    ] {
        let message = refusal("loads", &[("a.toml", &format!("{CORNER}{load}"))], &[]);
        let how = "; a force is written contact = [-3000.0, 0.0, 4000.0], in N, under [loads.NAME]";
        assert_eq!(message, format!("{expected}{how}"));
    }
}

#[test]
fn a_name_that_collides_with_the_column_of_a_quantity_is_refused() {
    let listing = LISTINGS
        .iter()
        .find(|(name, _)| *name == "double_wishbone_pushrod");
    let (_, listing) = listing.expect("a text");
    let file = CORNER.replace(
        "linkage = \"double_wishbone_pushrod\"",
        "listing = \"a.linkage\"",
    );
    for (statement, name, quantity, column) in [
        (
            "measure toe: angle(lower_ball -> upper_ball, z);",
            "toe",
            "toe angle",
            "toe_rad",
        ),
        (
            "point contact: upright at [0.0, 0.7, 0.1];",
            "contact",
            "contact point",
            "contact_x",
        ),
    ] {
        let listing = format!("{listing}\n{statement}\n");
        let message = refusal("motion", &[("a.toml", &file), ("a.linkage", &listing)], &[]);
        let expected = format!(
            "a.toml: `{name}` of the listing and the quantity `{quantity}` would both have the column `{column}` in tables; \
             give `{name}` another name in the listing"
        );
        assert_eq!(message, expected);
    }
}

/// In a file whose unit differs from that of the catalogue's hardpoints, so that it has to state them all.
#[test]
fn a_mistyped_point_in_millimetres_is_reported_at_its_line() {
    let file = CORNER.replace("unit = \"m\"", "unit = \"mm\"")
        + "[points]\nlower_bal = [5.0, 700.0, 170.0]\n";
    let message = refusal("motion", &[("a.toml", &file)], &[]);
    let line = 1 + file
        .lines()
        .position(|line| line.starts_with("lower_bal"))
        .expect("a line");
    assert!(
        message.starts_with(&format!("a.toml:{line}:1: unknown point `lower_bal`; ")),
        "{message}"
    );
    assert!(
        message.ends_with("; did you mean `lower_ball`?"),
        "{message}"
    );
}

#[test]
fn a_spring_along_a_drive_is_refused_with_the_measure_to_write() {
    let listing = LISTINGS.iter().find(|(name, _)| *name == "double_wishbone");
    let (_, by_height) = listing.expect("a text");
    let by_length = by_height.replace("wheel_centre.z;", "length(upper_front -> lower_ball);");
    let file = CORNER.replace(
        "linkage = \"double_wishbone_pushrod\"",
        "listing = \"a.linkage\"",
    ) + "[springs.coil]\nalong = \"bump\"\nrate = 28000.0\nload = 3800.0\n";
    for (listing, line) in [
        (*by_height, "a -> b"),
        (&*by_length, "upper_front -> lower_ball"),
    ] {
        let message = refusal("check", &[("a.toml", &file), ("a.linkage", listing)], &[]);
        let expected = format!(
            "a.toml:9:9: `bump` is a drive, and a spring acts along a measure: add `measure NAME: length({line});` to the listing, and \
             write along = \"NAME\""
        );
        assert_eq!(message, expected);
    }
}

#[test]
fn a_layout_in_place_of_a_file_and_a_mistyped_point_of_a_marker_are_reported_with_what_to_write() {
    for (from, to, expected) in [
        (
            "linkage =",
            "listing =",
            "1:11: there is no file `double_wishbone_pushrod`; for the layout of the catalogue write linkage = \"double_wishbone_pushrod\"",
        ),
        (
            "[drives]",
            "[points]\nwheel_centre = [0.0, 0.75, 0.3]\naxle = { from = \"wheel_center\", offset = [0.0, -0.1, 0.0] }\n[drives]",
            "7:17: there is no point `wheel_center`; did you mean `wheel_centre`?",
        ),
        (
            "[drives]",
            "[loads.braking]\ncontact = { torque = [0.0, 1.0, 0.0] }\n[drives]",
            "6:13: unknown field `torque`; did you mean `moment`?",
        ),
    ] {
        let message = refusal("check", &[("a.toml", &CORNER.replacen(from, to, 1))], &[]);
        assert_eq!(message, format!("a.toml:{expected}"));
    }
}
