//! The drawing of a mechanism at its first instant.

use suspension_core::Values;
use suspension_runtime::Listing;

use super::{Drawing, Wheel};
use crate::mechanism::{Mechanism, Suspension};

/// A mechanism of a listing at its first instant; without a wheel radius with that of the file, or else 0.3 m.
pub fn drawing_of<L: Suspension<N>, const N: usize>(
    mechanism: &Mechanism<L, N>,
    listing: &Listing,
    wheel_radius: Option<f64>,
) -> Drawing {
    let Mechanism { names, unit, .. } = mechanism;
    let inputs = mechanism.drives.inputs(mechanism.instants.ends()[0]);
    let points = mechanism.start.points(&mechanism.model, &inputs).value;
    let radius = wheel_radius.or(names.vehicle.wheel_radius);
    let origin = mechanism.origin.position();
    let at = points.values().map(|point| (point + origin).into());
    Drawing {
        points: names.points.iter().cloned().zip(at).collect(),
        chassis: names.chassis,
        links: listing.links(),
        slides: listing.slides(),
        lengths: listing.measured_lengths(),
        bodies: listing.bodies(),
        wheel: names.wheel.map(|wheel| Wheel {
            axis: wheel.axis,
            radius: radius.unwrap_or(0.3 * unit.metre()),
        }),
        kingpin: names.kingpin,
        others: Vec::new(),
        unit: unit.symbol(),
    }
}
