//! A mechanism solved about its own origin.
//!
//! Coordinates, and results computed from them, are rounded in proportion to their size. Four metres
//! from the origin, where vehicle axes often are, `f32` resolves 2.4e-7 m; within a suspension it resolves 1.5e-8 m.
//! A [`LocalOrigin`] among the points converts all inputs to local coordinates; rates, angles,
//! lengths and differences are the same in both.
//!
//! Conversion to local coordinates does not undo earlier rounding. For `f32`, convert the hardpoints
//! in `f64`. It is enough to round them after that; it is better to compute the model in `f64` too and to round each of
//! its numbers once ([`Listing::rounded`](crate::Listing::rounded)). The largest errors of `f32`
//! over the published motion of [`five_link`](crate::linkages::five_link), to tolerance or
//! bounded (`tests/long_running/f32.rs`), are:
//!
//! | model in `f32` | free points | wheel centre | toe |
//! | --- | --- | --- | --- |
//! | from hardpoints rounded in vehicle axes, 2.7 m away | 6.3e-7 m | 4.7e-7 m | 8.6e-6 rad |
//! | from local hardpoints rounded | 2.6e-7 m | 1.9e-7 m | 1.9e-6 rad |
//! | computed in `f64` from local hardpoints, then rounded | 2.4e-7 m | 1.5e-7 m | 1.1e-6 rad |
//!
//! In general the error of a position is at most the norm of the Jacobian's inverse times `EPSILON`
//! times the largest coordinate or length. A knuckle stated as a `body` keeps that norm small; stated
//! as nine distances (`attia2003`) it is larger by a factor of six.
//!
//! ```
//! use suspension_core::linkages::five_link::{self, Drives, Model};
//! use suspension_core::nalgebra::Vector3;
//! use suspension_core::{Bounded, Build, Inputs, Linkage, Listing, Motion, Signal, Values};
//! use suspension_core::model::local::LocalOrigin;
//! # let at = |x: f64, y, z| Vector3::new(x + 4.0, y, z);
//! # let design = five_link::Points {
//! #     lower_front_inner: at(-1.396, -0.025, -0.082), upper_front_inner: at(-1.301, 0.1168, 0.106),
//! #     upper_rear_inner: at(-1.0941, 0.1987, 0.09), lower_rear_inner: at(-0.9838, 0.2609, -0.0501),
//! #     track_rod_inner: at(-1.095, 0.183, -0.0158), lower_front_outer: at(-1.315, 0.400, 0.027),
//! #     upper_front_outer: at(-1.302, 0.383, 0.240), upper_rear_outer: at(-1.270, 0.315, 0.218),
//! #     lower_rear_outer: at(-1.292, 0.309, -0.005), track_rod_outer: at(-1.188, 0.418, 0.167),
//! #     wheel_centre: at(-1.270, 0.415, 0.218),
//! # };
//!
//! // On the desk: hardpoints in vehicle axes, in f64.
//! let origin = LocalOrigin::among(design.values());
//! let local = origin.to_local(&design);
//! let model = Model::new(&local)?;
//! let theta = model.drives_at(&local).theta;
//! let position = model.unknowns(&local);
//!
//! // On the controller: f32 throughout.
//! let model: Model<f32> = five_link::Listing::rounded(&model);
//! let mut motion = Motion::at_rest(position.map(|x| x as f32));
//! let still = Inputs::still(Signal { value: Drives { theta: theta as f32 }, ..Signal::default() });
//! Bounded::<f32>::default().step(&model, &still, 0.0, &mut motion)?;
//! let points = motion.points(&model, &still).value;
//! let in_vehicle_axes = origin.in_numbers::<f32>().from_local(&points);
//!
//! let off = points.wheel_centre.map(f64::from) - local.wheel_centre;
//! assert!(off.norm() < 3e-7);
//! assert_eq!(in_vehicle_axes.wheel_centre.x, design.wheel_centre.x as f32);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use nalgebra::Vector3;

use crate::arithmetic::scalar::Real;
use crate::linkage::{Build, Linkage, Values};
use crate::listing::{DriveKind, Kind, MeasureKind};
use crate::signal::Signal;

/// The smallest number of steps into which the extent of a mechanism is divided. The local origin is a multiple of
/// the step, less than one step from the middle.
const STEPS: f64 = 4.0;

/// The origin of local coordinates, whose axes are parallel to the given ones.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LocalOrigin<T: Real>(Vector3<T>);

impl<T: Real> LocalOrigin<T> {
    /// An origin near the middle of the points, to within a part of their extent; zero if one of the points is not
    /// finite.
    ///
    /// It is a multiple of a power of two, so points lose nothing when they are converted to it and back, except
    /// digits below the last that numbers of the mechanism's size have.
    pub fn among(points: impl IntoIterator<Item = Vector3<T>>) -> Self {
        let is_finite = |point: &Vector3<T>| point.iter().all(|x| x.is_finite());
        let mut extent: Option<[Vector3<T>; 2]> = None;
        for point in points {
            if !is_finite(&point) {
                return Self(Vector3::zeros());
            }
            let [low, high] = extent.unwrap_or([point; 2]);
            extent = Some([low.inf(&point), high.sup(&point)]);
        }
        let Some([low, high]) = extent else {
            return Self(Vector3::zeros());
        };
        let step = ((high - low).amax() / T::constant(STEPS))
            .log2()
            .floor()
            .exp2();
        let middle = low + (high - low) * T::constant(0.5);
        let origin = middle.map(|x| (x / step).round() * step);
        Self(if is_finite(&origin) {
            origin
        } else {
            Vector3::zeros()
        })
    }

    /// The local origin in given coordinates.
    pub fn position(&self) -> Vector3<T> {
        self.0
    }

    /// Points in local coordinates, from given ones.
    pub fn to_local<P: Values<Vector3<T>>>(&self, points: &P) -> P {
        points.map(|point| point - self.0)
    }

    /// Points in given coordinates, from local ones.
    pub fn from_local<P: Values<Vector3<T>>>(&self, points: &P) -> P {
        points.map(|point| point + self.0)
    }

    /// The offset of each drive, to be subtracted from a given value and added to a value that is read: the local
    /// origin's coordinate if the drive is a coordinate of a point, otherwise zero.
    pub fn of_drives<L: Build<N, Scalar = T>, const N: usize>(&self, linkage: &L) -> L::Drives {
        let values = linkage.drives_at(&self.everywhere());
        let each = values.values().take(linkage.count(Kind::Drive));
        L::Drives::from_values(each.enumerate().map(
            |(drive, value)| match linkage.drive_kind(drive) {
                DriveKind::Coordinate => value,
                DriveKind::Angle | DriveKind::Turn => T::zero(),
            },
        ))
    }

    /// The offset of each measure, to be added to the measure of local points: see [`of_drives`](Self::of_drives).
    pub fn of_measures<L: Linkage<N, Scalar = T>, const N: usize>(
        &self,
        linkage: &L,
    ) -> L::Measures {
        let points = Signal {
            value: self.everywhere(),
            rate: self.everywhere(),
            second_rate: self.everywhere(),
        };
        let values = linkage.measures(&points).value;
        let each = values.values().take(linkage.count(Kind::Measure));
        L::Measures::from_values(each.enumerate().map(|(measure, value)| {
            match linkage.measure_kind(measure) {
                MeasureKind::Length => value,
                MeasureKind::Angle => T::zero(),
            }
        }))
    }

    /// All points at the local origin, where every direction, length and difference vanishes.
    fn everywhere<P: Values<Vector3<T>>>(&self) -> P {
        P::from_values(core::iter::repeat(self.0))
    }
}

impl LocalOrigin<f64> {
    /// The same origin in another number type: in `f32` too it has all its digits, within a million extents of the
    /// mechanism.
    pub fn in_numbers<T: Real>(&self) -> LocalOrigin<T> {
        LocalOrigin(self.0.map(T::constant))
    }
}
