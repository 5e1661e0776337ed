//! A mirrored listing is the one that states both sides.

mod mistakes;
mod neither_side;

use std::collections::BTreeMap;

use suspension_listing::form::Form;
use suspension_listing::include::NoIncludes;
use suspension_listing::system::{Point, System};
use suspension_listing::text;

use super::catalogue_system;

const HALF: &str = "
mirror: left -> right;
fixed: left_front at [0.2, 0.35, 0.16], left_rear at [-0.2, 0.35, -0.0], rack_left, middle at [0.0, 0.0, 0.5];
free:  left at [0.0, 0.7, 0.2], tie_left at [0.1, -0.1, 0.2], bar;
hinge arm_left: left_front, left_rear -> left, tie_left;
link left_rod: rack_left -> bar;
link stay: middle -> bar;
drive left_bump: left along [0.0, 0.6, 0.8];
drive steer: rack_left.y;
/// The length of a spring.
measure left_spring: length(middle -> left_hub);
point left_hub: arm_left at [0.0, 0.8, 0.3];
point left_inner: arm_left at [0.1, -0.2, 0.3];
measure left_skew: left along [0.1, -0.9, 0.2];
wheel left: left_hub -> left;
kingpin left: middle -> left;
";

const WHOLE: &str = "
fixed: left_front at [0.2, 0.35, 0.16], left_rear at [-0.2, 0.35, -0.0], rack_left, middle at [0.0, 0.0, 0.5];
fixed: right_front at [0.2, -0.35, 0.16], right_rear at [-0.2, -0.35, -0.0], rack_right;
free:  left at [0.0, 0.7, 0.2], tie_left at [0.1, -0.1, 0.2], bar;
free:  right at [0.0, -0.7, 0.2], tie_right at [0.1, 0.1, 0.2];
hinge arm_left: left_front, left_rear -> left, tie_left;
hinge arm_right: right_front, right_rear -> right, tie_right;
link left_rod: rack_left -> bar;
link right_rod: rack_right -> bar;
link stay: middle -> bar;
drive left_bump: left along [0.0, 0.6, 0.8];
drive right_bump: right along [0.0, -0.6, 0.8];
drive steer: rack_left.y;
measure left_spring: length(middle -> left_hub);
measure right_spring: length(middle -> right_hub);
measure left_skew: left along [0.1, -0.9, 0.2];
measure right_skew: right along [0.1, 0.9, 0.2];
point left_hub: arm_left at [0.0, 0.8, 0.3];
point right_hub: arm_right at [0.0, -0.8, 0.3];
point left_inner: arm_left at [0.1, -0.2, 0.3];
point right_inner: arm_right at [0.1, 0.2, 0.3];
wheel left: left_hub -> left;
wheel right: right_hub -> right;
kingpin right: middle -> right;
kingpin left: middle -> left;
";

fn positions(points: &[Point]) -> BTreeMap<String, Option<[f64; 3]>> {
    let each = points.iter();
    each.map(|point| (point.named.name.to_string(), point.at))
        .collect()
}

/// What each equation, drive and measure is, by its name.
fn parts(system: &System) -> BTreeMap<String, String> {
    let points = |form: &Form| {
        let sites = form.equations().sites().into_iter();
        sites.map(|site| site.name.to_string()).collect::<Vec<_>>()
    };
    let equations = system.equations.iter().map(|equation| {
        let name = equation.named.name.to_string();
        (name, format!("{:?}", points(&equation.form)))
    });
    let drives = system.drives.iter();
    let drives = drives.map(|drive| {
        (
            format!("drive {}", drive.named.name),
            format!("{:?}", drive.quantity),
        )
    });
    let measures = system.measures.iter();
    let measures = measures.map(|measure| {
        (
            format!("measure {}", measure.named.name),
            format!("{:?}", measure.quantity),
        )
    });
    let markers = system.markers.iter();
    let markers = markers.map(|marker| {
        (
            format!("marker {}", marker.named.name),
            format!("{:?}", marker.at),
        )
    });
    let wheels = system.wheels.iter();
    let wheels = wheels.map(|wheel| {
        let name = wheel.name.as_ref().map(ToString::to_string);
        let points = (&wheel.axis, &wheel.carrier, &wheel.kingpin);
        (
            format!("wheel {}", name.unwrap_or_default()),
            format!("{points:?}"),
        )
    });
    equations
        .chain(wheels)
        .chain(drives)
        .chain(measures)
        .chain(markers)
        .collect()
}

#[test]
fn a_mirrored_half_equals_the_listing_of_both_sides() {
    let [half, whole] =
        [HALF, WHOLE].map(|text| text::parse(text, "axle", &NoIncludes).expect("an axle"));
    assert_eq!(positions(&half.fixed), positions(&whole.fixed));
    assert_eq!(positions(&half.free), positions(&whole.free));
    assert_eq!(parts(&half), parts(&whole));
    let markers = |system: &System| -> BTreeMap<String, Option<[f64; 3]>> {
        let each = system.markers.iter();
        each.map(|marker| (marker.named.name.to_string(), marker.at))
            .collect()
    };
    assert_eq!(markers(&half), markers(&whole));
    let springs = half.measures.iter();
    let springs = springs.filter(|measure| measure.named.name.to_string().ends_with("spring"));
    let springs = springs.map(|measure| &measure.named.docs);
    assert!(
        springs.clone().count() == 2
            && springs
                .into_iter()
                .all(|docs| docs == &[" The length of a spring."])
    );
}

#[test]
fn an_axle_of_the_catalogue_has_both_sides() {
    let axle = catalogue_system("steered_axle");
    let drives = axle.drives.iter().map(|drive| drive.named.name.to_string());
    assert_eq!(
        drives.collect::<Vec<_>>(),
        ["steer", "bump_left", "bump_right"]
    );
    assert_eq!(axle.size(), 32);
}
