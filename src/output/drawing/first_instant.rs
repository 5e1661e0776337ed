//! The drawing of a mechanism at its first instant.

use suspension_runtime::Listing;

use super::rack::racks;
use super::{Drawing, Wheel};
use crate::kinematics::Kinematics;
use crate::mechanism::{self, Description, Unit};

/// The radius of a drawn wheel whose file states none, in the unit of the file: 0.3 m.
pub fn usual_radius(unit: Unit) -> f64 {
    0.3 * unit.metre()
}

/// Returns the drawing of a mechanism at its first instant. The wheel radius is `radius`, or else that of the file, or else
/// the usual one.
pub fn drawing_of(
    mechanism: &dyn Kinematics,
    listing: &Listing,
    wheel_radius: Option<f64>,
) -> Drawing {
    let Description {
        names, unit, axes, ..
    } = &**mechanism;
    let of_wheel = |wheel: &mechanism::Wheel| Wheel {
        axis: wheel.points.axis,
        kingpin: wheel.points.kingpin,
        radius: wheel_radius.or(wheel.radius).unwrap_or(usual_radius(*unit)),
    };
    Drawing {
        names: names.points.clone(),
        points: mechanism.points(),
        axes: *axes,
        chassis: names.chassis,
        links: listing.links(),
        racks: racks(mechanism),
        slides: listing.slides(),
        lengths: listing.driven_and_measured_lengths(),
        bars: listing.measured_turns(),
        bodies: bodies(listing),
        wheels: names.wheels.iter().map(of_wheel).collect(),
        others: Vec::new(),
        forces: None,
        unit: unit.symbol(),
    }
}

/// Returns the points of each body, with those of its markers at which a measured line ends: the outline of an arm contains
/// the end of its damper.
fn bodies(listing: &Listing) -> Vec<Vec<usize>> {
    let lengths = listing.driven_and_measured_lengths();
    let lines = [lengths, listing.measured_turns()].concat();
    let ends = lines.as_flattened();
    let mut bodies = listing.bodies();
    for (marker, frame) in listing.carriers() {
        let carries = |body: &&mut Vec<usize>| frame.iter().all(|point| body.contains(point));
        if let Some(body) = bodies
            .iter_mut()
            .find(carries)
            .filter(|_| ends.contains(&marker))
        {
            body.push(marker);
        }
    }
    bodies
}
