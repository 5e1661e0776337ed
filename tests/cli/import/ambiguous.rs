//! Tables that can be read in several ways: they are refused, and the message names the rows.

use super::super::program::folder;
use super::refused::refusal;
use super::{CORNER, import, table};

#[test]
fn two_names_of_one_point_in_different_places_are_refused() {
    let corner = table(&CORNER);
    let said = refusal("a.csv", &format!("{corner}LBJ, -4, -560, 129\n"), &[]);
    let expected = "a.csv: `lca_outer` (a.csv:3) and `LBJ` (a.csv:16) are names of one point, lower_ball, in different places: \
                    leave one of them, or give the other a name that import does not know";
    assert_eq!(said, expected);
    // The middle of the rack is not the inner end of the tie rod.
    let said = refusal(
        "a.csv",
        &format!("Steering rack, -72, 0, 152\n{corner}"),
        &[],
    );
    assert!(
        said.contains(
            "`tierod_inner` (a.csv:8) and `Steering rack` (a.csv:1) are names of one point, rack"
        ),
        "{said}"
    );
}

#[test]
fn two_names_of_one_point_in_the_same_place_are_one_point() {
    let folder = folder();
    let corner = table(&CORNER);
    let twice = format!("{corner}LBJ, -4, -560, 128\n");
    let [once, twice] = [corner, twice].map(|file| import(folder.path(), "a.csv", &file, &[]));
    assert_eq!(twice.points(), once.points());
}

/// Tables of the corner with a line before them and one behind them, and a part of the message.
#[test]
fn a_unit_that_is_not_that_of_the_table_is_refused() {
    let corner = table(&CORNER);
    let in_rows = corner.replace('\n', ", cm\n");
    let two = format!("x, y, z [mm]\n{corner}Rear suspension\nx, y, z [in]\n{corner}");
    let cases = [
        (
            format!("Coordinates in cm\n{corner}"),
            "a.csv:1:1: lengths are in `cm`; convert them",
        ),
        (
            format!("Point [cm]\n{corner}"),
            "a.csv:1:1: lengths are in `cm`; convert them",
        ),
        (in_rows, "a.csv:1:1: lengths are in `cm`; convert them"),
        (
            two,
            "a.csv:18:1: lengths are in `in` here, and in `mm` before: convert them to one unit",
        ),
        (
            format!("name, x [mm], y [in], z [mm]\n{corner}"),
            "a.csv:1:1: lengths are in `in` here, and in `mm` before",
        ),
        (
            corner.replace("-72, -190, 152", "-72 mm, -7.48 in, 152 mm"),
            "a.csv:7:1: lengths are in `in` here, and in `mm` before",
        ),
        (
            format!("{corner}tire_radius, 22.9, cm\n"),
            "a.csv:16:1: lengths are in `cm`; convert them",
        ),
    ];
    for (file, expected) in cases {
        let said = refusal("a.csv", &file, &[]);
        assert!(said.contains(expected), "{file}: {said}");
    }
}

#[test]
fn in_and_m_in_a_remark_are_not_units_unless_they_stand_for_one() {
    let folder = folder();
    let corner = table(&CORNER);
    for (heading, expected) in [
        ("Coordinates in x, y, z (mm)", "mm"),
        ("Points in x y z order, mm", "mm"),
        ("Hardpoints by M. Smith", "mm"),
        ("x, y, z in the vehicle frame", "mm"),
        ("name, x [in], y [in], z [in], mass", "in"),
        ("Name, x [Zoll], y [Zoll], z [Zoll]", "in"),
        ("Hardpoints in in", "in"),
        ("Units: in, deg", "in"),
        ("All points in m, ISO 8855", "m"),
    ] {
        let imported = import(folder.path(), "a.csv", &format!("{heading}\n{corner}"), &[]);
        assert_eq!(imported.text("unit"), expected, "{heading}");
    }
}

/// A suspension of usual size would be in inches if its numbers were as large.
#[test]
fn a_table_in_centimetres_that_does_not_say_so_is_refused() {
    let corner = table(&CORNER.map(|(name, at)| (name, at.map(|coordinate| coordinate / 10.0))));
    let said = refusal("a.csv", &corner, &[]);
    let expected = "a.csv: the unit of lengths would be in, as the points are up to 59 apart, but then `wheel_center` (a.csv:9) is 1.55 m \
                    from the middle of the vehicle and no point off the spin axis more than 1.42 m: state the unit with --unit; convert lengths in cm to mm";
    assert_eq!(said, expected);
}

#[test]
fn an_angle_that_is_not_that_of_one_wheel_in_degrees_is_refused() {
    let corner = table(&CORNER);
    for row in [
        "Toe (mm), 2",
        "Toe [min], 12",
        "Toe (total), 0.4",
        "Total toe, 0.4",
        "Gesamtspur, 0.4",
        "Toe (per axle) [deg], 0.4",
        "Vorspur (Minuten), 6",
        "Convergenza [primi], 6",
        "Toe, total, 0.4",
        "Camber [rad], -0.02",
        "Toe, 12'",
        "Toe, 12 min",
        "Camber, -0.02 rad",
        "Toe, 1250",
        "Toe [° out], 0.2",
        "Toe (in), 0.2",
        "Vorspur (Achse), 0.4",
        "Vorspur, Achse, 0.4",
        "Toe [deg] (both wheels), 0.4",
        "Camber (top in positive), 2",
        "Camber (negative out), 2",
        "Camber, 2, positive = top in",
    ] {
        let said = refusal("a.csv", &format!("{corner}{row}\n"), &[]);
        assert!(said.starts_with("a.csv:16:1: `"), "{row}: {said}");
        assert!(
            said.ends_with(": write the angle of one wheel in degrees, positive for toe-in and for a top that leans outboard"),
            "{row}: {said}"
        );
    }
}

#[test]
fn the_toe_of_both_wheels_is_called_so() {
    for (row, said) in [
        ("Gesamtspur, 0.4", "gesamtspur"),
        ("Total toe, 0.4", "total"),
        ("Toe (per axle), 0.4", "per axle"),
    ] {
        let refused = refusal("a.csv", &format!("{}{row}\n", table(&CORNER)), &[]);
        let expected = format!(
            "says `{said}`, the angle of both wheels together: write the angle of one wheel"
        );
        assert!(refused.contains(&expected), "{refused}");
    }
}

#[test]
fn angles_in_quotes_and_in_degrees_are_read() {
    let folder = folder();
    let corner = table(&CORNER);
    let of = |row: &str| {
        let imported = import(folder.path(), "a.csv", &format!("{corner}{row}\n"), &[]);
        imported.motion["points"]["axle"].to_string()
    };
    let plain = of("Toe, 0.2");
    for row in [
        "'Toe', '0.2'",
        "Toe [deg], 0.2",
        "Toe (°), 0.2",
        "Toe, 0.2 deg",
        "Toe, 0.2°",
        "Toe; 0,2 Grad",
        "Toe 0.2°",
        "Toe (per wheel, toe-in positive) [deg], 0.2",
        "Vorspur (pro Rad), 0.2",
        "Vorspur (Grad), 0.2",
        "Vorspur (vorn links), 0.2",
        "Toe, angle, deg, 0.2, as measured",
        "Geometry, Toe, static, 0.2",
        "Toe (R), 0.1\nToe (L), 0.2",
    ] {
        assert_eq!(of(row), plain, "{row}");
    }
    assert_ne!(of("Toe, 0.3"), plain);
}

#[test]
fn one_point_under_two_groups_of_columns_is_refused_unless_its_row_says_which_it_is() {
    let pairs =
        CORNER.map(|(name, [x, y, z])| format!("{name}, {x}, {y}, {z}, {x}, {}, {z}\n", -y));
    let file = format!(", Left, , , Right, ,\n{}", pairs.concat());
    let [both, one] = [
        "tierod_inner, -72, -190, 152, -72, 190, 152",
        "tierod_inner, , , , -72, 190, 152",
    ];
    assert!(file.contains(both));
    let said = refusal("a.csv", &file.replace(both, one), &[]);
    let expected = "a.csv:8:1: `tierod_inner` has the coordinates of one point under two groups of columns: say in the row which it \
                    is, for example `right`";
    assert_eq!(said, expected);
    let folder = folder();
    let whole = import(folder.path(), "a.csv", &file, &["--side", "right"]);
    let one = file.replace(both, &one.replace("inner,", "inner, right,"));
    let one = import(folder.path(), "a.csv", &one, &["--side", "right"]);
    assert_eq!(one.points(), whole.points());
}

/// The mass behind the coordinates would be the third one.
#[test]
fn an_empty_cell_between_coordinates_is_refused() {
    let row = "tierod_inner, -72, -190, 152";
    for empty in [
        "tierod_inner, -72, , 152, 5",
        "tierod_inner, -72, -190, , 5",
        "tierod_inner, -72 mm, -190 mm, , 5",
        "tierod_inner, \u{2212}72, \u{2212}190, , 5",
        "tierod_inner, \"-72\", \"\", \"152\", \"5\"",
    ] {
        let said = refusal("a.csv", &table(&CORNER).replace(row, empty), &[]);
        assert!(
            said.starts_with("a.csv:7:1: a cell between the numbers is empty: "),
            "{said}"
        );
    }
}

#[test]
fn the_letters_f_and_r_in_a_column_are_refused() {
    let corner = table(&CORNER);
    let said = refusal(
        "a.csv",
        &corner.replace("lca_front,", "F, L, lca_front,"),
        &[],
    );
    assert!(
        said.starts_with("a.csv:1:1: beside `F`, an `R` may be rear or right: write "),
        "{said}"
    );
}

#[test]
fn a_number_that_may_have_a_sign_for_thousands_is_refused() {
    let moved = CORNER.map(|(name, [x, y, z])| (name, [x + 1400.0, y, z]));
    let file = table(&moved).replace(',', "\t");
    for written in ["1,260", "1.260"] {
        let file = file.replace("1260", written);
        let said = refusal("a.csv", &file, &[]);
        let expected = format!(
            "a.csv:1:1: `{written}` may be 1260, or a number with decimals: write 1260, or {written}0 for decimals"
        );
        assert_eq!(said, expected);
        // Other decimals show what the sign is.
        for (lateral, decimal) in [("-170,5", ','), ("-170.5", '.')] {
            let file = file.replace("-170", lateral);
            let x = if written.contains(decimal) {
                -1.26
            } else {
                -1260.0
            };
            let points = import(folder().path(), "a.csv", &file, &[]).points();
            assert_eq!(points["lower_front"], [x, 170.5, 125.0], "{file}");
        }
    }
}

/// `PR` is not known for a pushrod, so the points of a layout with a rocker are incomplete.
#[test]
fn a_damper_of_a_table_with_a_rocker_does_not_end_at_a_wishbone() {
    let pushrods = ["PR outboard", "PR inboard"];
    let file = table(&CORNER)
        .replace("prod_outboard", pushrods[0])
        .replace("prod_inboard", pushrods[1]);
    let file = file.replace("shock_to_bellcrank", "shock_outboard");
    let said = refusal("a.csv", &file, &[]);
    let expected = "a.csv: the damper would end at a wishbone or knuckle, but `bellcrank_pivot` (a.csv:12) is of a rocker: --linkage \
                    double_wishbone_rocker says which points are missing, for example the ends of the rocker's axis, `Rocker front` \
                    and `Rocker rear`; leave out all points of the rocker and its rod if the damper does not end at it";
    assert_eq!(said, expected);
}

#[test]
fn an_axle_that_is_no_spin_axis_is_refused() {
    let corner = table(&CORNER);
    let said = refusal("a.csv", &format!("Axle, 0, 0, 0\n{corner}"), &[]);
    let expected = "a.csv: the spin axis, from `Axle` to `wheel_center`, has a camber of 21 degrees: correct these points or, if \
                    `Axle` is no point of the spin axis, give it a name that import does not know";
    assert_eq!(said, expected);
    // `Front axle` is not even a point of it.
    let front = CORNER.map(|(name, at)| (format!("Front {name}"), at));
    let front: Vec<_> = front
        .iter()
        .map(|(name, at)| (name.as_str(), *at))
        .collect();
    let notes = import(
        folder().path(),
        "a.csv",
        &format!("Front axle, 0, 0, 0\n{}", table(&front)),
        &[],
    )
    .notes;
    assert!(notes.contains("not used: Front axle"), "{notes}");
}

#[test]
fn a_unit_in_which_the_suspension_has_a_strange_size_is_doubtful() {
    let file = format!("Lengths in inches\n{}", table(&CORNER));
    let notes = import(folder().path(), "a.csv", &file, &[]).notes;
    let expected = "the unit of lengths is in, as the file says; that is doubtful, as the points are then up to 14.99 m apart";
    assert!(notes.contains(expected), "{notes}");
}

/// `FR` is the corner front right wherever a name begins or ends with it.
#[test]
fn a_corners_code_within_a_name_is_reported_with_the_word_to_write() {
    let file = table(&CORNER);
    let file = file.replace("lca_front", "LCA FR IB");
    let said = refusal("a.csv", &file.replace("lca_rear", "LCA RR IB"), &[]);
    for (name, code, end) in [("LCA FR IB", "FR", "front"), ("LCA RR IB", "RR", "rear")] {
        let expected = format!(
            ", where `{code}` is a corner's code: write `{end}` if the {end} of the part is meant"
        );
        let (_, behind) = said
            .split_once(&format!("`{name}` (a.csv:"))
            .expect("named");
        let (_, behind) = behind.split_once(')').expect("a line");
        assert!(behind.starts_with(&expected), "{said}");
    }
}
