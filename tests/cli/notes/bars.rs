//! Notes on bars along an angle that no drive changes at the design position.

use super::notes;

/// A file of two trailing arms whose bar acts along the measure `twist`.
fn arms(inboard: &str, twist: &str) -> String {
    format!(
        "statements = '''
mirror: left -> right;
fixed: left_outer at [0.4, 0.65, 0.3], left_inner at [0.4, 0.35, 0.3];
free:  left_wheel_centre at [0.0, 0.7, 0.3];
hinge left_arm:  left_outer, left_inner -> left_wheel_centre;
point left_axle: left_arm at [0.0, 0.6, 0.302];
point left_end:  left_arm at [0.1, {inboard}, 0.3];
drive left_bump: left_wheel_centre.z;
wheel left:      left_axle -> left_wheel_centre;
measure twist:   {twist};
'''
unit = \"m\"
time = {{ instants = [0.0] }}
drives = {{ left_bump = 0.3, right_bump = 0.3 }}
[springs.arb]
along = \"twist\"
rate = 700.0
load = 0.0
"
    )
}

const BETWEEN: &str = "angle(left_inner -> left_end, right_inner -> right_end)";

#[test]
fn a_bar_along_an_angle_that_no_drive_changes_at_the_design_is_noted() {
    let parallel = notes(&arms("0.35", BETWEEN));
    let expected = "note: a.toml: the lines of the angle `twist` are parallel at the design position, where it has no derivatives, and \
         so the spring `arb` no rate; an angle between two lines has no sign: state the twist of a bar about the line of \
         the bar, as angle(left_inner -> left_end, right_inner -> right_end about bar_right -> bar_left)\n";
    assert_eq!(parallel, expected);
    let splayed = notes(&arms("0.40", BETWEEN));
    let expected = "note: a.toml: no drive changes the angle `twist` at the design position, and so none twists the spring `arb` there; \
         an angle between two lines has no sign: state the twist of a bar about the line of the bar, as \
         angle(left_inner -> left_end, right_inner -> right_end about bar_right -> bar_left)\n";
    assert_eq!(splayed, expected);
}

#[test]
fn a_bar_along_an_angle_that_drives_change_is_not_noted() {
    let about = BETWEEN.replace(')', " about right_inner -> left_inner)");
    for (inboard, twist) in [
        ("0.35", about.as_str()),
        ("0.40", about.as_str()),
        ("0.35", "angle(left_inner -> left_end, x)"),
        (
            "0.35",
            "angle(right_inner -> left_wheel_centre, right_inner -> right_axle)",
        ),
    ] {
        assert_eq!(notes(&arms(inboard, twist)), "");
    }
}
