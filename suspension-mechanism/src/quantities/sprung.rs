//! What springs do at the wheels: readings by virtual work.

use suspension_core::Signal;
use suspension_core::listing::MeasureKind;
use suspension_core::signal::Number as _;

use crate::mechanism::{Names, State};
use crate::quantities::formulas::Reading;
use crate::quantities::kind::Kind;
use crate::quantities::number::Number;
use crate::quantities::of_axle::{Axle, of_each_axle};
use crate::quantities::reader::Reader;
use crate::quantities::readings::{of_each_wheel, without_derivatives};
use crate::quantities::wheel::Rolling;

/// What all springs do along a coordinate.
#[derive(Clone, Copy)]
pub(super) struct Sprung {
    /// The generalised force against the coordinate.
    pub(super) force: f64,
    /// Its derivative with respect to the coordinate.
    pub(super) rate: f64,
}

impl Sprung {
    /// `-sum F s'` and `sum k s'^2 - F s''` along a coordinate of which the state's measures have the derivatives of another one:
    /// by the chain rule.
    fn along(coordinate: Signal<f64>, state: &State) -> Self {
        let none = Self {
            force: 0.0,
            rate: 0.0,
        };
        state.springs.iter().fold(none, |sum, spring| {
            let [value, rate, second_rate] = [
                &state.measures.value,
                &state.measures.rate,
                &state.measures.second_rate,
            ]
            .map(|measures| measures[spring.measure]);
            let slope = rate / coordinate.rate;
            let bend = (second_rate - slope * coordinate.second_rate) / coordinate.rate.powi(2);
            let presses = spring.presses(value);
            // Newton metres per unit of length.
            let scale = match spring.kind {
                MeasureKind::Angle => state.metre,
                MeasureKind::Length => 1.0,
            };
            Self {
                force: sum.force - scale * presses * slope,
                rate: sum.rate + scale * (spring.rate * slope * slope - presses * bend),
            }
        })
    }
}

/// A number of the springs at each wheel, along the height of its centre.
pub(super) fn of_wheels<N: Number>(
    names: &Names,
    kind: Kind,
    value: fn(Sprung) -> f64,
) -> Vec<Reading<N>> {
    let has_springs = !names.vehicle.springs.is_empty();
    of_each_wheel(names, &|rolling| {
        let Some(drive) = rolling.travel.filter(|_| has_springs) else {
            return Vec::new();
        };
        let of_state = move |state: &State| {
            let state = state.moved_along(&[(drive, 1.0)])?;
            Some(value(Sprung::along(height(state, rolling), state)))
        };
        vec![without_derivatives(kind, of_state)]
    })
}

/// The same of each axle in roll, its wheels moving opposite ways, along the angle of the line through their centres.
pub(super) fn of_roll<N: Number>(names: &Names, value: fn(Sprung) -> f64) -> Vec<Reading<N>> {
    let has_springs = !names.vehicle.springs.is_empty();
    let is_sprung = |axle: &Axle| axle.has_travel() && has_springs;
    of_each_axle(names, &is_sprung, &|wheels| {
        let of_state = move |state: &State| {
            let [a, b] = [wheels[0].travel?, wheels[1].travel?];
            let moved = state.moved_along(&[(a, 1.0), (b, -1.0)])?;
            let of = Reader::of(moved);
            let [left, right] = wheels.map(|rolling| of.wheel(rolling).centre);
            let roll = Signal::arc_tangent(left.z - right.z, left.y - right.y);
            let sprung = Sprung::along(roll, moved);
            // Along an angle a force is newtons times the unit of length.
            Some(value(sprung) / state.metre)
        };
        vec![without_derivatives(Kind::AngularStiffness, of_state)]
    })
}

fn height(state: &State, rolling: Rolling) -> Signal<f64> {
    Reader::of(state).wheel(rolling).centre.z
}
