//! A mechanism of other hardpoints, or of other lengths.

use nalgebra::Vector3;
use suspension_core::{Inputs, Motion, Newton, Signal, Still, Values, assemble};

use crate::mechanism::{Description, DriveLaws, Mechanism, Suspension};

/// Built anew of the points where the mechanism starts, one of them moved.
pub(super) fn with_point_moved<L: Suspension<N>, const N: usize>(
    mechanism: &Mechanism<L, N>,
    point: usize,
    by: Vector3<f64>,
) -> Option<Mechanism<L, N>> {
    let points = points(mechanism);
    let moved = points.values().nth(point)? + by;
    let points = points.with(point, moved);
    let model = L::of(mechanism.model.listing(), &points).ok()?;
    let drives = model.drives_at(&points);
    at_rest(mechanism, model, &points, drives)
}

/// With a length changed, the drives as they are where the mechanism starts.
pub(super) fn with_length_changed<L: Suspension<N>, const N: usize>(
    mechanism: &Mechanism<L, N>,
    length: usize,
    by: f64,
) -> Option<Mechanism<L, N>> {
    let lengths = mechanism.model.lengths();
    let changed = lengths.values().nth(length)? + by;
    let points = points(mechanism);
    let model = L::of(mechanism.model.listing(), &points).ok()?;
    let model = model.with_lengths(&lengths.with(length, changed)).ok()?;
    let drives = L::Drives::from_values(mechanism.first_drives());
    at_rest(mechanism, model, &points, drives)
}

/// All points where the mechanism starts.
fn points<L: Suspension<N>, const N: usize>(mechanism: &Mechanism<L, N>) -> L::Points {
    let drives = L::Drives::from_values(mechanism.first_drives());
    let inputs: Inputs<Still, _> = Inputs::still(Signal::still(drives));
    mechanism.start.points(&mechanism.model, &inputs).value
}

/// The configuration nearest to some points.
fn at_rest<L: Suspension<N>, const N: usize>(
    mechanism: &Mechanism<L, N>,
    model: L,
    points: &L::Points,
    drives: L::Drives,
) -> Option<Mechanism<L, N>> {
    let mut position = model.unknowns(points);
    let inputs = Inputs::still(Signal::still(drives));
    assemble(&Newton::from_afar(), &model, &inputs, &mut position).ok()?;
    Some(Mechanism {
        description: Description {
            drives: DriveLaws::held(drives.values()),
            ..mechanism.description.clone()
        },
        model,
        start: Motion::at_rest(position),
        lead: None,
    })
}
