//! Springs and bars that act in load cases by their rates.

use std::collections::BTreeMap;

use nalgebra::Vector3;

use super::super::program::{folder, run, text};
use super::{loaded, swept, table};

/// Two corners with the halves of an anti-roll bar, as `import --axle` writes them.
const AXLE: &str = "\
unit = \"m\"
angle = \"deg\"
statements = '''
mirror: left -> right;
include left: double_wishbone_pushrod;
measure bar_twist: angle(right_bar_outer -> right_drop_lower, left_bar_outer -> left_drop_lower
                         about right_bar_outer -> left_bar_outer);
'''
time = { instants = [0.0] }
vehicle = { wheel_radius = 0.3 }
[drives]
left_bump = 0.3
right_bump = 0.3
left_steer = 0.34
right_steer = -0.34
[springs.arb]
along = \"bar_twist\"
rate = 25.0
[springs.coil]
along = \"left_damper\"
rate = 30000.0
load = 2000.0
";
const ROLL: [&str; 2] = ["--drive", "left_bump,-right_bump=-0.03:0.03:13"];
const ACTING: &str = "[loads.roll]\nacting = [\"arb\"]\n";

fn axle(case: &str) -> String {
    format!("{AXLE}{case}")
}

fn assert_near(found: f64, expected: f64, bound: f64) {
    assert!((found - expected).abs() <= bound, "{found}, not {expected}");
}

/// Runs `loads` on a file and returns its exit code, report and messages.
fn run_loads(file: &str, more: &[&str]) -> (Option<i32>, String, String) {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), file).expect("written");
    let output = run(folder.path(), &[&["loads", "a.toml"], more].concat());
    let [report, notes] = [&output.stdout, &output.stderr].map(|bytes| text(bytes).to_owned());
    (output.status.code(), report, notes)
}

#[test]
fn springs_act_with_the_load_that_sweep_prints() {
    let case = "[loads.roll]\nacting = [\"coil\", \"arb\"]\n";
    let found = table(&axle(case), &ROLL);
    let expected = swept(&axle(""), &ROLL);
    assert_eq!(found.len(), 13);
    for (found, expected) in found.iter().zip(&expected) {
        assert_eq!(found["roll_bar_twist_Nm"], expected["arb_moment_Nm"]);
        assert_eq!(found["roll_left_damper_N"], expected["coil_force_N"]);
    }
    assert!(expected[0]["arb_moment_Nm"].abs() > 100.0);
    // One name needs no list.
    let alone = table(&axle("[loads.roll]\nacting = \"arb\"\n"), &ROLL);
    assert_eq!(alone, table(&axle(ACTING), &ROLL));
}

/// Along the roll, left drive up and right drive down, the difference of the forces on both is the moment times the slope of
/// the twist, by differences of `sweep`.
#[test]
fn drives_bear_the_virtual_work_of_a_bar() {
    let found = table(&axle(ACTING), &ROLL);
    for row in &found {
        let roll = row["left_bump_m"] - 0.3;
        let near = format!("left_bump,-right_bump={}:{}:2", roll - 1e-5, roll + 1e-5);
        let near = swept(&axle(""), &["--drive", &near]);
        let twist = |row: &BTreeMap<String, f64>| row["bar_twist_deg"].to_radians();
        let slope = (twist(&near[1]) - twist(&near[0])) / 2e-5;
        let on_drives = row["roll_left_bump_N"] - row["roll_right_bump_N"];
        let work = row["roll_bar_twist_Nm"] * slope;
        assert_near(on_drives, work, 1e-7 * work.abs() + 1e-6);
    }
    assert!(found[0]["roll_left_bump_N"].abs() > 100.0, "{:?}", found[0]);
}

/// The half of a bar turns about its own line: the drop link's force and the bar's moment balance there.
#[test]
fn a_drop_link_balances_the_moment_of_its_half_of_the_bar() {
    let found = table(&axle(ACTING), &ROLL);
    let places = swept(&axle(""), &ROLL);
    for (row, place) in found.iter().zip(&places) {
        let at = |name: &str| {
            Vector3::from(["x", "y", "z"].map(|axis| place[&format!("{name}_{axis}")]))
        };
        for (side, sign) in [("left", 1.0), ("right", -1.0)] {
            let [lower, upper] =
                ["drop_lower", "drop_upper"].map(|point| at(&format!("{side}_{point}")));
            let link = row[&format!("roll_{side}_drop_link_N")] * (upper - lower).normalize();
            // Both halves turn about one line, from right to left.
            let (outer, axis) = (Vector3::new(0.15, sign * 0.38, 0.26), Vector3::y());
            let of_link = (lower - outer).cross(&link).dot(&axis);
            let of_bar = sign * row["roll_bar_twist_Nm"];
            assert_near(of_link, -of_bar, 1e-9 * of_bar.abs() + 1e-9);
        }
    }
}

/// A spring by its rate has the same effect as its load as a constant.
#[test]
fn a_spring_acts_as_its_load_stated_as_a_number() {
    let springs = "[springs.coil]\nalong = \"damper\"\nrate = 28000.0\nload = 3800.0\n";
    let case = |line: &str| {
        let contact = "contact = [0.0, 0.0, 4000.0]";
        loaded(&format!("{springs}[loads.a]\n{contact}\n{line}\n"))
    };
    let up = ["--drive", "bump=0.02"];
    let by_rate = &table(&case("acting = [\"coil\"]"), &up)[0];
    let load = swept(&case(""), &up)[0]["coil_force_N"];
    assert_eq!(by_rate["a_damper_N"], load);
    let stated = &table(&case(&format!("coil = {load:?}")), &up)[0];
    for (name, expected) in stated {
        assert_eq!(by_rate[name], *expected, "{name}");
    }
    // A constant in the same measure, of another part, is added.
    let both = &table(&case("acting = [\"coil\"]\ndamper = 500.0"), &up)[0];
    assert_near(both["a_damper_N"], load + 500.0, 1e-9);
    let (_, report, _) = run_loads(&case("acting = [\"coil\"]\ndamper = 500.0"), &up);
    assert!(
        report.contains("\ndamper (spring coil and the stated 500.0 N)  "),
        "{report}"
    );
    // Also where the spring has the name of its measure.
    let case =
        case("acting = [\"damper\"]\ndamper = 500.0").replace("springs.coil", "springs.damper");
    assert_near(table(&case, &up)[0]["a_damper_N"], load + 500.0, 1e-9);
}

#[test]
fn a_wrong_line_of_acting_springs_is_refused_at_its_place() {
    for (case, expected) in [
        (
            "acting = [\"abr\"]",
            "a.toml:24:10: unknown spring `abr`; known are arb, coil; did you mean `arb`?",
        ),
        (
            "acting = [\"arb\", \"bar_twist\"]",
            "a.toml:24:10: unknown spring `bar_twist`; known are arb, coil",
        ),
        (
            "acting = 25.0",
            "a.toml:24:10: `acting` is a list of springs that act by their rates: write acting = [\"NAME\"]",
        ),
        (
            "acting = [\"arb\", \"coil\"]\ncoil = 2000.0",
            "a.toml:24:10: load case `a` states the load of spring `coil`, which cannot act by its rate as well: leave `coil` out of acting, or \
             leave out the line coil = ...\n",
        ),
        (
            "acting = [\"coil\"]\nleft_bump = \"coil\"",
            "a.toml:24:10: in load case `a` the measure `left_damper` bears the load of the drive `left_bump`, whatever the rate of spring \
             `coil`: leave `coil` out of acting, or leave out the line left_bump = ...\n",
        ),
        (
            "actign = [\"arb\"]",
            "unknown place `actign`; loads act at ",
        ),
    ] {
        let (code, _, notes) = run_loads(&axle(&format!("[loads.a]\n{case}\n")), &[]);
        assert_eq!(code, Some(2), "{case}");
        assert!(notes.contains(expected), "{expected}: {notes}");
    }
    let (code, _, notes) = run_loads(&loaded("[loads.a]\nacting = [\"arb\"]\n"), &[]);
    assert_eq!(code, Some(2));
    assert!(
        notes.contains("unknown spring `arb`: state it under [springs.arb]"),
        "{notes}"
    );
}

/// A spring that does not act is noted where the places stretch or twist it, unless the case says what it bears.
#[test]
fn springs_that_do_not_act_are_noted_with_the_remedy() {
    let contact = "left_contact = [0.0, 0.0, 2000.0]\n";
    let arb = "note: a.toml: the spring `arb` does not act in [loads.a], although its measure changes; write acting = [\"arb\"] there for it to act \
               by its rate\n";
    let both = "note: a.toml: the springs `arb` and `coil` do not act in [loads.a], although their measures change; write acting = [\"arb\", \
                \"coil\"] there for them to act by their rates\n";
    let coil = "note: a.toml: the spring `coil` does not act in [loads.a], although its measure changes; write acting = [\"arb\", \"coil\"] there for \
                it to act by its rate\n";
    let rack = "left_rack = [0.0, 100.0, 0.0]\n";
    for (lines, more, expected) in [
        (format!("{contact}left_bump = \"coil\"\n"), &ROLL[..], arb),
        (rack.to_owned(), &ROLL, both),
        ("acting = [\"arb\"]\n".to_owned(), &ROLL, coil),
        ("acting = [\"arb\", \"coil\"]\n".to_owned(), &ROLL, ""),
        (format!("{rack}arb = 10.0\ncoil = 2000.0\n"), &ROLL, ""),
        (rack.to_owned(), &[], ""),
    ] {
        let case = axle(&format!("[loads.a]\n{lines}"));
        let (code, _, notes) = run_loads(&case, more);
        assert_eq!(code, Some(0), "{notes}");
        let notes = notes.split_inclusive('\n');
        let notes: String = notes.filter(|note| note.contains(" not act in ")).collect();
        assert_eq!(notes, expected, "{lines}");
    }
}

/// Without --drive the case is solved at the design position alone, where a bar has no twist.
#[test]
fn springs_that_act_and_bear_nothing_are_noted_with_the_remedy() {
    let one = "note: a.toml: the spring `arb` acts in [loads.a] and bears nothing: its measure is as at the design position at every place; move \
               a drive with --drive, or state a load at the design position, load = ..., under [springs.NAME]\n";
    let both = "note: a.toml: the springs `arb` and `coil` act in [loads.a] and bear nothing: their measures are as at the design position at every \
                place; move a drive with --drive, or state a load at the design position, load = ..., under [springs.NAME]\n";
    let unloaded = axle("[loads.a]\nacting = [\"arb\", \"coil\"]\n").replace("load = 2000.0\n", "");
    for (file, more, expected) in [
        (
            axle("[loads.a]\nacting = [\"arb\", \"coil\"]\n"),
            &[][..],
            one,
        ),
        (unloaded, &[], both),
        (axle("[loads.a]\nacting = [\"coil\"]\n"), &[], ""),
        (axle("[loads.a]\nacting = [\"arb\"]\n"), &ROLL, ""),
    ] {
        let (code, _, notes) = run_loads(&file, more);
        assert_eq!(code, Some(0), "{notes}");
        let notes = notes.split_inclusive('\n');
        let notes: String = notes.filter(|note| note.contains("nothing: ")).collect();
        assert_eq!(notes, expected);
    }
}

/// At the design position, where a grid begins, a spring without a preload bears nothing.
#[test]
fn the_note_on_bushes_names_those_that_bear_a_load_anywhere() {
    let file = "unit = \"m\"\nstatements = \"\"\"\nfixed: front at [0.5, 0.25, 0.25], rear at [-0.5, 0.25, 0.25], top at [0.0, 0.75, 1.25];\n\
                free: tip at [0.0, 0.75, 0.25];\nhinge arm: front, rear -> tip;\ndrive bump: tip.z;\n\
                measure strut: length(top -> tip);\n\"\"\"\ntime = { instants = [0.0] }\ndrives = { bump = 0.25 }\n\
                springs.coil = { along = \"strut\", rate = 30000.0 }\nloads.a = { acting = [\"coil\"] }\n";
    let (_, report, _) = run_loads(file, &[]);
    assert!(report.contains("no load in: arm at front"), "{report}");
    let (_, _, notes) = run_loads(file, &["--drive", "bump=-0.05:0.05:3"]);
    assert!(notes.contains("bushes of the hinge `arm`"), "{notes}");
}
