//! Tables as spreadsheets, typeset pages and other programs have them.

use super::super::program::folder;
use super::refused::refusal;
use super::{CORNER, import, table};

/// The double wishbone of the corner, without its pushrod, in the names of a thesis.
const NAMES: [[&str; 4]; 9] = [
    [
        "lca_front",
        "Lower control arm front",
        "Querlenker unten vorn",
        "front.lwb.front",
    ],
    [
        "lca_rear",
        "Lower control arm rear",
        "Querlenker unten hinten",
        "front.lwb.rear",
    ],
    [
        "lca_outer",
        "Lower control arm ball joint",
        "Traggelenk unten",
        "front.lwb.outer",
    ],
    [
        "uca_front",
        "Upper control arm front",
        "Querlenker oben vorn",
        "front.uwb.front",
    ],
    [
        "uca_rear",
        "Upper control arm rear",
        "Querlenker oben hinten",
        "front.uwb.rear",
    ],
    [
        "uca_outer",
        "Upper control arm ball joint",
        "Traggelenk oben",
        "front.uwb.outer",
    ],
    [
        "tierod_inner",
        "Inner tie rod",
        "Spurstange innen",
        "front.tr.inner",
    ],
    [
        "tierod_outer",
        "Outer tie rod",
        "Spurstange aussen",
        "front.tr.outer",
    ],
    [
        "wheel_center",
        "Wheel center",
        "Radmitte",
        "front.wheel.centre",
    ],
];

/// A line for each of these points with the name in a column of `NAMES`.
fn lines(column: usize, line: impl Fn(&str, [f64; 3]) -> String) -> String {
    let points = NAMES.iter().zip(CORNER);
    points
        .map(|(names, (_, at))| line(names[column], at))
        .collect()
}

fn comma(x: f64) -> String {
    format!("{x:.1}").replace('.', ",")
}

#[test]
fn tables_of_other_programs_give_the_same_points() {
    let folder = folder();
    let plain = lines(0, |name, [x, y, z]| format!("{name}, {x}, {y}, {z}\n"));
    let plain = import(folder.path(), "a.csv", &plain, &[]);
    let markdown = lines(1, |name, [x, y, z]| {
        format!("| {name} | {x} | {y} | {z} |\n")
    });
    for file in [
        format!("| Point | X (mm) | Y (mm) | Z (mm) |\n|---|---|---|---|\n{markdown}"),
        lines(1, |name, [x, y, z]| {
            format!("{name} & {x} & ${y}$ & ${z}$ \\\\ \\hline\n")
        }),
        lines(2, |name, [x, y, z]| {
            format!("{name}\t{}\t{}\t{}\n", comma(x), comma(y), comma(z))
        }),
        lines(3, |name, [x, y, z]| {
            format!("{name} = [{x}, {y}, {z}]; % mm\n")
        }),
    ] {
        let imported = import(folder.path(), "a.csv", &file, &[]);
        assert_eq!(imported.points(), plain.points(), "{file}");
        assert!(!imported.notes.contains("not used"), "{}", imported.notes);
    }
}

/// The name of the part has a column of its own, or is the heading above the points.
#[test]
fn a_part_and_its_point_may_be_apart() {
    let folder = folder();
    let parts = ["Lower wishbone", "Upper wishbone", "Tie rod", "Wheel"];
    let points = [
        &["Front inboard", "Rear inboard", "Ball joint"][..],
        &["Front", "Rear", "Ball joint"],
        &["Inner", "Outer"],
        &["Centre"],
    ];
    let at = |index: usize| CORNER[index].1.map(|x| x.to_string()).join(",");
    let [mut columns, mut headed] = [String::new(), String::new()];
    for (part, points) in parts.into_iter().zip(points) {
        headed += &format!("{part},X (mm),Y (mm),Z (mm)\n");
        for point in points {
            let at = at(columns.lines().count());
            columns += &format!("{part},{point},{at}\n");
            headed += &format!("{point},{at}\n");
        }
    }
    let plain = lines(0, |name, [x, y, z]| format!("{name}, {x}, {y}, {z}\n"));
    let plain = import(folder.path(), "a.csv", &plain, &[]);
    for file in [columns + "Tyre,Radius,229\n", headed + "Radius,229\n"] {
        let imported = import(folder.path(), "a.csv", &file, &[]);
        assert_eq!(imported.points(), plain.points(), "{file}");
        let radius = &imported.motion["vehicle"]["wheel_radius"];
        assert_eq!(radius.as_float(), Some(229.0), "{file}");
    }
}

#[test]
fn a_heading_of_columns_is_no_part_of_the_names_below() {
    let file = format!("Point, x, y, z\n{}", table(&CORNER));
    let notes = import(folder().path(), "a.csv", &file, &[]).notes;
    assert!(notes.contains(" at `lca_front` "), "{notes}");
}

/// `FL`, `RR` and the like stand before the name, behind it, or in a column.
#[test]
fn codes_of_corners_state_the_side_and_the_axle() {
    let folder = folder();
    let of_right = |[x, y, z]: [f64; 3]| [x, 0.0 - y, z];
    let plain = import(folder.path(), "a.csv", &table(&CORNER), &["--side", "left"]);
    for (left, right, is_rear) in [("FL", "FR", false), ("RL", "RR", true), ("LR", "RR", true)] {
        for place in ["before", "behind", "column", "parentheses"] {
            let line = |code: &str, name: &str, [x, y, z]: [f64; 3]| match place {
                "before" => format!("{code} {name}, {x}, {y}, {z}\n"),
                "behind" => format!("{name}_{code}, {x}, {y}, {z}\n"),
                "parentheses" => format!("{name} ({code}), {x}, {y}, {z}\n"),
                _ => format!("{name}, {x}, {y}, {z}, {code}\n"),
            };
            // In axes of Adams the points of the left are those with negative y.
            let rows =
                CORNER.map(|(name, at)| line(left, name, at) + &line(right, name, of_right(at)));
            let imported = import(folder.path(), "a.csv", &rows.concat(), &[]);
            assert_eq!(imported.points(), plain.points(), "{left} {place}");
            assert_eq!(
                imported.notes.contains("does not steer"),
                is_rear,
                "{left} {place}"
            );
            assert!(
                imported
                    .notes
                    .contains("the right corner is the mirror image")
            );
        }
    }
}

#[test]
fn words_in_parentheses_state_the_side() {
    let folder = folder();
    let plain = import(folder.path(), "a.csv", &table(&CORNER), &["--side", "left"]);
    for [left, right] in [["left", "right"], ["LH", "RH"]] {
        let rows = CORNER.map(|(name, [x, y, z])| {
            let y_of_right = 0.0 - y;
            format!("{name} ({left}), {x}, {y}, {z}\n{name} ({right}), {x}, {y_of_right}, {z}\n")
        });
        let imported = import(folder.path(), "a.csv", &rows.concat(), &[]);
        assert_eq!(imported.points(), plain.points(), "{left}");
        let said = "the right corner is the mirror image of the left one";
        assert!(imported.notes.contains(said), "{}", imported.notes);
    }
}

/// Two groups of columns: both sides, or both axles.
#[test]
fn two_points_in_a_row_are_those_of_the_groups_in_the_heading() {
    let folder = folder();
    let one = lines(0, |name, [x, y, z]| format!("{name}\t{x}\t{y}\t{z}\n"));
    let plain = import(folder.path(), "a.csv", &one, &[]);
    let both = lines(0, |name, [x, y, z]| {
        format!("{name}\t{x}\t{y}\t{z}\t{x}\t{}\t{z}\n", -y)
    });
    for heading in [
        "\tLeft\t\t\tRight\t\t\n",
        "Point\tLeft X\tLeft Y\tLeft Z\tRight X\tRight Y\tRight Z\n",
        "\tFL\t\t\tFR\t\t\n\tx\ty\tz\tx\ty\tz\n",
    ] {
        let imported = import(folder.path(), "a.csv", &format!("{heading}{both}"), &[]);
        assert_eq!(imported.points(), plain.points(), "{heading}");
        let said = "the right corner is the mirror image of the left one";
        assert!(imported.notes.contains(said), "{}", imported.notes);
    }
    let axles = lines(0, |name, [x, y, z]| {
        format!("{name};{x};{y};{z};{};{y};{z}\n", x + 1600.0)
    });
    let file = format!("Name;Front;;;Rear;;\n{axles}");
    let front = import(folder.path(), "a.csv", &file, &["--end", "front"]);
    assert_eq!(front.points(), plain.points());
    let rear = import(folder.path(), "a.csv", &file, &["--end", "rear"]);
    let [x, y, z] = plain.points()["lower_ball"];
    assert_eq!(rear.points()["lower_ball"], [x - 1600.0, y, z]);
}

#[test]
fn two_points_in_a_row_without_a_heading_are_refused() {
    let both = lines(0, |name, [x, y, z]| {
        format!("{name}\t{x}\t{y}\t{z}\t{x}\t{}\t{z}\n", -y)
    });
    let said = refusal("a.csv", &both, &[]);
    let expected = "a.csv:1:1: point `lca_front` has six numbers: say in a heading above the columns which are `Left` and which \
                    `Right` (or `Front`, `Rear`), or give each a row of its own";
    assert_eq!(said.trim_end(), expected);
}

#[test]
fn angles_and_radii_may_have_decimal_commas_between_semicolons() {
    let folder = folder();
    let points = lines(2, |name, [x, y, z]| {
        format!("{name};{};{};{}\n", comma(x), comma(y), comma(z))
    });
    let imported = import(
        folder.path(),
        "a.csv",
        &format!("{points}toe angle;0,15\ntyre radius;229,5\n"),
        &[],
    );
    assert!(
        imported.notes.contains("toe 0.15 deg"),
        "{}",
        imported.notes
    );
    assert_eq!(
        imported.motion["vehicle"]["wheel_radius"].as_float(),
        Some(229.5)
    );
}

/// Such a row would leave a suspension without an optional point, without a word.
#[test]
fn a_row_of_a_known_name_that_cannot_be_read_is_refused() {
    for row in [
        "shock to chassis 4,0 20,0 530,0",
        "shock to chassis x4 y-20 z530",
        "shock to chassis X-4 mm Y-20 mm Z530 mm",
        "toe angle 0,15",
    ] {
        let said = refusal("a.csv", &with_last_point(row), &[]);
        assert!(said.starts_with("a.csv:15:1: "), "{row}: {said}");
        assert!(said.contains("` needs "), "{row}: {said}");
    }
    // Remarks that begin with the name of a point are none.
    for row in [
        "Rack travel 60 mm",
        "Top speed 100 km/h, 28 m/s",
        "toe angle 0.15",
    ] {
        import(folder().path(), "a.csv", &with_last_point(row), &[]);
    }
}

/// The table with another row in place of its last one, the chassis end of the damper.
fn with_last_point(row: &str) -> String {
    format!("{}{row}\n", table(&CORNER[..14]))
}

/// Adams/View writes a command over several lines.
#[test]
fn points_of_adams_commands_are_read() {
    let folder = folder();
    let plain = import(folder.path(), "a.csv", &table(&CORNER), &["--side", "left"]);
    for (apart, between, behind) in [
        (" &\n   ", " ", ""),
        (" ", " ", ""),
        ("  &\n", "  &\n", "relative_to = .car.ground"),
    ] {
        let points = CORNER.map(|(name, [x, y, z])| {
            format!(
                "point create{apart}point_name = .car.ground.hpl_{name}{apart}adams_id = 7{apart}\
                 location = {x:.1},{between}{y:.1},{between}{z:.1}{apart}{behind}\n!\n"
            )
        });
        let units = "! Points of the car\ndefaults units length=mm\n";
        let file = format!("{units}{}", points.concat());
        let imported = import(folder.path(), "a.cmd", &file, &[]);
        assert_eq!(imported.points(), plain.points(), "{file}");
        let said = "mm, as the file says";
        assert!(imported.notes.contains(said), "{}", imported.notes);
    }
}

/// The last line of a file may end with the sign at which a command goes on.
#[test]
fn a_row_that_goes_on_nowhere_is_read() {
    let folder = folder();
    let plain = import(folder.path(), "a.csv", &table(&CORNER), &[]);
    let file = format!("{} &", table(&CORNER).trim_end());
    let imported = import(folder.path(), "a.csv", &file, &[]);
    assert_eq!(imported.points(), plain.points());
}

/// Excel writes a sign for thousands where its cells are so formatted.
#[test]
fn numbers_with_a_sign_for_thousands_and_decimals_are_read() {
    let folder = folder();
    let moved = CORNER.map(|(name, [x, y, z])| (name, [x - 1400.0, y, z]));
    let plain = import(folder.path(), "a.csv", &table(&moved), &[]);
    let written = |x: f64, [thousand, decimal]: [char; 2]| {
        let sign = if x < 0.0 { "-" } else { "" };
        let rest = x.abs() % 1000.0;
        match x.abs() {
            ..1000.0 => format!("{sign}{rest}{decimal}00"),
            _ => format!("{sign}1{thousand}{rest:03}{decimal}00"),
        }
    };
    for signs in [[',', '.'], ['.', ',']] {
        let rows = moved.map(|(name, at)| {
            let at = at.map(|x| written(x, signs));
            format!("{name}\t{}\n", at.join("\t"))
        });
        let imported = import(folder.path(), "a.csv", &rows.concat(), &[]);
        assert_eq!(imported.points(), plain.points(), "{rows:?}");
    }
    for wrong in ["1,2,3.5", "12.34,5"] {
        let file = table(&CORNER).replace(',', "\t").replace("-190", wrong);
        let said = refusal("a.csv", &file, &[]);
        assert!(said.contains("needs three numbers"), "{said}");
    }
}
