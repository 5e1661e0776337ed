//! Layouts with both sides in one listing.

use super::super::program::folder;
use super::import;

/// A live axle with a Panhard rod, x, y, z in inches; the points of the right side are images of those of the left one.
const PANHARD: [(&str, [f64; 3]); 14] = [
    ("Lower left front", [22.0, 14.0, 9.5]),
    ("Lower left rear", [2.0, 16.0, 8.2]),
    ("Left wheel center", [0.0, 29.0, 12.5]),
    ("Left shock upper", [-3.0, 14.0, 28.0]),
    ("Left shock lower", [-2.0, 17.0, 9.0]),
    ("Upper link chassis", [18.0, 0.0, 17.0]),
    ("Upper link axle", [1.0, 0.0, 18.5]),
    ("Panhard rod chassis", [-5.0, 18.0, 12.5]),
    ("Panhard rod axle", [-5.0, -17.0, 11.5]),
    ("Lower right front", [22.0, -14.0, 9.5]),
    ("Lower right rear", [2.0, -16.0, 8.2]),
    ("Right wheel center", [0.0, -29.0, 12.5]),
    ("Right shock upper", [-3.0, -14.0, 28.0]),
    ("Right shock lower", [-2.0, -17.0, 9.0]),
];

/// A table of these points in axes with these signs.
fn table(points: &[(&str, [f64; 3])], signs: [f64; 3]) -> String {
    let row = |(name, at): &(&str, [f64; 3])| {
        let [x, y, z] = [0, 1, 2].map(|axis| signs[axis] * at[axis]);
        format!("{name}, {x}, {y}, {z}\n")
    };
    points.iter().map(row).collect()
}

const ISO: [f64; 3] = [1.0, 1.0, 1.0];

#[test]
fn axes_are_deduced_from_the_left_side() {
    let folder = folder();
    let iso = import(folder.path(), "a.csv", &table(&PANHARD, ISO), &[]);
    for signs in [[1.0, -1.0, -1.0], [-1.0, -1.0, 1.0]] {
        let other = import(folder.path(), "a.csv", &table(&PANHARD, signs), &[]);
        assert_eq!(other.points(), iso.points(), "{}", other.notes);
    }
}

#[test]
fn a_missing_right_side_is_the_mirror_image_of_the_left_one() {
    let folder = folder();
    let [both, left] = [&PANHARD[..], &PANHARD[..9]]
        .map(|points| import(folder.path(), "a.csv", &table(points, ISO), &[]));
    assert_eq!(left.points(), both.points());
    let said = "does not have the points `lower_right_front`, `right_damper_upper`, `lower_right_rear`, `right_wheel_centre`, \
                `right_damper_lower`, each of which is placed as the mirror image of the left one";
    assert!(left.notes.contains(said), "{}", left.notes);
}

#[test]
fn a_right_point_that_is_not_the_mirror_image_of_its_twin_is_noted() {
    let folder = folder();
    let file = table(&PANHARD, ISO);
    let notes = import(folder.path(), "a.csv", &file, &[]).notes;
    assert!(!notes.contains("mirror images"), "{notes}");
    let slip = file.replace(
        "Right wheel center, 0, -29, 12.5",
        "Right wheel center, 0, -29, 125",
    );
    let notes = import(folder.path(), "a.csv", &slip, &[]).notes;
    let expected = "left and right are not mirror images, for example at `Right wheel center` (a.csv:12; z = 125, but 12.5 on the left)\n";
    assert!(notes.contains(expected), "{notes}");
}

#[test]
fn the_size_of_an_axle_has_no_exponent() {
    let millimetres = PANHARD.map(|(name, at)| (name, at.map(|x| 25.0 * x)));
    let notes = import(folder().path(), "a.csv", &table(&millimetres, ISO), &[]).notes;
    assert!(
        notes.contains("is mm, as the points are up to 1450 apart"),
        "{notes}"
    );
}

/// The spin axis of each wheel is placed from toe and camber, which are the same on both sides.
#[test]
fn spin_axes_of_a_twist_beam_are_mirror_images() {
    let folder = folder();
    let file = "left bush; 400; 520; 290\nleft wheel centre; 0; 740; 300\nleft outer; 150; 480; 320\nleft inner; 150; 40; 320\n\
                left damper lower; -60; 560; 240\nleft damper upper; 0; 540; 640\ntoe_angle; 0,5\ncamber_angle; -1,5\n";
    let imported = import(folder.path(), "a.csv", file, &[]);
    let of = |point: &str| {
        let place = &imported.motion["points"][point];
        assert_eq!(
            place["from"].as_str(),
            Some(&*point.replace("axle", "wheel_centre"))
        );
        [0, 1, 2].map(|axis| place["offset"][axis].as_float().expect("a number"))
    };
    let [[x, y, z], right] = [of("left_axle"), of("right_axle")];
    assert_eq!(right, [x, -y, z]);
    assert!(x < 0.0 && y < -99.0 && z < 0.0, "{x} {y} {z}");
}
