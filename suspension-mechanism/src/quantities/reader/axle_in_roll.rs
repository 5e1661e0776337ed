//! An axle in roll: its left contact point rises as fast as the right one falls.

use nalgebra::Vector3;
use suspension_core::wheel::{
    Carrier, camber_rate, contact_velocity, roll_centre, roll_rate, steer_rate,
};

use crate::quantities::number::Number;
use crate::quantities::reader::two_drives::{combined, rates};
use crate::quantities::reader::wheel::{MovingWheel, Rolling, Wheel};

/// An axle as it rolls, in the file's coordinates.
pub(crate) struct InRoll<N> {
    /// See [`roll_centre`].
    pub(crate) centre: Vector3<N>,
    /// The wheels by number, each with its values per radian of roll.
    wheels: [(usize, PerRoll<N>); 2],
}

/// The values of a wheel per radian of roll.
#[derive(Clone, Copy)]
pub(crate) struct PerRoll<N> {
    pub(crate) camber: N,
    pub(crate) steer: N,
}

/// A wheel moved by one drive, or by several.
struct Moved<N> {
    carrier: Carrier<N>,
    axis_rate: Vector3<N>,
    contact_velocity: Vector3<N>,
}

impl<N: Number> Moved<N> {
    fn new(carrier: Carrier<N>, axis: &Vector3<N>, radius: f64) -> Self {
        let axis_rate = carrier.omega.cross(axis);
        let (velocity, radius) = (&carrier.velocity, N::still(radius));
        Self {
            contact_velocity: contact_velocity(velocity, axis, &axis_rate, radius),
            axis_rate,
            carrier,
        }
    }
}

/// See [`roll_centre`]. If both contact points move vertically to rounding, the normals are level. At the same height
/// they coincide, and the centre is midway between the wheels, without derivatives; at different heights they do not
/// meet.
fn centre<N: Number>(carriers: [&Carrier<N>; 2], contacts: [&Vector3<N>; 2]) -> Vector3<N> {
    const ROUNDING: f64 = 1e-11;
    let values = |vector: &Vector3<N>| vector.map(N::value);
    let [left, right] = contacts.map(values);
    let contact_velocity = |wheel: usize| values(&carriers[wheel].velocity_of(contacts[wheel]));
    let [of_left, of_right] = [contact_velocity(0), contact_velocity(1)];
    let largest = |axis: usize| of_left[axis].abs().max(of_right[axis].abs());
    if largest(1) > ROUNDING * largest(2) {
        return roll_centre(carriers, contacts);
    }
    let middle = 0.5 * (left + right);
    if (left.z - right.z).abs() > ROUNDING * (left.y - right.y).abs() {
        return Vector3::repeat(N::unknown());
    }
    Vector3::new(N::zero(), N::alone(middle.y), N::alone(middle.z))
}

impl<N: Number> InRoll<N> {
    /// The axle in roll, from its left and right wheels and a function that gives the motion of a wheel's carrier by
    /// a drive; `None` if the mechanism locks, or a wheel has no drive of travel.
    pub(crate) fn compute(
        axle: [(Rolling, &Wheel<N>); 2],
        moved: impl Fn(Rolling, usize) -> Option<MovingWheel<N>>,
    ) -> Option<Self> {
        let [left, right] = axle.map(|(rolling, _)| rolling);
        let drives = [left.travel?, right.travel?];
        let of_left = [moved(left, drives[0])?, moved(left, drives[1])?];
        let of_right = [moved(right, drives[0])?, moved(right, drives[1])?];
        let rises = |by_drive: &[MovingWheel<N>; 2], rolling: Rolling| {
            by_drive.each_ref().map(|moving| {
                let moved = Moved::new(moving.carrier, &moving.axis, rolling.radius);
                moved.contact_velocity.z
            })
        };
        let rises = [rises(&of_left, left), rises(&of_right, right)];
        let rates = rates(rises, [1.0, -1.0]);
        let [left_in_roll, right_in_roll] =
            [(&of_left, left), (&of_right, right)].map(|(by_drive, rolling)| {
                let carrier = combined(by_drive, rates);
                Moved::new(carrier, &by_drive[0].axis, rolling.radius)
            });
        let contacts = [&of_left[0].contact, &of_right[0].contact];
        let velocities = [
            &left_in_roll.contact_velocity,
            &right_in_roll.contact_velocity,
        ];
        let roll = roll_rate(contacts, velocities);
        let per_roll = |(rolling, Wheel { axis, .. }): (Rolling, &Wheel<N>), moved: &Moved<N>| {
            let per = PerRoll {
                camber: camber_rate(axis, &moved.axis_rate) / roll,
                steer: steer_rate(axis, &moved.axis_rate) / roll,
            };
            (rolling.number, per)
        };
        Some(Self {
            centre: centre([&left_in_roll.carrier, &right_in_roll.carrier], contacts),
            wheels: [
                per_roll(axle[0], &left_in_roll),
                per_roll(axle[1], &right_in_roll),
            ],
        })
    }

    /// The values of a wheel of the axle per radian of roll.
    pub(crate) fn per_roll(&self, number: usize) -> Option<PerRoll<N>> {
        let mut wheels = self.wheels.iter();
        wheels
            .find(|(other, _)| *other == number)
            .map(|(_, per)| *per)
    }
}
