//! Several mistakes of one file: all are reported in one run, each in one line; those in notation, keys and values in the order of the file.

use super::refusal;
use crate::program::CORNER;

/// The beginnings of the lines with which `check` refuses a file, behind its name.
fn refused(file: &str) -> Vec<String> {
    let message = refusal("check", &[("a.toml", file)], &[]);
    let lines = message.lines().map(|line| {
        let line = line.strip_prefix("a.toml:").unwrap_or(line);
        line.split(';').next().unwrap_or_default().to_owned()
    });
    lines.collect()
}

#[test]
fn mistakes_in_the_notation_are_reported_together() {
    let file = "linkage = \"double_wishbone\"\nunit = \"m\"\n[time]\nstart = 0,0\nstop = 1.0s\nstep = 0.1\n[drives]\nsteer = .34\nbump: 0.3\n";
    assert_eq!(
        refused(file),
        [
            "4:10: unexpected key or value, expected newline, `#`",
            "5:11: `1.0s` is no number",
            "8:9: `.34` is no number",
            "9:7: key with no value, expected `=`",
        ]
    );
}

#[test]
fn mistakes_behind_a_line_without_an_equals_sign_are_reported_too() {
    let file =
        "linkage: \"double_wishbone\"\nunit = m\n[time]\nfirst instant\nstep = .1\nstep = 0.1\n";
    assert_eq!(
        refused(file),
        [
            "1:10: key with no value, expected `=`",
            "2:8: a text stands in straight quotes",
            "4:7: key with no value, expected `=`",
            "5:8: `.1` is no number",
            "6:1: duplicate key",
        ]
    );
}

/// Ten minutes of a recording, for which a search of the whole text at each line would take hours.
#[test]
fn a_long_file_with_a_mistake_in_each_line_is_refused_at_once() {
    let refused = refused(&"1.0;2.0\n".repeat(100_000));
    assert_eq!(refused[0], "1:8: key with no value, expected `=`");
    assert_eq!(
        refused.last().map(String::as_str),
        Some(" and 99980 more mistakes")
    );
}

/// The lines behind it are read as parts of the list.
#[test]
fn only_the_first_mistake_behind_an_open_bracket_is_reported() {
    let file = CORNER.replace("{ instants = [0.0] }", "{ instants = [0.0");
    assert_eq!(
        refused(&file),
        ["5:1: missing comma between array elements, expected `,`"]
    );
}

#[test]
fn mistakes_in_keys_and_values_are_reported_together() {
    let file = "linkage = \"double_wishbone\"\nunti = \"m\"\n[time]\ninstants = [0.0]\n[drives]\nbump = \"a\"\nsteer = 0.34\n\
                [springs.coil]\nalong = 3\n[springs.bar]\nrate = 1e4\n";
    assert_eq!(
        refused(file),
        [
            "2:1: unknown field `unti`",
            "6:8: invalid type: string \"a\", expected a number, coefficients of a polynomial of time as [value, rate, ...], a sine \
             as { mean = 0.30, amplitude = 0.05, frequency = 1.5 }, or a recording as { csv = \"logged.csv\", columns = \
             [\"t_s\", \"bump\"] }",
            "9:9: invalid type: integer `3`, expected a text in quotes",
            "10:1: missing field `along`",
        ]
    );
}

#[test]
fn mistakes_in_values_of_one_line_are_reported_together() {
    let file = CORNER.replace(
        "wheel_radius = 0.3",
        "wheel_radius = true, wheelbase = \"b\"",
    );
    assert_eq!(
        refused(&file),
        [
            "3:28: invalid type: boolean `true`, expected a number or { front = number, rear = number }",
            "3:46: invalid type: string \"b\", expected a number",
        ]
    );
}

#[test]
fn a_list_of_known_keys_is_printed_once() {
    let file = format!("{CORNER}[colours]\nred = 1\n[tyres]\nblack = 1\n");
    let message = refusal("check", &[("a.toml", &file)], &[]);
    let (colours, tyres) = message.split_once('\n').expect("two lines");
    assert!(
        colours.starts_with("a.toml:8:2: unknown field `colours`, expected one of `linkage`, ")
    );
    assert_eq!(tyres, "a.toml:10:2: unknown field `tyres`");
}

/// `unit` is missing because it is misspelt or in another table, and the rest of a spring with a mistake is not looked at.
#[test]
fn what_follows_from_another_mistake_is_not_reported() {
    let file = CORNER.replace("unit", "unti");
    assert_eq!(refused(&file), ["2:1: unknown field `unti`"]);
    let file = "linkage = \"double_wishbone\"\n[time]\nunit = \"m\"\ninstants = [0.0]\n[drives]\nbump = 0.3\nsteer = 0.34\n";
    assert_eq!(refused(file), ["3:1: unknown field `unit`"]);
    let file = format!("{CORNER}[springs.coil]\nalong = 3\n");
    assert_eq!(
        refused(&file),
        ["9:9: invalid type: integer `3`, expected a text in quotes"]
    );
}

#[test]
fn mistakes_in_names_and_numbers_are_reported_together() {
    let file = "linkage = \"double_wishbone\"\nunit = \"m\"\n[points]\nupper_ball = [nan, 0.66, 0.44]\nrack = [inf, 0.34, 0.20]\n\
                [time]\ninstants = [0.0, 0.0]\n[drives]\nbumb = 0.3\nstear = 0.34\n[design]\nbump = nan\nsteer = inf\n";
    assert_eq!(
        refused(file),
        ["7:18: the instants must increase or decrease throughout, but 0 s follows 0 s"]
    );
    assert_eq!(
        refused(&file.replace("[0.0, 0.0]", "[0.0]")),
        [
            "4:14: point `upper_ball` has a coordinate that is not a finite number",
            "5:8: point `rack` has a coordinate that is not a finite number",
            "12:8: drive `bump` is not a finite number",
            "13:9: drive `steer` is not a finite number",
            "9:1: unknown drive `bumb`",
            "10:1: unknown drive `stear`",
        ]
    );
}

#[test]
fn an_unknown_point_does_not_hide_other_mistakes() {
    let file =
        CORNER.replace("steer", "stear") + "[points]\nrak = [1, 2, 3]\nrack = [nan, 0.34, 0.20]\n";
    assert_eq!(
        refused(&file),
        [
            "9:1: unknown point `rak`",
            "10:8: point `rack` has a coordinate that is not a finite number",
            "7:1: unknown drive `stear`",
        ]
    );
}

#[test]
fn mistakes_in_recordings_are_reported_together() {
    let file = CORNER.replace("0.34", "{ csv = \"b.csv\", columns = [\"t\", \"b\"] }");
    let file = file.replace(
        "bump = 0.3",
        "bump = { csv = \"a.csv\", columns = [\"t\", \"b\"] }",
    );
    let refused = refused(&file);
    assert_eq!(refused.len(), 2, "{refused:?}");
    assert!(refused[0].starts_with("6:16: a.csv: cannot be read"));
    assert!(refused[1].starts_with("7:17: b.csv: cannot be read"));
}

#[test]
fn mistakes_in_the_vehicle_are_reported_together() {
    let vehicle = "{ wheel_radius = -0.3, wheelbase = 0, cg_height = -1, travel = \"bumb\", brake_share = 3, axle = \"front\" }";
    let file = CORNER.replace("{ wheel_radius = 0.3 }", vehicle);
    assert_eq!(
        refused(&file),
        [
            "3:74: unknown drive `bumb`",
            "3:28: wheel_radius is not a positive finite number",
            "3:96: brake_share must be the axle's share of the force, from 0 to 1",
            "3:46: wheelbase is not a positive finite number",
            "3:61: cg_height is not a positive finite number",
        ]
    );
}

#[test]
fn mistakes_in_what_single_analyses_state_are_reported_together() {
    let file = format!(
        "{CORNER}[loads.brake]\nwhel_centre = [0, 0, 1]\nupper_bal = [0, 0, 1]\n[tolerances]\nx = 0.001\nrack = -1\n"
    );
    assert_eq!(
        refused(&file),
        [
            "9:1: unknown place `whel_centre`",
            "10:1: unknown place `upper_bal`",
            "12:1: unknown point or link `x`",
            "13:8: a tolerance must be zero or a positive number: the standard deviation in the unit of lengths",
        ]
    );
}
