//! An axle: two wheels, one on each side of the vehicle. The left one comes first.

use nalgebra::Vector3;

use super::angles::{arc_tangent_rate, steer_angle};
use super::ground::Heading;
use super::travel::Carrier;
use crate::signal::Number;

/// The steer angles of the wheels of a steered axle in a turn, with the other axle straight. The inner wheel is the
/// one on the side to which both turn on average.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turn<N> {
    /// The steer angle of the inner wheel, positive into the turn.
    pub inner: N,
    /// The steer angle of the outer wheel, positive into the turn.
    pub outer: N,
    /// The cosine and the sine of the outer wheel's steer angle.
    heading: [N; 2],
}

impl<N: Number> Turn<N> {
    /// Computes the angles from the spin axes of both wheels, which point outboard.
    pub fn of([left, right]: [&Vector3<N>; 2]) -> Self {
        let [of_left, of_right] = [left, right].map(steer_angle);
        let to_the_right = (of_left + of_right).is_below_zero();
        let (inner, outer, axis) = if to_the_right {
            (-of_right, -of_left, left)
        } else {
            (of_left, of_right, right)
        };
        let ahead = Heading::of(axis).forward;
        let aside = if to_the_right { -ahead.y } else { ahead.y };
        Self {
            inner,
            outer,
            heading: [ahead.x, aside],
        }
    }

    /// The steer angle of the inner wheel for which the normals of both wheels meet on the line of the other axle,
    /// given the outer wheel: `cot(inner) = cot(outer) - track / wheelbase`.
    pub fn ideal_inner(&self, wheelbase: N, track: N) -> N {
        let [ahead, aside] = self.heading;
        N::arc_tangent(wheelbase * aside, wheelbase * ahead - track * aside)
    }

    /// The actual difference of the steer angles as a fraction of the ideal difference; not finite straight ahead.
    pub fn ackermann(&self, wheelbase: N, track: N) -> N {
        (self.inner - self.outer) / (self.ideal_inner(wheelbase, track) - self.outer)
    }

    /// The radius of the circle on which the outer wheel rolls, about a centre on the line of the other axle:
    /// `wheelbase / sin(outer)`; not finite straight ahead.
    pub fn radius(&self, wheelbase: N) -> N {
        let [_, aside] = self.heading;
        wheelbase / aside
    }
}

/// The rate at which an axle rolls relative to the chassis, positive where the left wheel rises: the rate of the
/// angle in the front view between the y axis and the line through both contact points, from their positions and
/// velocities.
pub fn roll_rate<N: Number>(
    [left, right]: [&Vector3<N>; 2],
    [left_velocity, right_velocity]: [&Vector3<N>; 2],
) -> N {
    let (line, rate) = (left - right, left_velocity - right_velocity);
    arc_tangent_rate([line.z, line.y], [rate.z, rate.y])
}

/// The roll centre of an axle: the point in the front view where the normals to the velocities of both contact
/// points, taken as points of the carriers, meet. Its x is zero; not finite if the normals are parallel.
pub fn roll_centre<N: Number>(
    [of_left, of_right]: [&Carrier<N>; 2],
    [left, right]: [&Vector3<N>; 2],
) -> Vector3<N> {
    let [v, w] = [of_left.velocity_of(left), of_right.velocity_of(right)];
    let reach = |velocity: &Vector3<N>, contact: &Vector3<N>| {
        velocity.y * contact.y + velocity.z * contact.z
    };
    let (to_left, to_right) = (reach(&v, left), reach(&w, right));
    let determinant = v.y * w.z - v.z * w.y;
    Vector3::new(
        N::zero(),
        (to_left * w.z - v.z * to_right) / determinant,
        (v.y * to_right - to_left * w.y) / determinant,
    )
}
