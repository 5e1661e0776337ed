//! Cells of spreadsheets that are merged, so that the first of several rows alone has their words, or that have several lines.

use super::super::program::folder;
use super::{CORNER, import, table};

/// The parts with the points that each has, in the order of the corner.
const PARTS: [(&str, &[&str]); 4] = [
    ("Lower wishbone", &["Front", "Rear", "Outer"]),
    ("Upper wishbone", &["Front", "Rear", "Ball joint"]),
    ("Tie rod", &["Inner", "Outer"]),
    ("Wheel", &["Centre"]),
];

/// A row for each point, its part in the first row of the part alone; `before` is the number of the row.
fn merged(separator: &str, before: impl Fn(usize) -> String) -> String {
    let mut at = CORNER.iter().enumerate();
    let mut rows = format!("Part{separator}Point\n");
    for (part, points) in PARTS {
        for (place, point) in points.iter().enumerate() {
            let (index, (_, at)) = at.next().expect("a point");
            let part = if place == 0 { part } else { "" };
            let at = at.map(|x| x.to_string()).join(separator);
            rows += &format!("{}{part}{separator}{point}{separator}{at}\n", before(index));
        }
    }
    rows
}

#[test]
fn a_part_in_a_merged_cell_is_that_of_the_rows_below() {
    let folder = folder();
    let plain = import(folder.path(), "a.csv", &table(&CORNER[..9]), &[]);
    for separator in [",", ";", "\t"] {
        for file in [
            merged(separator, |_| String::new()),
            merged(separator, |index| format!("{}{separator}", index + 1)),
        ] {
            let imported = import(folder.path(), "a.csv", &file, &[]);
            assert_eq!(imported.points(), plain.points(), "{file}");
            assert!(!imported.notes.contains("not used"), "{}", imported.notes);
        }
    }
}

/// The right corner has its own points: they are no mirror image of the left one.
#[test]
fn a_point_or_a_side_in_a_merged_cell_is_that_of_the_rows_below() {
    let folder = folder();
    let right = |[x, y, z]: [f64; 3]| [x + 1.0, -y, z];
    let left = |at: [f64; 3]| at;
    let row = |words: &str, [x, y, z]: [f64; 3]| format!("{words},{x},{y},{z}\n");
    let points = CORNER.iter();
    let plain = points.clone().map(|(name, at)| {
        let left = row(&format!("{name},L"), left(*at));
        left + &row(&format!("{name},R"), right(*at))
    });
    let names = points
        .clone()
        .map(|(name, at)| row(&format!("{name},L"), left(*at)) + &row(",R", right(*at)));
    let side = |side: &'static str, of: fn([f64; 3]) -> [f64; 3]| {
        CORNER.iter().enumerate().map(move |(index, (name, at))| {
            let side = if index == 0 { side } else { "" };
            row(&format!("{side},{name}"), of(*at))
        })
    };
    let sides = side("Left", left).chain(side("Right", right));
    let options = ["--axle"];
    let plain = import(folder.path(), "a.csv", &plain.collect::<String>(), &options);
    for file in [names.collect::<String>(), sides.collect()] {
        let imported = import(folder.path(), "a.csv", &file, &options);
        assert_eq!(imported.points(), plain.points(), "{file}");
    }
}

/// Words stand in the line above, which is no row of numbers, or the row has no word of its own.
#[test]
fn rows_below_a_title_or_without_a_word_are_filled_with_nothing() {
    let folder = folder();
    let plain = import(folder.path(), "a.csv", &table(&CORNER), &[]);
    let indented = table(&CORNER).replace('\n', "\n,");
    for file in [
        format!("Upper wishbone,,,\n,{}", indented.trim_end_matches(',')),
        table(&CORNER) + ",0,0,0\n",
    ] {
        let imported = import(folder.path(), "a.csv", &file, &[]);
        assert_eq!(imported.points(), plain.points(), "{file}");
    }
}

/// The mass in the second column is no coordinate, as the heading says.
#[test]
fn a_cell_in_quotes_may_have_several_lines() {
    let folder = folder();
    let plain = import(folder.path(), "a.csv", &table(&CORNER), &[]);
    let rows = CORNER.map(|(name, [x, y, z])| {
        let name = name.replacen('_', "\n", 1);
        format!("\"{name}\";0.4;{x};{y};{z};\n")
    });
    let heading = "\"Hard\npoint\";\"Mass\n[kg]\";\"X\n[mm]\";\"Y\n[mm]\";\"Z\n[mm]\";Remark\n";
    let file = format!("{heading}{}", rows.concat());
    let imported = import(folder.path(), "a.csv", &file, &[]);
    assert_eq!(imported.points(), plain.points(), "{file}");
    let said = "the unit of lengths is mm, as the file says";
    assert!(imported.notes.contains(said), "{}", imported.notes);
}
