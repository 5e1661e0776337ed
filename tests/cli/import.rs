//! `suspension import`: from hardpoint files to motion files.

mod ambiguous;
mod axle;
mod both_sides;
mod contact;
mod designer;
mod ends;
mod formats;
mod frames;
mod groups;
mod incomplete;
mod line_per_axis;
mod merged;
mod names_as_columns;
mod noted;
mod random;
mod rear;
mod refused;
mod row_names;
mod rows;
mod spreadsheets;
mod struts;
mod upper;

use std::collections::BTreeMap;
use std::path::Path;

use suspension_core::linkages::LISTINGS;
use suspension_core::listing::{Part, Parts};
use suspension_runtime::Listing;

use super::program::{Rows, folder, rows, run, text};

/// An example file with the points below, toe, camber and radius.
const EXAMPLE: &str = include_str!("../../examples/hardpoints.csv");

/// A double wishbone with pushrod and rocker in names of Adams/Car, front left; x rearward, y right, z up, mm.
const CORNER: [(&str, [f64; 3]); 15] = [
    ("lca_front", [-140.0, -170.0, 125.0]),
    ("lca_rear", [150.0, -175.0, 120.0]),
    ("lca_outer", [-4.0, -560.0, 128.0]),
    ("uca_front", [-120.0, -235.0, 270.0]),
    ("uca_rear", [130.0, -240.0, 262.0]),
    ("uca_outer", [14.0, -535.0, 330.0]),
    ("tierod_inner", [-72.0, -190.0, 152.0]),
    ("tierod_outer", [-68.0, -552.0, 166.0]),
    ("wheel_center", [0.0, -610.0, 229.0]),
    ("prod_outboard", [2.0, -520.0, 150.0]),
    ("prod_inboard", [10.0, -265.0, 480.0]),
    ("bellcrank_pivot", [-8.0, -225.0, 455.0]),
    ("bellcrank_axis", [22.0, -223.0, 454.0]),
    ("shock_to_bellcrank", [6.0, -210.0, 515.0]),
    ("shock_to_chassis", [4.0, -20.0, 530.0]),
];

/// The points with the listing's names, x forward, y left, z up.
const IN_OUR_AXES: [(&str, [f64; 3]); 15] = [
    ("lower_front", [140.0, 170.0, 125.0]),
    ("lower_rear", [-150.0, 175.0, 120.0]),
    ("lower_ball", [4.0, 560.0, 128.0]),
    ("upper_front", [120.0, 235.0, 270.0]),
    ("upper_rear", [-130.0, 240.0, 262.0]),
    ("upper_ball", [-14.0, 535.0, 330.0]),
    ("rack", [72.0, 190.0, 152.0]),
    ("tie_ball", [68.0, 552.0, 166.0]),
    ("wheel_centre", [0.0, 610.0, 229.0]),
    ("pushrod_lower", [-2.0, 520.0, 150.0]),
    ("pushrod_upper", [-10.0, 265.0, 480.0]),
    ("rocker_front", [8.0, 225.0, 455.0]),
    ("rocker_rear", [-22.0, 223.0, 454.0]),
    ("damper_outer", [-6.0, 210.0, 515.0]),
    ("damper_inner", [-4.0, 20.0, 530.0]),
];

/// The places of a sweep along drives.
fn swept(folder: &Path, file: &str, drives: &[&str]) -> Rows {
    let drives = drives.iter().flat_map(|drive| ["--drive", drive]);
    let arguments: Vec<&str> = ["sweep", file, "--csv", "-"]
        .into_iter()
        .chain(drives)
        .collect();
    let output = run(folder, &arguments);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    rows(&output.stdout)
}

/// The messages and the file of an import.
struct Imported {
    notes: String,
    motion: toml::Table,
}

impl Imported {
    /// The points that have coordinates.
    fn points(&self) -> BTreeMap<String, [f64; 3]> {
        let points = self.motion["points"].as_table().expect("a table");
        let placed = points.iter().filter_map(|(name, at)| {
            let at: Vec<f64> = at
                .as_array()?
                .iter()
                .filter_map(toml::Value::as_float)
                .collect();
            Some((name.clone(), at.try_into().expect("three")))
        });
        placed.collect()
    }

    fn text(&self, key: &str) -> &str {
        self.motion[key].as_str().expect("text")
    }
}

/// Imports a file, which must succeed.
fn import(folder: &Path, name: &str, content: &str, options: &[&str]) -> Imported {
    std::fs::write(folder.join(name), content).expect("written");
    let arguments = [&["import", name, "--out", "motion.toml"], options].concat();
    let output = run(folder, &arguments);
    assert_eq!(output.status.code(), Some(0), "{content}{output:?}");
    let motion = std::fs::read_to_string(folder.join("motion.toml")).expect("a motion file");
    Imported {
        notes: text(&output.stderr).to_owned(),
        motion: motion.parse().expect("TOML"),
    }
}

/// A line a point, between commas.
fn table(points: &[(&str, [f64; 3])]) -> String {
    let lines = points.iter();
    let lines = lines.map(|(name, [x, y, z])| format!("{name}, {x}, {y}, {z}\n"));
    lines.collect()
}

#[test]
fn import_and_sheet_turn_a_table_of_adams_names_into_a_page() {
    let folder = folder();
    std::fs::write(folder.path().join("front.csv"), EXAMPLE).expect("written");
    let output = run(folder.path(), &["import", "front.csv"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    // The drives that it writes are those of the design: nothing is doubtful in them.
    assert!(!text(&output.stderr).contains("[drives]"), "{output:?}");
    let output = run(folder.path(), &["sheet", "front.toml"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    assert!(folder.path().join("out/front_sheet.html").exists());
    let output = run(folder.path(), &["motion", "front.toml", "--csv", "-"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let motion = rows(&output.stdout);
    assert_eq!(motion.len(), 51);
    // At the design position the wheel has the angles of the file, and the kingpin those of the ball joints.
    let design = &motion[0];
    let close = |name: &str, expected: f64| {
        let off = (design[name] - expected).abs();
        assert!(off < 1e-9, "{name} is {off:e} deg off");
    };
    close("toe_deg", -0.2);
    close("kingpin_deg", (25.0_f64).atan2(202.0).to_degrees());
    close("caster_deg", (18.0_f64).atan2(202.0).to_degrees());
    // Adams/Car turns the wheel by toe, then by camber, which is to the ground.
    let camber = (1.2_f64.to_radians().tan() / 0.2_f64.to_radians().cos()).atan();
    close("camber_deg", -camber.to_degrees());
    let length = (2.0_f64.powi(2) + 202.0_f64.powi(2) + 3.0_f64.powi(2)).sqrt();
    assert!((design["damper_mm"] - length).abs() < 1e-9);
}

/// Returns the points of a layout at the positions of its listing.
fn listed(linkage: &str) -> Vec<(String, [f64; 3])> {
    let (_, listing) = LISTINGS
        .iter()
        .find(|(name, _)| *name == linkage)
        .expect("a layout");
    let listing = Listing::parse(listing).expect("a listing");
    let points = listing.stated();
    let points = points.map(|(point, at)| (listing.name(Part::Point(point)).to_owned(), at.into()));
    let mut points: Vec<_> = points.collect();
    // Two listings leave the wheel centre to the host.
    if let Some(marker) = ["p11", "wheel_centre"]
        .into_iter()
        .find(|name| listing.point(name) == Some(points.len()))
    {
        points.push((marker.to_owned(), [-1.27, 0.415, 0.218]));
    }
    points
}

#[test]
fn import_finds_every_layout_by_its_own_point_names() {
    let folder = folder();
    for (linkage, _) in LISTINGS {
        let listed = listed(linkage);
        let points: Vec<_> = listed
            .iter()
            .map(|(name, at)| (name.as_str(), *at))
            .collect();
        // Its points are those of multi_link, which has a spin axis of its own.
        let options: &[&str] = match *linkage {
            "five_link" => &["--linkage", "five_link"],
            _ => &[],
        };
        let imported = import(folder.path(), "own.csv", &table(&points), options);
        assert_eq!(imported.text("linkage"), *linkage);
        assert_eq!(imported.text("unit"), "m");
        let expected = points.iter().map(|(name, at)| ((*name).to_owned(), *at));
        assert_eq!(imported.points(), expected.collect(), "{linkage}");
        let expected_text =
            "camber and toe are those of the line from upper_rear_outer to wheel_centre";
        assert_eq!(
            imported.notes.contains(expected_text),
            *linkage == "five_link"
        );
        let head = std::fs::read_to_string(folder.path().join("motion.toml")).expect("written");
        assert_eq!(
            head.contains(&format!("# {expected_text}")),
            *linkage == "five_link"
        );
        let output = run(
            folder.path(),
            &["sheet", "motion.toml", "--travel", "0:0.001"],
        );
        assert_eq!(output.status.code(), Some(0), "{linkage}: {output:?}");
    }
}

/// A spreadsheet calls the end of a link by the link: `Lower front link inner`.
#[test]
fn ends_of_links_are_found_by_the_names_of_the_links() {
    let folder = folder();
    let listed = listed("multi_link");
    let named = listed.iter().map(|(name, at)| {
        let name = name.replace("track_rod", "toe");
        (
            name.replace("_inner", " link inner")
                .replace("_outer", " link outer"),
            *at,
        )
    });
    let named: Vec<_> = named.collect();
    let points: Vec<_> = named
        .iter()
        .map(|(name, at)| (name.as_str(), *at))
        .collect();
    let imported = import(folder.path(), "rear.csv", &table(&points), &[]);
    assert_eq!(imported.text("linkage"), "multi_link");
    assert_eq!(imported.points(), listed.iter().cloned().collect());
}

#[test]
fn imported_drive_angles_are_in_degrees_and_start_at_the_design() {
    let folder = folder();
    let listed = listed("five_link");
    let points: Vec<_> = listed
        .iter()
        .map(|(name, at)| (name.as_str(), *at))
        .collect();
    let imported = import(
        folder.path(),
        "own.csv",
        &table(&points),
        &["--linkage", "five_link"],
    );
    assert_eq!(imported.text("angle"), "deg");
    let [rise, reach] = [0.027 + 0.082, 0.400 + 0.025].map(f64::abs);
    let length = f64::hypot(f64::hypot(-1.315 + 1.396, reach), rise);
    let start = imported.motion["drives"]["theta"][0]
        .as_float()
        .expect("a number");
    assert!(
        (start - (rise / length).acos().to_degrees()).abs() < 1e-12,
        "{start}"
    );
}

#[test]
fn an_imported_motion_that_reaches_a_lock_is_noted() {
    let folder = folder();
    let small = CORNER.map(|(name, at)| (name, at.map(|coordinate| coordinate / 8.0)));
    let imported = import(folder.path(), "own.csv", &table(&small), &["--unit", "mm"]);
    assert!(
        imported
            .notes
            .contains("the drive `bump` locks at +10.13 mm"),
        "{}",
        imported.notes
    );
    assert!(
        imported
            .notes
            .contains("; state a shorter motion under [drives]"),
        "{}",
        imported.notes
    );
}

#[test]
fn hardpoints_md_has_all_names_that_import_knows() {
    let output = run(folder().path(), &["import", "--names"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let page = include_str!("../../docs/hardpoints.md");
    let names = text(&output.stdout);
    assert!(names.lines().count() > 100);
    let expected = format!("```text\n{names}```\n");
    assert!(
        page.contains(&expected),
        "docs/hardpoints.md is not as suspension import --names has it"
    );
}
