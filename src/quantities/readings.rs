//! How the numbers of a quantity are read of a state.

use nalgebra::Vector3;

use crate::mechanism::{Names, State};
use crate::quantities::kind::Kind;
use crate::quantities::quantity::{Axis, Reading};

/// One number of any state.
pub(super) fn number(kind: Kind, value: fn(&State) -> f64) -> Vec<Reading> {
    vec![Reading {
        name: None,
        kind,
        axis: None,
        value: Box::new(value),
    }]
}

/// A number each of several things that the linkage names.
pub(super) fn each<'a>(
    things: impl Iterator<Item = (&'a str, Kind)>,
    value: fn(&State, usize) -> f64,
) -> Vec<Reading> {
    let reading = |(index, (name, kind)): (usize, (&str, Kind))| Reading {
        name: Some(name.to_owned()),
        kind,
        axis: None,
        value: Box::new(move |state| value(state, index)),
    };
    things.enumerate().map(reading).collect()
}

/// The components of a vector.
pub(super) fn vector(
    name: Option<&str>,
    kind: Kind,
    value: impl Fn(&State) -> Vector3<f64> + Clone + 'static,
) -> Vec<Reading> {
    let component = |(index, axis)| {
        let value = value.clone();
        Reading {
            name: name.map(str::to_owned),
            kind,
            axis: Some(axis),
            value: Box::new(move |state: &State| value(state)[index]),
        }
    };
    Axis::ALL.into_iter().enumerate().map(component).collect()
}

/// Positions, velocities or accelerations of a point.
pub(super) fn point(names: &Names, point: usize, kind: Kind) -> Vec<Reading> {
    let name = Some(names.points[point].as_str());
    vector(name, kind, move |state| match kind {
        Kind::Velocity => state.points.rate[point],
        Kind::Acceleration => state.points.second_rate[point],
        _ => state.position(point),
    })
}

/// An angle of the spin axis.
pub(super) fn of_spin_axis(names: &Names, angle: fn(&Vector3<f64>) -> f64) -> Vec<Reading> {
    let Some(wheel) = names.wheel else {
        return Vec::new();
    };
    let value = move |state: &State| angle(&from_to(state, wheel.axis));
    vec![angle_of(value)]
}

/// An angle of the kingpin.
pub(super) fn of_kingpin(names: &Names, angle: fn(&Vector3<f64>) -> f64) -> Vec<Reading> {
    let Some(kingpin) = names.kingpin else {
        return Vec::new();
    };
    let value = move |state: &State| angle(&from_to(state, kingpin));
    vec![angle_of(value)]
}

/// An angle of the kingpin whose sign rests on the side of the vehicle: kingpin first, then spin axis.
pub(super) fn of_kingpin_and_spin_axis(
    names: &Names,
    angle: fn(&Vector3<f64>, &Vector3<f64>) -> f64,
) -> Vec<Reading> {
    let (Some(kingpin), Some(wheel)) = (names.kingpin, names.wheel) else {
        return Vec::new();
    };
    let value = move |state: &State| angle(&from_to(state, kingpin), &from_to(state, wheel.axis));
    vec![angle_of(value)]
}

fn angle_of(value: impl Fn(&State) -> f64 + 'static) -> Reading {
    Reading {
        name: None,
        kind: Kind::Angle,
        axis: None,
        value: Box::new(value),
    }
}

fn from_to(state: &State, [from, to]: [usize; 2]) -> Vector3<f64> {
    state.points.value[to] - state.points.value[from]
}
