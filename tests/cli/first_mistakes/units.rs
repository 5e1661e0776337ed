//! Points that are in another unit, or whose decimal point has slipped.

use super::super::program::{CORNER, folder, run, text};
use super::refusal;

/// A corner whose statements are those of the catalogue, with some points in the motion file.
fn corner_with(points: &str) -> String {
    format!("{CORNER}[points]\n{points}\n")
}

#[test]
fn a_point_in_another_unit_is_reported_first_at_its_place() {
    // The spin axis has no length: the marker coincides with the wheel centre.
    let flat = "axle = { from = \"wheel_centre\", offset = [0.0, 0.0, 0.0] }\n";
    let message = refusal(
        "motion",
        &[(
            "a.toml",
            &corner_with(&format!("{flat}lower_ball = [0.005, 700.0, 0.17]")),
        )],
        &[],
    );
    let first = "a.toml:10:14: `lower_ball` lies 699.3 m from the other points: is it in mm?\n";
    assert!(message.starts_with(first), "{message}");
    assert_eq!(message.lines().count(), 2, "{message}");
}

/// An axle in inches is as large in mm as a small corner, and a car as a small axle.
#[test]
fn an_axle_or_a_car_in_another_unit_is_noted() {
    let folder = folder();
    let listed = run(folder.path(), &["list", "live_axle_panhard"]);
    let axle = in_inches(text(&listed.stdout));
    std::fs::write(folder.path().join("axle.linkage"), axle).expect("written");
    let car =
        "include front: \"axle.linkage\";\ninclude rear: \"axle.linkage\" at [-102.0, 0.0, 0.0];\n";
    std::fs::write(folder.path().join("car.linkage"), car).expect("written");
    for (listing, ends) in [("axle", [""].as_slice()), ("car", &["front_", "rear_"])] {
        let lines = ends
            .iter()
            .flat_map(|end| ["left", "right"].map(|side| format!("{end}bump_{side} = 12.2\n")));
        let drives: String = lines.collect();
        let motion = format!(
            "listing = \"{listing}.linkage\"\nunit = \"mm\"\n[time]\ninstants = [0.0]\n[drives]\n{drives}"
        );
        std::fs::write(folder.path().join("a.toml"), motion).expect("written");
        let output = run(folder.path(), &["check", "a.toml"]);
        let expected = "mm apart: is the file in inches? (unit = \"in\")";
        assert!(text(&output.stdout).contains(expected), "{output:?}");
    }
}

/// A listing in metres with its points in inches.
fn in_inches(listing: &str) -> String {
    let mut parts = listing.split('[');
    let first = parts.next().unwrap_or_default().to_owned();
    parts.fold(first, |text, part| {
        let (point, rest) = part.split_once(']').expect("a bracket");
        let numbers = point.split(',').map(|number| {
            let number: f64 = number.trim().parse().expect("a number");
            format!("{:.4}", number / 0.0254)
        });
        let numbers = numbers.collect::<Vec<_>>().join(", ");
        text + "[" + &numbers + "]" + rest
    })
}

/// The image that `mirror` makes is as far off, and no further from the point than the sides are apart.
#[test]
fn a_mirrored_point_in_another_unit_is_noted() {
    let folder = folder();
    let file = "unit = \"m\"\ntime = { instants = [0.0] }\ndrives = { left_bump = 300.0, right_bump = 300.0 }\nstatements = '''\n\
                mirror: left -> right;\nfixed: left_a at [0.2, 0.3, 0.3], left_b at [-0.2, 0.3, 0.3];\n\
                free: left_hub at [0.0, 0.7, 300.0];\nhinge left_arm: left_a, left_b -> left_hub;\ndrive left_bump: left_hub.z;\n'''\n";
    std::fs::write(folder.path().join("a.toml"), file).expect("written");
    let output = run(folder.path(), &["motion", "a.toml"]);
    let expected = "`left_hub` lies 299.7 m from the other points: is it in mm?\n";
    assert!(text(&output.stderr).contains(expected), "{output:?}");
}

#[test]
fn a_buildable_point_in_another_unit_is_noted() {
    let folder = folder();
    for (points, expected) in [
        ("lower_ball = [0.005, 0.71, 0.17]", ""),
        (
            "damper_inner = [0.02, 120.0, 0.54]",
            "note: a.toml:9:16: `damper_inner` lies 119.3 m from the other points: is it in mm?\n",
        ),
        (
            "damper_inner = [0.02, 12.0, 0.54]",
            "note: a.toml:9:16: `damper_inner` lies 11.25 m from the other points: is it in inches?\n",
        ),
        (
            "damper_inner = [0.02, 0.32, 2.4]",
            "note: a.toml:9:16: `damper_inner` lies 1.8 m from the other points: should its z be 0.24 instead of 2.4?\n",
        ),
        (
            "damper_inner = [0.02, 850.0, 0.54]",
            "note: a.toml:9:16: `damper_inner` lies 849.3 m from the other points: is it in mm?\n",
        ),
        (
            "damper_inner = [0.02, 3.2, 0.54]",
            "note: a.toml:9:16: `damper_inner` lies 2.462 m from the other points: should its y be 0.32 instead of 3.2?\n",
        ),
    ] {
        std::fs::write(folder.path().join("a.toml"), corner_with(points)).expect("written");
        let output = run(folder.path(), &["motion", "a.toml"]);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        assert_eq!(text(&output.stderr), expected);
    }
}

/// A rack in metres in a file in mm assembles, with a tie rod that ends at the origin.
#[test]
fn a_point_in_a_larger_unit_is_noted_beside_the_origin() {
    let listing = |rack: &str| {
        format!(
            "fixed: lower at [0.0, 700.0, 200.0], upper at [-20.0, 660.0, 450.0], rack at {rack}, housing at [-100.0, 280.0, 180.0];\n\
             free: tie_ball at [-120.0, 640.0, 300.0], nose at [200.0, 680.0, 310.0];\nhinge knuckle: lower, upper -> tie_ball, nose;\n\
             link tie_rod: rack -> tie_ball;\ndrive steer: rack.y;\nmeasure length: length(rack -> housing);\n"
        )
    };
    let folder = folder();
    for (rack, steer, expected) in [
        ("[-118.0, 300.0, 290.0]", "300.0", ""),
        ("[0.2, 0.3, 900.0]", "0.3", ""),
        ("[0.0, 0.3, 0.29]", "0.3", ""),
        (
            "[-0.118, 0.3, 0.29]",
            "0.3",
            "`rack` lies 0.4336 mm from the origin: is it in m?\n",
        ),
    ] {
        let file = format!(
            "unit = \"mm\"\ntime = {{ instants = [0.0] }}\ndrives = {{ steer = {steer} }}\nstatements = '''\n{}'''\n",
            listing(rack)
        );
        std::fs::write(folder.path().join("a.toml"), file).expect("written");
        let output = run(folder.path(), &["motion", "a.toml"]);
        let notes = text(&output.stderr);
        assert_eq!(
            notes.contains("from the origin"),
            !expected.is_empty(),
            "{notes}"
        );
        assert!(notes.contains(expected), "{notes}");
    }
}
