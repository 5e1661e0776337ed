//! The drawing of a mechanism at its first instant.

use suspension_runtime::Listing;

use super::rack::racks;
use super::{Drawing, Wheel};
use crate::kinematics::Kinematics;
use crate::mechanism::{self, Description};

/// Returns the drawing of a mechanism at its first instant. The wheel radius is `radius`, or else that of the file, or else
/// 0.3 m.
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
        radius: wheel_radius.or(wheel.radius).unwrap_or(0.3 * unit.metre()),
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
        bodies: listing.bodies(),
        wheels: names.wheels.iter().map(of_wheel).collect(),
        others: Vec::new(),
        forces: None,
        unit: unit.symbol(),
    }
}
