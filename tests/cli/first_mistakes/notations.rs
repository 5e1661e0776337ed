//! Values in another notation than the one that is wanted.

use super::super::program::CORNER;
use super::refusal;

/// Inserts a line above the tables of the corner.
fn with_line(line: &str) -> String {
    CORNER.replacen("unit = \"m\"", &format!("unit = \"m\"\n{line}"), 1)
}

/// A move and a target of `tune`, with one line in place of another.
fn tuned(from: &str, to: &str) -> String {
    let tune = "[tune.moves.rack_height]\npoints = [\"rack\"]\nalong = \"z\"\nby = [-0.01, 0.01]\n\
                [tune.targets.bump_steer]\nof = \"toe\"\nover = { bump = [-0.05, 0.05] }\nvalue = 0.0\nwithin = 0.001\n";
    assert!(tune.contains(from), "{from}");
    format!("{CORNER}{}", tune.replace(from, to))
}

#[test]
fn for_a_value_of_another_kind_its_notation_is_given() {
    for (from, to, expected) in [
        (
            "by = [-0.01, 0.01]",
            "by = 0.03",
            "11:6: invalid type: floating point `0.03`, expected 2 numbers [from, to]; write the box, from the least to the greatest, \
             as by = [-0.010, 0.010]",
        ),
        (
            "points = [\"rack\"]",
            "points = \"rack\"",
            "9:10: invalid type: string \"rack\", expected a list in brackets, [...]; write [\"rack\"]",
        ),
        (
            "value = 0.0",
            "value = { csv = \"a.csv\", columns = [0, 1] }",
            "15:37: invalid type: integer `0`, expected a text in quotes; write the headings of its two columns, as columns = [\"NAME\", \"NAME\"]",
        ),
        (
            "over = { bump = [-0.05, 0.05] }",
            "over = [-0.05, 0.05]",
            "14:8: invalid type: list, expected a table with a line for each name; write the range from the design position, as over = \
             { bump = [-0.05, 0.05] }",
        ),
        (
            "of = \"toe\"",
            "of = 5",
            "13:6: invalid type: integer `5`, expected a text in quotes; write the name of a quantity, as of = \"toe\"",
        ),
    ] {
        let message = refusal("tune", &[("a.toml", &tuned(from, to))], &[]);
        assert_eq!(message, format!("a.toml:{expected}"));
    }
    for (from, to, expected) in [
        (
            "{ instants = [0.0] }",
            "{ instants = 0.0 }",
            "4:21: invalid type: floating point `0.0`, expected a list in brackets, [...]; write [0.0]",
        ),
        (
            "bump = 0.3",
            "bump = [[0.0, 0.3], [1.0, 0.4]]",
            "6:9: invalid type: list, expected a number, one of the coefficients [value, rate, ...]; values over time stand in a file, \
             as { csv = \"logged.csv\", columns = [\"t_s\", \"bump\"] }",
        ),
        (
            "[drives]\n",
            "[[drives]]\n",
            "5:1: invalid type: list, expected a table with a line for each name; write [drives] with a line for each drive, as bump = \
             [0.30, 0.05]",
        ),
    ] {
        let message = refusal("check", &[("a.toml", &CORNER.replace(from, to))], &[]);
        assert_eq!(message, format!("a.toml:{expected}"));
    }
}

/// Of a struct serde reads a list as its keys in order: such a spring acted.
#[test]
fn a_list_in_place_of_a_table_is_refused() {
    let spring = "a spring, which has a name: write its lines under [springs.NAME]";
    for (line, place, expected) in [
        (
            "springs = { coil = [\"damper\", 28000.0, 3800.0] }",
            "20",
            spring,
        ),
        ("[[springs.coil]]\nalong = \"damper\"", "1", spring),
        (
            "tune = [1, 2]",
            "8",
            "moves and targets under [tune.moves.NAME] and [tune.targets.NAME]",
        ),
    ] {
        let message = refusal("check", &[("a.toml", &with_line(line))], &[]);
        let list = format!("a.toml:3:{place}: invalid type: list, expected {expected}");
        assert!(message.lines().any(|line| line == list), "{message}");
    }
    for (from, to, expected) in [
        (
            "time = { instants = [0.0] }",
            "time = [0.0, 1.0, 0.01]",
            "a.toml:4:8: invalid type: list, expected the instants of the motion under [time]; write [time] with start, \
             stop and step, or with instants, in seconds",
        ),
        (
            "vehicle = { wheel_radius = 0.3 }",
            "vehicle = [0.3]",
            "a.toml:3:11: invalid type: list, expected lines under [vehicle], as wheel_radius = 0.3",
        ),
    ] {
        let message = refusal("check", &[("a.toml", &CORNER.replace(from, to))], &[]);
        assert_eq!(message, expected);
    }
}

#[test]
fn for_a_short_or_another_name_of_a_key_the_key_is_suggested() {
    let sine = "{ mean = 0.3, amplitude = 0.05, frequency = 1.5 }";
    let recording = "{ csv = \"a.csv\", columns = [\"t_s\", \"bump\"], factor = 0.001 }";
    for (law, key, other) in [
        (sine, "frequency", "freq"),
        (sine, "amplitude", "amp"),
        (sine, "mean", "center"),
        (recording, "csv", "file"),
        (recording, "factor", "scale"),
    ] {
        let law = law.replace(&format!("{key} ="), &format!("{other} ="));
        let file = CORNER.replace("bump = 0.3", &format!("bump = {law}"));
        let message = refusal("motion", &[("a.toml", &file)], &[]);
        let expected = format!("unknown field `{other}`; did you mean `{key}`?");
        assert!(message.ends_with(&expected), "{message}");
    }
    for (file, expected) in [
        (
            with_line("springs.coil = { along = \"damper\", stiffness = 28000.0 }"),
            "unknown field `stiffness`; did you mean `rate`?",
        ),
        (
            CORNER.replace("wheel_radius", "tyre_radius"),
            "unknown field `tyre_radius`; did you mean `wheel_radius`?",
        ),
        (
            CORNER.replace("wheel_radius", "track"),
            "unknown field `track`; the track follows from the points of the wheels",
        ),
    ] {
        let message = refusal("check", &[("a.toml", &file)], &[]);
        assert!(message.ends_with(expected), "{message}");
    }
}

#[test]
fn a_line_in_another_notation_is_refused_with_what_to_write() {
    for (from, to, expected) in [
        (
            "unit = \"m\"",
            "unit = m",
            "2:8: a text stands in straight quotes; write \"m\"",
        ),
        (
            "unit = \"m\"",
            "unit = “m”",
            "2:8: a text stands in straight quotes; write \"m\"",
        ),
        (
            "vehicle = { wheel_radius = 0.3 }",
            "vehicle.axle = front",
            "3:16: a text stands in straight quotes; write \"front\"",
        ),
        (
            "steer = 0.34",
            "steer =",
            "7:8: the value is missing; write it behind the `=`",
        ),
        (
            "steer = 0.34",
            "steer = -30:30",
            "7:9: `-30:30` is no number; several numbers are written [0.1, 0.2, 0.3]",
        ),
        (
            "unit = \"m\"",
            "unit: \"m\"",
            "2:7: key with no value, expected `=`; write `=` in place of `:`",
        ),
        (
            "unit = \"m\"",
            "// Metres.\nunit = \"m\"",
            "2:4: key with no value, expected `=`; a comment begins with #",
        ),
        (
            "unit = \"m\"",
            "unit = \"m\";",
            "2:11: unexpected key or value, expected newline, `#`; a line ends without `;`",
        ),
        (
            "unit = \"m\"",
            "unit = \"m\" // 1 = 1000 mm",
            "2:12: unexpected key or value, expected newline, `#`; a comment begins with #",
        ),
        (
            "steer = 0.34",
            "steer = 0.34, # as in a list",
            "7:13: unexpected key or value, expected newline, `#`; a line ends without `,`",
        ),
        (
            "bump = 0.3\n",
            "bump = 0.3, ",
            "6:11: unexpected key or value, expected newline, `#`; each NAME = value stands in a line of its own",
        ),
        (
            "[drives]",
            "[drives]]",
            "5:9: unexpected key or value, expected newline, `#`; there is a `]` too many",
        ),
        (
            "{ instants = [0.0] }",
            "{ instants = [0.0] start = 0.0 }",
            "4:27: missing comma between key-value pairs, expected `,`; or the table before it lacks its `}`",
        ),
        (
            "{ wheel_radius = 0.3 }",
            "{ brake_share = 60 % }",
            "3:27: `60 %` is no number; write the fraction, as 0.6 for 60 %",
        ),
        (
            "steer = 0.34",
            "steer = 0.34\nsteer = 0.3",
            "8:1: duplicate key; `steer` is stated twice: leave one of them",
        ),
        (
            "[drives]\n",
            "[points]\nlower ball = [0.0, 0.7, 0.2]\n[drives]\n",
            "6:7: key with no value, expected `=`; a line is written NAME = value, with `_` in place of blanks in the name",
        ),
        (
            "[drives]\n",
            "[points]\nlower_ball = { x = 0.0, y = 0.7, z = 0.2 }\n[drives]\n",
            "6:16: unknown field `x`; coordinates are written [x, y, z]",
        ),
        (
            "[drives]\n",
            "[points]\nrack = [0.0, 0.7, 0.2\nlower_ball = [0.0, 0.7, 0.2]\n[drives]\n",
            "7:1: missing comma between array elements, expected `,`; or the list before it lacks its `]`",
        ),
        (
            "[drives]\n",
            "[hardpoints]\n[drives]\n",
            "5:2: unknown field `hardpoints`; did you mean `points`?",
        ),
    ] {
        assert!(CORNER.contains(from), "{from}");
        let message = refusal("check", &[("a.toml", &CORNER.replace(from, to))], &[]);
        assert_eq!(message, format!("a.toml:{expected}"), "{to}");
    }
}

/// A formula is no misplaced unit.
#[test]
fn only_for_a_unit_among_drives_its_place_is_given() {
    let place = "; unit, angle and axes belong above the first table";
    for (to, has_place) in [
        ("angle = \"deg\"\nbump = 0.3", true),
        ("bump = \"0.3 + t\"", false),
    ] {
        let message = refusal(
            "check",
            &[("a.toml", &CORNER.replace("bump = 0.3", to))],
            &[],
        );
        assert_eq!(message.ends_with(place), has_place, "{message}");
    }
}

#[test]
fn for_a_value_that_only_begins_like_a_number_what_to_write_is_said() {
    for (value, expected) in [
        ("0.30;", "`0.30;` is no number; a line ends without `;`"),
        ("0.30m", "`0.30m` is no number; write 0.30 without the unit"),
        (
            ".30",
            "`.30` is no number; a digit stands on both sides of the point, as in 0.3",
        ),
        (
            "3/10",
            "`3/10` is no number; a number is written out, as 0.01: formulas are not read",
        ),
        (
            "0.30 // metres",
            "`0.30 // metres` is no number; a comment begins with #",
        ),
        (
            "\"m\" // metres",
            "unexpected key or value, expected newline, `#`; a comment begins with #",
        ),
        (
            "\"C:\\users\"",
            "too few unicode value digits, expected unicode hexadecimal value; in double quotes `\\` begins an escape: write `/` in a \
             path, or single quotes",
        ),
    ] {
        let file = CORNER.replace("bump = 0.3\n", &format!("bump = {value}\n"));
        assert_ne!(file, CORNER);
        let message = refusal("check", &[("a.toml", &file)], &[]);
        let (_, message) = message.split_once(": ").expect("a place");
        assert_eq!(message, expected);
    }
}
