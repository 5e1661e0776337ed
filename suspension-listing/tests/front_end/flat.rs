//! A listing that was printed flat is the same listing.

use std::path::Path;

use suspension_listing::include::{IncludeSource, Wanted};
use suspension_listing::system::System;
use suspension_listing::text;

use super::catalogue_text;

/// The catalogue, and one file.
struct Catalogue;

const CORNER: &str = "\
fixed: front at [0.2, 0.35, 0.16], rear at [-0.2, 0.35, 0.16], r#type at [0.0, 0.4, 0.3];
free:  /// The end of an arm.
       ball at [0.0, 0.7, 0.2], hub at [0.0, 0.8, 0.3];
hinge arm: front, rear -> ball, hub;
drive bump: ball along [0.0, -0.6, 0.8];
measure z: angle(r#type -> ball, z);
measure far: 1.5 ball.y - 2 * hub.y;
point centre: arm;
wheel: centre -> hub;
";

impl IncludeSource for Catalogue {
    fn text(&self, wanted: Wanted<'_>) -> Result<String, String> {
        match wanted {
            Wanted::OfCatalogue(name) => Ok(catalogue_text(name)),
            Wanted::File(path) => {
                assert_eq!(path, Path::new("corner.linkage"));
                Ok(CORNER.to_owned())
            }
        }
    }
}

fn read(text: &str) -> System {
    let read = text::parse(text, "listing", &Catalogue);
    read.unwrap_or_else(|mistakes| panic!("{mistakes}\n{text}"))
}

/// The position that a system states for a point.
fn stated(system: &System, name: &str) -> Option<[f64; 3]> {
    let points = system.fixed.iter().chain(&system.free);
    let points = points.map(|point| (&point.named, point.at));
    let markers = system.markers.iter();
    let markers = markers.map(|marker| (&marker.named, marker.at));
    let mut all = points.chain(markers);
    all.find(|(named, _)| named.name.as_str() == name)?.1
}

/// The printed listing has no `//!`, which the system has too.
fn without_docs(system: System) -> String {
    let docs = Vec::new();
    format!("{:#?}", System { docs, ..system })
}

fn assert_same(text: &str) {
    let system = read(text);
    let flat = text::flat(text, "listing", &Catalogue, &|name| stated(&system, name));
    let flat = flat.unwrap_or_else(|mistakes| panic!("{mistakes}"));
    for word in ["include", "mirror"] {
        let begins = |line: &str| line.starts_with(word);
        assert!(!flat.lines().any(begins), "{flat}");
    }
    assert_eq!(without_docs(read(&flat)), without_docs(system), "{flat}");
}

#[test]
fn the_layouts_of_the_catalogue_stay_the_same() {
    let folder = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../suspension-core/src/linkages"
    );
    let files = std::fs::read_dir(folder).expect("a folder");
    let files = files.map(|file| file.expect("a file").path());
    let files: Vec<_> = files
        .filter(|file| file.extension().is_some_and(|end| end == "linkage"))
        .collect();
    assert!(files.len() > 15, "{files:?}");
    for file in files {
        assert_same(&std::fs::read_to_string(file).expect("read"));
    }
}

#[test]
fn listings_of_all_kinds_of_statements_stay_the_same() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../tests/back_ends/listings");
    let files: Vec<_> = std::fs::read_dir(folder).expect("a folder").collect();
    assert!(files.len() > 5, "{files:?}");
    for file in files {
        assert_same(&std::fs::read_to_string(file.expect("a file").path()).expect("read"));
    }
}

#[test]
fn includes_and_mirrors_stay_the_same() {
    assert_same("mirror: left -> right;\ninclude left: \"corner.linkage\";\n");
    assert_same("include front: steered_axle at [2.6, 0.0, 0.0];\n");
}

/// Its docs have a line each then.
#[test]
fn a_block_comment_is_printed_as_lines() {
    let text = "fixed: a; free: /** An end\n of a link. */ b;\n/** Holds it,\n or not. */\nlink l: a -> b;";
    let flat = text::flat(text, "listing", &Catalogue, &|_| None).expect("a listing");
    let expected = "fixed: a;\nfree:  /// An end\n       /// of a link. \n       b;\n/// Holds it,\n/// or not. \nlink l: a -> b;\n";
    assert_eq!(flat, expected);
}

#[test]
fn positions_are_those_that_are_given() {
    let text = "fixed: a at [1, 2, 3], longer; free: b at [0, 0, 0];\nbody c: a, longer, b; point d: c at [1, 1, 1];\n\
                /// Moves it.\ndrive x: b.x - 0.5 a.x;";
    let at = |name: &str| (name != "longer").then_some([0.1 + 0.2, -1e-7, 1e20]);
    let flat = text::flat(text, "listing", &Catalogue, &at);
    let expected = "\
fixed: a      at [0.30000000000000004, -1e-7, 1e20],
       longer;
free:  b at [0.30000000000000004, -1e-7, 1e20];
body c: a, longer, b;
point d: c at [0.30000000000000004, -1e-7, 1e20];
/// Moves it.
drive x: b.x - 0.5 a.x;
";
    assert_eq!(flat.as_deref(), Ok(expected));
}

#[test]
fn a_text_with_a_mistake_is_refused_at_its_place() {
    let flat = text::flat("fixed: a;\nlink b a;\n", "listing", &Catalogue, &|_| None);
    let mistakes = flat.expect_err("a mistake").to_string();
    assert!(
        mistakes.starts_with("listing:2:8: expected `:`"),
        "{mistakes}"
    );
}
