//! Both corners of a file, as an axle.

mod sides;

use suspension_core::linkages::LISTINGS;
use suspension_core::listing::{Part, Parts};
use suspension_runtime::Listing;

use super::super::program::{folder, run, text};
use super::{CORNER, import, swept, table};

/// The corner under the names of a side of Adams/Car; y as on the left, multiplied.
fn side(prefix: &str, y: f64) -> String {
    let points = CORNER.map(|(name, at)| (format!("{prefix}{name}"), [at[0], y * at[1], at[2]]));
    let points = points.each_ref().map(|(name, at)| (name.as_str(), *at));
    table(&points)
}

const ANGLES: &str = "toe_angle, 0.3\ncamber_angle, -1.2\ntire_radius, 229\n";

/// Both sides, in a mirror.
fn symmetric() -> String {
    side("hpl_", 1.0) + &side("hpr_", -1.0) + ANGLES
}

fn assert_near(found: f64, expected: f64, what: &str) {
    let bound = 1e-9 * expected.abs().max(1.0);
    assert!(
        (found - expected).abs() <= bound,
        "{what}: {found}, not {expected}"
    );
}

#[test]
fn import_and_sheet_turn_both_sides_into_the_page_of_an_axle() {
    let folder = folder();
    let path = folder.path();
    std::fs::write(path.join("front.csv"), symmetric()).expect("written");
    let output = run(path, &["import", "front.csv", "--axle"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    assert!(
        text(&output.stderr).contains("wrote front.toml\nwrote front_corner.linkage\n"),
        "{output:?}"
    );
    // Data that the file lacks and the motion file has a place for.
    let motion = std::fs::read_to_string(path.join("front.toml")).expect("a motion file");
    let motion = motion.replace("# wheelbase = ", "wheelbase = 1550.0 ");
    std::fs::write(path.join("front.toml"), motion).expect("written");
    let output = run(path, &["sheet", "front.toml"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let page = std::fs::read_to_string(path.join("out/front_sheet.html")).expect("a page");
    for quantity in ["track", "total toe", "Ackermann", "roll steer"] {
        assert!(page.contains(quantity), "{quantity}");
    }
    // At the design position, computed by hand: the contact points are below the lean of the wheel.
    let design = &swept(path, "front.toml", &["steer=0"])[0];
    assert_near(design["total_toe_deg"], 0.6, "total toe");
    let lean = (-1.2_f64).to_radians().sin() * 0.3_f64.to_radians().cos();
    assert_near(design["track_mm"], 2.0 * (610.0 - 229.0 * lean), "track");
}

/// The axle's corners on the shared rack equal the corner of the same file with its own rack.
#[test]
fn corners_of_an_imported_axle_equal_the_corner_on_its_own_rack() {
    let folder = folder();
    let path = folder.path();
    import(path, "front.csv", &symmetric(), &[]);
    let alone = swept(path, "motion.toml", &["bump=-30:30:3", "steer=-15:15:3"]);
    import(path, "front.csv", &symmetric(), &["--axle"]);
    let both = swept(
        path,
        "motion.toml",
        &["left_bump,right_bump=-30:30:3", "steer=-15:15:3"],
    );
    assert_eq!((alone.len(), both.len()), (9, 9));
    let quantities = [
        "camber_deg",
        "toe_deg",
        "caster_deg",
        "damper_mm",
        "tie_ball_z_mm",
        "camber_deg_per_bump",
    ];
    let mut compared = 0;
    for (place, row) in both.iter().enumerate() {
        // The rack moves towards one wheel and away from the other.
        let mirrored = place / 3 * 3 + (2 - place % 3);
        for quantity in quantities {
            let left = format!("left_{quantity}").replace("per_bump", "per_left_bump");
            let right = format!("right_{quantity}").replace("per_bump", "per_right_bump");
            let Some(expected) = alone[place].get(quantity) else {
                continue;
            };
            assert_near(row[&left], *expected, &left);
            assert_near(row[&right], alone[mirrored][quantity], &right);
            compared += 1;
        }
    }
    assert!(compared >= 9 * 4, "{compared}");
    let racks = both
        .iter()
        .map(|row| row["left_rack_y"] - row["right_rack_y"]);
    for apart in racks {
        assert_near(apart, 380.0, "the rack's length");
    }
}

#[test]
fn every_layout_with_a_wheel_centre_is_imported_as_an_axle() {
    let mut made = 0;
    for (linkage, listing) in LISTINGS {
        let listing = Listing::parse(listing).expect("a listing");
        if listing.point("wheel_centre").is_none() {
            continue;
        }
        let points = listing.stated();
        let points = points.map(|(point, at)| (listing.name(Part::Point(point)), at.into()));
        let mut points: Vec<(&str, [f64; 3])> = points.collect();
        if *linkage == "five_link" {
            points.push(("wheel_centre", [-1.27, 0.415, 0.218]));
        }
        let options = ["--axle", "--linkage", linkage];
        let folder = folder();
        let imported = import(folder.path(), "own.csv", &table(&points), &options);
        let drives = imported.motion["drives"].as_table().expect("a table");
        let steered = listing.drive("steer").is_some();
        assert_eq!(drives.len(), 2 + usize::from(steered), "{linkage}");
        let (travel, _) = drives.iter().next().expect("a drive");
        let rows = swept(
            folder.path(),
            "motion.toml",
            &[&format!("{travel}=0:0.001:2")],
        );
        let [design, moved] = rows.as_slice() else {
            panic!("{linkage}: {}", rows.len())
        };
        for row in &rows {
            assert!(row["residual_m"] < 1e-12, "{linkage}: {row:?}");
        }
        assert_near(design["right_toe_deg"], design["left_toe_deg"], linkage);
        assert_near(moved["right_toe_deg"], design["right_toe_deg"], linkage);
        assert!(
            moved["left_wheel_centre_z"] > design["left_wheel_centre_z"] + 1e-4
                || *linkage == "five_link"
        );
        made += 1;
    }
    assert!(made >= 10, "{made}");
}

/// Angles and radii that a table states for each side, in a file whose points are mirror images. The middle of an anti-roll
/// bar is one point in the file, without a side.
#[test]
fn an_anti_roll_bar_of_both_sides_is_halved() {
    let folder = folder();
    let bar = [
        ("arb_bend", [120.0, -200.0, 130.0]),
        ("droplink_to_arb", [60.0, -205.0, 140.0]),
        ("droplink_to_bellcrank", [15.0, -240.0, 420.0]),
    ];
    let of = |prefix: &str, y: f64| {
        bar.map(|(name, [x, at, z])| format!("{prefix}{name}, {x}, {}, {z}\n", y * at))
            .concat()
    };
    let file =
        symmetric() + &of("hpl_", 1.0) + &of("hpr_", -1.0) + "hps_arb_bar_centre, 120, 0, 130\n";
    let imported = import(folder.path(), "front.csv", &file, &["--axle"]);
    let points = imported.points();
    assert_eq!(points["left_bar_inner"], [-120.0, 100.0, 130.0]);
    assert_eq!(points["right_bar_inner"], [-120.0, -100.0, 130.0]);
    let output = run(folder.path(), &["sheet", "motion.toml"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    // A spring on the twist is a bar: it adds no load in heave, and its whole rate in roll.
    let path = folder.path().join("motion.toml");
    let sprung = std::fs::read_to_string(&path).expect("a file")
        + "[springs.bar]\nalong = \"bar_twist\"\nrate = 400.0\n";
    std::fs::write(path, sprung).expect("written");
    let both = ["left_bump=0:20:2", "right_bump=0:20:2"];
    let rows = swept(folder.path(), "motion.toml", &both);
    let [design, one_up, _, both_up] = rows.as_slice() else {
        panic!("{}", rows.len())
    };
    let [heave, roll] = [both_up, one_up].map(|row| row["left_spring_load_N"]);
    assert!(
        heave.abs() < 1e-6 * roll.abs() && roll.abs() > 100.0,
        "{heave} {roll}"
    );
    assert_near(both_up["bar_twist_deg"], design["bar_twist_deg"], "twist");
    assert!(design["roll_rate_Nm_deg"] > 0.0, "{design:?}");
}

#[test]
fn import_refuses_an_axle_of_points_that_are_no_corner() {
    let folder = folder();
    let path = folder.path();
    let listing = LISTINGS
        .iter()
        .find(|(name, _)| *name == "twist_beam")
        .expect("a listing");
    let listing = Listing::parse(listing.1).expect("a listing");
    let points = listing.stated();
    let points = points.map(|(point, at)| (listing.name(Part::Point(point)), at.into()));
    let beam = table(&points.collect::<Vec<_>>());
    for (file, options, expected) in [
        (
            beam,
            &["--axle"][..],
            "a.csv: --axle is for corners; twist_beam has both sides",
        ),
        (
            symmetric(),
            &["--axle", "--side", "left"],
            "cannot be used with",
        ),
    ] {
        std::fs::write(path.join("a.csv"), file).expect("written");
        let output = run(path, &[&["import", "a.csv"], options].concat());
        assert_eq!(output.status.code(), Some(2), "{output:?}");
        assert!(text(&output.stderr).contains(expected), "{output:?}");
    }
    let listing = path.join("a_corner.linkage");
    for options in [&[][..], &["--out", "a.toml"]] {
        std::fs::write(&listing, "mine").expect("written");
        let output = run(path, &[&["import", "a.csv", "--axle"], options].concat());
        assert_eq!(output.status.code(), Some(2), "{output:?}");
        let expected = "a_corner.linkage: exists already, and is not as import writes it; the axle of a.toml needs a listing there: move it";
        assert!(text(&output.stderr).contains(expected), "{output:?}");
        let kept = std::fs::read_to_string(&listing).expect("there");
        assert_eq!(kept, "mine");
    }
    assert!(!path.join("a.toml").exists());
}

/// A listing written for an axle that then cannot be built is removed, and one that existed before is kept.
#[test]
fn an_axle_that_cannot_be_built_leaves_the_files_unchanged() {
    let folder = folder();
    let path = folder.path();
    let file = symmetric().replace(
        "tierod_inner, -72, -190, 152",
        "tierod_inner, -68, -552, 166",
    );
    std::fs::write(path.join("a.csv"), file).expect("written");
    let output = run(path, &["import", "a.csv", "--axle"]);
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    assert!(
        text(&output.stderr).contains("is in the same place as point"),
        "{output:?}"
    );
    assert!(!path.join("a.toml").exists() && !path.join("a_corner.linkage").exists());
    std::fs::write(path.join("a_corner.linkage"), "mine").expect("written");
    let output = run(path, &["import", "a.csv", "--axle", "--out", "a.toml"]);
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    let kept = std::fs::read_to_string(path.join("a_corner.linkage"));
    assert_eq!(kept.expect("there"), "mine");
}

/// The catalogue's coordinates are in metres, and the motion file in the unit of the hardpoint file.
#[test]
fn a_deleted_axle_point_is_missing_not_taken_from_the_catalogue() {
    let folder = folder();
    let path = folder.path();
    import(path, "front.csv", &symmetric(), &["--axle"]);
    let listing = std::fs::read_to_string(path.join("motion_corner.linkage")).expect("a listing");
    assert!(
        !listing.contains(" at ") && !listing.contains("metres"),
        "{listing}"
    );
    let motion = std::fs::read_to_string(path.join("motion.toml")).expect("a motion file");
    let without = motion
        .lines()
        .filter(|line| !line.starts_with("left_rocker_rear"));
    let without: Vec<&str> = without.collect();
    assert_eq!(without.len() + 1, motion.lines().count());
    std::fs::write(path.join("without.toml"), without.join("\n")).expect("written");
    let output = run(path, &["check", "without.toml"]);
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    let expected = "point `left_rocker_rear` has no position";
    assert!(text(&output.stderr).contains(expected), "{output:?}");
}

#[test]
fn statements_in_a_motion_file_have_the_name_of_the_file() {
    let folder = folder();
    let path = folder.path();
    import(path, "front.csv", &symmetric(), &["--axle"]);
    let output = run(path, &["check", "motion.toml"]);
    let report = text(&output.stdout);
    assert!(
        report.starts_with("motion.toml: motion, lengths in mm"),
        "{report}"
    );
}

/// The option replaces existing files: the motion file, and its listing.
#[test]
fn importing_an_axle_again_replaces_motion_file_and_listing() {
    let folder = folder();
    let path = folder.path();
    import(path, "a.csv", &symmetric(), &["--axle"]);
    let without_rocker = symmetric().replace("prod_outboard", "unknown");
    let listing = path.join("motion_corner.linkage");
    let written = std::fs::read_to_string(&listing).expect("a listing");
    let edited = format!("{written}// Mine.\n");
    std::fs::write(&listing, &edited).expect("written");
    let output = run(path, &["import", "a.csv", "--axle", "--out", "motion.toml"]);
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    assert_eq!(std::fs::read_to_string(&listing).expect("kept"), edited);
    std::fs::write(&listing, written).expect("written");
    let imported = import(path, "a.csv", &without_rocker, &["--axle"]);
    assert!(
        imported.notes.contains("the layout is double_wishbone: "),
        "{}",
        imported.notes
    );
    let output = run(path, &["check", "motion.toml"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
}
