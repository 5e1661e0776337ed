//! Groups of columns: a row has the point of each corner.

use super::super::program::folder;
use super::refused::refusal;
use super::{CORNER, IN_OUR_AXES, Imported, import};

/// A line for each point with the coordinates of the four corners, in the axes of the program; the rear is 1600 mm behind.
fn cars(line: impl Fn(&str, [String; 4]) -> String) -> String {
    let lines = CORNER.iter().zip(IN_OUR_AXES);
    let lines = lines.map(|((name, _), (_, [x, y, z]))| {
        let [front, rear] = [x, x - 1600.0];
        let corners = [[front, y, z], [front, -y, z], [rear, y, z], [rear, -y, z]];
        line(name, corners.map(|at| at.map(|x| x.to_string()).join(";")))
    });
    lines.collect()
}

fn assert_corner(imported: &Imported, [behind, side]: [f64; 2], what: &str) {
    let expected =
        IN_OUR_AXES.map(|(name, [x, y, z])| (name.to_owned(), [x - behind, side * y, z]));
    assert_eq!(imported.points(), expected.into(), "{what}");
}

#[test]
fn a_row_may_have_the_four_corners_of_a_vehicle() {
    let folder = folder();
    let rows = cars(|name, corners| format!("{name};{}\n", corners.join(";")));
    for heading in [
        "Point;Front left;;;Front right;;;Rear left;;;Rear right;;\n",
        "Point;FL;;;FR;;;RL;;;RR;;\n;x;y;z;x;y;z;x;y;z;x;y;z\n",
        "Point;FL x;FL y;FL z;FR x;FR y;FR z;RL x;RL y;RL z;RR x;RR y;RR z\n",
        ";Front;;;;;;Rear;;;;;\n;Left;;;Right;;;Left;;;Right;;\n;x;y;z;x;y;z;x;y;z;x;y;z\n",
        "Punkt;vorne links;;;vorne rechts;;;hinten links;;;hinten rechts;;\n",
        "Punkt;vorn li.;;;vorn re.;;;hinten li.;;;hinten re.;;\n",
        "Punkt;Linkes Vorderrad;;;Rechtes Vorderrad;;;Linkes Hinterrad;;;Rechtes Hinterrad;;\n",
        "Punkt;Rad VL;;;Rad VR;;;Rad HL;;;Rad HR;;\n",
        "Punkt;VA links;;;VA rechts;;;HA links;;;HA rechts;;\n",
        "Punto;Ruota anteriore sinistra;;;Ruota anteriore destra;;;Ruota posteriore sinistra;;;Ruota posteriore destra;;\n",
        "Punto;Ant. SX;;;Ant. DX;;;Post. SX;;;Post. DX;;\n",
        "Punto;AS;;;AD;;;PS;;;PD;;\n",
        "Point;AVG;;;AVD;;;ARG;;;ARD;;\n",
    ] {
        let file = format!("{heading}{rows}");
        for (end, behind) in [("front", 0.0), ("rear", 1600.0)] {
            for (side, sign) in [("left", 1.0), ("right", -1.0)] {
                let options = ["--end", end, "--side", side];
                let imported = import(folder.path(), "a.csv", &file, &options);
                assert_corner(
                    &imported,
                    [behind, sign],
                    &format!("{end} {side}: {heading}"),
                );
            }
        }
    }
    let said = refusal("a.csv", &rows, &[]);
    assert!(
        said.contains("point `lca_front` has twelve numbers")
            && said.contains("which are `FL`, `FR`, `RL` and `RR`, or"),
        "{said}"
    );
}

#[test]
fn the_columns_of_two_sides_may_have_letters() {
    let folder = folder();
    let sides = |[x, y, z]: [f64; 3]| format!("{x};{y};{z};{x};{};{z}", -y);
    let rows = CORNER.iter().zip(IN_OUR_AXES);
    let rows = rows.map(|((name, _), (_, at))| format!("{name};{}\n", sides(at)));
    let rows: String = rows.collect();
    for heading in [
        "Point;X_L;Y_L;Z_L;X_R;Y_R;Z_R",
        "Point;XL;YL;ZL;XR;YR;ZR",
        "Point;x L [mm];y L [mm];z L [mm];x R [mm];y R [mm];z R [mm]",
        "Point;L;;;R;;\n;x;y;z;x;y;z",
    ] {
        for (side, sign) in [("left", 1.0), ("right", -1.0)] {
            let file = format!("{heading}\n{rows}");
            let imported = import(folder.path(), "a.csv", &file, &["--side", side]);
            assert_corner(&imported, [0.0, sign], &format!("{side}: {heading}"));
        }
    }
}

#[test]
fn groups_that_are_not_told_apart_are_refused_by_their_heading() {
    let rows = cars(|name, corners| format!("{name};{}\n", corners.join(";")));
    let axes = ";x;y;z;x;y;z;x;y;z;x;y;z\n";
    for (heading, expected) in [
        (
            "Punkt;Rad A;;;Rad B;;;Rad C;;;Rad D;;",
            "which are `FL`, `FR`, `RL` and `RR` (`Punkt;Rad A;;;Rad B;;;Rad C;;;Rad D` in a.csv:1 does not), or give",
        ),
        (
            "Punkt;Links;;;Rechts;;;Links;;;Rechts;;",
            "a.csv:3:1: point `lca_front` stands in this row already; write above the columns which are `Left` and which `Right`, or \
             of four corners `FL`, `FR`, `RL` and `RR`",
        ),
    ] {
        let said = refusal("a.csv", &format!("{heading}\n{axes}{rows}"), &[]);
        assert!(said.contains(expected), "{said}");
    }
}

#[test]
fn a_point_that_one_corner_lacks_is_named_with_the_corner_that_has_it() {
    let heading = "Point;FL;;;FR;;\n;x;y;z;x;y;z\n";
    let rows = cars(|name, [left, right, ..]| match name {
        "lca_front" => format!("{name};{left};;;\n"),
        _ => format!("{name};{left};{right}\n"),
    });
    let expected = "lacks `lower_front`, which only the left corner has (`lca_front`, a.csv:3); ";
    for option in [["--axle"].as_slice(), &["--side", "right"]] {
        let said = refusal("a.csv", &format!("{heading}{rows}"), option);
        assert!(said.contains(expected), "{said}");
    }
}

/// The three numbers of the other group are not those of a point of this name.
#[test]
fn a_mistyped_number_in_the_first_group_is_refused() {
    for (mistyped, remark) in [
        ("12O", ""),
        (
            "1 20",
            " (between thousands only a comma or a point may stand)",
        ),
    ] {
        let rows = cars(|name, [left, right, ..]| match name {
            "lca_rear" => format!("{name};{};{right}\n", left.replace("120", mistyped)),
            _ => format!("{name};{left};{right}\n"),
        });
        let said = refusal(
            "a.csv",
            &format!("Point;FL;;;FR;;\n;x;y;z;x;y;z\n{rows}"),
            &[],
        );
        let expected = format!(
            "a.csv:4:1: point `lca_rear` needs three numbers in a row: x, y, z; `{mistyped}` is no number{remark}"
        );
        assert_eq!(said, expected);
    }
}

#[test]
fn a_suspension_of_no_layout_is_refused_with_each_row_named_once() {
    let rows: String = [
        "FLL inner",
        "FLL outer",
        "RLL inner",
        "Pushrod inner",
        "Pushrod outer",
        "Wheel centre",
    ]
    .iter()
    .zip(1..)
    .map(|(name, row)| format!("{name};{row};{row}00;250;{row};-{row}00;250\n"))
    .collect();
    let said = refusal(
        "a.csv",
        &format!("Point;Left;;;Right;;\n;x;y;z;x;y;z\n{rows}"),
        &[],
    );
    assert!(
        said.contains("; of other layouts: `Pushrod inner` (a.csv:6), `Pushrod outer` (a.csv:7); "),
        "{said}"
    );
    let expected = "a.csv: no layout has half of its points here under known names; a suspension of another kind needs a listing of \
                    its own, see suspension motion --help; the nearest, ";
    assert!(said.starts_with(expected), "{said}");
}

/// The front axle has more points than the rear one, and angles of its own.
#[test]
fn groups_may_be_empty_and_state_numbers() {
    let folder = folder();
    let heading = ";FL;;;FR;;;RL;;;RR;;\n;x;y;z;x;y;z;x;y;z;x;y;z\n";
    let rows = cars(|name, [fl, fr, rl, rr]| match name {
        "shock_to_chassis" => format!("{name};{fl};{fr};;;;;;\n"),
        _ => format!("{name};{fl};{fr};{rl};{rr}\n"),
    });
    let angles = "toe;0,1;;;0,1;;;0,2;;;0,2;;\ntyre radius;229;;;;;;;;;;;\n";
    let file = format!("{heading}{rows}{angles}");
    let front = import(folder.path(), "a.csv", &file, &["--end", "front"]);
    assert_corner(&front, [0.0, 1.0], "front");
    assert!(front.notes.contains("toe 0.1 deg"), "{}", front.notes);
    let rear = import(folder.path(), "a.csv", &file, &["--end", "rear"]);
    let layout = "the layout is double_wishbone: ";
    assert!(rear.notes.contains(layout), "{}", rear.notes);
    assert!(rear.notes.contains("toe 0.2 deg"), "{}", rear.notes);
    let radii = [front, rear].map(|end| end.motion["vehicle"]["wheel_radius"].as_float());
    assert_eq!(radii, [Some(229.0); 2]);
}

#[test]
fn masses_beside_the_coordinates_of_groups_are_skipped() {
    let folder = folder();
    let mass = |corners: [String; 4]| corners.map(|at| format!("{at};0,35")).join(";");
    let four = cars(|name, corners| format!("{name};{};M8\n", mass(corners)));
    let four = format!(
        "Point;FL;;;;FR;;;;RL;;;;RR;;;;Remark\n;x;y;z;Mass [kg];x;y;z;Mass [kg];x;y;z;Mass [kg];x;y;z;Mass [kg];\n{four}"
    );
    let two = cars(|name, [left, right, ..]| format!("{name};{left};0,35;{right};0,36\n"));
    let two = format!("Point;Left x;Left y;Left z;Mass;Right x;Right y;Right z;Mass\n{two}");
    let tables =
        cars(|name, [left, right, ..]| format!("{name};{left};0,35;;{name};{right};0,36\n"));
    let tables = format!("Left;;;;;;Right;;;;\nPoint;x;y;z;Mass;;Point;x;y;z;Mass\n{tables}");
    for file in [four, two, tables] {
        let imported = import(
            folder.path(),
            "a.csv",
            &file,
            &["--side", "right", "--end", "front"],
        );
        assert_corner(&imported, [0.0, -1.0], &file);
    }
}
