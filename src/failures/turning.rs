//! Turning points of the first drive.

use suspension_core::path::{Continuation, Curve};
use suspension_core::{Motion, Named};

use super::truth::Truth;
use crate::input::drives::DriveLaws;
use crate::input::polynomial::Polynomial;
use crate::study::{Suspension, follow};

/// A turning point, and the way there.
#[derive(Clone, Debug)]
pub struct TurningPoint<const N: usize> {
    /// The first drive's value there, in its unit.
    pub value: f64,
    /// The speed at which the drive is moved there, in its unit per second; negative where it
    /// falls.
    pub speed: f64,
    /// All drives' values half-way through the file's motion.
    values: Vec<f64>,
    /// The motion there.
    origin: Motion<f64, N>,
}

/// The turning points at which the first drive locks, either way from the middle of the motion,
/// other drives held.
pub fn turning_points<L: Suspension<N>, const N: usize>(
    truth: &Truth<'_, L, N>,
) -> Vec<TurningPoint<N>> {
    let middle = (truth.ends[0] + truth.ends[1]) / 2.0;
    let motion = truth.at(middle);
    let inputs = truth.drives.inputs::<L::Drives>(middle);
    let values: Vec<f64> = inputs.drives.value.values().collect();
    let speed = usual_speed(truth);
    let found = [speed, -speed].map(|speed| {
        let curve = Curve::new(truth.model, &inputs, 0)?;
        let path = Continuation::default().path(curve, &motion.position, speed > 0.0);
        let turning = path.ok()?.flatten().find_map(|stretch| stretch.turning)?;
        let is_lock = !turning.is_end_of_angle && speed != 0.0;
        is_lock.then(|| TurningPoint {
            value: turning.place.value,
            speed,
            values: values.clone(),
            origin: motion,
        })
    });
    found.into_iter().flatten().collect()
}

/// The first drive's range in the motion over its duration.
fn usual_speed<L: Suspension<N>, const N: usize>(truth: &Truth<'_, L, N>) -> f64 {
    let first = |t: f64| {
        let drives: L::Drives = truth.drives.inputs(t).drives.value;
        drives.values().next().unwrap_or_default()
    };
    let values = truth.times().map(first);
    let [least, most] = values.fold(
        [f64::INFINITY, f64::NEG_INFINITY],
        |[least, most], value| [least.min(value), most.max(value)],
    );
    (most - least) / truth.duration()
}

impl<const N: usize> TurningPoint<N> {
    /// The drives that reach the value `end` of the first one at time 0.
    pub fn drives(&self, end: f64) -> DriveLaws {
        let others = self.values.iter().skip(1);
        let moving = Polynomial::new(vec![end, self.speed]);
        let held = others.map(|value| Polynomial::new(vec![*value]));
        DriveLaws::new(std::iter::once(moving).chain(held))
    }

    /// The drive's value at a distance before the lock.
    pub fn before(&self, distance: f64) -> f64 {
        self.value - self.speed.signum() * distance
    }

    /// The motion in which the first drive has the value `end`; `None` beyond the lock.
    pub fn motion_at<L: Suspension<N>>(&self, model: &L, end: f64) -> Option<Motion<f64, N>> {
        let started = (self.values[0] - end) / self.speed;
        let mut motion = self.origin;
        let drives = self.drives(end);
        follow(model, &drives, [started, started], &mut motion).ok()?;
        follow(model, &drives, [started, 0.0], &mut motion).ok()?;
        Some(motion)
    }

    /// How far apart the two configurations are that meet in the turning point, where the drive
    /// is still `distance` away and `motion` is one of them.
    ///
    /// With `x` the distance, `q = q* + a sqrt(x)` up to terms of higher order, so that
    /// `qdot = -a speed / (2 sqrt(x))`, and the two are `2 a sqrt(x)` apart.
    pub fn separation(&self, distance: f64, motion: &Motion<f64, N>) -> f64 {
        4.0 * distance * motion.velocity.amax() / self.speed.abs()
    }
}
