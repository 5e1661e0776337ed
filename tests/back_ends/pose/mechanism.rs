//! The double wishbone with pushrod and rocker as rigid bodies: a hinge angle of each wishbone, of the rocker and of
//! the anti-roll bar, position and quaternion of the upright. Ball joints close the upright; tie rod, pushrod and drop
//! link are squared lengths.

use std::collections::HashMap;
use std::ops::Add;

use suspension_core::Signal;

use super::jet::{Jet, Vector};
use super::newton::{self, Coordinates, Equations, SIZE};

// The places of the coordinates.
const LOWER: usize = 0;
const UPPER: usize = 1;
const ROCKER: usize = 2;
const BAR: usize = 3;
const POSITION: usize = 4;
const QUATERNION: usize = 7;

/// The prescribed quantities: the height of the wheel centre, and the lateral position of the rack.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Drives<T> {
    pub(crate) bump: T,
    pub(crate) steer: T,
}

/// The mechanism at its design position: its points by name.
pub(crate) struct Mechanism(pub(crate) HashMap<String, Vector>);

/// A rotation about a fixed line.
struct Hinge {
    origin: Vector,
    axis: Vector,
}

impl Hinge {
    /// A point of the design turned by an angle.
    fn turned(&self, point: Vector, angle: Jet) -> Vector {
        let arm = point - self.origin;
        let along = self.axis * self.axis.dot(arm);
        let [sine, cosine] = angle.sine_cosine();
        self.origin + along + (arm - along) * cosine + self.axis.cross(arm) * sine
    }
}

/// A vector turned by a unit quaternion, its scalar first.
fn turned([scalar, x, y, z]: [Jet; 4], arm: Vector) -> Vector {
    let vector = Vector([x, y, z]);
    let half = vector.cross(arm) + arm * scalar;
    arm + vector.cross(half) * Jet::from(2.0)
}

impl Mechanism {
    fn design(&self, name: &str) -> Vector {
        self.0[name]
    }

    fn hinge(&self, [from, to]: [&str; 2]) -> Hinge {
        let origin = self.design(from);
        let axis = (self.design(to) - origin).unit();
        Hinge { origin, axis }
    }

    /// A point of the body that turns about a line through two points.
    fn on_hinge(&self, ends: [&str; 2], name: &str, angle: Jet) -> Vector {
        self.hinge(ends).turned(self.design(name), angle)
    }

    fn on_upright(&self, name: &str, x: &Coordinates) -> Vector {
        let arm = self.design(name) - self.design("wheel_centre");
        let position = Vector([0, 1, 2].map(|axis| x[POSITION + axis]));
        let quaternion = [0, 1, 2, 3].map(|entry| x[QUATERNION + entry]);
        position + turned(quaternion, arm)
    }

    /// A moving point. The ends of the wishbones are those of the wishbones.
    pub(crate) fn point(&self, name: &str, x: &Coordinates) -> Vector {
        let (hinge, angle) = match name {
            "lower_ball" | "pushrod_lower" => (["lower_front", "lower_rear"], x[LOWER]),
            "upper_ball" => (["upper_front", "upper_rear"], x[UPPER]),
            "pushrod_upper" | "damper_outer" | "drop_upper" => {
                (["rocker_front", "rocker_rear"], x[ROCKER])
            }
            "drop_lower" => (["bar_inner", "bar_outer"], x[BAR]),
            "tie_ball" | "wheel_centre" | "axle" => return self.on_upright(name, x),
            other => panic!("{other} does not move"),
        };
        self.on_hinge(hinge, name, angle)
    }

    fn rack(&self, steer: Jet) -> Vector {
        let [x, _, z] = self.design("rack").0;
        Vector([x, steer, z])
    }

    /// Returns the square of a link's length minus that of the design.
    fn stretch(&self, [from, to]: [&str; 2], now: [Vector; 2]) -> Jet {
        let design = self.design(to) - self.design(from);
        let now = now[1] - now[0];
        now.dot(now) - design.dot(design)
    }

    fn link(&self, ends: [&str; 2], x: &Coordinates) -> Jet {
        self.stretch(ends, ends.map(|end| self.point(end, x)))
    }

    /// Returns the distance of a ball joint of the upright from its wishbone.
    fn gap(&self, ball: &str, x: &Coordinates) -> [Jet; 3] {
        (self.on_upright(ball, x) - self.point(ball, x)).0
    }

    fn residual(&self, x: &Coordinates, drives: &Drives<Jet>) -> Coordinates {
        let [lower, upper] = ["lower_ball", "upper_ball"].map(|ball| self.gap(ball, x));
        let rack = [self.rack(drives.steer), self.on_upright("tie_ball", x)];
        let squares = x[QUATERNION..].iter().map(|entry| *entry * *entry);
        let [_, _, height] = self.point("wheel_centre", x).0;
        let scalars = [
            self.stretch(["rack", "tie_ball"], rack),
            squares.fold(Jet::from(-1.0), Jet::add),
            height - drives.bump,
            self.link(["pushrod_lower", "pushrod_upper"], x),
            self.link(["drop_upper", "drop_lower"], x),
        ];
        let mut rows = lower.into_iter().chain(upper).chain(scalars);
        std::array::from_fn(|_| rows.next().expect("11 rows"))
    }

    /// The coordinates of the design: no angle, no turn.
    pub(crate) fn start(&self) -> Coordinates {
        let mut start = [Jet::from(0.0); SIZE];
        start[POSITION..QUATERNION].copy_from_slice(&self.design("wheel_centre").0);
        start[QUATERNION] = Jet::from(1.0);
        start
    }

    /// The coordinates, their rates and second rates, from coordinates near by.
    pub(crate) fn solve(&self, near: &Coordinates, drives: &Drives<Signal<f64>>) -> Coordinates {
        let drives = Drives {
            bump: Jet::input(&drives.bump),
            steer: Jet::input(&drives.steer),
        };
        newton::solve(&Driven(self, drives), near)
    }
}

/// The mechanism at an instant.
struct Driven<'a>(&'a Mechanism, Drives<Jet>);

impl Equations for Driven<'_> {
    fn moving(&self, x: &Coordinates) -> Coordinates {
        self.0.residual(x, &self.1)
    }

    fn held(&self, x: &Coordinates) -> Coordinates {
        let Drives { bump, steer } = self.1;
        let held = |drive: Jet| Jet::constant(drive.0[0]);
        let drives = Drives {
            bump: held(bump),
            steer: held(steer),
        };
        self.0.residual(x, &drives)
    }
}
