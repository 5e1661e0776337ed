//! Tuning in other units and axes, and refusals.

use super::super::corner;
use super::super::program::{folder, text};
use super::{DRIVES, FLAT, file, met, tuned};

/// The same target in millimetres, radians and the axes of Adams.
#[test]
fn tuning_does_not_depend_on_units_and_axes() {
    let moved = |file: &str| -> Vec<f64> {
        let folder = folder();
        let output = tuned(folder.path(), file);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        let lines = text(&output.stdout)
            .lines()
            .map(str::to_owned)
            .collect::<Vec<_>>();
        let number = |name: &str| {
            let line = lines
                .iter()
                .find(|line| line.starts_with(name))
                .expect(name);
            line.split_whitespace()
                .nth(1)
                .expect("a number")
                .parse()
                .expect("a number")
        };
        vec![number("rack_height"), number("ball_height")]
    };
    let listing = r#"statements = """
        fixed: lower_front, lower_rear, upper_front, upper_rear, rack;
        free: lower_ball, upper_ball, tie_ball, wheel_centre;
        link a: lower_front -> lower_ball;
        link b: lower_rear -> lower_ball;
        link c: upper_front -> upper_ball;
        link d: upper_rear -> upper_ball;
        link tie_rod: rack -> tie_ball;
        body upright: lower_ball, upper_ball, tie_ball, wheel_centre;
        point axle: upright;
        drive bump: wheel_centre.z;
        drive steer: rack.y;
        wheel: axle -> wheel_centre;
    """"#;
    let of = |unit: &str, scale: f64, [x, y]: [f64; 2], axes: &str| {
        let points = corner::POINTS.map(|(name, [px, py, pz])| {
            format!(
                "{name} = [{:?}, {:?}, {:?}]",
                x * px * scale,
                y * py * scale,
                pz * scale
            )
        });
        let tune = FLAT.replace("0.03", &format!("{:?}", 0.03 * scale));
        let tune = tune.replace("0.06", &format!("{:?}", 0.06 * scale));
        let (angle, within) = match unit {
            "mm" => ("rad", 0.02_f64.to_radians()),
            _ => ("deg", 0.02),
        };
        let tune = tune.replace("within = 0.02", &format!("within = {within:?}"));
        let head = format!("unit = \"{unit}\"\nangle = \"{angle}\"\naxes = \"{axes}\"\n");
        let [bump, steer] = [0.3 * scale, 0.34 * scale * y];
        let drives = format!(
            "time = {{ instants = [0.0] }}\n[drives]\nbump = {bump:?}\nsteer = {steer:?}\n"
        );
        format!(
            "{head}{listing}\n{drives}[points]\n{}\n{tune}",
            points.join("\n")
        )
    };
    let iso = moved(&of("m", 1.0, [1.0, 1.0], "ISO 8855"));
    let adams = moved(&of("mm", 1000.0, [-1.0, -1.0], "Adams"));
    for (iso, adams) in iso.iter().zip(&adams) {
        assert!((1000.0 * iso - adams).abs() < 0.01, "{iso} {adams}");
    }
}

#[test]
fn an_invalid_tune_table_is_refused_at_its_place() {
    let drives = "bump = 0.3\nsteer = 0.34";
    for (tune, code, expected) in [
        ("", 2, "nothing to tune: write [tune.moves.NAME]"),
        (
            &FLAT.replace("[\"rack\"]", "[\"rack\", \"rack\"]"),
            2,
            "`rack` is moved twice by one move; remove one",
        ),
        (
            &FLAT.replace("over = { bump = [-0.06, 0.06] }\n", ""),
            2,
            "`change` counts from the design position: state the drives that move",
        ),
        (
            &FLAT.replace("of = \"toe\"", "of = \"Toe angle\""),
            2,
            "unknown quantity `Toe angle`; did you mean `toe`?\n",
        ),
        (
            &FLAT.replace("of = \"toe\"", "of = \"Bump steer\""),
            2,
            "`bump_steer` is the derivative of `toe` with respect to a drive of travel; name `toe` in its place",
        ),
        (
            &FLAT.replace("of = \"toe\"", "of = \"toe_deg\""),
            2,
            "unknown quantity `toe_deg`; did you mean `toe`? Quantities are named without a unit",
        ),
        (
            &FLAT.replace("of = \"toe\"", "of = \"camber_to_ground_deg\""),
            2,
            "unknown quantity `camber_to_ground_deg`; did you mean `camber_to_ground`? Quantities are named without a unit",
        ),
        (
            &FLAT.replace("of = \"toe\"", "of = \"wheel_rate\""),
            2,
            "there is no `wheel_rate` of this mechanism",
        ),
        (
            &FLAT.replace("\"tie_ball\"", "\"tie_bal\""),
            2,
            "unknown point `tie_bal`; known are ",
        ),
        (
            &FLAT.replace("of = \"toe\"", "of = \"tow\""),
            2,
            "unknown quantity `tow`; known are ",
        ),
        (
            &FLAT.replace("of = \"toe\"", "of = \"spread\""),
            2,
            "; suspension sensitivities a.toml prints all\n",
        ),
        (
            &FLAT.replace("of = \"toe\"", "of = \"bump_steer\""),
            2,
            "`bump_steer` is the derivative of `toe` with respect to a drive of travel; name `toe` in its place",
        ),
        (
            &FLAT.replace("{ bump", "{ bumb"),
            2,
            "unknown drive `bumb`; known are bump, steer",
        ),
        (
            &FLAT.replace("change = 0.0\n", ""),
            2,
            "a target needs either `value` or `change`",
        ),
        (
            &FLAT.replace("along = \"z\"\n", ""),
            2,
            "`along` is missing",
        ),
        (
            &FLAT.replace("along = \"z\"", "along = \"up\""),
            2,
            "expected \"x\", \"y\", \"z\" or [x, y, z]",
        ),
        (
            &FLAT.replace("[0, 0, 2]", "[0, 0, 0]"),
            2,
            "a direction must be finite and not zero",
        ),
        (
            &FLAT.replacen("[-0.03, 0.03]", "[0.03, -0.03]", 1),
            2,
            "`by` is [least, greatest]",
        ),
        (
            &FLAT.replace("points = [\"rack\"]\nalong = \"z\"", "length = \"tie_rot\""),
            2,
            "unknown link `tie_rot`; known are ",
        ),
        (
            &FLAT.replace("within = 0.02", "within = 0.0"),
            2,
            "`within` must be a positive number",
        ),
        (
            &FLAT.replace("[-0.06, 0.06]", "[-0.06, 0.6]"),
            3,
            "target `bump_steer`: ",
        ),
        (
            &format!("{FLAT}[design]\nbump = 0.3\nsteer = 0.34\n"),
            2,
            "without [lengths] and [design]",
        ),
    ] {
        let folder = folder();
        let output = tuned(folder.path(), &file("double_wishbone", drives, tune));
        assert_eq!(output.status.code(), Some(code), "{tune}: {output:?}");
        assert!(
            text(&output.stderr).contains(expected),
            "{expected}: {output:?}"
        );
        assert!(!folder.path().join("a_tuned.toml").exists());
    }
}

/// In mm the example was [-6e1, 6e1].
#[test]
fn an_example_of_a_range_has_the_numbers_of_the_files_unit() {
    let tune = FLAT.replace("over = { bump = [-0.06, 0.06] }\n", "");
    for (unit, scale, expected) in [
        ("m", 1.0, "[-0.06, 0.06] in m\n"),
        ("mm", 1000.0, "[-60, 60] in mm\n"),
        ("in", 1.0 / 0.0254, "[-2, 2] in inches\n"),
    ] {
        let drives = format!("bump = {}\nsteer = {}", 0.3 * scale, 0.34 * scale);
        let points = corner::POINTS.map(|(name, point)| {
            let point = point.map(|coordinate| coordinate * scale);
            format!("{name} = {point:?}\n")
        });
        let file = file("double_wishbone", &drives, &tune) + "[points]\n" + &points.concat();
        let file = file.replace("unit = \"m\"", &format!("unit = \"{unit}\""));
        let folder = folder();
        let output = tuned(folder.path(), &file);
        assert_eq!(output.status.code(), Some(2), "{unit}: {output:?}");
        assert!(text(&output.stderr).ends_with(expected), "{output:?}");
    }
}

/// In a file in metres a box in millimetres is noted before the search.
#[test]
fn the_limits_of_a_move_in_another_unit_are_noted() {
    let drives = "bump = 0.3\nsteer = 0.34";
    for (by, expected) in [
        ("[-0.03, 0.03]", None),
        (
            "[-30, 30]",
            Some(
                "note: a.toml: the width of the box of [tune.moves.ball_height] is 60 m: is it in mm? The file is in m",
            ),
        ),
    ] {
        let folder = folder();
        let tune = FLAT.replace("2]\nby = [-0.03, 0.03]", &format!("2]\nby = {by}"));
        let output = tuned(folder.path(), &file("double_wishbone", drives, &tune));
        let messages = text(&output.stderr);
        let note = messages.lines().find(|line| line.starts_with("note: "));
        assert_eq!(note, expected, "{messages}");
    }
}

/// Thirteen places along each of eight drives are more than a computer holds.
#[test]
fn too_many_places_of_a_target_are_refused() {
    let names = ["ax", "ay", "az", "bx", "by", "bz", "cx", "cy"];
    let each = |of: &dyn Fn(&str) -> String| names.map(of).concat();
    let drives = each(&|name| format!("drive {name}: {}.{};\n", &name[..1], &name[1..]));
    let file = format!(
        "unit = \"m\"\ntime = {{ instants = [0.0] }}\nstatements = \"\"\"\nfixed: o at [0.0, 0.0, 0.0];\n\
         free: a at [0.1, 0.2, 0.3], b at [0.4, 0.2, 0.1], c at [0.5, 0.5, 0.5];\n{drives}link rod: o -> c;\nmeasure apart: length(a -> b);\n\"\"\"\n\
         [drives]\n{}[tune.moves.a]\npoints = [\"a\"]\nalong = \"x\"\nby = [-0.01, 0.01]\n\
         [tune.targets.apart]\nof = \"apart\"\nvalue = 0.3\nwithin = 0.1\n[tune.targets.apart.over]\n{}",
        each(&|name| format!("{name} = 0.2\n")),
        each(&|name| format!("{name} = [-0.01, 0.01]\n")),
    );
    let folder = folder();
    let output = tuned(folder.path(), &file);
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    let expected = "a grid may have 1000000 places at most";
    assert!(text(&output.stderr).contains(expected), "{output:?}");
}

/// Other tables of a file have drives' own values.
#[test]
fn a_target_range_in_absolute_values_is_noted_with_the_changes() {
    let folder = folder();
    let own = FLAT.replace("bump = [-0.06, 0.06]", "bump = [0.24, 0.36]");
    let output = tuned(folder.path(), &file("double_wishbone", DRIVES, &own));
    let expected = "note: a.toml: [tune.targets.bump_steer]: `bump` takes a change from the design position, not the drive's own value: \
                `bump` is 0.3 m at the design position; write bump = [-0.06, 0.06]\n";
    assert!(text(&output.stderr).starts_with(expected), "{output:?}");
    let output = met(folder.path(), &file("double_wishbone", DRIVES, FLAT));
    assert!(
        !text(&output.stderr).contains("takes a change"),
        "{output:?}"
    );
}
