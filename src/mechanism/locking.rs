//! Whether a motion that stops does so because a drive turns.

use nalgebra::SVector;
use suspension_core::path::{Continuation, Curve};
use suspension_core::{Inputs, Linkage, Still, Values};

/// Steps within which the turning point must lie: the motion has stopped beside it.
const STEPS: usize = 3;

/// How near a drive's value must be to that where it turns, as a part of itself or of one: the
/// tracker stops where the next step has shrunk to rounding.
const NEAR: f64 = 1e-9;

/// The number of the drive that turns where a motion has stopped; `None` where none does.
pub(super) fn turning_drive<L: Linkage<N, Scalar = f64>, const N: usize>(
    model: &L,
    inputs: &Inputs<Still, L::Drives>,
    position: &SVector<f64, N>,
) -> Option<usize> {
    let settings = Continuation {
        max_steps: STEPS,
        ..Continuation::default()
    };
    let mut drives = inputs.drives.value.values().enumerate();
    let turning = drives.find(|(index, value)| {
        let turns_there = |increasing| {
            let curve = Curve::new(model, inputs, *index)?;
            let path = settings.path(curve, position, increasing).ok()?;
            let turning = path.filter_map(|stretch| stretch.ok()?.turning).next()?;
            let apart = (turning.place.value - value).abs();
            (!turning.is_end_of_angle && apart <= NEAR * value.abs().max(1.0)).then_some(())
        };
        [true, false]
            .into_iter()
            .any(|way| turns_there(way).is_some())
    });
    turning.map(|(index, _)| index)
}
