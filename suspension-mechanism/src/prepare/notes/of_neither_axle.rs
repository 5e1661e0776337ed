//! Wheels with a share of the brake or drive force whose axle is not known.

use crate::mechanism::{Wheel, quoted};
use crate::prepare::task::Task;

/// A note that these wheels have no anti-dive, anti-lift and anti-squat, as those of a third axle.
pub(in crate::prepare) fn note(task: &Task<'_>) -> Option<String> {
    let has_share = |wheel: &&Wheel| wheel.brake_share.is_some() || wheel.drive_share.is_some();
    let wheels = task.names.wheels.iter().filter(has_share);
    let without: Vec<&String> = wheels
        .filter(|wheel| wheel.axle.is_none())
        .map(|wheel| &wheel.name)
        .collect();
    (!without.is_empty()).then(|| {
        format!(
            "anti-dive, anti-lift and anti-squat are left out for {}, whose share of the force has no effect: they are \
             quantities of wheels that have `front` or `rear` in their names",
            quoted(without)
        )
    })
}
