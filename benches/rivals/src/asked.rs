//! The tasks of the general multibody engines in addition to a step, for our solver: the forces of four rods under a load at
//! rest, and the message past the lock.

use suspension_core::linkages::attia2003::Points;
use suspension_core::nalgebra::Vector3;
use suspension_core::statics::{Loads, spread};
use suspension_core::step::bounded::Bounded;
use suspension_core::{Linkage, SolveError, Tracker};

use crate::mechanism::inputs;
use crate::{Mechanism, Motion, STEP};

/// The load at the wheel centre, N.
const LOAD: Vector3<f64> = Vector3::new(0.0, 0.0, 3000.0);
/// The number of steps between two loads.
const STRIDE: usize = 100;
/// Steps that lead past the lock.
const PAST_LOCK: usize = 2100;

/// Forces of links 7-2, 8-3, 9-4 and 10-5, N, tension positive; `centres`: from point 6 to the wheel
/// centre at each of the loaded steps.
pub fn rods<'a>(
    mechanism: &'a Mechanism,
    centres: &'a [[f64; 3]],
) -> impl Iterator<Item = f64> + 'a {
    let loaded = mechanism.starts.iter().step_by(STRIDE).skip(1);
    loaded
        .zip(centres)
        .enumerate()
        .flat_map(|(index, (start, centre))| {
            let time = (STRIDE * (index + 1)) as f64 * STEP;
            let drives = inputs(time).drives.value;
            let (model, position) = (&mechanism.model, &start.motion.position);
            let points = model.points(position, model.fixed());
            let corners = [points.p6, points.p7, points.p8];
            let centre = points.p6 + Vector3::from(*centre);
            let [p6, p7, p8] = spread(corners, LOAD, centre, Vector3::zeros());
            let forces = Points {
                p6,
                p7,
                p8,
                ..Points::default()
            };
            let loads = Loads::new(model, drives, position, &forces).expect("regular");
            let multipliers = *loads.multipliers();
            (1..5).map(move |link| multipliers[link])
        })
}

/// Returns the message of each of our methods when it is driven past the lock.
pub fn past_lock(mechanism: &Mechanism) -> [(&'static str, String); 2] {
    let model = &mechanism.model;
    let tracker = Tracker::default();
    let bounded: Bounded<f64> = Bounded::default();
    let first = mechanism.starts[0].motion;
    [
        (
            "ours, to tolerance",
            said(first, |t, motion| {
                tracker.step(model, &inputs(t), STEP, motion).err()
            }),
        ),
        (
            "ours, bounded",
            said(first, |t, motion| {
                bounded.step(model, &inputs(t), STEP, motion).err()
            }),
        ),
    ]
}

/// The first error and its time, without its figures.
fn said(
    mut motion: Motion,
    mut step: impl FnMut(f64, &mut Motion) -> Option<SolveError<f64>>,
) -> String {
    let times = (1..=PAST_LOCK).map(|k| k as f64 * STEP);
    let mut errors = times.filter_map(|t| {
        let message = step(t, &mut motion)?.to_string();
        let (what, _) = message.split_once(':').unwrap_or((&message, ""));
        Some(format!("error at t = {t:.3} s: {what}"))
    });
    errors.next().unwrap_or_else(|| "silent".to_owned())
}
