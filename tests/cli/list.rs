//! `suspension list`: the catalogue, and examples of it.

mod flat;

use std::path::Path;

use suspension_core::linkages::LISTINGS;
use suspension_core::listing::{Kind, Part, Parts};
use suspension_runtime::Listing;

use super::program::{folder, rows, run, table, text};

/// Returns the folder of the package, which contains the examples.
fn package() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

#[test]
fn list_prints_every_layout_with_description_drives_and_measures() {
    let output = run(folder().path(), &["list"]);
    assert_eq!(output.status.code(), Some(0));
    let list = text(&output.stdout);
    let entries: Vec<&str> = list.split("\n\n").collect();
    assert_eq!(entries.len(), LISTINGS.len());
    for (entry, (name, _)) in entries.iter().zip(LISTINGS) {
        assert!(entry.starts_with(&format!("{name}\n  ")), "{entry}");
        assert!(entry.contains(".\n  drives    "), "{entry}");
    }
    let pushrod =
        "an anti-roll bar, front left.\n  drives    bump, steer\n  measures  damper, bar_arm\n";
    assert!(list.contains(pushrod), "{list}");
}

#[test]
fn a_printed_listing_works_in_a_motion_file() {
    let folder = folder();
    let output = run(folder.path(), &["list", "double_wishbone"]);
    assert_eq!(output.status.code(), Some(0));
    std::fs::write(folder.path().join("my.linkage"), &output.stdout).expect("written");
    let file = "listing = \"my.linkage\"\nunit = \"m\"\ntime = { instants = [0.0] }\ndrives = { bump = 0.3, steer = 0.34 }\n";
    std::fs::write(folder.path().join("my.toml"), file).expect("written");
    let output = run(folder.path(), &["motion", "my.toml"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
}

#[test]
fn an_unknown_layout_gives_exit_code_2_and_a_suggestion() {
    for (name, expected) in [
        (
            "macferson",
            "unknown linkage `macferson`; did you mean `macpherson`?",
        ),
        ("strut", "unknown linkage `strut`; known are attia2003, "),
    ] {
        let output = run(folder().path(), &["list", name]);
        assert_eq!(output.status.code(), Some(2));
        let message = text(&output.stderr);
        assert!(message.starts_with(expected), "{message}");
    }
}

/// But for the double wishbone, whose example has pushrod and rocker.
#[test]
fn every_layout_has_an_example_that_is_solved_and_drawn() {
    let folder = folder();
    let layouts = LISTINGS.iter().map(|(name, _)| *name);
    for name in layouts.filter(|name| !name.starts_with("double_wishbone")) {
        let file = package().join("examples").join(format!("{name}.toml"));
        let file = file.to_str().expect("UTF-8");
        let output = run(folder.path(), &["motion", file, "--csv", "-"]);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        assert!(rows(&output.stdout).len() > 8, "{name}");
        let output = run(folder.path(), &["draw", file, "--out", "a.svg"]);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
    }
}

#[test]
fn layouts_md_has_a_row_for_every_layout() {
    let page = include_str!("../../docs/layouts.md");
    for (name, listing) in LISTINGS {
        let listing = Listing::parse(listing).expect("a listing");
        let drives = (0..listing.count(Kind::Drive)).map(|drive| listing.name(Part::Drive(drive)));
        let drives = drives.map(|drive| format!("`{drive}`"));
        let drives = drives.collect::<Vec<_>>().join(", ");
        let row = page
            .lines()
            .find(|line| line.starts_with(&format!("| `{name}` | ")));
        let row = row.unwrap_or_else(|| panic!("{name} has no row"));
        let tail = format!(" | {} | {drives} | ", listing.size());
        assert!(row.contains(&tail), "{row}: not{tail}");
    }
}

#[test]
fn layouts_md_names_the_compiled_layouts() {
    let catalogue = include_str!("../../suspension-core/src/linkages/mod.rs");
    let (_, behind) = catalogue.split_once("\n    compiled: ").expect("names");
    let (names, _) = behind.split_once(';').expect("their end");
    let (others, last) = names.rsplit_once(", ").expect("several");
    let others = others.replace(", ", "`, `");
    let sentence = format!("In Rust `{others}` and `{last}` are compiled");
    let page = include_str!("../../docs/layouts.md").replace('\n', " ");
    assert!(page.contains(&sentence), "not in the page: {sentence}");
}

/// The length is that of the points that the page states, at the design position.
#[test]
fn layouts_md_shows_a_spring_beside_a_strut() {
    let page = include_str!("../../docs/layouts.md");
    let (_, section) = page
        .split_once("## Spring beside a strut")
        .expect("a section");
    let block = section.split("```").nth(1);
    let statements = block.and_then(|block| block.strip_prefix("text\n"));
    let statements = statements.expect("a block");
    for (layout, bump) in [("macpherson", 0.31), ("macpherson_two_links", 0.315)] {
        let (_, strut) = LISTINGS
            .iter()
            .find(|(name, _)| *name == layout)
            .expect("a layout");
        let file = format!(
            "statements = '''\n{strut}{statements}'''\nunit = \"m\"\n[vehicle]\nwheel_radius = {bump}\n[time]\n\
             instants = [0.0]\n[drives]\nbump = {bump}\nsteer = 0.33\n[springs.coil]\nalong = \"spring\"\nrate = 30000.0\n"
        );
        let row = &table(&file, &["motion"])[0];
        let expected = (0.025_f64.powi(2) + 0.055_f64.powi(2) + 0.28_f64.powi(2)).sqrt();
        let off = row["spring_m"] - expected;
        assert!(off.abs() < 1e-14, "{layout}: off by {off:e}");
        assert!(row.contains_key("wheel_rate_N_m"), "{layout}");
    }
}

/// A name in a drawing: the text, and its left, top, right and bottom, letters half as wide as the type is high.
type Label = (String, [f64; 4]);

fn labels(svg: &str) -> Vec<Label> {
    let texts = svg.split("<text ").skip(1).filter_map(|element| {
        let attribute = |name: &str| {
            let (_, behind) = element.split_once(&format!("{name}=\""))?;
            behind.split('"').next()
        };
        let number = |name: &str| attribute(name)?.parse::<f64>().ok();
        let name = element.split(['>', '<']).nth(1)?.trim().to_owned();
        let size = number("font-size")?;
        let width = 0.5 * size * name.chars().count() as f64;
        let part = match attribute("text-anchor")? {
            "end" => 1.0,
            "middle" => 0.5,
            _ => 0.0,
        };
        let (left, top) = (number("x")? - part * width, number("y")?);
        Some((name, [left, top, left + width, top + size]))
    });
    texts.filter(|(name, _)| name.contains('_')).collect()
}

/// The ends of the lines from points to their names.
fn leaders(svg: &str) -> Vec<[f64; 2]> {
    let lines = svg.split("<polyline ").skip(1);
    let faint =
        lines.filter(|line| line.starts_with("fill=\"none\" opacity=\"0.5\" stroke=\"#3C3C3C\""));
    let end = |line: &str| {
        let (_, points) = line.split_once("points=\"")?;
        let (points, _) = points.split_once('"')?;
        let (x, y) = points.split_whitespace().next_back()?.split_once(',')?;
        Some([x.parse().ok()?, y.parse().ok()?])
    };
    faint.filter_map(end).collect()
}

#[test]
fn labels_in_the_drawing_of_a_car_are_apart_and_at_their_leaders() {
    let folder = folder();
    let car = include_str!("../../examples/front_and_rear_axle.toml");
    std::fs::write(folder.path().join("car.toml"), car).expect("written");
    let output = run(folder.path(), &["draw", "car.toml", "--out", "car.svg"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let svg = std::fs::read_to_string(folder.path().join("car.svg")).expect("written");
    let labels = labels(&svg);
    assert!(labels.len() > 30, "{}", labels.len());
    let leaders = leaders(&svg);
    assert!(!leaders.is_empty());
    for [x, y] in leaders {
        let near = |[left, top, right, bottom]: [f64; 4]| {
            let gap = bottom - top;
            (left - gap..right + gap).contains(&x) && (top - gap..bottom + gap).contains(&y)
        };
        assert!(labels.iter().any(|(_, label)| near(*label)), "{x}, {y}");
    }
    for (index, (name, a)) in labels.iter().enumerate() {
        for (other, b) in &labels[..index] {
            let meet = |low: usize, high: usize| a[high].min(b[high]) > a[low].max(b[low]);
            assert!(!(meet(0, 2) && meet(1, 3)), "{name} and {other}");
        }
    }
}
