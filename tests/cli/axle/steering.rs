//! Ackermann and turning circle.

use super::{DESIGN, Row, assert_near, file, steered, table};

const TRACK: f64 = 1.5;
const WHEELBASE: f64 = 2.6;

/// Steer angles of the outer and the inner wheel.
fn turned(row: &Row) -> [f64; 2] {
    let [left, right] = [-row["left_toe_rad"], row["right_toe_rad"]];
    assert_near(row["left_steer_angle_rad"], left, 0.0, "left");
    assert_near(row["right_steer_angle_rad"], right, 0.0, "right");
    if left + right < 0.0 {
        [-left, -right]
    } else {
        [right, left]
    }
}

#[test]
fn ackermann_and_turning_circle_follow_from_cotangents_of_steer() {
    let table = table(&steered(DESIGN), &["sweep", "--drive=steer=-0.03:0.03:13"]);
    for (place, row) in table.iter().enumerate() {
        let [outer, inner] = turned(row);
        let track = row["left_contact_y"] - row["right_contact_y"];
        assert_near(row["track_m"], track, 1e-15, "track");
        let toe = row["left_toe_rad"] + row["right_toe_rad"];
        assert_near(row["total_toe_rad"], toe, 0.0, "total toe");
        if place == 6 {
            assert!(row["ackermann_percent"].is_nan() && row["turning_radius_m"].is_nan());
            assert_near(track, TRACK, 1e-12, "track of the design");
            continue;
        }
        let ideal = (1.0 / (1.0 / outer.tan() - track / WHEELBASE)).atan();
        let percent = 100.0 * (inner - outer) / (ideal - outer);
        assert_near(row["ackermann_percent"], percent, 1e-8, "percentage");
        assert_near(
            row["ackermann_error_rad"],
            inner - ideal,
            1e-12,
            "Ackermann error",
        );
        // The circle through the outer contact point about the point where its normal meets the line of the rear axle.
        let across = WHEELBASE / outer.tan();
        let radius = across.hypot(WHEELBASE);
        assert_near(row["turning_radius_m"], radius, 1e-10 * radius, "radius");
    }
}

/// Bump steer may turn the outer wheel nearly straight while the inner one is steered. The ideal difference is then nearly
/// zero, and a percentage of it means nothing.
#[test]
fn a_nearly_straight_outer_wheel_has_no_ackermann_percentage() {
    let ends = [
        ("rack_left", 0.34),
        ("housing_left", 0.20),
        ("rack_right", -0.34),
        ("housing_right", -0.20),
    ];
    let raised = ends.map(|(end, y)| format!("{end} = [0.11, {y}, 0.24]\n"));
    let file = format!("{}\n[points]\n{}", steered(DESIGN), raised.concat());
    let table = table(
        &file,
        &[
            "sweep",
            "--drive=bump_left,bump_right=0.05",
            "--drive=steer=-0.015:0.015:61",
        ],
    );
    let degree = 1_f64.to_radians();
    let mut nearly_straight = 0;
    for row in &table {
        let [outer, inner] = turned(row);
        let has_none = outer.min(inner) < degree;
        nearly_straight += usize::from(has_none && outer + inner > 2.0 * degree);
        for name in [
            "ackermann_percent",
            "ackermann_error_rad",
            "turning_radius_m",
        ] {
            assert_eq!(row[name].is_nan(), has_none, "{name} at {outer}, {inner}");
        }
    }
    assert!(nearly_straight > 0);
}

/// Its turning circle would be about a centre on the line of the front axle, on the other side.
#[test]
fn a_steered_rear_axle_has_no_turning_circle() {
    for (axle, has_circle) in [("front", true), ("rear", false)] {
        let drives = DESIGN.lines().map(|drive| format!("{axle}_{drive}\n"));
        let file = file("", "wheelbase = 2.6", &drives.collect::<String>());
        let statements = format!("statements = \"include {axle}: steered_axle;\"");
        let file = file.replace("linkage = \"\"", &statements);
        let row = &table(&file, &["sweep", &format!("--drive={axle}_steer=0.02")])[0];
        for name in [
            "ackermann_percent",
            "ackermann_error_rad",
            "turning_radius_m",
        ] {
            assert_eq!(row.contains_key(name), has_circle, "{axle} {name}");
        }
        let moved = row.contains_key(&format!("{axle}_left_wheelbase_change_m"));
        assert!(moved, "the wheel's name tells its axle");
    }
}

/// Two wheels on fixed kingpins, with a rack.
fn wheels_on_kingpins(axle: &str, x: f64) -> String {
    let rack = x - 0.15;
    let statements = format!(
        "fixed: left_low at [{x}, 0.6, 0.2], left_high at [{x}, 0.58, 0.45], left_house at [{rack}, 0.2, 0.25];\n\
         free: left_tie at [{rack}, 0.58, 0.28], left_rack at [{rack}, 0.25, 0.25];\n\
         hinge left_knuckle: left_low, left_high -> left_tie;\nslide left_guide: left_rack on right_house -> left_house;\n\
         link bar: left_rack -> right_rack;\nlink left_rod: left_rack -> left_tie;\n\
         point left_hub: left_knuckle at [{x}, 0.65, 0.3];\npoint left_wc: left_knuckle at [{x}, 0.72, 0.3];\n\
         wheel left: left_hub -> left_wc;\n"
    );
    let named = statements.replace("left_", &format!("{axle}_left_"));
    let named = named.replace("right_", &format!("{axle}_right_"));
    let named = named.replace("link bar", &format!("link {axle}_bar"));
    named.replace("wheel left", &format!("wheel {axle}_left"))
}

/// The centre of the turn is on the line of the rear axle only if its wheels point straight ahead.
#[test]
fn with_steered_rear_wheels_no_turning_circle_about_the_rear_axle_is_told() {
    let front = wheels_on_kingpins("front", 1.3);
    let rear = wheels_on_kingpins("rear", -1.3)
        + "couple gear: rear_left_rack.y = 0.3 front_left_rack.y;\n";
    for (rear, has_circle) in [("", true), (rear.as_str(), false)] {
        let file = format!(
            "unit = 'm'\nvehicle = {{ wheel_radius = 0.3, wheelbase = 2.6 }}\ntime = {{ instants = [0.0] }}\n\
             drives = {{ steer = 0.25 }}\nstatements = '''\nmirror: left -> right;\n{front}{rear}\
             drive steer: front_left_rack.y;\n'''\n"
        );
        let table = table(&file, &["sweep", "--drive=steer=-0.03:0.03:3"]);
        for name in [
            "turning_radius_m",
            "ackermann_percent",
            "ackermann_error_rad",
        ] {
            let has = table[0].keys().any(|column| column.ends_with(name));
            assert_eq!(has, has_circle, "{name}");
        }
    }
}
