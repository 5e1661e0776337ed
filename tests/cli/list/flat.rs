//! The listing of a motion file, printed as one text: in the program, in Rust and beside the motion file.

use std::path::{Path, PathBuf};

use nalgebra::Vector3;
use suspension::file::{Position, Source};
use suspension::prepare::load;
use suspension_core::listing::{Kind, Part, Parts};
use suspension_core::{Signal, Values};
use suspension_runtime::Listing;

use super::super::program::{folder, rows, run, text};
use super::package;
use imported_axle::Drives;

suspension_core::linkage! {
    /// Both front corners of `examples/hardpoints.csv`, as `suspension list` prints them.
    mod imported_axle in "../../data/imported_axle.linkage";
}

const PRINTED: &str = include_str!("../../data/imported_axle.linkage");

/// Returns the printed listing of a motion file.
fn printed(folder: &Path, file: &str) -> String {
    let output = run(folder, &["list", file]);
    assert_eq!(output.status.code(), Some(0), "{file}: {output:?}");
    text(&output.stdout).to_owned()
}

/// Imports the example of hardpoints as an axle, in mm.
fn import_axle(folder: &Path, layout: &str) {
    let table = package().join("examples/hardpoints.csv");
    let table = table.to_str().expect("UTF-8");
    let arguments = ["import", table, "--axle", "--linkage", layout];
    let output = run(folder, &[&arguments[..], &["--out", "front.toml"]].concat());
    assert_eq!(output.status.code(), Some(0), "{output:?}");
}

/// All names of a listing in order, and what its statements join.
fn contents(listing: &Listing) -> String {
    let parts = |kind, part: fn(usize) -> Part| {
        let names = (0..listing.count(kind)).map(|index| listing.name(part(index)).to_owned());
        names.collect::<Vec<String>>()
    };
    let counts = Kind::POINTS.map(|kind| listing.count(kind));
    let points: Vec<&str> = suspension::prepare::point_names(listing).collect();
    format!(
        "{counts:?} {points:?} {:?} {:?} {:?} {:?} {:?} {:?} {:?}",
        parts(Kind::Unknown, Part::Unknown),
        parts(Kind::Drive, Part::Drive),
        parts(Kind::Measure, Part::Measure),
        parts(Kind::Length, Part::Length),
        listing.links(),
        listing.bodies(),
        listing.slides(),
    )
}

/// Asserts that a printed listing has the names of a motion file's listing, and its design positions.
fn assert_same(printed: &str, file: &Path) {
    let source = Source::read(file).expect("read");
    let loaded = load(&source).expect("a motion file");
    let listing = Listing::parse(printed).unwrap_or_else(|mistakes| panic!("{mistakes}"));
    assert_eq!(contents(&listing), contents(loaded.listing()), "{printed}");
    let design = listing.design().expect("all positions");
    let mechanism = loaded.at_design().expect("assembled");
    let names = suspension::prepare::point_names(&listing);
    for ((name, at), assembled) in names.zip(design).zip(mechanism.points()) {
        assert!(
            (at - assembled).amax() < 1e-12 * assembled.amax().max(1.0),
            "{name}"
        );
        let is_stated = match loaded.stated_position(name) {
            Some(Position::At(stated)) => Vector3::from(*stated) == at,
            Some(Position::Off(_)) | None => true,
        };
        // With [lengths] the points are a start of the assembly.
        assert!(
            is_stated || source.text().contains("[lengths]"),
            "{name}: {at}"
        );
    }
}

#[test]
fn the_listing_of_each_example_is_printed_with_the_positions_of_the_file() {
    let folder = folder();
    let examples = std::fs::read_dir(package().join("examples")).expect("a folder");
    let examples = examples.map(|file| file.expect("a file").path());
    let examples: Vec<PathBuf> = examples
        .filter(|file| file.extension().is_some_and(|end| end == "toml"))
        .collect();
    assert!(examples.len() > 15, "{examples:?}");
    for file in examples {
        let printed = printed(folder.path(), file.to_str().expect("UTF-8"));
        assert_same(&printed, &file);
    }
}

#[test]
fn the_listing_of_an_imported_axle_moves_as_the_axle() {
    let folder = folder();
    let path = folder.path();
    import_axle(path, "double_wishbone_rocker");
    let listing = printed(path, "front.toml");
    assert!(
        listing.contains("\n//! Lengths are in mm, axes are ISO 8855: x forward"),
        "{listing}"
    );
    assert_same(&listing, &path.join("front.toml"));
    let motion = std::fs::read_to_string(path.join("front.toml")).expect("a motion file");
    let (_, behind) = motion.split_once("\nunit =").expect("a unit");
    let (unit, behind) = behind.split_once("\n[points]").expect("points");
    let (_, vehicle) = behind.split_once("\n[vehicle]").expect("a vehicle");
    let motion = format!("listing = \"flat.linkage\"\nunit ={unit}\n[vehicle]{vehicle}");
    std::fs::write(path.join("flat.toml"), motion).expect("written");
    std::fs::write(path.join("flat.linkage"), listing).expect("written");
    let moved = |file: &str| {
        let output = run(path, &["motion", file, "--csv", "-"]);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        rows(&output.stdout)
    };
    let [flat, front] = ["flat.toml", "front.toml"].map(moved);
    assert_eq!((flat.len(), front.len()), (51, 51));
    for (flat, front) in flat.iter().zip(&front) {
        assert!(flat.keys().eq(front.keys()));
        for (name, value) in flat {
            // The motion file states the points of the spin axes by their offset from the wheel centres, which is added
            // after rounding here, before it there.
            let of_joint = ["ball", "_rack", "upper", "lower", "wheel_centre", "damper"];
            let bound = match of_joint.iter().any(|joint| name.contains(joint)) {
                true => 0.0,
                false => 1e-11 * front[name].abs().max(1.0),
            };
            assert!((value - front[name]).abs() <= bound, "{name}: {value}");
        }
    }
}

#[test]
fn the_printed_listing_is_compiled_by_the_macro_to_the_same_model() {
    let folder = folder();
    import_axle(folder.path(), "double_wishbone");
    let listing = printed(folder.path(), "front.toml");
    if std::env::var_os("UPDATE_SNAPSHOTS").is_some_and(|value| value == "1") {
        let file = package().join("tests/data/imported_axle.linkage");
        std::fs::write(file, &listing).expect("written");
    }
    assert!(
        listing == PRINTED,
        "another listing is printed; take it over with `UPDATE_SNAPSHOTS=1 cargo test --test cli list::`"
    );
    let listing = Listing::parse(PRINTED).expect("a listing");
    let names = |parts: &dyn Parts| {
        let count = parts.count(Kind::Unknown);
        let names = (0..count).map(|unknown| parts.name(Part::Unknown(unknown)).to_owned());
        names.collect::<Vec<_>>()
    };
    assert_eq!(names(&listing), names(&imported_axle::Listing));
    let design = listing.design().expect("all positions");
    let mut walked = listing.corner::<60>(&design).expect("a geometry");
    let mut compiled: imported_axle::Corner = imported_axle::Corner::design().expect("a geometry");
    let moved = Drives {
        left_bump: 229.0 + 20.0,
        steer: 190.0 + 5.0,
        right_bump: 229.0 - 10.0,
    };
    compiled.step(0.1, Signal::still(moved)).expect("a step");
    let moved = Values::from_values(moved.values());
    walked.step(0.1, Signal::still(moved)).expect("a step");
    let points = |points: &mut dyn Iterator<Item = Vector3<f64>>| {
        points.take(design.len()).collect::<Vec<_>>()
    };
    let compiled = points(&mut compiled.points().value.values());
    assert_eq!(compiled.len(), design.len());
    assert_eq!(compiled, points(&mut walked.points().value.values()));
}

#[test]
fn a_file_in_other_axes_says_so_above_its_listing() {
    let folder = folder();
    let file = "linkage = \"double_wishbone\"\nunit = \"m\"\naxes = \"Adams\"\ntime = { instants = [0.0] }\n[drives]\nbump = 0.3\nsteer = -0.34\n";
    std::fs::write(folder.path().join("a.toml"), file).expect("written");
    let listing = printed(folder.path(), "a.toml");
    let heading = "//! Lengths are in m, axes are Adams: x rearward, y right, z up.\n\
                   //! The library reads camber, toe and other wheel quantities in the axes of ISO 8855.\n\nfixed: lower_front at [-0.2, -0.35, 0.16],";
    assert!(listing.contains(heading), "{listing}");
}

#[test]
fn a_motion_file_that_is_missing_is_refused() {
    let folder = folder();
    let output = run(folder.path(), &["list", "none.toml"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(
        text(&output.stderr).starts_with("none.toml: cannot be read"),
        "{output:?}"
    );
}
