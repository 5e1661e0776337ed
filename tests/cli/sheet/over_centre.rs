//! Springs that are longest or shortest within the travel.

use super::super::program::{CORNER, folder, run, text};

/// A corner with a spring on its damper, whose inner end is at a place (y, z); the rocker turns about y 0.38, z 0.52, and the
/// damper's outer end is at y 0.34, z 0.60.
fn with_spring(inner: [f64; 2]) -> String {
    let [y, z] = inner;
    let spring = format!(
        "points = {{ damper_inner = [0.0, {y}, {z}] }}\nsprings.corner = {{ along = \"damper\", rate = 28000.0 }}\n[drives]"
    );
    CORNER.replace("[drives]", &spring)
}

/// The height above the design at which the sheet says that the rocker goes over centre, in metres.
fn noted(inner: [f64; 2]) -> Option<f64> {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), with_spring(inner)).expect("written");
    let output = run(folder.path(), &["sheet", "a.toml"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let page = std::fs::read_to_string(folder.path().join("out/a_sheet.html")).expect("a page");
    let before = "`damper` is longest or shortest at ";
    let (_, note) = text(&output.stderr).split_once(before)?;
    let (height, rest) = note.split_once(" m of bump, ").expect("a height");
    assert!(
        rest.starts_with(
            "as where a rocker goes over centre; beyond, the spring `corner` moves the other way\n"
        ),
        "{rest}"
    );
    let on_page = format!("<code>damper</code> is longest or shortest at {height} m of bump");
    assert!(page.contains(&on_page));
    Some(height.parse().expect("a number"))
}

#[test]
fn a_rocker_that_goes_over_centre_within_the_travel_is_noted() {
    // The rocker's axis is on the damper's line at the design.
    assert_eq!(noted([0.30, 0.68]), Some(0.0));
    let height = noted([0.25, 0.62]).expect("a note");
    // The place of the rocker at that height, by the program's own table: its axis is on the damper's line.
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), with_spring([0.25, 0.62])).expect("written");
    let drive = format!("bump={}:{}:2", height - 0.001, height);
    let sweep = ["sweep", "a.toml", "--drive", &drive, "--csv", "-"];
    let output = run(folder.path(), &sweep);
    let mut rows = csv::Reader::from_reader(text(&output.stdout).as_bytes());
    let headings = rows.headers().expect("headings").clone();
    let column = |name: &str| headings.iter().position(|heading| heading == name);
    let places = ["damper_outer_y", "damper_outer_z"].map(|name| column(name).expect(name));
    let last = rows.records().last().expect("rows").expect("a row");
    let [y, z] = places.map(|place| last[place].parse::<f64>().expect("a number"));
    let off = (y - 0.38) * (0.62 - z) - (z - 0.52) * (0.25 - y);
    assert!(off.abs() < 2e-5, "{off} m^2 at {height} m");
    assert_eq!(noted([0.10, 0.58]), None);
}
