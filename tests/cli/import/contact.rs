//! The wheel's radius of a table that has the contact point instead.

use super::super::program::folder;
use super::{CORNER, import, table};

/// The wheel's radius in the motion file, and the notes.
fn radius(file: &str, options: &[&str]) -> (Option<f64>, String) {
    let folder = folder();
    let imported = import(folder.path(), "a.csv", file, options);
    let radius = imported.motion["vehicle"].get("wheel_radius");
    let radius = radius.and_then(toml::Value::as_float);
    (radius, imported.notes)
}

#[test]
fn a_contact_point_gives_the_radius_of_the_wheel() {
    for name in [
        "Contact patch",
        "Tyre contact point",
        "Wheel centre (contact patch)",
        "Radaufstandspunkt",
    ] {
        let file = format!("{}{name}, 3, -618, 2\n", table(&CORNER));
        for options in [&[][..], &["--axle"], &["--side", "right"]] {
            let (found, notes) = radius(&file, options);
            // 3, 8 and 227 mm from the wheel centre.
            assert_eq!(found, Some(227.160_736), "{name}: {notes}");
            let from = "the wheel radius is the distance of `wheel_center` from";
            assert_eq!(notes.matches(from).count(), 1, "{notes}");
            assert!(notes.contains("(a.csv:16)\n"), "{notes}");
            assert!(!notes.contains("not used"), "{notes}");
        }
    }
}

#[test]
fn a_stated_radius_or_a_point_elsewhere_leaves_the_contact_point_unused() {
    let stated = "Contact patch, 0, -610, 0\ntire_radius, 225\n";
    let (found, notes) = radius(&(table(&CORNER) + stated), &[]);
    assert_eq!(found, Some(225.0));
    assert!(notes.contains("not used: Contact patch\n"), "{notes}");
    for elsewhere in [
        "Bump stop contact, 0, -300, 210",
        "Contact patch, 0, -610, 458",
    ] {
        let (found, notes) = radius(&format!("{}{elsewhere}\n", table(&CORNER)), &[]);
        assert_eq!(found, None, "{notes}");
        assert!(notes.contains("the file has no tire_radius"), "{notes}");
    }
}
