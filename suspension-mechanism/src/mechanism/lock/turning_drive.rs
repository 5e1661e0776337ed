//! The drive that turns where a motion has stopped.

use nalgebra::SVector;
use suspension_core::path::{Continuation, Curve};
use suspension_core::{Inputs, Signal, Still, Values};

use crate::mechanism::lock::at_drives::AtDrives;
use crate::mechanism::suspension::Suspension;

/// The number of steps within which the turning point must lie: the motion has stopped beside it.
const STEPS: usize = 3;

/// How near a drive's value must be to the value where it turns, as a fraction of itself or of one: the tracker stops
/// when the next step has shrunk to rounding.
const NEAR: f64 = 1e-9;

/// Whether a drive's value is another one, as far as a tracker that stops there can tell.
pub(crate) fn is_near(here: f64, there: f64) -> bool {
    (there - here).abs() <= NEAR * here.abs().max(1.0)
}

/// The number of the drive that turns where a motion has stopped; `None` if none does. If one locks, all others do too: the
/// one that leads most into the lock is named before the others.
pub(crate) fn turning_drive<L: Suspension<N>, const N: usize>(
    model: &L,
    inputs: &Inputs<Still, L::Drives>,
    position: &SVector<f64, N>,
) -> Option<usize> {
    let settings = Continuation {
        max_steps: STEPS,
        ..Continuation::default()
    };
    let turns_there = |index: usize, value: f64, increasing: bool| {
        let curve = Curve::new(model, inputs, index)?;
        let mut path = settings.path(curve, position, increasing).ok()?;
        let turning = path.find_map(|stretch| stretch.ok()?.turning)?;
        (!turning.is_end_of_angle && is_near(value, turning.place.value)).then_some(())
    };
    let leads = leads(model, inputs, position);
    let mut drives: Vec<(usize, f64)> = inputs.drives.value.values().enumerate().collect();
    drives.sort_by(|(a, _), (b, _)| leads[*b].total_cmp(&leads[*a]));
    let turning = drives.into_iter().find(|(index, value)| {
        let mut ways = [true, false].into_iter();
        ways.any(|way| turns_there(*index, *value, way).is_some())
    });
    turning.map(|(index, _)| index)
}

/// How much the rate of each drive leads into a lock, `|f^T dF/ds s'|` with `f^T J = 0`: no motion of the unknowns makes up for
/// this part of the move.
fn leads<L: Suspension<N>, const N: usize>(
    model: &L,
    inputs: &Inputs<Still, L::Drives>,
    position: &SVector<f64, N>,
) -> Vec<f64> {
    /// The time over which the equations change, s.
    const BESIDE: f64 = 1e-6;
    let lock = AtDrives::new(model, inputs).analyse_lock(position);
    let forces = lock.map_or_else(SVector::zeros, |lock| lock.forces);
    let value = inputs.drives.value;
    let each = value.values().zip(inputs.drives.rate.values()).enumerate();
    let leads = each.map(|(drive, (at, rate))| {
        let work = |time: f64| {
            let drives = Signal::still(value.with(drive, at + rate * time));
            forces.dot(&AtDrives::new(model, &Inputs::still(drives)).residual(position))
        };
        (work(BESIDE) - work(-BESIDE)).abs()
    });
    leads.collect()
}
