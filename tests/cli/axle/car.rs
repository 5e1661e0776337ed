//! A front and a rear axle in one listing: each moves like the axle alone.

use super::*;

/// 2.6 m, as far as the rear axle is moved back.
const BACK: f64 = 2.6;

const AT_DESIGN: &str = "front_bump_left = 0.3\nfront_bump_right = 0.3\nfront_steer = 0.34\n\
                         rear_bump_left = 0.29\nrear_bump_right = 0.29";

fn vehicle(radius: &str, brake_share: &str) -> String {
    format!(
        "wheel_radius = {radius}\nwheelbase = {BACK}\ncg_height = 0.5\nbrake_share = {brake_share}\n"
    )
}

/// Returns the file of a linkage away from its design position in heave, roll and steering.
fn moved(linkage: &str, vehicle: &str, drives: &str) -> String {
    format!(
        "linkage = \"{linkage}\"\nunit = \"m\"\n[vehicle]\n{vehicle}[time]\ninstants = [0.0]\n[drives]\n{drives}\n"
    )
}

/// Returns the first rows of a sweep over one value, by name.
fn swept(file: &str, drive: &str) -> Row {
    table(
        file,
        &[
            "sweep",
            "--drive",
            &format!("{drive}=0.02"),
            "--derivatives",
            "2",
        ],
    )
    .into_iter()
    .next()
    .expect("a row")
}

/// Compares the columns of an axle of the car with the axle alone.
fn check(car: &Row, alone: &Row, axle: &str, back: f64) {
    let mut compared = 0;
    let quantities = alone
        .iter()
        .filter(|(name, _)| !name.starts_with("residual"));
    for (name, value) in quantities {
        let of_axle = name.split("_per_").collect::<Vec<_>>();
        let named = of_axle.iter().map(|part| format!("{axle}_{part}"));
        let named = named.collect::<Vec<_>>().join("_per_");
        let found = car
            .get(&named)
            .unwrap_or_else(|| panic!("{named} is missing"));
        let is_position = name.ends_with("_x");
        let expected = if is_position { value - back } else { *value };
        assert_near(*found, expected, 1e-8 * (1.0 + value.abs()), &named);
        compared += 1;
    }
    assert!(compared > 200, "{compared}");
}

#[test]
fn each_axle_of_a_car_equals_the_axle_alone() {
    let car = moved(
        "front_and_rear_axle",
        &vehicle(
            "{ front = 0.30, rear = 0.29 }",
            "{ front = 0.65, rear = 0.35 }",
        ),
        AT_DESIGN,
    );
    let front = moved(
        "steered_axle",
        &format!("{}axle = \"front\"\n", vehicle("0.30", "0.65")),
        DESIGN,
    );
    let rear = moved(
        "twist_beam",
        &format!("{}axle = \"rear\"\n", vehicle("0.29", "0.35")),
        "bump_left = 0.29\nbump_right = 0.29",
    );
    let of_front = swept(&front, "steer");
    check(&swept(&car, "front_steer"), &of_front, "front", 0.0);
    let of_rear = swept(&rear, "bump_left");
    check(&swept(&car, "rear_bump_left"), &of_rear, "rear", BACK);
    assert!(of_front.contains_key("left_anti_dive_percent"));
    assert!(of_rear.contains_key("right_anti_lift_percent"));
}

/// The drives of one axle move no wheel of the other.
#[test]
fn drives_of_one_axle_do_not_move_the_other() {
    let car = moved("front_and_rear_axle", &vehicle("0.3", "0.5"), AT_DESIGN);
    let row = swept(&car, "front_bump_left");
    for name in [
        "rear_left_camber_rad",
        "rear_left_toe_rad",
        "rear_right_centre_z",
    ] {
        let per = format!("{name}_per_front_bump_left");
        assert!(row.get(&per).is_none_or(|slope| *slope == 0.0), "{per}");
    }
    let own = row["rear_left_camber_rad_per_rear_bump_right"];
    assert!(own.abs() > 1e-3, "the beam twists: {own}");
}

#[test]
fn vehicle_entries_of_missing_wheels_are_refused() {
    for (vehicle, expected) in [
        (
            "wheel_radius = { middle = 0.3 }\n",
            "unknown wheel `middle`; known are front_left, front_right, rear_left, rear_right",
        ),
        (
            "axle = \"front\"\nwheelbase = 2.6\ncg_height = 0.5\n",
            "car.toml:3:1: `axle` contradicts the name of the wheel `rear_left`; leave it out",
        ),
        (
            "wheelbase = 2.6\nbrake_share = { front = 0.6, rear = 0.4 }\n",
            "car.toml:3:1: [vehicle] is incomplete: anti-dive, anti-lift and anti-squat need axle, wheelbase, cg_height and \
             brake_share or drive_share; cg_height is missing",
        ),
        (
            "brake_share = { front = 1.5 }\nwheelbase = 2.6\ncg_height = 0.5\n",
            "brake_share must be the axle's share of the force, from 0 to 1",
        ),
        (
            "brake_share = 0.6\nwheelbase = 2.6\ncg_height = 0.5\n",
            "car.toml:4:15: brake_share is 0.6 in front and 0.6 at the rear, more than 1 in all; state how the axles share the force",
        ),
        (
            "drive_share = { front = 0.5, rear = 0.6 }\nwheelbase = 2.6\ncg_height = 0.5\n",
            "car.toml:4:15: drive_share is 0.5 in front and 0.6 at the rear",
        ),
        (
            "wheel_radius = {}\n",
            "car.toml:4:16: the table is empty; write a number or { front = number, rear = number }, or leave it out",
        ),
        (
            "wheel_radius = \"big\"\n",
            "invalid type: string \"big\", expected a number or { front = number, rear = number }",
        ),
    ] {
        let folder = folder();
        let file = moved("front_and_rear_axle", vehicle, AT_DESIGN);
        std::fs::write(folder.path().join("car.toml"), file).expect("written");
        let output = run(folder.path(), &["check", "car.toml"]);
        assert_eq!(output.status.code(), Some(2), "{output:?}");
        let message = text(&output.stderr);
        assert!(message.contains(expected), "{message}");
    }
}

/// A corner in a file in millimetres, twice by `mirror`, with the motion file in the same folder.
#[test]
fn a_corner_file_included_and_mirrored_makes_an_axle() {
    let folder = folder();
    let write =
        |name: &str, text: &str| std::fs::write(folder.path().join(name), text).expect("written");
    write(
        "corner.linkage",
        "fixed: front at [200.0, 350.0, 300.0], rear at [-200.0, 350.0, 310.0];\n\
         free: hub at [0.0, 700.0, 300.0];\nhinge arm: front, rear -> hub;\npoint axle: arm at [0.0, 600.0, 300.0];\n\
         drive bump: hub.z;\nwheel: axle -> hub;\n",
    );
    write(
        "axle.linkage",
        "mirror: left -> right;\ninclude left: \"corner.linkage\";\n",
    );
    write(
        "axle.toml",
        "listing = \"axle.linkage\"\nunit = \"mm\"\nvehicle = { wheel_radius = 300.0 }\ntime = { instants = [0.0] }\n\
         drives = { left_bump = 320.0, right_bump = 280.0 }\n",
    );
    let row = &table_in(folder.path(), &["motion", "axle.toml"])[0];
    assert!(
        row["left_camber_rad"] < 0.0 && row["right_camber_rad"] > 0.0,
        "{row:?}"
    );
    assert!((row["track_mm"] - 1400.0).abs() < 60.0);
    write("car.linkage", "include front: steered_axle;\n");
    let car = std::fs::read_to_string(folder.path().join("axle.toml")).expect("written");
    write("car.toml", &car.replace("axle.linkage", "car.linkage"));
    let output = run(folder.path(), &["motion", "car.toml"]);
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    let message = text(&output.stderr);
    let expected = "car.toml:1:11: the listing includes `steered_axle` of the catalogue, whose hardpoints are in metres";
    assert!(message.starts_with(expected), "{message}");
    write("odd.linkage", "include odd: \".\";\n");
    write("odd.toml", &car.replace("axle.linkage", "odd.linkage"));
    let output = run(folder.path(), &["motion", "odd.toml"]);
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    assert!(
        text(&output.stderr).contains("it is no regular file"),
        "{output:?}"
    );
    write("corner.linkage", "fixed: front;\nlink rod front -> hub;\n");
    let output = run(folder.path(), &["motion", "axle.toml"]);
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    let message = text(&output.stderr);
    assert!(
        message
            .contains("axle.linkage:2:15: corner.linkage:2:10: expected `:`; a `link` is written"),
        "{message}"
    );
}

#[test]
fn vehicle_entries_that_the_mechanism_contradicts_are_noted() {
    for (vehicle, expected) in [
        ("wheelbase = 2.65\n", ""),
        (
            "wheelbase = 2.9\n",
            "note: car.toml: wheelbase is 2.9 m, but the wheel centres of the axles are 2.6 m apart\n",
        ),
        (
            "travel = { front_left = \"front_bump_right\", front_right = \"front_bump_left\" }\n",
            "note: car.toml: travel of the front_left wheel is `front_bump_right`, which moves the front_right wheel: are the drives \
             of travel crossed?\n\
             note: car.toml: travel of the front_right wheel is `front_bump_left`, which moves the front_left wheel: are the drives \
             of travel crossed?\n",
        ),
        ("steer = { front = \"front_steer\" }\n", ""),
        (
            "steer = { rear_left = \"front_steer\" }\n",
            "note: car.toml: steer of the rear_left wheel is `front_steer`, which does not turn it: is it another drive?\n",
        ),
    ] {
        let folder = folder();
        let file = moved("front_and_rear_axle", vehicle, AT_DESIGN);
        std::fs::write(folder.path().join("car.toml"), file).expect("written");
        let output = run(folder.path(), &["motion", "car.toml"]);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        assert_eq!(text(&output.stderr), expected, "{vehicle}");
    }
}
