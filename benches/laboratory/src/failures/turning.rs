//! Turning points of the first drive.

use suspension_core::listing::{DriveKind, Parts};
use suspension_core::path::{Continuation, Curve};
use suspension_core::{Motion, Newton, Real, Values};

use super::trial::Trial;
use super::truth::Truth;
use suspension::mechanism::{DriveLaws, Law, Suspension, follow};

/// A turning point, and the way there.
#[derive(Clone, Debug)]
pub struct TurningPoint<const N: usize> {
    /// The first drive's value there, in its unit.
    pub value: f64,
    /// The speed of the drive there, in its unit per second; negative if it falls.
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
    /// Returns the drives that reach the value `end` of the first one at time 0.
    pub fn drives(&self, end: f64) -> DriveLaws {
        let others = self.values.iter().skip(1);
        let moving = Law::Polynomial(vec![end, self.speed]);
        let held = others.map(|value| Law::Polynomial(vec![*value]));
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

    /// Returns whether a residual that counts as a root for numbers `T` still distinguishes the two configurations that meet
    /// here, when the drive is still `distance` away.
    pub fn is_apart<T: Real, L: Suspension<N>>(&self, model: &L, distance: f64) -> bool {
        distance > tolerated::<T, L, N>(model, &self.origin)
    }
}

/// A way to a turning point that ends at a distance before it.
pub struct Approach<'a, const N: usize> {
    point: &'a TurningPoint<N>,
    distance: f64,
    drives: DriveLaws,
}

impl<'a, const N: usize> Approach<'a, N> {
    /// Approaches at the point's own speed.
    pub fn new(point: &'a TurningPoint<N>, distance: f64) -> Self {
        let drives = point.drives(point.before(distance));
        Self {
            point,
            distance,
            drives,
        }
    }

    /// A step of `step` seconds. A result is right if its error is at most `within`, and it is nearer to the intended
    /// configuration than half-way to the configuration that meets it in the turning point.
    ///
    /// With `x` the distance, both are `a sqrt(x)` from there up to terms of higher order, so that `a sqrt(x) = 2 x |qdot| /
    /// speed`. A residual acts as a change of `x`: the permitted error grows by the change of position due to a residual
    /// that counts as a root for numbers `T`.
    pub fn trial<T: Real, L: Suspension<N>>(
        &self,
        model: &L,
        step: f64,
        within: f64,
    ) -> Option<Trial<'_, N>> {
        let Self {
            point,
            distance,
            drives,
        } = self;
        let end = point.before(*distance);
        let start = point.motion_at(model, end - point.speed * step)?;
        let last = point.motion_at(model, end)?;
        let half_way = 2.0 * distance * last.velocity.amax() / point.speed.abs();
        let residual = tolerated::<T, L, N>(model, &last);
        let moved = half_way * ((1.0 + residual / distance).sqrt() - 1.0);
        Some(Trial {
            drives,
            times: [-step, 0.0],
            start,
            meant: last.position,
            tolerance: half_way.min(within + moved),
        })
    }
}

/// The residual that counts as a root for numbers `T`, as a change of the first drive; a few of
/// them act together.
fn tolerated<T: Real, L: Suspension<N>, const N: usize>(model: &L, motion: &Motion<f64, N>) -> f64 {
    const FEW: f64 = 4.0;
    let size = model.size();
    let epsilon: f64 = T::EPSILON.to_subset_unchecked();
    let rounding = epsilon * size.max(motion.position.amax());
    let residual = FEW * Newton::<f64>::near_by().tolerance.length(rounding);
    match model.drive_kind(0) {
        DriveKind::Angle | DriveKind::Turn => residual / size,
        DriveKind::Coordinate => residual,
    }
}

/// Returns the unit of distances along the first drive, and its size in the unit of the motion.
pub fn unit_of_first_drive(model: &impl Parts, metre: f64) -> (&'static str, f64) {
    match model.drive_kind(0) {
        DriveKind::Angle | DriveKind::Turn => ("rad", 1.0),
        DriveKind::Coordinate => ("m", metre),
    }
}
