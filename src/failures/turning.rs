//! Turning points of the first drive, found by driving it to its locks.

use std::f64::consts::PI;

use suspension_core::{DriveKind, Motion, Named};

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
    /// The motion there, driven at [`speed`](Self::speed).
    origin: Motion<f64, N>,
}

/// The turning points at which the first drive locks, either way from the middle of the motion,
/// other drives held.
pub fn turning_points<L: Suspension<N>, const N: usize>(
    truth: &Truth<'_, L, N>,
) -> Vec<TurningPoint<N>> {
    let middle = (truth.ends[0] + truth.ends[1]) / 2.0;
    let motion = truth.at(middle);
    let drives = |t: f64| truth.drives.inputs::<L::Drives>(t).drives.value;
    let values: Vec<f64> = drives(middle).values().collect();
    let ends = truth
        .ends
        .map(|t| drives(t).values().next().unwrap_or_default());
    let mean = (ends[1] - ends[0]).abs() / truth.duration();
    let found = [mean, -mean].map(|speed| {
        let way = TurningPoint {
            value: f64::NAN,
            speed,
            values: values.clone(),
            origin: motion,
        };
        way.located(truth.model)
    });
    found.into_iter().flatten().collect()
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

    fn located<L: Suspension<N>>(mut self, model: &L) -> Option<Self> {
        /// The drive's angle where its cosine turns, not the mechanism.
        const NEAR: f64 = 1e-3;
        let is_angle = L::DRIVE_KINDS.first() == Some(&DriveKind::Angle);
        let farthest = match (is_angle, self.speed > 0.0) {
            (true, true) => PI,
            (true, false) => 0.0,
            (false, _) => self.values[0] + self.speed.signum() * 4.0 * model.size(),
        };
        self.value = self.lock(model, farthest)?;
        let is_own = is_angle && (self.value - farthest).abs() < NEAR;
        if is_own {
            return None;
        }
        self.value = self.refined(model)?;
        Some(self)
    }

    /// Where the drive locks on its way to `farthest`, to about 12 digits.
    fn lock<L: Suspension<N>>(&self, model: &L, farthest: f64) -> Option<f64> {
        if self.speed == 0.0 {
            return None;
        }
        let started = (self.values[0] - farthest) / self.speed;
        let mut motion = self.origin;
        let drives = self.drives(farthest);
        follow(model, &drives, [started, started], &mut motion).ok()?;
        let stopped = follow(model, &drives, [started, 0.0], &mut motion).err()?;
        Some(farthest + self.speed * stopped.reached)
    }

    /// The same to all digits: `x = qdot speed / (2 qddot)` up to `sqrt(x)` of itself, in the
    /// notation of [`separation`](Self::separation).
    fn refined<L: Suspension<N>>(&self, model: &L) -> Option<f64> {
        const BEFORE: f64 = 1e-10;
        let end = self.before(BEFORE);
        let motion = self.motion_at(model, end)?;
        let fastest = motion.acceleration.iamax();
        let (rate, second) = (motion.velocity[fastest], motion.acceleration[fastest]);
        Some(end + self.speed * rate / (2.0 * second))
    }
}
