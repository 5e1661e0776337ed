//! Measured tables that are refused.

use super::super::super::program::{CORNER, run, text};
use super::super::rig::axle;
use super::beside;
use super::several::in_heave_and_roll;

#[test]
fn mistakes_in_a_measured_table_are_located_with_the_remedy() {
    for (table, options, expected) in [
        (
            "",
            &[][..],
            "m.csv:1:1: the file is empty; it needs a line of headings",
        ),
        (
            "# Rig 17\nwheel_travel toe\nmm deg\n0 0\n10 1\n",
            &[],
            "m.csv:4:1: several numbers in one field; separate fields by commas, semicolons or tabs, in the line of headings too",
        ),
        (
            "bump [mm],camer [deg]\n",
            &[],
            "m.csv:1:11: unknown quantity `camer`; did you mean `camber`? A column whose heading is empty is left out",
        ),
        (
            "bump [mm],Chamber Angle [deg]\n",
            &[],
            "m.csv:1:11: unknown quantity `Chamber Angle`; did you mean `camber_angle`?",
        ),
        (
            "bump [mm],caster\n",
            &[],
            "m.csv:1:11: `caster` states no unit; write `caster [deg]`",
        ),
        (
            "bump [mm];toe [mm]\n",
            &[],
            "m.csv:1:11: `mm` is no unit of `toe` here; convert the column and write `toe [deg]`",
        ),
        (
            "toe [deg]\n0.1\n",
            &[],
            "m.csv:1:1: no column says where the model is; head one with a drive and its unit (the drives are bump, steer), or with wheel travel, as `wheel travel [mm]`, ",
        ),
        (
            "toe [deg]\tbump [mm]\n",
            &[],
            "m.csv:1:11: the table needs a column of a quantity beside this one, as `toe [deg]`, and lines of numbers; suspension sweep writes",
        ),
        (
            "bump [mm]\ttoe [deg]\n-20\t0,1\n0\t-\n",
            &[],
            "m.csv:3:3: `-` in column `toe [deg]` is not a finite number, as -0.5; leave the field empty if nothing was measured",
        ),
        (
            "toe [deg];bump [mm]\n0;-20,0\n0;20\n0; 900\n",
            &[],
            "m.csv:4:4: 900 mm from the design position is out of the model's reach; of the measured places those from -20 to 20 mm \
             are in reach; leave out the lines beyond. suspension range a.toml says what stops the model",
        ),
        (
            "toe [deg];bump [mm];steer [mm]\n0;-20;15\n0; 900;15\n",
            &[],
            "m.csv:3:4: `bump` 900 mm and `steer` 15 mm from the design position are together out of the model's reach; leave out \
             the line (1 of 2 are out of reach)",
        ),
        (
            "toe [deg],wheel travel [mm]\n0,-900\n",
            &[],
            "m.csv:2:3: -900 mm from the design position is out of the model's reach; of the measured places none are in reach; leave \
             out",
        ),
        (
            "bump [mm],toe [deg]\n0,0,0,1\n",
            &[],
            "m.csv:2:5: the line has more fields than there are headings in line 1; begin lines above the headings with #, and with decimal \
             commas separate the fields by semicolons or tabs",
        ),
        (
            "Rear suspension; right corner [mm]\nPoint;X;Y;Z\nlower front;318.0;245.5;135.0\n",
            &[],
            "m.csv:3:1: a name with three numbers, as in a table of hardpoints, which suspension import reads; a measured table has",
        ),
        (
            "Point,X,Y,Z\nlower front,318.0,245.5,135.0\n",
            &[],
            "m.csv:2:1: a name with three numbers, as in a table of hardpoints",
        ),
        (
            "# Rig 17\nAxle;front\nbump [mm];toe [deg];Fz [N]\n0;0;0\n",
            &[],
            "m.csv:3:21: the line has more fields than there are headings in line 2; begin lines above the headings with #, and",
        ),
        (
            "# Rig 17\n\nwheel travel [mm],toe [deg]\n# begin\n0,0\n,0\n",
            &[],
            "m.csv:6:1: the line has no number in column `wheel travel [mm]`; write one, or leave out the line",
        ),
        (
            "bump [mm]\twheel_centre_y [mm]\n-20\t1,750\n",
            &[],
            "m.csv:2:5: `1,750` may be 1750, or a number with decimals: write 1750, or 1,7500 for decimals, here or in another line",
        ),
        (
            "bump [mm];toe [deg];camber [deg]\n-20;1,125;1.5\n",
            &[],
            "m.csv:2:5: 1125 deg is more than half a turn; write all decimals of the table behind the same sign, a comma or a point",
        ),
        (
            "Rig 17, front axle\nbump [mm];toe [deg]\n0;zero\n",
            &[],
            "m.csv:3:3: `zero` in column `toe [deg]` is not a finite number",
        ),
        (
            "bump [mm];toe [deg]\n0;0\nend\n",
            &[],
            "m.csv:3:1: `end` in column `bump [mm]` is not a finite number",
        ),
        (
            "bump [mm];wheel_centre_y [mm]\n-20;1.750\n",
            &[],
            "m.csv:2:5: `1.750` may be 1750, or",
        ),
        (
            "steer [mm],toe\nmm,mm\n0,0\n",
            &[],
            "m.csv:1:12: `mm` is no unit of `toe` here; convert the column and write `toe [deg]`",
        ),
        (
            "toe [deg],\"bump,-steer [mm]\"\n0,0\n",
            &["--absolute"],
            "m.csv:1:11: the drives `bump,-steer` move together from the design position; state their changes, and leave out --absolute, \
             or give each drive a column of its own",
        ),
        (
            "bump [mm],toe [deg],toe angle [rad]\n0,0,0\n",
            &[],
            "m.csv:1:21: `toe angle` is in two columns; empty the heading of one",
        ),
        (
            "bump [mm],bump_mm,toe [deg]\n0,0,0\n",
            &[],
            "m.csv:1:11: `bump` and `bump` both say where `bump` is; empty the heading of one",
        ),
        (
            "toe [deg],bump [mm]\n0,0\n",
            &["--travel", "-1:1"],
            "m.csv: the table states the places; leave --travel and --steer out",
        ),
    ] {
        let (_folder, output) = beside(CORNER, table, options);
        assert_eq!(output.status.code(), Some(2), "{table}: {output:?}");
        let message = text(&output.stderr);
        let message = message.lines().filter(|line| !line.starts_with("note: "));
        let message = message.collect::<String>();
        assert!(message.starts_with(expected), "{expected}\n{message}");
    }
}

#[test]
fn a_table_in_the_place_of_the_model_is_refused_with_the_order() {
    let (folder, _) = beside(CORNER, "bump [mm],toe [deg]\n0,0\n", &[]);
    let output = run(folder.path(), &["compare", "m.csv", "a.toml"]);
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    let expected = "m.csv: the table comes second: suspension compare a.toml m.csv\n";
    assert_eq!(text(&output.stderr), expected);
}

#[test]
fn wheel_travel_in_mm_under_a_heading_in_m_is_noted() {
    for (heading, is_noted) in [("m", true), ("in", true), ("mm", false)] {
        let table = format!("wheel travel [{heading}],toe [deg]\n0,0\n50,1\n");
        let (_folder, output) = beside(CORNER, &table, &[]);
        let note = format!("note: m.csv: is `wheel travel` in mm? Its heading states {heading}\n");
        assert_eq!(
            text(&output.stderr).starts_with(&note),
            is_noted,
            "{output:?}"
        );
    }
}

/// Recordings of ten minutes are read; what a table may take of memory is bounded.
#[test]
fn long_tables_are_read_up_to_a_million_lines() {
    let table = "bump [mm],toe [deg]\n0,0\n".to_owned() + &"# idle\n".repeat(1 << 20) + "1,0\n";
    assert!(table.len() > 7 << 20);
    let (_folder, output) = beside(CORNER, &table, &[]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let long = "bump [mm],toe [deg]\n".to_owned() + &"0,0\n".repeat(1_000_000);
    let (_folder, output) = beside(CORNER, &long, &[]);
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    let expected = "m.csv: has more than 1000000 lines; leave out those that are not needed, as every second one\n";
    assert_eq!(text(&output.stderr), expected);
}

/// A bar that turns about an axis along x, with a wheel at each end and one drive.
const BAR: &str = "unit = \"m\"\nstatements = \"\"\"\nfixed: fore at [0.3, 0, 0.3], aft at [-0.3, 0, 0.3];\n\
                   free: left_hub at [0, 0.7, 0.3], right_hub at [0, -0.7, 0.3];\n\
                   hinge bar: fore, aft -> left_hub, right_hub;\npoint left_in: bar at [0, 0.6, 0.3];\n\
                   point right_in: bar at [0, -0.6, 0.3];\ndrive roll: left_hub.z;\nwheel left: left_in -> left_hub;\n\
                   wheel right: right_in -> right_hub;\n\"\"\"\nvehicle = { wheel_radius = 0.3, travel = \"roll\" }\n\
                   time = { instants = [0.0] }\ndrives = { roll = 0.3 }\n";

/// A pendulum with a spring.
const NO_WHEEL: &str = "unit = \"m\"\nstatements = \"\"\"\nfixed: fore at [0.3, 0, 0.3], aft at [-0.3, 0, 0.3];\n\
                        free: hub at [0, 0.7, 0.3];\nhinge bar: fore, aft -> hub;\ndrive lift: hub.z;\n\
                        measure spring: length(hub -> fore);\n\"\"\"\ntime = { instants = [0.0] }\n\
                        drives = { lift = 0.3 }\n";

#[test]
fn columns_that_the_model_cannot_follow_together_are_refused() {
    let [axle, heave] = [axle(), in_heave_and_roll()];
    let far = "left toe [deg],left wheel travel [mm],right wheel travel [mm],steer [mm]\n0,0,0,0\n";
    let far = far.to_owned() + &"0,9,900,0\n".repeat(30);
    for (model, table, expected) in [
        (
            &*axle,
            "left toe [deg],bump_left [mm],\"bump_left,bump_right [mm]\"\n0,0,0\n",
            "m.csv:1:31: `bump_left` and `bump_left,bump_right` both say where `bump_left` is; empty the heading of one",
        ),
        (
            BAR,
            "left wheel travel [mm],right wheel travel [mm],left camber [deg]\n0,0,0\n",
            "m.csv:1:24: the drive `roll` follows `left wheel travel`, and no other drive is left that could follow `right wheel \
             travel`; empty the heading of one",
        ),
        (
            &heave,
            "left camber [deg],left wheel travel [mm]\n0,0\n",
            "m.csv:1:19: which drive follows `left wheel travel`? Write travel = { left = \"NAME\" } under [vehicle] of the motion \
             file, or empty the heading",
        ),
        (
            &axle,
            "Pad height L [mm],Toe L [deg]\n0,0\n",
            "m.csv:1:1: no column says where the model is; head one with a drive and its unit (the drives are steer, bump_left, \
             bump_right), or with wheel travel, as `left wheel travel [mm]` and `right wheel travel [mm]`, for which [vehicle] may \
             have to state travel = \"DRIVE\", or with steering_wheel_angle, for which [vehicle] states rack_per_turn. The \
             headings are the first line of several fields that does not begin with #",
        ),
        (
            &axle,
            "Radhub [mm],Toe L [deg]\n0,0\n",
            "m.csv:1:1: unknown quantity `Radhub`; did you mean `left_wheel_travel` or `right_wheel_travel`? A column whose heading",
        ),
        (
            &axle,
            "Radhub links [mm],Spur [deg]\n0,0\n",
            "m.csv:1:19: unknown quantity `Spur`; did you mean `left_toe`, `right_toe` or `total_toe`? A column whose heading",
        ),
        (
            NO_WHEEL,
            "height [mm],spring [mm]\n0,0\n",
            "m.csv:1:1: no column says where the model is; head one with a drive and its unit (the drives are lift). The headings are the \
             first line of several fields that does not begin with #",
        ),
        (
            &axle,
            "left wheel travel [mm],Steering wheel angle [deg],left toe [deg]\n0,0,0\n",
            "m.csv:1:24: there is no `steering_wheel_angle` of this mechanism: it needs rack_per_turn under [vehicle], see suspension \
             motion --help; or empty the heading",
        ),
        (
            &axle,
            "steer [mm],left wheel travel [mm],left toe [deg]\n0,0,0\n1,,0\n",
            "m.csv:3:3: the line has no number in column `left wheel travel [mm]`",
        ),
        (
            &axle,
            "left toe [deg],left wheel travel [mm],right wheel travel [mm],steer [mm]\n0,0,0,0\n0,10,10,0\n0,10,900,0\n0,9,900,0\n",
            "m.csv:4:3: `left wheel travel` 10 mm, `right wheel travel` 900 mm and `steer` 0 mm from the design position are \
             together out of the model's reach; leave out the line (2 of 4 are out of reach). suspension range a.toml says what stops",
        ),
        (
            &axle,
            &far,
            "m.csv:3:3: `left wheel travel` 9 mm, `right wheel travel` 900 mm and `steer` 0 mm from the design position are together \
             out of the model's reach; leave out the line (20 of the first 21 are out of reach)",
        ),
    ] {
        let (_folder, output) = beside(model, table, &[]);
        assert_eq!(output.status.code(), Some(2), "{table}: {output:?}");
        let message = text(&output.stderr);
        let message = message.lines().filter(|line| !line.starts_with("note: "));
        let message = message.collect::<String>();
        assert!(message.starts_with(expected), "{expected}\n{message}");
    }
}
