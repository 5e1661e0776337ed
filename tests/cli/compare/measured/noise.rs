//! Tables with the noise of a rig, and with another way back.

use super::super::rig::axle;
use super::super::{arm, rows};
use super::{beside, spring};

/// The table of a closed form at these places in mm, with a known offset and slope; it is 0.5 mm higher on the way there, lower
/// on the way back, and has noise.
fn there_and_back(places: impl Iterator<Item = i32> + Clone) -> String {
    let line = |(at, way): (i32, f64)| {
        let at = f64::from(at);
        let off = 2.0 + 0.004 * at + 0.5 * way + 0.3 * (17.0 * at + 1.0).sin();
        format!("{at:?},{:?}\n", 1000.0 * spring(at / 1000.0) + off)
    };
    let there = places.clone().map(|at| (at, 1.0));
    let back = places.map(|at| (at, -1.0));
    let lines: String = there.chain(back).map(line).collect();
    format!("bump [mm],spring [mm]\n{lines}")
}

/// The two lines at the design position, which have the same noise, would give 2.25 mm.
#[test]
fn the_offset_is_that_of_the_places_around_the_design_position() {
    let table = there_and_back(-100..101);
    let (_folder, output) = beside(&arm("m", 1.0, 0.4), &table, &["--csv", "-"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let found = rows(&output);
    let (names, [at, model, measured, offset]) = &found[1];
    assert_eq!(names[0], "offset");
    assert!(*at == 0.0 && (model - 1000.0 * spring(0.0)).abs() < 1e-9);
    assert!((offset - 2.0).abs() < 0.02, "{offset}");
    assert!((measured - model - offset).abs() < 1e-9);
}

/// A curve through the lines themselves has bends of 33 pixels.
#[test]
fn the_noise_of_the_rack_does_not_bend_the_curve_of_the_model() {
    let line = |line: i32| {
        let at = 50.0 * (0.05 * f64::from(line)).sin();
        let noise = 0.05 * (17.0 * f64::from(line)).sin();
        format!("{at:?},{at:?},{noise:?},0.0\n")
    };
    let lines: String = (0..252).map(line).collect();
    let heading = "left wheel travel [mm],right wheel travel [mm],steer [mm],left toe [deg]";
    let table = format!("{heading}\n{lines}");
    let (folder, output) = beside(&axle(), &table, &["--html", "c.html"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let page = std::fs::read_to_string(folder.path().join("c.html")).expect("a page");
    let lines = page.split("points=\"").skip(1);
    let lines = lines.filter_map(|rest| rest.split('"').next());
    let curve = lines.map(|points| points.split_whitespace().map(height).collect::<Vec<f64>>());
    let mut curves = curve.filter(|points| points.len() == 61);
    let curve = curves.next().expect("a curve");
    let bends = curve
        .windows(3)
        .map(|three| (three[0] - 2.0 * three[1] + three[2]).abs());
    // An eighth of a pixel is the unit of a page's drawings.
    let most = bends.fold(0.0, f64::max) / 8.0;
    assert!(most < 4.0, "{most}");
}

fn height(point: &str) -> f64 {
    let (_, height) = point.split_once(',').expect("two coordinates");
    height.parse().expect("a number")
}
