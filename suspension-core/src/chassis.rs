//! A chassis in rigid motion.
//!
//! A simulator usually solves the linkage in chassis axes, where the chassis points are at rest
//! ([`Still`](crate::Still)), and transforms the result to world axes ([`RigidMotion::carry`]).
//! This is the cheapest way and keeps coordinates small. The other way, with chassis points that move
//! in world axes ([`RigidMotion::anchors`] as inputs), gives the same motion; drives then
//! prescribe world coordinates.
//!
//! ```
//! use suspension_core::chassis::RigidMotion;
//! use suspension_core::linkages::double_wishbone::{Corner, Drives};
//! use suspension_core::nalgebra::{Isometry3, Vector3};
//! use suspension_core::{Inputs, Linkage, Signal, Tracker};
//!
//! // Straight ahead at 20 m/s.
//! let chassis = |time: f64| RigidMotion {
//!     pose: Isometry3::translation(20.0 * time, 0.0, 0.0),
//!     velocity: Vector3::new(20.0, 0.0, 0.0),
//!     omega: Vector3::zeros(),
//!     acceleration: Vector3::zeros(),
//!     alpha: Vector3::zeros(),
//! };
//! let design: Corner = Corner::design()?;
//! let rate = Drives { bump: 0.2, steer: 0.0 };
//! let drives = |time| Signal::line(design.drives(), rate, time);
//!
//! let mut corner = design;
//! corner.advance(0.1, drives)?;
//! let carried = chassis(0.1).carry(corner.points().map(|points| points.wheel_centre));
//!
//! let model = design.model();
//! let inputs = |time| Inputs { chassis: chassis(time).anchors(model.fixed()), drives: drives(time) };
//! let (tracker, mut motion) = (Tracker::default(), *design.motion());
//! tracker.step(model, &inputs(0.0), 0.0, &mut motion)?; // finds the rates
//! tracker.advance(model, inputs, 0.0, 0.1, &mut motion)?;
//! let in_world = motion.points(model, &inputs(0.1)).map(|points| points.wheel_centre);
//!
//! assert!((carried.value - in_world.value).norm() < 1e-14);
//! assert!((carried.rate - in_world.rate).norm() < 1e-13);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use nalgebra::{Isometry3, Vector3};

use crate::arithmetic::scalar::Real;
use crate::linkage::Values;
use crate::signal::Signal;

/// Pose, velocity and acceleration of a rigid body, all in world axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RigidMotion<T: Real> {
    /// The transformation from body axes to world axes.
    pub pose: Isometry3<T>,
    /// Velocity of the body's origin, per second.
    pub velocity: Vector3<T>,
    /// Angular velocity, rad/s.
    pub omega: Vector3<T>,
    /// Acceleration of the body's origin, per second squared.
    pub acceleration: Vector3<T>,
    /// Angular acceleration, rad/s^2.
    pub alpha: Vector3<T>,
}

impl<T: Real> RigidMotion<T> {
    /// Transforms a point that moves in body axes to world axes.
    pub fn carry(&self, point: Signal<Vector3<T>>) -> Signal<Vector3<T>> {
        let [r, v, a] =
            [point.value, point.rate, point.second_rate].map(|x| self.pose.rotation * x);
        let turning = self.omega.cross(&r);
        let coriolis = self.omega.cross(&v) * T::constant(2.0);
        Signal {
            value: self.pose.translation.vector + r,
            rate: self.velocity + turning + v,
            second_rate: self.acceleration
                + self.alpha.cross(&r)
                + self.omega.cross(&turning)
                + coriolis
                + a,
        }
    }

    /// Chassis points at rest in body axes, as inputs of a linkage that is solved in world axes.
    pub fn anchors<F: Values<Vector3<T>>>(&self, at_rest: &F) -> Signal<F> {
        let carry = |point| {
            self.carry(Signal {
                value: point,
                rate: Vector3::zeros(),
                second_rate: Vector3::zeros(),
            })
        };
        Signal {
            value: at_rest.map(|point| carry(point).value),
            rate: at_rest.map(|point| carry(point).rate),
            second_rate: at_rest.map(|point| carry(point).second_rate),
        }
    }
}
