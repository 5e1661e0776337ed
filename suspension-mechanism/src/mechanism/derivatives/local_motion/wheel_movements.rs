//! The states that springs and masses need: a single wheel moving up and down, and both wheels of an axle together.

use nalgebra::{Matrix2, Vector2};
use suspension_core::{Signal, Values};

use crate::mechanism::derivatives::local_motion::LocalMotion;
use crate::mechanism::motion::drive_laws::unit_change;
use crate::mechanism::parts::sides::Pair;
use crate::mechanism::state::{Moved, WheelMovement};
use crate::mechanism::suspension::Suspension;

impl<L: Suspension<N>, const N: usize> LocalMotion<'_, L, N> {
    /// See [`State::moved`](crate::mechanism::State::moved).
    pub(super) fn travel_movements(&self) -> Vec<Moved> {
        let names = &self.mechanism.names;
        if names.vehicle.springs.is_empty() && names.vehicle.masses.is_empty() {
            return Vec::new();
        }
        let pairs = Pair::all(&names.wheels);
        let alone = names.vehicle.travel.iter().map(|drive| {
            let movement = WheelMovement::Travel(*drive);
            Some((movement, self.single_wheel_motion(*drive, &pairs)?))
        });
        let together = pairs.iter().flat_map(|Pair { wheels, .. }| {
            let heave = (WheelMovement::Heave(*wheels), [1.0, 1.0]);
            let roll = (WheelMovement::Roll(*wheels), [1.0, -1.0]);
            [heave, roll]
                .map(|(movement, rise)| Some((movement, self.two_wheel_motion(*wheels, rise)?)))
        });
        let moved = alone.chain(together).flatten();
        let state = |(movement, points)| Moved {
            movement,
            state: self.mechanism.state(0.0, &self.drives, &points),
        };
        moved.map(state).collect()
    }

    /// The motion in which a wheel rises while the one beside it, which has a drive of its own, keeps its height;
    /// otherwise the motion of the drive alone.
    fn single_wheel_motion(&self, drive: usize, pairs: &[Pair]) -> Option<Signal<L::Points>> {
        let travel_drive = |wheel: usize| self.mechanism.names.wheels[wheel].travel;
        let alone = pairs.iter().find_map(|Pair { wheels, .. }| {
            match wheels.map(|wheel| travel_drive(wheel) == Some(drive)) {
                [true, false] => self.two_wheel_motion(*wheels, [1.0, 0.0]),
                [false, true] => self.two_wheel_motion(*wheels, [0.0, 1.0]),
                _ => None,
            }
        });
        alone.or_else(|| self.directions?.points(unit_change(drive)).ok())
    }

    /// The motion in which the drives of travel of two wheels raise their centres at given rates, without
    /// acceleration.
    fn two_wheel_motion(&self, wheels: [usize; 2], rise: [f64; 2]) -> Option<Signal<L::Points>> {
        let wheels = wheels.map(|wheel| &self.mechanism.names.wheels[wheel]);
        let [Some(a), Some(b)] = wheels.map(|wheel| wheel.travel) else {
            return None;
        };
        if a == b {
            return None;
        }
        let centres = wheels.map(|wheel| wheel.points.axis[1]);
        let axes = self.mechanism.axes;
        let rises = |points: &L::Points| {
            let [left, right] = points.at(centres).map(|centre| axes.turned(centre).z);
            Vector2::new(left, right)
        };
        let [of_a, of_b] = [self.derivatives.along(a)?, self.derivatives.along(b)?];
        let [of_a, of_b] = [&of_a.direction.points, &of_b.direction.points];
        let drives_of = Matrix2::from_columns(&[rises(of_a), rises(of_b)]).try_inverse()?;
        let rates = drives_of * Vector2::from(rise);
        let change = L::Drives::from_values([]);
        let change = change.with(a, rates.x).with(b, rates.y);
        let points = self.directions?.points(change).ok()?;
        let second_rates = -drives_of * rises(&points.second_rate);
        let curved = points
            .second_rate
            .values()
            .zip(of_a.values())
            .zip(of_b.values());
        let second_rate =
            curved.map(|((point, a), b)| point + a * second_rates.x + b * second_rates.y);
        Some(Signal {
            second_rate: L::Points::from_values(second_rate),
            ..points
        })
    }
}
