//! The effects of springs at the wheels, compared with differences of their energy.

use std::collections::BTreeMap;

use super::program::{folder, run, text};
use super::tables::live_axle::{BY_DAMPERS, HEAVE_AND_ROLL, live_axle};
use super::tables::swept;

/// First and second derivative in the middle of five values `h` apart.
fn derivatives(values: [f64; 5], h: f64) -> [f64; 2] {
    let [a, b, c, d, e] = values;
    [
        (8.0 * (d - b) - (e - a)) / (12.0 * h),
        (16.0 * (b + d) - (a + e) - 30.0 * c) / (12.0 * h * h),
    ]
}

/// A spring along the damper and a bar about its arm.
fn corner(unit: &str, springs: &str) -> String {
    format!(
        "linkage = \"double_wishbone_pushrod\"\nunit = \"m\"\n{unit}vehicle = {{ wheel_radius = 0.3 }}\ntime = {{ instants = [0.0] }}\n\
         {springs}[drives]\nbump = 0.3\nsteer = 0.34\n"
    )
}

const SPRINGS: &str = "[springs.spring]\nalong = \"damper\"\nrate = 28000.0\nload = 3800.0\n\
                       [springs.bar]\nalong = \"bar_arm\"\nrate = 1500.0\n";

#[test]
fn wheel_rate_and_load_are_derivatives_of_spring_energy() {
    let design = &swept(&corner("", SPRINGS), "bump=0.0")[0];
    let h = 2e-3;
    for bump in [-0.05, 0.0, 0.04] {
        let around = format!("bump={:?}:{:?}:5", bump - 2.0 * h, bump + 2.0 * h);
        let rows = swept(&corner("", SPRINGS), &around);
        let energy = |row: usize| {
            let [damper, arm] =
                ["damper_m", "bar_arm_rad"].map(|name| rows[row][name] - design[name]);
            0.5 * 28000.0 * damper * damper - 3800.0 * damper + 0.5 * 1500.0 * arm * arm
        };
        let [load, rate] = derivatives([0, 1, 2, 3, 4].map(energy), h);
        let found = [rows[2]["spring_load_N"], rows[2]["wheel_rate_N_m"]];
        assert!(
            (found[0] - load).abs() < 1e-5 * load,
            "{bump}: {found:?} {load}"
        );
        assert!(
            (found[1] - rate).abs() < 1e-5 * rate.abs(),
            "{bump}: {found:?} {rate}"
        );
        assert!(load > 1000.0 && rate.abs() > 100.0, "{load} {rate}");
        for (force, measure, rate, load) in [
            ("spring_force_N", "damper_m", 28000.0, 3800.0),
            ("bar_moment_Nm", "bar_arm_rad", 1500.0, 0.0),
        ] {
            let expected = load - rate * (rows[2][measure] - design[measure]);
            assert!(
                (rows[2][force] - expected).abs() < 1e-8,
                "{force} {expected}"
            );
        }
    }
}

/// The file says N m a degree: the same bar.
#[test]
fn a_bar_rate_in_degrees_equals_that_in_radians() {
    let expected = &swept(&corner("", SPRINGS), "bump=0.03")[0];
    let rate = 1500.0_f64.to_radians();
    let in_degrees = SPRINGS.replace("rate = 1500.0", &format!("rate = {rate:?}"));
    let found = &swept(&corner("angle = \"deg\"\n", &in_degrees), "bump=0.03")[0];
    for name in ["spring_load_N", "wheel_rate_N_m", "bar_moment_Nm"] {
        assert!(
            (found[name] - expected[name]).abs() < 1e-9 * expected[name].abs(),
            "{found:?}"
        );
    }
}

/// Springs at both ends of a live axle, and a bar between them, by the energy in roll.
#[test]
fn roll_rate_is_the_second_derivative_of_spring_energy() {
    let file = "linkage = \"live_axle_watt\"\nunit = \"m\"\nvehicle = { wheel_radius = 0.3 }\ntime = { instants = [0.0] }\n\
                [springs.left]\nalong = \"damper_left\"\nrate = 30000.0\nload = 2500.0\n\
                [springs.right]\nalong = \"damper_right\"\nrate = 30000.0\nload = 2500.0\n\
                [springs.bar]\nalong = \"roll_travel\"\nrate = 4000.0\n[drives]\nbump_left = 0.3\nbump_right = 0.3\n";
    let h = 2e-3;
    let rows = swept(
        file,
        &format!("bump_left,-bump_right={:?}:{:?}:5", -2.0 * h, 2.0 * h),
    );
    let design = &rows[2];
    let energy = |row: usize| {
        let changes = ["damper_left_m", "damper_right_m", "roll_travel_m"];
        let [left, right, bar] = changes.map(|name| rows[row][name] - design[name]);
        15000.0 * (left * left + right * right) - 2500.0 * (left + right) + 2000.0 * bar * bar
    };
    let roll = |row: usize| {
        let across = |axis: &str| {
            rows[row][&format!("left_wheel_centre_{axis}")]
                - rows[row][&format!("right_wheel_centre_{axis}")]
        };
        across("z").atan2(across("y"))
    };
    let each = [0, 1, 2, 3, 4];
    let [force, bend] = derivatives(each.map(energy), h);
    let [turn, curve] = derivatives(each.map(roll), h);
    let expected = (bend - force * curve / turn) / (turn * turn);
    let found = design["roll_rate_Nm_rad"];
    assert!(
        (found - expected).abs() < 1e-4 * expected,
        "{found} {expected}"
    );
    assert!(expected > 10_000.0, "{expected}");
}

/// A swing axle with its masses and springs, driven in three ways: by the height of each wheel, by heave and roll, and by an
/// angle of each wheel, with the opposite sign on the right.
#[test]
fn rates_and_masses_of_wheels_do_not_depend_on_the_drives() {
    let axle = |drives: &str, values: &str, travel: &str| {
        let spring = |side: &str| {
            format!("[springs.{side}]\nalong = \"{side}_spring\"\nrate = 30000.0\nload = 4000.0\n")
        };
        let file = format!(
            "unit = \"m\"\nstatements = \"\"\"\nmirror: left -> right;\n\
             fixed: left_inner at [0.45, 0.30, 0.32], left_outer at [0.45, 0.60, 0.30], left_top at [0.1, 0.55, 0.65];\n\
             free: left_wheel_centre at [0.0, 0.75, 0.30], left_low at [0.08, 0.56, 0.25];\n\
             hinge left_arm: left_inner, left_outer -> left_wheel_centre, left_low;\npoint left_hub: left_arm at [0.0, 0.65, 0.30];\n\
             measure left_spring: length(left_low -> left_top);\n{drives}\nwheel left: left_hub -> left_wheel_centre;\n\"\"\"\n\
             time = {{ instants = [0.0] }}\ndrives = {{ {values} }}\n\
             [vehicle]\nwheel_radius = 0.3\ntravel = {travel}\n{}{}\
             [masses]\nleft_arm = {{ mass = 20.0, centre = \"left_wheel_centre\" }}\nright_arm = {{ mass = 20.0, centre = \"right_wheel_centre\" }}\n",
            spring("left"),
            spring("right"),
        );
        let (first, _) = values.split_once(' ').expect("a drive");
        swept(&file, &format!("{first}=0.0")).remove(0)
    };
    let by_height = axle(
        "drive bump_left: left_wheel_centre.z;",
        "bump_left = 0.3, bump_right = 0.3",
        "{ left = \"bump_left\", right = \"bump_right\" }",
    );
    let by_heave = axle(
        "drive heave: 0.5 left_wheel_centre.z + 0.5 right_wheel_centre.z;\ndrive roll: left_wheel_centre.z - right_wheel_centre.z;",
        "heave = 0.3, roll = 0.0",
        "\"heave\"",
    );
    let by_angle = axle(
        "drive swing_left: angle(left_top -> left_outer, left_outer -> left_wheel_centre about left_inner -> left_outer);",
        "swing_left = 2.3842570993657453, swing_right = -2.3842570993657453",
        "{ left = \"swing_left\", right = \"swing_right\" }",
    );
    let near = |name: &str, row: &BTreeMap<String, f64>| {
        let (found, expected) = (row[name], by_height[name]);
        assert!(
            (found - expected).abs() < 1e-9 * expected,
            "{name}: {found} {expected}"
        );
    };
    for side in ["left", "right"] {
        for name in ["spring_load_N", "wheel_rate_N_m", "effective_mass_kg"] {
            near(&format!("{side}_{name}"), &by_heave);
            near(&format!("{side}_{name}"), &by_angle);
        }
    }
    near("heave_rate_N_m", &by_angle);
    near("roll_rate_Nm_rad", &by_angle);
    // No bar joins the wheels.
    assert!((by_height["heave_rate_N_m"] - by_height["left_wheel_rate_N_m"]).abs() < 1e-6);
}

/// A wheel rises with the other one held at its height, even if drives move both.
#[test]
fn loads_of_live_axle_wheels_do_not_depend_on_the_drives() {
    let [heights, dampers, heave_and_roll] =
        [[("wl.z", 0.31), ("wr.z", 0.31)], BY_DAMPERS, HEAVE_AND_ROLL].map(|drives| {
            let springs = ["left", "right"].map(|side| {
                format!(
                    "[springs.{side}]\nalong = \"damper_{side}\"\nrate = 25000.0\nload = 4000.0\n"
                )
            });
            let masses = "[masses]\naxle = { mass = 90.0, centre = [0.0, 0.0, 0.31] }\n";
            let file = format!("{}{}{masses}", live_axle(drives), springs.concat());
            swept(&file, "bump_left=0.0").remove(0)
        });
    for side in ["left", "right"] {
        for name in ["spring_load_N", "wheel_rate_N_m", "effective_mass_kg"] {
            let name = format!("{side}_{name}");
            for other in [&dampers, &heave_and_roll] {
                let (found, expected) = (other[&name], heights[&name]);
                let off = (found - expected).abs();
                assert!(off < 1e-9 * expected.abs(), "{name}: {found} {expected}");
            }
        }
    }
    let [left, right] = ["left_wheel_rate_N_m", "right_wheel_rate_N_m"].map(|name| heights[name]);
    assert!(
        (left / right - 1.0).abs() > 1e-3,
        "the sides differ: {left} {right}"
    );
}

/// The line from the contact point to the roll centre.
#[test]
fn jacking_is_the_slope_from_contact_point_to_roll_centre() {
    let row = &swept(&corner("", ""), "bump=0.0")[0];
    let expected = 100.0 * row["roll_centre_m"] / row["contact_y"];
    assert!(
        (row["jacking_percent"] - expected).abs() < 1e-9 * expected.abs(),
        "{row:?}"
    );
    assert!(
        !row.contains_key("wheel_rate_N_m"),
        "without springs there is none"
    );
}

/// A wheel behind an arm, whose axis is oblique or straight across: the contact point moves at right angles to both the axis and the
/// way there.
#[test]
fn jacking_of_a_wheel_on_the_centre_line_is_the_slope_of_its_path() {
    for (left_bush, expected) in [
        ("[0.35, 0.1, 0.3]", 100.0 * 0.0125 / 0.065),
        ("[0.3, 0.1, 0.3]", 0.0),
    ] {
        let file = format!(
            "statements = '''\nfixed: right at [0.3, -0.1, 0.3], left at {left_bush};\n\
             free: wheel_centre at [0.0, 0.0, 0.3];\nhinge arm: right, left -> wheel_centre;\n\
             point axle: arm at [0.0, -0.1, 0.3];\ndrive bump: wheel_centre.z;\n\
             wheel: axle -> wheel_centre;\n'''\nunit = \"m\"\nvehicle = {{ wheel_radius = 0.25 }}\n\
             time = {{ instants = [0.0] }}\ndrives = {{ bump = 0.3 }}\n"
        );
        let found = swept(&file, "bump=0.0")[0]["jacking_percent"];
        assert!((found - expected).abs() < 1e-9, "{found} {expected}");
    }
}

#[test]
fn an_invalid_spring_is_refused_at_its_place() {
    for (springs, expected) in [
        (
            "[springs.a]\nalong = \"dampr\"\nrate = 1.0\n",
            "unknown measure `dampr`; known are damper, bar_arm",
        ),
        (
            "[springs.a]\nalong = \"damper\"\nrate = -1.0\n",
            "the rate of spring `a` must be zero or a positive number",
        ),
        (
            "[springs.a]\nalong = \"damper\"\nrate = 1.0\nload = inf\n",
            "the load of spring `a` is not finite",
        ),
        ("[springs.a]\nalong = \"damper\"\n", "missing field `rate`"),
    ] {
        let folder = folder();
        std::fs::write(folder.path().join("a.toml"), corner("", springs)).expect("written");
        let output = run(folder.path(), &["sheet", "a.toml"]);
        assert_eq!(output.status.code(), Some(2), "{springs}: {output:?}");
        assert!(
            text(&output.stderr).contains(expected),
            "{expected}: {output:?}"
        );
    }
}

/// Neither goes by the alphabet.
#[test]
fn springs_and_mistakes_in_them_come_in_the_order_of_the_file() {
    let folder = folder();
    let printed = |springs: &str| {
        std::fs::write(folder.path().join("corner.toml"), corner("", springs)).expect("written");
        run(folder.path(), &["motion", "corner.toml", "--csv", "-"])
    };
    let table = text(&printed(SPRINGS).stdout).to_owned();
    let heading = table.lines().next().expect("a heading");
    let place = |column: &str| heading.find(column).expect("a column");
    assert!(
        place("spring_force_N") < place("bar_moment_Nm"),
        "{heading}"
    );

    let mistakes = SPRINGS.replace("rate = ", "rate = -");
    let message = text(&printed(&mistakes).stderr).to_owned();
    assert_eq!(
        message.trim_end(),
        "corner.toml:7:8: the rate of spring `spring` must be zero or a positive number\n\
         corner.toml:11:8: the rate of spring `bar` must be zero or a positive number"
    );
}
