//! Rear corners, whose toe link is fixed on the chassis, and arms.

use super::super::program::{folder, run};
use super::refused::refusal;
use super::{CORNER, Imported, import, listed, swept, table};

/// The table with other names for both ends of the tie rod.
fn with_names(inner: &str, outer: &str) -> String {
    let file = table(&CORNER).replace("tierod_inner", inner);
    file.replace("tierod_outer", outer)
}

fn steers(imported: &Imported) -> bool {
    let drives = imported.motion["drives"].as_table().expect("a table");
    drives.contains_key("steer")
}

/// Rows above the table, the name of the file, the inner end of the tie rod, and whether it steers.
const CASES: [(&str, &str, &str, bool); 15] = [
    ("", "a.csv", "tierod_inner", true),
    ("", "a.csv", "Toe link inner", false),
    ("Rear suspension\n", "a.csv", "tierod_inner", false),
    ("# REAR LEFT\n", "a.csv", "tierod_inner", false),
    ("Rear;;;\n", "a.csv", "tierod_inner", false),
    ("Rear suspension\n", "a.csv", "rack", true),
    ("Front suspension\n", "a.csv", "Toe link inner", true),
    ("", "rear.csv", "tierod_inner", false),
    ("", "Hardpoints_Rear_2024.csv", "tierod_inner", false),
    ("Front axle\n", "rear.csv", "Toe link inner", true),
    ("Front and rear axle\n", "a.csv", "tierod_inner", true),
    (
        "Point, X to rear, Y to right, Z up\n",
        "a.csv",
        "tierod_inner",
        true,
    ),
    ("Rear lower wishbone\n", "a.csv", "tierod_inner", true),
    (
        "# front axle\n# rear axle\n",
        "a.csv",
        "Toe link inner",
        false,
    ),
    ("", "front_and_rear.csv", "tierod_inner", true),
];

#[test]
fn a_toe_link_is_fixed_where_the_table_is_of_a_rear_suspension() {
    let folder = folder();
    for (above, name, inner, expected) in CASES {
        let file = format!("{above}{}", with_names(inner, "tierod_outer"));
        let imported = import(folder.path(), name, &file, &[]);
        assert_eq!(steers(&imported), expected, "{above}{name}: {inner}");
        let said = format!("`{inner}` does not steer, it is fixed on the chassis: ");
        assert_eq!(
            imported.notes.contains(&said),
            !expected,
            "{}",
            imported.notes
        );
        assert_eq!(
            imported.points(),
            import(folder.path(), "b.csv", &table(&CORNER), &[]).points()
        );
    }
}

/// A corner in parentheses behind each name is that of the table.
#[test]
fn a_tie_rod_is_fixed_where_the_names_say_rear_in_parentheses() {
    let rows = CORNER.map(|(name, [x, y, z])| format!("{name} (rear axle), {x}, {y}, {z}\n"));
    let imported = import(folder().path(), "a.csv", &rows.concat(), &[]);
    assert!(!steers(&imported), "{}", imported.notes);
}

#[test]
fn a_note_says_why_a_toe_link_is_fixed_and_how_to_make_it_steer() {
    let folder = folder();
    for (above, name, inner, why) in [
        ("Rear axle\n", "a.csv", "tierod_inner", "a.csv:1 says rear"),
        (
            "",
            "rear.csv",
            "tierod_inner",
            "the name of the file says rear",
        ),
        (
            "",
            "a.csv",
            "toe_link_inner",
            "front axles have a tie rod instead",
        ),
    ] {
        let file = format!("{above}{}", with_names(inner, "tierod_outer"));
        let imported = import(folder.path(), name, &file, &[]);
        let said = format!(
            "`{inner}` does not steer, it is fixed on the chassis: {why}. To make it steer, call it `rack` in the hardpoint file and \
             import that again"
        );
        assert!(imported.notes.contains(&said), "{}", imported.notes);
        let written = std::fs::read_to_string(folder.path().join("motion.toml")).expect("written");
        assert!(written.contains(&format!("# {said}")), "{written}");
    }
}

/// The listing differs from the catalogue's only by the drive, so that every number is the same.
#[test]
fn a_fixed_toe_link_moves_as_with_the_rack_held() {
    let folder = folder();
    let swept = |file: &str, drives: &[&str]| {
        import(folder.path(), "a.csv", file, &[]);
        swept(folder.path(), "motion.toml", drives)
    };
    let held = swept(&table(&CORNER), &["bump=-30:30:7", "steer=0"]);
    let fixed = swept(
        &with_names("toe_link_inner", "toe_link_outer"),
        &["bump=-30:30:7"],
    );
    assert_eq!(fixed.len(), 7);
    for (held, fixed) in held.iter().zip(&fixed) {
        for name in ["toe_deg", "camber_deg", "wheel_centre_x", "damper_mm"] {
            assert!((held[name] - fixed[name]).abs() < 1e-10, "{name}");
        }
    }
}

#[test]
fn an_axle_of_fixed_toe_links_has_no_rack() {
    let folder = folder();
    let file = with_names("toe_link_inner", "toe_link_outer");
    let imported = import(folder.path(), "a.csv", &file, &["--axle"]);
    assert!(!steers(&imported));
    assert!(!imported.text("statements").contains("rack"));
    let corner = std::fs::read_to_string(folder.path().join("motion_corner.linkage"));
    assert!(!corner.expect("written").contains("steer"));
    // Both files may be written again.
    import(folder.path(), "a.csv", &file, &["--axle"]);
    let output = run(
        folder.path(),
        &["sheet", "motion.toml", "--travel", "-20:20"],
    );
    assert_eq!(output.status.code(), Some(0), "{output:?}");
}

#[test]
fn the_role_of_an_adams_subsystem_tells_front_from_rear() {
    let folder = folder();
    let points = CORNER.map(|(name, [x, y, z])| format!(" '{name}' 'left/right' {x} {y} {z}\n"));
    for (role, expected) in [("rear", false), ("front", true)] {
        let file = format!(
            "[SUBSYSTEM_HEADER]\nMAJOR_ROLE = 'suspension'\nMINOR_ROLE = '{role}'\n[UNITS]\nLENGTH = 'mm'\n[HARDPOINT]\n{}",
            points.concat()
        );
        let imported = import(folder.path(), "a.sub", &file, &[]);
        assert_eq!(steers(&imported), expected, "{role}");
    }
}

/// The layout of the semi-trailing arm needs the joints of its drive shaft.
#[test]
fn an_arm_with_an_oblique_axis_is_called_a_semi_trailing_arm() {
    let folder = folder();
    let points = |x: f64| {
        table(&[
            ("pivot_inner", [x, 160.0, 280.0]),
            ("pivot_outer", [450.0, 580.0, 260.0]),
            ("wheel_centre", [0.0, 720.0, 310.0]),
            ("spring_upper", [160.0, 480.0, 500.0]),
            ("spring_lower", [160.0, 480.0, 260.0]),
            ("damper_upper", [-50.0, 540.0, 680.0]),
            ("damper_lower", [-90.0, 570.0, 250.0]),
        ])
    };
    let said = "the axis of the arm is turned by 22 degrees in plan view, so it is a semi-trailing arm, which moves as in this \
                layout. With the points shaft_inner and shaft_outer the layout is semi_trailing_arm, with the drive shaft";
    let oblique = import(folder.path(), "a.csv", &points(280.0), &[]);
    assert!(oblique.notes.contains(said), "{}", oblique.notes);
    for name in ["Semi trailing arm", "Schr\u{e4}glenker"] {
        let named = points(280.0).replace("pivot_", &format!("{name} "));
        let named = import(folder.path(), "a.csv", &named, &[]);
        assert_eq!(named.points(), oblique.points(), "{name}");
    }
    let across = import(folder.path(), "a.csv", &points(450.0), &[]);
    assert!(!across.notes.contains("semi"), "{}", across.notes);
}

/// A live axle with a Watt linkage; the crank's axis is a line along the vehicle.
const WATT: &str = "unit, mm
Lower trailing link left chassis, 560, 460, 290
Lower trailing link right chassis, 560, -460, 290
Lower trailing link left axle, 20, 500, 240
Lower trailing link right axle, 20, -500, 240
Upper link chassis, 360, 0, 460
Upper link axle, 30, 0, 440
Watt link left chassis, -160, 460, 400
Watt link right chassis, -160, -460, 240
Watt bellcrank pivot front, -80, 0, 320
Watt bellcrank pivot rear, -160, 0, 320
Watt bellcrank upper, -160, 0, 400
Watt bellcrank lower, -160, 0, 240
Left wheel centre, 0, 740, 310
Right wheel centre, 0, -740, 310
Left damper upper, -60, 460, 660
Right damper upper, -60, -460, 660
Left damper lower, -80, 540, 220
Right damper lower, -80, -540, 220
";

#[test]
fn a_watt_linkage_is_found_by_the_names_of_its_links() {
    let folder = folder();
    let imported = import(folder.path(), "a.csv", WATT, &[]);
    assert_eq!(imported.text("linkage"), "live_axle_watt");
    let points = imported.points();
    assert_eq!(points["lower_right_front"], [560.0, -460.0, 290.0]);
    assert_eq!(points["watt_right"], [-160.0, -460.0, 240.0]);
    assert_eq!(points["crank_rear"], [-160.0, 0.0, 320.0]);
    // Many tables have one point of the crank's axis.
    let one = WATT.replace("Watt bellcrank pivot front, -80, 0, 320\n", "");
    let message = refusal("a.csv", &one.replace("pivot rear", "pivot"), &[]);
    for expected in [
        "the nearest, live_axle_watt, lacks `crank_front` (or watt_rocker_pivot_front, ",
        "): any second point of the axis through `Watt bellcrank pivot` will do; ",
    ] {
        assert!(message.contains(expected), "{message}");
    }
}

/// Pairs of names in the table above and others of the same points.
const WATT_NAMES: [&[[&str; 2]]; 10] = [
    &[
        ["Left damper upper", "Left damper top"],
        ["Left damper lower", "Damper axle LH"],
    ],
    &[
        ["Left wheel centre", "Wheel centre L"],
        ["Right wheel centre", "Wheel centre R"],
    ],
    &[
        ["Left wheel centre", "L, Wheel centre"],
        ["Right wheel centre", "R, Wheel centre"],
    ],
    &[
        ["Left wheel centre", "Radmitte links"],
        ["Right wheel centre", "Radmitte rechts"],
    ],
    &[
        ["Watt link left", "Watt's link left"],
        ["Watt bellcrank pivot", "Watt's crank pivot"],
    ],
    &[["Watt bellcrank", "Bellcrank"]],
    &[["Upper link chassis", "Upper link front"]],
    &[
        ["Lower trailing link left chassis", "LH lower link front"],
        ["Lower trailing link left axle", "LH lower link rear"],
    ],
    &[
        [
            "Lower trailing link left chassis",
            "Trailing arm left front",
        ],
        ["Lower trailing link left axle", "Trailing arm left rear"],
    ],
    &[
        [
            "Lower trailing link left chassis",
            "Längslenker links Karosserie",
        ],
        ["Lower trailing link left axle", "Längslenker links Achse"],
        ["Watt link left chassis", "Wattgestänge links Karosserie"],
    ],
];

#[test]
fn splayed_upper_links_are_found_by_the_names_of_their_ends() {
    let names = [
        ["left_front", "Left upper link chassis"],
        ["left_rear", "Upper link left axle"],
        ["right_front", "RH upper link front"],
        ["right_rear", "Upper link rear R"],
    ];
    let folder = folder();
    let points = listed("live_axle_splayed");
    let rows = points.iter().map(|(name, [x, y, z])| {
        let upper = name.strip_prefix("upper_");
        let other = names.iter().find(|[end, _]| upper == Some(*end));
        let name = other.map_or(name.as_str(), |[_, other]| other);
        format!("{name}, {x}, {y}, {z}\n")
    });
    let table = format!("unit, m\n{}", rows.collect::<String>());
    let imported = import(folder.path(), "a.csv", &table, &[]);
    assert_eq!(imported.text("linkage"), "live_axle_splayed");
    assert_eq!(imported.points(), points.into_iter().collect());
}

/// `Watt's` must not be the beginning of a quotation.
#[test]
fn a_watt_linkage_is_found_by_other_names() {
    let folder = folder();
    let plain = import(folder.path(), "a.csv", WATT, &[]).points();
    for names in WATT_NAMES {
        let changed = |file: String, [from, to]: &[&str; 2]| file.replace(from, to);
        let file = names.iter().fold(WATT.to_owned(), changed);
        assert_ne!(file, WATT);
        let imported = import(folder.path(), "a.csv", &file, &[]);
        assert_eq!(imported.points(), plain, "{names:?}");
        // One more name that is not known.
        let message = refusal("a.csv", &file.replace("Upper link axle", "Strange"), &[]);
        let expected = "the nearest, live_axle_watt, lacks `upper_rear` (";
        assert!(message.contains(expected), "{names:?}: {message}");
    }
}

/// The prefixes of Adams/Car state the sides.
#[test]
fn a_layout_with_both_sides_is_found_where_rows_state_the_side() {
    let folder = folder();
    let points = listed("twist_beam");
    let left = points.iter().filter_map(|(name, [x, y, z])| {
        let name = name
            .strip_prefix("left_")?
            .replace("damper_upper", "damper_top");
        Some(format!(" '{name}' 'left/right' {x} {y} {z}\n"))
    });
    let file = format!(
        "[UNITS]\nLENGTH = 'm'\n[HARDPOINT]\n{}",
        left.collect::<String>()
    );
    let imported = import(folder.path(), "a.sub", &file, &[]);
    assert_eq!(imported.text("linkage"), "twist_beam");
    assert_eq!(imported.points(), points.into_iter().collect());
}
