//! Rows and columns of a table: which are read, and which are refused.

use super::super::program::folder;
use super::refused::refusal;
use super::{CORNER, IN_OUR_AXES, import, table};

/// Part of a row, and its replacement.
#[test]
fn a_point_row_without_three_numbers_is_refused() {
    let none = |field: &str, remark: &str| format!("`{field}` is no number{remark}");
    let apart = " (between thousands only a comma or a point may stand)";
    for (row, other, has) in [
        ("150, -175, 120", "150, -175", "it has 2".to_owned()),
        ("150, -175, 120", "150, -175, 120, 7", "it has 4".to_owned()),
        ("-175", "-l75", none("-l75", "")),
        ("-175", "17O.5", none("17O.5", "")),
        ("-175", "1 75", none("1 75", apart)),
        (
            ", -175",
            ", \u{2013} 175",
            none("\u{2013} 175", " (its sign stands directly before it)"),
        ),
        ("-175", "-175*", none("-175*", "")),
        ("-175", "--175", none("--175", "")),
        ("-175", "inf", "it has 2".to_owned()),
        (
            "lca_rear, 150, -175, 120",
            "lca_rear 150,0 -175,0 120,0",
            none("0 -175", apart),
        ),
    ] {
        let message = refusal("a.csv", &table(&CORNER).replace(row, other), &[]);
        let expected =
            format!("a.csv:2:1: point `lca_rear` needs three numbers in a row: x, y, z; {has}");
        assert_eq!(message, expected, "{other}");
    }
}

/// Such a row would be a remark, and the suspension would lack the point or an optional part.
#[test]
fn an_error_value_of_a_spreadsheet_is_refused() {
    for error in [
        "#REF!", "#N/A", "#NV", "#DIV/0!", "#NAME?", "#WERT!", "#####", "Err:502",
    ] {
        for row in ["6;-210;515", "-210;515"] {
            let file = table(&CORNER).replace(", ", ";");
            let first = row.split(';').next().expect("a number");
            let file = file.replacen(
                &format!(";{row}"),
                &format!(";{}", row.replacen(first, error, 1)),
                1,
            );
            let said = refusal("a.csv", &file, &[]);
            let expected = format!(
                "a.csv:14:1: the cell `{error}` of `shock_to_bellcrank` is an error of the spreadsheet: correct it there and save the table again"
            );
            assert_eq!(said, expected, "{row}");
        }
    }
    // Behind the coordinates, and beside no point, it is no coordinate.
    let behind = table(&CORNER).replace('\n', ", #N/A\n") + "Motion ratio, #DIV/0!\n";
    let plain = import(folder().path(), "a.csv", &table(&CORNER), &[]);
    let imported = import(folder().path(), "a.csv", &behind, &[]);
    assert_eq!(imported.points(), plain.points());
}

/// A dash before a number may be its sign or belong to the name, so it is not guessed.
#[test]
fn a_sign_that_stands_alone_is_refused() {
    let numbers = "toe_angle, 0.1\ncamber_angle -1.5\n";
    let file = table(&CORNER) + numbers;
    for [row, other] in [
        ["lca_rear, 150, -175, 120", "lca_rear - 150 -175 120"],
        ["lca_rear, 150, -175, 120", "lca_rear, - 150, -175, 120"],
        ["lca_rear, 150, -175, 120", "lca_rear, -, 150, -175, 120"],
        ["lca_rear, 150, -175, 120", "lca_rear \u{2212} 150 -175 120"],
        ["camber_angle -1.5", "camber_angle - 1.5"],
    ] {
        let said = refusal("a.csv", &file.replace(row, other), &[]);
        let expected = "the sign before the number stands alone: write it at the number, or leave it out if it is a dash";
        assert!(said.ends_with(expected), "{other}: {said}");
    }
}

/// Accountants write `(90)` for -90.
#[test]
fn a_number_in_parentheses_is_refused() {
    let file = table(&CORNER) + "camber_angle, -1.5\n";
    let german = file.replace(',', ";").replace('.', ",");
    for (file, row, other) in [
        (&file, "-175", "(175)"),
        (&file, "-175", "(175 mm)"),
        (&file, "-1.5", "( 1.5 )"),
        (&german, "-175", "(175,5)"),
        (&german, "-1,5", "(1,5)"),
    ] {
        let said = refusal("a.csv", &file.replace(row, other), &[]);
        let expected = "a number stands in parentheses: write it with a minus if that is meant, or without parentheses";
        assert!(said.ends_with(expected), "{other}: {said}");
    }
}

#[test]
fn coordinates_may_have_the_names_of_their_axes() {
    let folder = folder();
    let plain = import(folder.path(), "a.csv", &table(&CORNER), &[]);
    for [row, other] in [
        ["lca_rear, 150, -175, 120", "lca rear x=150 y=-175 z=120"],
        [
            "lca_rear, 150, -175, 120",
            "lca_rear: (X: 150, Y: -175, Z: 120)",
        ],
        ["lca_rear, 150, -175, 120", "lca_rear (150, -175, 120)"],
    ] {
        let labelled = table(&CORNER).replace(row, other);
        let imported = import(folder.path(), "a.csv", &labelled, &[]);
        assert_eq!(imported.points(), plain.points(), "{other}");
    }
    let said = refusal(
        "a.csv",
        &table(&CORNER).replace("150, -175, 120", "y=-175 x=150 z=120"),
        &[],
    );
    assert!(
        said.contains("point `lca_rear` needs three numbers"),
        "{said}"
    );
}

/// Typeset tables have the character of a minus, or an en dash, instead of a hyphen.
#[test]
fn a_minus_of_a_typeset_table_is_one() {
    let folder = folder();
    let plain = import(folder.path(), "a.csv", &table(&CORNER), &[]);
    for minus in ["\u{2212}", "\u{2013}"] {
        let typeset = table(&CORNER).replace('-', minus);
        let imported = import(folder.path(), "a.csv", &typeset, &[]);
        assert_eq!(imported.points(), plain.points());
    }
}

#[test]
fn a_point_or_number_stated_twice_is_refused() {
    for (rows, expected) in [
        (
            "lca_rear, 1, 2, 3\n",
            "a.csv:16:1: point `lca_rear` stands in a.csv:2 already",
        ),
        (
            "toe_angle, 0.1\ntoe_angle, 0.1\ntoe_angle, 0.2\n",
            "a.csv:18:1: `toe_angle` stands in a.csv:16 already, as 0.1; leave one of them",
        ),
    ] {
        let message = refusal("a.csv", &format!("{}{rows}", table(&CORNER)), &[]);
        assert!(message.contains(expected), "{message}");
    }
}

#[test]
fn swapped_columns_are_refused() {
    // The second in coordinates of the vehicle, the origin far ahead.
    for (columns, ahead) in [([1, 0, 2], 0.0), ([1, 0, 2], 2600.0), ([0, 2, 1], 0.0)] {
        let placed = CORNER.map(|(name, [x, y, z])| (name, [x + ahead, y, z]));
        let swapped = placed.map(|(name, at)| (name, columns.map(|column| at[column])));
        let message = refusal("a.csv", &table(&swapped), &[]);
        let expected = "a.csv: the columns seem to be swapped: the second one is y, across the vehicle, and is ";
        assert!(message.starts_with(expected), "{message}");
    }
}

/// Ten times too large in one field.
#[test]
fn a_slipped_y_is_refused_by_its_point() {
    for (point, slipped, expected) in [
        (
            "150, -175",
            "150, -1750",
            "a.csv: y is -1750 at `lca_rear` on the chassis, and no other point off the spin axis is as far from the middle of the \
             vehicle as `wheel_center`, at -610: correct it, or if the columns are swapped, put them in the order x (along), y (across), z (up or down)",
        ),
        (
            "0, -610",
            "0, -6100",
            "a.csv: the unit of lengths would be mm, as the points are up to 6080 apart, but then `wheel_center` (a.csv:9) is 6.1 m from \
             the middle of the vehicle and no point off the spin axis more than 0.56 m: correct its y",
        ),
    ] {
        let message = refusal("a.csv", &table(&CORNER).replace(point, slipped), &[]);
        assert_eq!(message, expected);
    }
}

#[test]
fn centimetres_are_refused_as_the_unit_of_a_table() {
    for heading in [
        "# unit: cm",
        "name, x [cm], y [cm], z [cm]",
        "# all lengths in centimetres",
    ] {
        let message = refusal("a.csv", &format!("{heading}\n{}", table(&CORNER)), &[]);
        let expected = "a.csv:1:1: lengths are in `c";
        assert!(message.starts_with(expected), "{message}");
        assert!(
            message.ends_with("; convert them to mm, m or in, and say so here"),
            "{message}"
        );
    }
}

#[test]
fn an_unreadable_number_is_refused() {
    for line in ["toe_angle, 0,15", "tire_radius, 12 x 30", "toe_angle 0,15"] {
        let message = refusal("a.csv", &format!("{line}\n{}", table(&CORNER)), &[]);
        assert!(message.starts_with("a.csv:1:1: `"), "{message}");
        assert!(
            message.ends_with("` needs one number after it, with a decimal point"),
            "{message}"
        );
    }
}

#[test]
fn rows_of_a_hardpoint_table_may_be_numbered() {
    let rows = table(&CORNER) + "toe_angle, 0.2\n";
    let rows = rows.lines().enumerate();
    let numbered: String = rows.map(|(row, line)| format!("{row}, {line}\n")).collect();
    let folder = folder();
    let imported = import(folder.path(), "a.csv", &numbered, &[]);
    assert!(imported.notes.contains("toe 0.2 deg"), "{}", imported.notes);
}

#[test]
fn units_behind_numbers_are_units() {
    let folder = folder();
    let of_row = |[x, y, z]: [f64; 3], unit: &str| format!("{x}{unit}, {y}{unit}, {z}{unit}");
    for unit in ["mm", " mm", ", mm"] {
        let rows = CORNER.map(|(name, at)| format!("{name}, {}\n", of_row(at, unit)));
        let imported = import(folder.path(), "a.csv", &rows.concat(), &[]);
        let expected = IN_OUR_AXES.map(|(name, at)| (name.to_owned(), at));
        assert_eq!(imported.points(), expected.into(), "{unit}");
        assert!(
            imported.notes.contains("lengths is mm, as the file says"),
            "{unit}"
        );
    }
}

/// As spreadsheets in the web write it where numbers have decimal commas.
#[test]
fn numbers_in_quotes_between_commas_may_have_decimal_commas() {
    let rows = CORNER.map(|(name, [x, y, z])| format!("{name},\"{x},0\",\"{y},0\",\"{z},0\"\n"));
    let imported = import(folder().path(), "a.csv", &rows.concat(), &[]);
    let expected = IN_OUR_AXES.map(|(name, at)| (name.to_owned(), at));
    assert_eq!(imported.points(), expected.into());
}

/// Heading, and a row with `name` and the coordinates between its other columns.
#[test]
fn a_heading_says_which_columns_are_coordinates() {
    let folder = folder();
    let expected = IN_OUR_AXES.map(|(name, at)| (name.to_owned(), at)).into();
    for [heading, row] in [
        ["Name, x, y, z, Mass [kg]", "name, at, 0.25"],
        [
            "No., Name, x [mm], y [mm], z [mm], dx, dy, dz",
            "7, name, at, 1, 1, 1",
        ],
        ["Name, Part, x, y, z", "name, 3, at"],
        ["x, y, z, Name, Mass", "at, name, 0.25"],
    ] {
        let row = |(name, [x, y, z]): (&str, [f64; 3])| {
            row.replace("name", name)
                .replace("at", &format!("{x}, {y}, {z}"))
                + "\n"
        };
        let file = format!("{heading}\n{}", CORNER.map(row).concat());
        let commas = import(folder.path(), "a.csv", &file, &[]);
        assert_eq!(commas.points(), expected, "{heading}");
        let file = file.replace(',', ";");
        let semicolons = import(folder.path(), "a.csv", &file, &[]);
        assert_eq!(semicolons.points(), expected, "{heading}");
        // The mass does not take the place of a coordinate.
        let said = refusal("a.csv", &file.replace("; -190;", "; ;"), &[]);
        assert!(
            said.contains("a cell between the numbers is empty"),
            "{said}"
        );
    }
}

#[test]
fn a_heading_with_two_columns_of_an_axis_does_not_say_which_are_coordinates() {
    let rows = CORNER.map(|(name, [x, y, z])| format!("{name}, {x}, {y}, {z}, {x}, {y}, {z}\n"));
    let file = format!("Name, x, y, z, new x, new y, new z\n{}", rows.concat());
    let said = refusal("a.csv", &file, &[]);
    assert!(said.contains("`lca_front` has six numbers"), "{said}");
}

/// The radius of the tyre is often in inches beside points in millimetres.
#[test]
fn a_radius_in_another_unit_is_converted() {
    let file = format!("x, y, z [mm]\n{}tire_radius [in], 9\n", table(&CORNER));
    let motion = import(folder().path(), "a.csv", &file, &[]).motion;
    assert_eq!(motion["vehicle"]["wheel_radius"].as_float(), Some(228.6));
}
