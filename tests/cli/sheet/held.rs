//! Derivatives per travel of one wheel, with the other wheel held.

use super::super::program::{folder, run, text};

/// A layout of the catalogue whose drives of travel are the lengths of its dampers instead of the heights of its wheels.
fn led_by_dampers(listing: &str, body: &str) -> String {
    let begins = format!("body {body}: left");
    let lines = listing.lines().map(|line| {
        if line.starts_with("drive bump_left:") {
            "drive bump_left: length(left_damper_lower -> left_damper_upper);".to_owned()
        } else if let Some(place) = line.strip_prefix("point left_damper_lower: ") {
            let (_, place) = place.split_once(" at ").expect("a place");
            format!("free: left_damper_lower at {place}")
        } else if line.starts_with(&begins) {
            let dampers = match body {
                "axle" => "left_damper_lower, right_damper_lower",
                _ => "left_damper_lower",
            };
            line.replacen(": ", &format!(": {dampers}, "), 1)
        } else {
            line.to_owned()
        }
    });
    lines.map(|line| line + "\n").collect()
}

/// The cells of the table at the design position, the last ones of each row.
fn last_cells(page: &str, count: usize) -> Vec<Vec<&str>> {
    let (_, table) = page.split_once("At the design position").expect("a table");
    let (table, _) = table.split_once("</table>").expect("its end");
    let rows = table
        .split("<tbody")
        .skip(1)
        .flat_map(|group| group.split("<tr").skip(1));
    let rows = rows.filter(|row| !row.contains("class=\"definition\""));
    let cells = rows.map(|row| {
        let (row, _) = row.rsplit_once("</td>").expect("cells");
        let cells = row.split("</td>").map(|cell| cell.rsplit('>').next());
        let cells: Vec<&str> = cells.flatten().map(str::trim).collect();
        cells[cells.len() - count..].to_vec()
    });
    cells.collect()
}

/// The dampers of a live axle or a twist beam move both wheels, yet per wheel travel the other wheel is held, as where the
/// drives are the heights of the wheels.
#[test]
fn per_wheel_travel_the_other_wheel_is_held() {
    let folder = folder();
    for (body, listing) in [
        (
            "axle",
            include_str!("../../../suspension-core/src/linkages/live_axle_panhard.linkage"),
        ),
        (
            "left_arm",
            include_str!("../../../suspension-core/src/linkages/twist_beam.linkage"),
        ),
    ] {
        let page = |listing: &str| {
            let file = format!(
                "unit = 'm'\nvehicle = {{ wheel_radius = 0.3 }}\ntime = {{ instants = [0.0] }}\n\
                 drives = {{ bump_left = 0.4, bump_right = 0.4 }}\nstatements = '''\n{listing}'''\n"
            );
            std::fs::write(folder.path().join("a.toml"), file).expect("written");
            let output = run(folder.path(), &["sheet", "a.toml", "--out", "-"]);
            assert_eq!(output.status.code(), Some(0), "{output:?}");
            text(&output.stdout).to_owned()
        };
        let [by_height, by_damper] =
            [listing.to_owned(), led_by_dampers(listing, body)].map(|listing| page(&listing));
        assert!(!by_height.contains("per wheel travel"), "that is the drive");
        let (by_height, by_damper) = (last_cells(&by_height, 4), last_cells(&by_damper, 8));
        assert_eq!(by_height.len(), by_damper.len());
        for (heights, dampers) in by_height.iter().zip(&by_damper) {
            assert_eq!(heights[..2], dampers[2..4], "{heights:?} {dampers:?}");
            assert_eq!(heights[2..], dampers[6..], "{heights:?} {dampers:?}");
        }
        assert!(by_height.len() > 20, "{by_height:?}");
    }
}
