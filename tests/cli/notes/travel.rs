//! Wheels whose drives of travel are not found by their names.

use super::super::program::{folder, run, text};
use super::notes;

/// Two arms, each with a wheel.
fn arms(vehicle: &str) -> String {
    let side = |wheel: &str, word: &str, side: f64| {
        let [inner, axle, outer] = [0.3, 0.6, 0.7].map(|y| side * y);
        format!(
            "fixed: {wheel}_front at [0.2, {inner:?}, 0.2], {wheel}_rear at [-0.2, {inner:?}, 0.2];\n\
             free: {wheel}_wc at [0, {outer:?}, 0.3];\nhinge {wheel}_arm: {wheel}_front, {wheel}_rear -> {wheel}_wc;\n\
             point {wheel}_axle: {wheel}_arm at [0, {axle:?}, 0.3];\ndrive bump_{word}: {wheel}_wc.z;\n\
             wheel {wheel}: {wheel}_axle -> {wheel}_wc;\n"
        )
    };
    let [left, right] = [side("fl", "left", 1.0), side("fr", "right", -1.0)];
    format!(
        "unit = 'm'\nstatements = '''\n{left}{right}'''\ntime = {{ instants = [0.0] }}\n\
         drives = {{ bump_left = 0.3, bump_right = 0.3 }}\n[vehicle]\nwheel_radius = 0.3\n{vehicle}"
    )
}

const TRAVEL: &str = "travel = { fl = \"bump_left\", fr = \"bump_right\" }";
const CAR: &str = "axle = \"front\"\nwheelbase = 2.6\ncg_height = 0.5\nbrake_share = 0.6\n";

#[test]
fn a_note_proposes_the_travel_drive_of_each_wheel_if_needed() {
    let expected = format!(
        "note: a.toml: no drive is named as the travel of the fl wheel and the fr wheel, and quantities of [vehicle] that need it are \
         left out; write {TRAVEL} under [vehicle]\n"
    );
    // Quantities that need the ground: the roll centre and those in roll.
    for vehicle in [CAR, ""] {
        assert_eq!(notes(&arms(vehicle)), expected);
        assert_eq!(notes(&arms(&format!("{vehicle}{TRAVEL}\n"))), "");
    }
    assert_eq!(notes(&arms("").replace("wheel_radius = 0.3\n", "")), "");
}

#[test]
fn sheet_proposes_the_travel_drive_of_each_wheel() {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), arms("")).expect("written");
    let output = run(folder.path(), &["sheet", "a.toml"]);
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    let messages = text(&output.stderr);
    let expected = format!("Write [vehicle] with {TRAVEL}; the drives are bump_left, bump_right\n");
    assert!(messages.ends_with(&expected), "{messages}");
}

#[test]
fn for_drives_in_heave_and_roll_the_missing_travel_is_noted() {
    let both = arms("")
        .replace("drive bump_left: fl_wc.z;\n", "")
        .replace(
            "drive bump_right: fr_wc.z;",
            "drive heave: 0.5 fl_wc.z + 0.5 fr_wc.z;\ndrive roll: fl_wc.z - fr_wc.z;",
        )
        .replace(
            "bump_left = 0.3, bump_right = 0.3",
            "heave = 0.3, roll = 0.0",
        );
    assert_eq!(
        notes(&both),
        "note: a.toml: `heave` and `roll` together move the fl wheel and the fr wheel up and down, and quantities of [vehicle] that need a \
         drive of travel for each wheel are left out; in place of these write one for each, as `drive NAME: fl_wc.z;`\n"
    );
}
