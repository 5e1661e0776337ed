//! The effects of springs at the wheels: readings by virtual work.

use suspension_core::Signal;
use suspension_core::listing::MeasureKind;
use suspension_core::signal::Number as _;

use crate::file::Dimension;
use crate::mechanism::{Names, Spring, State, WheelMovement};
use crate::quantities::formulas::Reading;
use crate::quantities::number::Number;
use crate::quantities::reader::Reader;
use crate::quantities::reader::wheel::{Rolling, share};
use crate::quantities::readings::axle::{Axle, of_each_axle};
use crate::quantities::readings::{of_each_wheel, without_derivatives};

/// The effect of all springs along a coordinate.
#[derive(Clone, Copy)]
pub(crate) struct Sprung {
    /// The generalised force against the coordinate.
    pub(crate) force: f64,
    /// Its derivative with respect to the coordinate.
    pub(crate) rate: f64,
}

impl Sprung {
    /// `-sum F s'` and `sum k s'^2 - F s''` along a coordinate, when the state's measures have the derivatives along
    /// another one: by the chain rule.
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
            let load = spring.load_at(value);
            // Converts to newton metres per unit of length.
            let scale = match spring.kind {
                MeasureKind::Angle => state.metre,
                MeasureKind::Length => 1.0,
            };
            Self {
                force: sum.force - scale * load * slope,
                rate: sum.rate + scale * (spring.rate * slope * slope - load * bend),
            }
        })
    }
}

/// The load of each spring.
pub(crate) fn of_springs<N: Number>(names: &Names) -> Vec<Reading<N>> {
    let springs = names.vehicle.springs.iter().enumerate();
    let of_one = |(number, spring): (usize, &Spring)| {
        let (dimension, what) = match spring.kind {
            MeasureKind::Length => (Dimension::Force, "force"),
            MeasureKind::Angle => (Dimension::Moment, "moment"),
        };
        let of_state = move |state: &State| Some(state.load_of(state.springs.get(number)?));
        Reading {
            name: Some(format!("{}_{what}", spring.name)),
            ..without_derivatives(dimension, of_state)
        }
    };
    springs.map(of_one).collect()
}

/// A number of the springs at each wheel, along the height of its centre.
pub(crate) fn of_wheels<N: Number>(
    names: &Names,
    dimension: Dimension,
    value: fn(Sprung) -> f64,
) -> Vec<Reading<N>> {
    let has_springs = !names.vehicle.springs.is_empty();
    of_each_wheel(names, &|rolling| {
        let drive = rolling.travel.filter(|_| has_springs)?;
        let together = rolling.moved_together(names);
        let of_state = move |state: &State| {
            let state = state.moved_along(WheelMovement::Travel(drive))?;
            let height = |rolling| height(state, rolling);
            let share = share(&together, rolling, |rolling| height(rolling).rate);
            Some(share * value(Sprung::along(height(rolling), state)))
        };
        Some(without_derivatives(dimension, of_state))
    })
}

/// The rate of the springs at each wheel of an axle in heave, in which both centres rise by the same amount: each
/// wheel has half of it.
pub(crate) fn of_heave<N: Number>(names: &Names) -> Vec<Reading<N>> {
    of_sprung_axles(names, Dimension::Stiffness, move |wheels, state| {
        let moved = state.moved_along(WheelMovement::Heave(wheels.map(|wheel| wheel.number)))?;
        Some(0.5 * Sprung::along(height(moved, wheels[0]), moved).rate)
    })
}

/// The rate of the springs of each axle in roll, in which one centre rises as the other falls, along the angle of the line
/// through them.
pub(crate) fn of_roll<N: Number>(names: &Names) -> Vec<Reading<N>> {
    of_sprung_axles(names, Dimension::AngularStiffness, move |wheels, state| {
        let moved = state.moved_along(WheelMovement::Roll(wheels.map(|wheel| wheel.number)))?;
        let reader = Reader::new(moved);
        let [left, right] = wheels.map(|rolling| reader.wheel(rolling).centre);
        let roll = Signal::arc_tangent(left.z - right.z, left.y - right.y);
        // Along an angle, a force is in newtons times the unit of length.
        Some(Sprung::along(roll, moved).rate / state.metre)
    })
}

/// A number of each axle whose wheels have their own drives of travel, if there are springs.
fn of_sprung_axles<N: Number>(
    names: &Names,
    dimension: Dimension,
    value: impl Fn([Rolling; 2], &State) -> Option<f64> + Copy + 'static,
) -> Vec<Reading<N>> {
    let has_springs = !names.vehicle.springs.is_empty();
    let is_sprung = |axle: &Axle| axle.has_travel() && has_springs;
    of_each_axle(names, &is_sprung, &|wheels| {
        Some(without_derivatives(dimension, move |state| {
            value(wheels, state)
        }))
    })
}

fn height(state: &State, rolling: Rolling) -> Signal<f64> {
    Reader::new(state).wheel(rolling).centre.z
}
