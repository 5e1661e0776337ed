//! Tables as rigs and other programs write them.

use super::super::program::{CORNER, folder, run, text};
use super::measured::beside;
use super::rows;

pub(super) fn axle() -> String {
    CORNER
        .replace("double_wishbone_pushrod", "steered_axle")
        .replace("bump = 0.3", "bump_left = 0.3\nbump_right = 0.3")
}

/// The table that sweep writes for options.
pub(super) fn swept(model: &str, options: &[&str]) -> String {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), model).expect("written");
    let output = run(
        folder.path(),
        &[&["sweep", "a.toml", "--csv", "-"], options].concat(),
    );
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    text(&output.stdout).to_owned()
}

/// Drives that do not change are held, here away from the design position too.
#[test]
fn a_table_of_sweep_is_equal_to_its_own_model() {
    let five_link = include_str!("../../../examples/five_link_height.toml");
    for (model, options, count) in [
        (CORNER, &["--drive", "bump=-0.05:0.06:12"][..], 100),
        (five_link, &["--drive", "theta=0.7:0.8:5", "--absolute"], 60),
        (
            &axle(),
            &["--drive", "steer=-0.02:0.02:5", "--drive", "bump_left=0.02"],
            300,
        ),
    ] {
        let (_folder, output) =
            beside(model, &swept(model, options), &["--absolute", "--csv", "-"]);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        let found = rows(&output);
        assert!(found.len() > count, "{}", found.len());
        for (names, [.., difference]) in &found {
            assert!(difference.abs() < 1e-9, "{names:?} {difference}");
        }
        let notes = text(&output.stderr);
        assert!(!notes.contains("--absolute"), "{notes}");
        assert!(notes.contains(" more; suspension motion --help"), "{notes}");
    }
}

/// Quantities of this name would be called `left bump`, which no option takes.
#[test]
fn a_drive_of_a_wheel_keeps_its_name() {
    let table = "bump_left [mm],left toe [deg]\n0,0\n10,0\n";
    let (_folder, output) = beside(&axle(), table, &[]);
    let printed = text(&output.stdout);
    assert!(
        printed.contains("at a change of bump_left (mm)"),
        "{printed}"
    );
}

#[test]
fn drives_that_seem_to_be_counted_otherwise_are_noted() {
    let own = swept(
        CORNER,
        &["--drive", "bump=-0.05:0.06:12", "--derivatives", "0"],
    );
    let changes = "bump [mm],toe [deg]\n-20,0\n20,0\n";
    for (table, options, expected) in [
        (
            &*own,
            &[][..],
            "`bump` takes a change from the design position, not the drive's own value: `bump` is 0.3 m at the design position; \
             use --absolute to state its own values",
        ),
        (
            changes,
            &["--absolute"],
            "`bump` takes the drive's own value, not a change from the design position: `bump` is 300 mm at the design position; \
             leave out --absolute to state changes",
        ),
        (
            "bump [mm],toe [deg]\n-0.05,0\n0.05,0\n",
            &[],
            "is `bump` in m? The file is in mm",
        ),
    ] {
        let (_folder, output) = beside(CORNER, table, options);
        let message = text(&output.stderr);
        assert!(
            message.contains(&format!("note: m.csv: {expected}\n")),
            "{message}"
        );
    }
    let heights = "left wheel travel [mm],left toe [deg]\n250,0\n300,0\n350,0\n";
    let (_folder, output) = beside(&axle(), heights, &[]);
    let expected = "note: m.csv: `left wheel travel` counts from the design position, and its numbers look like heights of the wheel \
                    centre, which is 300 mm there: subtract 300 mm from them\n";
    assert!(text(&output.stderr).contains(expected), "{output:?}");
    let (folder, _) = beside(CORNER, changes, &[]);
    let output = run(
        folder.path(),
        &["compare", "a.toml", "a.toml", "--absolute"],
    );
    let expected =
        "a.toml: --absolute is for the drives of a table of measured numbers; leave it out";
    assert!(text(&output.stderr).starts_with(expected), "{output:?}");
}

/// The rows of a table in standard form, and of the same numbers as rigs write them.
#[test]
fn the_forms_of_rigs_are_read_alike() {
    let plain = "left wheel travel [mm],left toe [deg]\n-20,0.2\n0,0.05\n10,-0.1\n0,0.03\n";
    let compared = |table: &str| {
        let (_folder, output) = beside(&axle(), table, &["--csv", "-"]);
        assert_eq!(output.status.code(), Some(0), "{table}: {output:?}");
        (
            text(&output.stdout).to_owned(),
            text(&output.stderr).to_owned(),
        )
    };
    let left_out = |names: &str| {
        format!(
            "note: m.csv: left out, as the model knows no such names: {names}; suspension motion --help says what each quantity \
             needs\n"
        )
    };
    let (expected, notes) = compared(plain);
    assert_eq!((expected.lines().count(), &*notes), (4, ""));
    for (table, notes) in [
        (
            "\u{feff}# Rig 17; run 3\r\nZeit;Wheel Travel (left);Toe angle left;Kommentar;\r\ns;[mm];Grad;;\r\n0,0;-20,0;0,2;start;\r\n\
             \r\n0,1;0;0,05;;\r\n0,2;10;-0,1;;\r\n0,3;0,0;0,03;;\r\n;;;;\r\n",
            left_out("`Zeit`, `Kommentar`"),
        ),
        (
            "time [s]\tFz [N]\tLEFT_TOE [\u{b0}]\tleft_wheel_travel [mm]\n0\t3000\t0.2\t-20\n1\t3000\t0.05\t0\n# back\n2\t3000\t-0.1\t10\n3\t-\t0.03\t0",
            left_out("`time [s]`, `Fz [N]`"),
        ),
        (
            "\"load; left [N]\",left toe [deg],left wheel travel [mm],right toe [deg]\n1,0.2,-20,\n1,0.05,0,NaN\n\"2\",\"-0.1\",1e1,\n1,0.03,0\n",
            left_out("`load; left [N]`"),
        ),
    ] {
        let (found, told) = compared(table);
        assert_eq!((found, told), (expected.clone(), notes), "{table}");
    }
}

/// One turn moves the rack by 50 mm.
#[test]
fn the_steering_wheel_leads_the_model() {
    let model = axle().replace(
        "vehicle = { wheel_radius = 0.3 }",
        "vehicle = { wheel_radius = 0.3, rack_per_turn = 0.05 }",
    );
    let options = ["--drive", "steer=-0.02:0.02:5", "--derivatives", "0"];
    let table = swept(&model, &options);
    let table = table.replacen("steer_m,bump_left_m,bump_right_m", ",,", 1);
    let (_folder, output) = beside(&model, &table, &["--csv", "-"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let found = rows(&output);
    assert!(found.len() > 300, "{}", found.len());
    for (names, [.., difference]) in &found {
        assert!(difference.abs() < 1e-9, "{names:?} {difference}");
    }
    assert!(
        text(&output.stdout).contains("change of angle of the steering wheel (rad)"),
        "{output:?}"
    );
}

/// An arm of the left wheel in the axes of Adams, whose y points to the right.
const LEFT_IN_ADAMS: &str = "unit = \"mm\"\naxes = \"Adams\"\ntime = { instants = [0.0] }\ndrives = { bump = 0.0 }\nstatements = \"\"\"\n\
    fixed: front at [-300, 0, 0], rear at [200, 0, 0];\nfree: tip at [0, -500, 0];\nhinge arm: front, rear -> tip;\n\
    point hub: arm at [0, -400, 0];\nwheel: hub -> tip;\ndrive bump: tip.z;\n\"\"\"\n";

/// The rows of a table with the model's names, and of the same numbers under those of rigs.
#[test]
fn the_names_of_rigs_are_read_as_those_of_the_model() {
    let axle = axle().replace(
        "vehicle = { wheel_radius = 0.3 }",
        "vehicle = { wheel_radius = 0.3, rack_per_turn = 0.05 }",
    );
    let car = include_str!("../../../examples/front_and_rear_axle.toml");
    for (model, own, of_rigs) in [
        (
            LEFT_IN_ADAMS,
            "wheel travel [mm],camber [deg],toe [deg],recession [mm],tip z [mm]",
            "Wheel travel L [mm],Camber FL [deg],L toe [deg],Wheel recession [mm],tip z [mm]",
        ),
        (
            &*axle,
            "left wheel travel [mm],right wheel travel [mm],steer [mm],left toe [deg],right caster [deg]",
            "Wheel Displacement FL [mm],Jounce (RH) [mm],Rack-Travel [mm],Toe L [deg],Castor angle FR [deg]",
        ),
        (
            &axle,
            "left wheel travel [mm],right toe [deg],steering wheel angle [deg],left kingpin [deg],left mechanical trail [mm]",
            "Wheel Center Vertical Displacement LF [mm],R Toe [deg],Handwheel Angle [deg],KPI L [deg],Caster trail L [mm]",
        ),
        (
            CORNER,
            "steer [mm],wheel travel [mm],toe [deg],camber [deg],recession [mm]",
            "Steering rack displacement [mm],Left wheel jounce [mm],Toe FL [deg],Front left camber [deg],Wheel recession L [mm]",
        ),
        (
            CORNER,
            "steer [mm],wheel travel [mm],toe [deg],camber [deg],recession [mm]",
            "Zahnstangenhub in mm,Radhub / mm,Spur (links) / \u{b0},Sturz in deg,\"Wheel\nrecession\n[mm]\"",
        ),
        (
            CORNER,
            "steer [mm],wheel travel [mm],toe [deg],camber [deg],recession [mm]",
            "Rack travel in mm,Vertical travel in mm,Toe in (FL) in deg,Camber [deg],Wheel recession [mm]",
        ),
        (
            &axle,
            "left wheel travel [mm],steer [mm],left toe [deg],right toe [deg],total toe [deg]",
            "Jounce L [mm],Rack [mm],Toe in L [deg],Toe-in angle R (deg),Total toe-in [deg]",
        ),
        (
            car,
            "front_left wheel travel [mm],rear_right toe [deg],rear_right wheel travel [mm],front_steer [mm],front_left camber [deg]",
            "Wheel travel FL [mm],Toe RR [deg],Wheel travel Z RR [mm],Rack displacement [mm],LF camber [deg]",
        ),
        (
            car,
            "front_left wheel travel [mm],front_steer [mm],front_left toe [deg],rear_right camber [deg],front_right caster [deg]",
            "Federweg VL [mm],Zahnstangenweg [mm],Spur VL [deg],Sturz HR [deg],Nachlauf VR [deg]",
        ),
        (
            &axle,
            "left wheel travel [mm],right wheel travel [mm],steering wheel angle [deg],left kingpin [deg],total toe [deg]",
            "Radhub links [mm],Einfederung (rechts) [mm],Lenkradwinkel [deg],Spreizung links [deg],Gesamtspur [deg]",
        ),
        (
            &axle,
            "left wheel travel [mm],right wheel travel [mm],steer [mm],left steer angle [deg],left toe [deg]",
            "Radhub links [mm],Radhub rechts [mm],Zahnstangenhub [mm],Lenkwinkel links [deg],Spur links [deg]",
        ),
    ] {
        let compared = |headings: &str| {
            let table = format!("{headings}\n0,0,0,0,0\n9,8,7,6,5\n");
            let (_folder, output) = beside(model, &table, &["--csv", "-"]);
            assert_eq!(output.status.code(), Some(0), "{headings}: {output:?}");
            assert_eq!(text(&output.stderr), "", "{headings}");
            text(&output.stdout).to_owned()
        };
        assert_eq!(compared(of_rigs), compared(own));
    }
}

#[test]
fn what_a_rig_measures_elsewhere_is_left_out() {
    let table = "Wheel travel L [mm],Toe L [deg],Toe R [deg],Jounce bumper force [N]\n0,0,0,0\n";
    let (_folder, output) = beside(CORNER, table, &[]);
    for left_out in [
        "m.csv: left out, as the model has only the wheel on the other side: `Toe R [deg]`; import with --side or --axle makes",
        "knows no such names: `Jounce bumper force [N]`;",
    ] {
        assert!(text(&output.stderr).contains(left_out), "{output:?}");
    }
    let table = "Wheel travel L [mm],Toe L [deg],Handwheel angle [deg]\n0,0,0\n";
    let (_folder, output) = beside(CORNER, table, &[]);
    let expected =
        "m.csv:1:33: there is no `steering_wheel_angle` of this mechanism: it needs rack_per_turn";
    assert!(text(&output.stderr).starts_with(expected), "{output:?}");
    let rear = axle().replace("wheel_radius = 0.3", "wheel_radius = 0.3, axle = \"rear\"");
    let table = "Wheel travel RL [mm],Toe FL [deg],Toe RL [deg],FR_camber [deg],ch4\n0,0,0,0,0\n";
    let (_folder, output) = beside(&rear, table, &[]);
    for left_out in [
        "m.csv: left out, as the model is of the other axle: `Toe FL [deg]`, `FR_camber [deg]`; [vehicle] of the motion file states \
         which one\n",
        "knows no such names: `ch4`;",
    ] {
        assert!(text(&output.stderr).contains(left_out), "{output:?}");
    }
}

#[test]
fn a_quantity_of_the_opposite_sign_is_refused() {
    for (heading, place) in [("Toe-out [deg]", 19), ("left toe out angle (deg)", 19)] {
        let table = format!("wheel travel [mm],{heading}\n0,0\n9,1\n");
        let (_folder, output) = beside(CORNER, &table, &[]);
        assert_eq!(output.status.code(), Some(2), "{output:?}");
        let (name, _) = heading.split_once([' ', '(']).expect("a unit");
        let expected = format!("m.csv:1:{place}: `{name}");
        assert!(text(&output.stderr).starts_with(&expected), "{output:?}");
        let expected = "has the opposite sign of `toe`, which is positive if the front of the wheel points inboard: change the \
                        signs and call it `toe`; a column whose heading is empty is left out\n";
        assert!(text(&output.stderr).ends_with(expected), "{output:?}");
    }
}

/// The order of words does not matter unless it tells two names apart.
#[test]
fn the_exact_name_is_found_before_others_of_the_same_words() {
    let arm = "unit = \"m\"\ntime = { instants = [0.0] }\ndrives = { bump = 0.0 }\nstatements = \"\"\"\n\
               fixed: front at [0.3, 0, 0], rear at [-0.2, 0, 0];\nfree: tip at [0, 0.5, 0];\n\
               hinge arm: front, rear -> tip;\ndrive bump: tip.z;\n\
               measure front_to_tip: length(front -> tip);\nmeasure tip_to_front: length(rear -> tip);\n\"\"\"\n";
    for (name, x) in [("front_to_tip", 0.3_f64), ("Tip to front", 0.2)] {
        let table = format!("bump [m],{name} [m]\n0,{}\n", x.hypot(0.5));
        let (_folder, output) = beside(arm, &table, &["--csv", "-"]);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        for (names, [.., difference]) in rows(&output) {
            assert!(difference.abs() < 1e-12, "{names:?} {difference}");
        }
    }
}

/// Reports and pages call the wheel centre so, whatever the name of its point.
#[test]
fn the_wheel_centre_has_the_name_that_reports_use() {
    let listing = include_str!("../../../suspension-core/src/linkages/trailing_arm.linkage");
    let model = format!(
        "unit = \"m\"\nstatements = '''\n{}\n'''\ntime = {{ instants = [0.0] }}\ndrives = {{ bump = 0.3 }}\n",
        listing.replace("wheel_centre", "hub")
    );
    let table = swept(&model, &["--drive", "bump=-0.05:0.06:12"])
        .replace("hub_x,", "Wheel centre x [m],")
        .replace("recession_m,", "wheel centre recession [m],");
    let (_folder, output) = beside(&model, &table, &["--absolute", "--csv", "-"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let found = rows(&output);
    for quantity in ["wheel centre x", "recession"] {
        let mut of_this = found
            .iter()
            .filter(|(names, _)| names.contains(&quantity.to_owned()));
        let (_, [.., difference]) = of_this.next().expect(quantity);
        assert!(difference.abs() < 1e-9, "{quantity} {difference}");
    }
}
