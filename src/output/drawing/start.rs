//! The drawing of a mechanism at its first instant.

use suspension_core::Values;
use suspension_runtime::Listing;

use super::{Disc, Drawing};
use crate::mechanism::{Mechanism, Suspension};

/// A mechanism of a listing at its first instant; without a wheel radius with that of the file, or else 0.3 m.
pub fn drawing_of<L: Suspension<N>, const N: usize>(
    mechanism: &Mechanism<L, N>,
    listing: &Listing,
    wheel_radius: Option<f64>,
) -> Drawing {
    let Mechanism { model, names, .. } = mechanism;
    let inputs = mechanism.drives.inputs(mechanism.instants.ends()[0]);
    let points = mechanism.start.points(model, &inputs).value;
    let disc = model.wheel_axis(&points).map(|[inner, centre]| Disc {
        centre: centre.into(),
        axis: (centre - inner).into(),
        radius: wheel_radius
            .or(names.vehicle.wheel_radius)
            .unwrap_or(0.3 * mechanism.unit.metre()),
    });
    let at = points.values().map(<[f64; 3]>::from);
    Drawing {
        points: names.points.iter().cloned().zip(at).collect(),
        chassis: names.chassis,
        links: listing.links(),
        slides: listing.slides(),
        lengths: listing.measured_lengths(),
        bodies: listing.bodies(),
        wheel: disc,
    }
}
