//! Tables with both axles of a vehicle, of which `--end` takes one, and headings that name a side.

use super::super::program::{folder, run, text};
use super::refused::refusal;
use super::{CORNER, import, table};

/// The points of the rear corner: those of the front one, each moved.
fn rear() -> Vec<(&'static str, [f64; 3])> {
    let points = CORNER.into_iter();
    let moved = points.map(|(name, [x, y, z])| (name, [x + 1600.0, y - 20.0, z + 10.0]));
    moved.collect()
}

fn mirrored(points: &[(&'static str, [f64; 3])]) -> Vec<(&'static str, [f64; 3])> {
    let points = points.iter();
    points
        .map(|(name, [x, y, z])| (*name, [*x, -y, *z]))
        .collect()
}

/// The lines of a table with something before each.
fn each_with(before: &str, points: &[(&str, [f64; 3])]) -> String {
    let table = table(points);
    let lines = table.lines();
    lines.map(|line| format!("{before}{line}\n")).collect()
}

/// The lines of a table with something behind each name.
fn each_behind(behind: &str, points: &[(&str, [f64; 3])]) -> String {
    let table = table(points);
    let lines = table.lines();
    let named = lines.map(|line| line.replacen(',', &format!("{behind},"), 1) + "\n");
    named.collect()
}

/// The lines of two tables side by side, with an empty column between them.
fn side_by_side(one: &str, other: &str) -> String {
    let lines = one.lines().zip(other.lines());
    lines
        .map(|(one, other)| format!("{one}, , {other}\n"))
        .collect()
}

/// Tables of both axles.
fn cars() -> [String; 13] {
    let (front, rear) = (CORNER.as_slice(), rear());
    let front_right = mirrored(front);
    let rear_right = mirrored(&rear);
    [
        format!(
            "Front suspension\n{}Rear suspension\n{}",
            table(front),
            table(&rear)
        ),
        format!("x, y, z\n# FRONT\n{}# REAR\n{}", table(front), table(&rear)),
        each_with("Front, ", front) + &each_with("Rear, ", &rear),
        each_with("Front ", front) + &each_with("Rear ", &rear),
        each_with("Front Left ", front)
            + &each_with("Front Right ", &front_right)
            + &each_with("Rear Left ", &rear)
            + &each_with("Rear Right ", &rear_right),
        each_with("FL ", front)
            + &each_with("FR ", &front_right)
            + &each_with("RL ", &rear)
            + &each_with("RR ", &rear_right),
        format!(
            "FRONT LEFT\n{}FRONT RIGHT\n{}REAR LEFT (mm)\n{}REAR RIGHT\n{}",
            table(front),
            table(&front_right),
            table(&rear),
            table(&rear_right)
        ),
        each_behind("_F", front) + &each_behind("_R", &rear),
        each_behind("-FL", front) + &each_behind("-RL", &rear),
        each_with("F_L_", front) + &each_with("R_L_", &rear),
        each_behind(" (front axle)", front) + &each_behind(" (rear axle)", &rear),
        each_behind(" (front left)", front)
            + &each_behind(" (front right)", &front_right)
            + &each_behind(" (rear left)", &rear)
            + &each_behind(" (rear right)", &rear_right),
        format!(
            "Front suspension, , , , , Rear suspension\n{}",
            side_by_side(&table(front), &table(&rear))
        ),
    ]
}

#[test]
fn one_axle_of_a_table_is_that_axle_in_a_table_of_its_own() {
    let folder = folder();
    for car in cars() {
        for (end, alone) in [("front", CORNER.to_vec()), ("rear", rear())] {
            let imported = import(folder.path(), "car.csv", &car, &["--end", end]);
            let alone = format!("{end} suspension\n{}", table(&alone));
            let alone = import(folder.path(), "alone.csv", &alone, &[]);
            assert_eq!(imported.points(), alone.points(), "{end} of {car}");
            let drives = [&imported, &alone].map(|each| each.motion["drives"].clone());
            assert_eq!(drives[0], drives[1], "{end} of {car}");
        }
    }
}

#[test]
fn a_table_of_both_axles_is_refused_without_an_end() {
    for car in cars() {
        let said = refusal("car.csv", &car, &[]);
        let expected = "already; to import one axle of the two, say --end front or --end rear";
        assert!(said.trim_end().ends_with(expected), "{said}");
    }
    let twice = table(&CORNER) + &table(&rear());
    let said = refusal("car.csv", &twice, &[]);
    let expected = "point `lca_front` stands in car.csv:1 already; leave one of them; if they are of two axles, write headings \
                    such as `Front suspension` and `Rear suspension` above the points and say --end front or --end rear";
    assert!(said.trim_end().ends_with(expected), "{said}");
}

#[test]
fn an_end_is_refused_if_all_points_are_of_the_other_one() {
    let file = format!("Front suspension\n{}", table(&CORNER));
    let said = refusal("car.csv", &file, &["--end", "rear"]);
    let expected = "car.csv:2:1: point `lca_front` is of the other axle, and no line says which points are of the rear one: write \
                    a heading such as `rear suspension` above them";
    assert_eq!(said.trim_end(), expected);
}

/// The tie rod of a rear axle is fixed on the chassis.
#[test]
fn an_end_may_be_told_of_a_table_that_does_not_name_it() {
    let folder = folder();
    let file = table(&CORNER);
    let [untold, rear] =
        [&[][..], &["--end", "rear"]].map(|options| import(folder.path(), "a.csv", &file, options));
    assert_eq!(rear.points(), untold.points());
    assert!(!untold.notes.contains("does not steer"), "{}", untold.notes);
    assert!(
        rear.notes.contains("fixed on the chassis: --end says rear"),
        "{}",
        rear.notes
    );
}

#[test]
fn radii_and_points_without_an_end_belong_to_both_axles() {
    let folder = folder();
    let (centre, others) = (CORNER[8], [&CORNER[..8], &CORNER[9..]].concat());
    let car = format!(
        "{}Front suspension\n{}tire_radius, 229\nRear suspension\n{}tire_radius, 260\n",
        table(&[centre]),
        table(&others),
        table(&others)
    );
    for (end, radius) in [("front", 229.0), ("rear", 260.0)] {
        let imported = import(folder.path(), "car.csv", &car, &["--end", end]);
        assert_eq!(imported.points()["wheel_centre"], [0.0, 610.0, 229.0]);
        let found = imported.motion["vehicle"]["wheel_radius"].as_float();
        assert_eq!(found, Some(radius), "{end}");
    }
}

#[test]
fn each_axle_has_a_motion_file_of_its_own_name() {
    let folder = folder();
    let [car, ..] = cars();
    std::fs::write(folder.path().join("car.csv"), car).expect("written");
    for (end, file) in [("front", "car_front.toml"), ("rear", "car_rear.toml")] {
        let output = run(folder.path(), &["import", "car.csv", "--end", end]);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        let said = text(&output.stderr);
        assert!(said.ends_with(&format!("wrote {file}\n")), "{said}");
    }
}

#[test]
fn the_motion_file_states_the_axle_if_the_table_does() {
    let folder = folder();
    let corner = table(&CORNER);
    let of = |file: &str, content: &str, options: &[&str]| {
        let imported = import(folder.path(), file, content, options);
        let axle = imported.motion["vehicle"].get("axle");
        axle.map(|axle| axle.as_str().expect("text").to_owned())
    };
    assert_eq!(of("a.csv", &corner, &[]), None);
    let rear = format!("Rear suspension\n{corner}");
    assert_eq!(of("a.csv", &rear, &[]).as_deref(), Some("rear"));
    assert_eq!(of("a.csv", &rear, &["--axle"]).as_deref(), Some("rear"));
    assert_eq!(of("front.csv", &corner, &[]).as_deref(), Some("front"));
    let option = of("a.csv", &corner, &["--end", "rear"]);
    assert_eq!(option.as_deref(), Some("rear"));
}

#[test]
fn headings_name_the_sides_of_unlike_corners() {
    let folder = folder();
    let left = CORNER.as_slice();
    let right = mirrored(&rear());
    let one_below_the_other =
        |one: &str, other: &str| format!("{one}\n{}{other}\n{}", table(left), table(&right));
    let files = [
        one_below_the_other("Left side", "Right side"),
        one_below_the_other("Left-hand side", "Right-hand side"),
        one_below_the_other("LHS", "RHS"),
        one_below_the_other(
            "LEFT FRONT SUSPENSION POINTS",
            "RIGHT FRONT SUSPENSION POINTS",
        ),
        each_behind("_L", left) + &each_behind("_R", &right),
        each_with("L ", left) + &each_with("R ", &right),
        "Left, , , , , Right\n".to_owned() + &side_by_side(&table(left), &table(&right)),
    ];
    for file in files {
        let axle = import(folder.path(), "axle.csv", &file, &[]).points();
        for (side, points) in [("left", left), ("right", &right)] {
            let alone = format!("{side}\n{}", table(points));
            let alone = import(folder.path(), "alone.csv", &alone, &[]).points();
            for (name, at) in alone {
                assert_eq!(axle[&format!("{side}_{name}")], at, "{side} {name}: {file}");
            }
        }
    }
}

#[test]
fn tables_side_by_side_without_a_heading_are_refused() {
    let corner = table(&CORNER);
    let said = refusal("a.csv", &side_by_side(&corner, &corner), &[]);
    let expected = "a.csv:1:1: two points stand side by side: write `Left` and `Right`, or `Front` and `Rear`, in a heading above \
                    the tables, or one table below the other";
    assert_eq!(said, expected);
}

/// Words of an origin behind those of the axle change nothing.
#[test]
fn a_heading_with_a_remark_on_the_origin_names_the_axle() {
    let folder = folder();
    let corner = table(&CORNER);
    for heading in [
        "Rear suspension at ride height",
        "Rear axle geometry relative to chassis",
        "Rear suspension hardpoints, origin at front axle",
    ] {
        let motion = import(folder.path(), "a.csv", &format!("{heading}\n{corner}"), &[]).motion;
        assert_eq!(
            motion["vehicle"]["axle"].as_str(),
            Some("rear"),
            "{heading}"
        );
        assert!(motion["drives"].get("steer").is_none(), "{heading}");
    }
}

/// A tie rod whose table is of a rear axle is fixed on the chassis.
#[test]
fn remarks_on_the_other_axle_are_no_headings() {
    let folder = folder();
    let corner = table(&CORNER);
    for file in [
        format!("Origin: rear axle centre\n{corner}"),
        format!("# x from the rear axle\n{corner}"),
        format!("x = 0 at the rear axle\n{corner}"),
        format!("{corner}Rear\n"),
        format!("{corner}The rear suspension is in a file of its own\n"),
    ] {
        let motion = import(folder.path(), "a.csv", &file, &[]).motion;
        assert!(motion["drives"].get("steer").is_some(), "{file}");
    }
}

/// In axes with y to the right, the left corner has negative y.
#[test]
fn a_title_may_state_the_corner_among_other_words() {
    let folder = folder();
    for (title, side, axle) in [
        ("Front left suspension hardpoints v3", "left", "front"),
        ("Car 7, right rear corner", "right", "rear"),
        ("Suspension FL - revision B", "left", "front"),
        ("Kinematikpunkte Vorderachse links", "left", "front"),
        ("Train arrière droit", "right", "rear"),
        ("Sospensione anteriore sinistra", "left", "front"),
        ("Sospensione anteriore dx", "right", "front"),
        ("Suspensión trasera derecha", "right", "rear"),
    ] {
        let sign = if side == "left" { 1.0 } else { -1.0 };
        let points = CORNER.map(|(name, [x, y, z])| (name, [x, sign * y, z]));
        let file = format!("{title}\n{}", table(&points));
        let imported = import(folder.path(), "a.csv", &file, &[]);
        let notes = &imported.notes;
        for said in [
            format!("the corner is the {side} one"),
            format!(" on the {side}"),
        ] {
            assert!(notes.contains(&said), "{title}: {notes}");
        }
        let stated = imported.motion["vehicle"]["axle"].as_str();
        assert_eq!(stated, Some(axle), "{title}");
    }
    let title = "Front suspension, measured right of the pit";
    let file = format!("{title}\n{}", table(&CORNER));
    let notes = import(folder.path(), "a.csv", &file, &[]).notes;
    assert!(!notes.contains(" on the right"), "{notes}");
}

/// The German `links` is `left`.
#[test]
fn links_of_a_suspension_are_no_side() {
    let folder = folder();
    let corner = table(&CORNER);
    let plain = import(folder.path(), "a.csv", &corner, &[]);
    for heading in [
        "Links",
        "Front links",
        "Lateral links rear",
        "Rear drive train",
    ] {
        let imported = import(folder.path(), "a.csv", &format!("{heading}\n{corner}"), &[]);
        assert_eq!(imported.motion, plain.motion, "{heading}");
    }
}
