//! How the numbers of a quantity are read of a state.

use nalgebra::Vector3;
use suspension_core::Signal;

use crate::mechanism::Names;
use crate::quantities::kind::Kind;
use crate::quantities::quantity::{Axis, Reading};
use crate::quantities::reader::Reader;
use crate::quantities::wheel::{Number, Rolling, from_to, origin};

/// A number whose derivatives are not known.
pub(super) fn alone(value: f64) -> Number {
    Signal {
        value,
        rate: f64::NAN,
        second_rate: f64::NAN,
    }
}

/// One number of any state, of which no derivatives are known.
pub(super) fn number(kind: Kind, value: fn(&Reader<'_>) -> f64) -> Vec<Reading> {
    vec![Reading {
        has_derivatives: false,
        ..reading(kind, move |state| alone(value(state)))
    }]
}

/// One number, by a formula of positions.
pub(super) fn reading(kind: Kind, value: impl Fn(&Reader<'_>) -> Number + 'static) -> Reading {
    Reading {
        name: None,
        wheel: None,
        kind,
        axis: None,
        has_derivatives: true,
        value: Box::new(value),
    }
}

/// A number each of several things that the linkage names.
pub(super) fn each<'a>(
    things: impl Iterator<Item = (&'a str, Kind)>,
    has_derivatives: bool,
    value: fn(&Reader<'_>, usize) -> Number,
) -> Vec<Reading> {
    let of_one = |(index, (name, kind)): (usize, (&str, Kind))| Reading {
        name: Some(name.to_owned()),
        has_derivatives,
        ..reading(kind, move |state| value(state, index))
    };
    things.enumerate().map(of_one).collect()
}

/// A number of which no derivatives are known; none where the state does not tell it.
pub(super) fn without_derivatives(
    kind: Kind,
    value: impl Fn(&Reader<'_>) -> Option<f64> + 'static,
) -> Reading {
    Reading {
        has_derivatives: false,
        ..reading(kind, move |reader| alone(value(reader).unwrap_or(f64::NAN)))
    }
}

/// Components of a vector of which no derivatives are known.
pub(super) fn vector(
    name: Option<&str>,
    kind: Kind,
    axes: &[Axis],
    value: impl Fn(&Reader<'_>) -> Vector3<f64> + Clone + 'static,
) -> Vec<Reading> {
    let mut readings = components(name, kind, axes, move |state| value(state).map(alone));
    for reading in &mut readings {
        reading.has_derivatives = false;
    }
    readings
}

/// Components of a vector, by a formula of positions.
pub(super) fn components(
    name: Option<&str>,
    kind: Kind,
    axes: &[Axis],
    value: impl Fn(&Reader<'_>) -> Vector3<Number> + Clone + 'static,
) -> Vec<Reading> {
    let component = |axis: &Axis| {
        let (axis, value) = (*axis, value.clone());
        Reading {
            name: name.map(str::to_owned),
            axis: Some(axis),
            ..reading(kind, move |state| value(state)[axis as usize])
        }
    };
    axes.iter().map(component).collect()
}

/// The coordinates of a place in the file's axes, by a formula of positions in local coordinates and the axes of
/// ISO 8855.
pub(super) fn place(
    name: Option<&str>,
    local: impl Fn(&Reader<'_>) -> Vector3<Number> + Clone + 'static,
) -> Vec<Reading> {
    components(name, Kind::Length, &Axis::ALL, move |state| {
        state.axes.turned(local(state) + origin(state))
    })
}

/// Positions, velocities or accelerations of a point.
pub(super) fn point(names: &Names, point: usize, kind: Kind) -> Vec<Reading> {
    let name = Some(names.points[point].as_str());
    match kind {
        Kind::Velocity => vector(name, kind, &Axis::ALL, move |state| {
            state.points.rate[point]
        }),
        Kind::Acceleration => vector(name, kind, &Axis::ALL, move |state| {
            state.points.second_rate[point]
        }),
        _ => Axis::ALL.map(|axis| coordinate(name, point, axis)).into(),
    }
}

/// A coordinate of a point.
fn coordinate(name: Option<&str>, point: usize, axis: Axis) -> Reading {
    let of = move |vector: &Vector3<f64>| vector[axis as usize];
    Reading {
        name: name.map(str::to_owned),
        axis: Some(axis),
        ..reading(Kind::Length, move |state| {
            let local = state.points.map(|points| of(&points[point]));
            local + Signal::still(of(&state.origin))
        })
    }
}

/// The readings of each wheel.
pub(super) fn of_each_wheel(names: &Names, read: impl Fn(Rolling) -> Vec<Reading>) -> Vec<Reading> {
    let of_one = |(name, rolling): (&str, Rolling)| {
        let wheel = (!name.is_empty()).then(|| name.to_owned());
        let readings = read(rolling).into_iter();
        let readings = readings.map(move |reading| Reading {
            wheel: wheel.clone(),
            ..reading
        });
        readings.collect::<Vec<_>>()
    };
    Rolling::each(names).flat_map(of_one).collect()
}

/// An angle of the spin axis.
pub(super) fn of_spin_axis(names: &Names, angle: fn(&Vector3<Number>) -> Number) -> Vec<Reading> {
    of_each_wheel(names, |rolling| {
        let axis = rolling.points.axis;
        vec![reading(Kind::Angle, move |state| {
            angle(&from_to(state, axis))
        })]
    })
}

/// An angle of the kingpin.
pub(super) fn of_kingpin(names: &Names, angle: fn(&Vector3<Number>) -> Number) -> Vec<Reading> {
    of_kingpin_and_spin_axis(names, move |kingpin, _| angle(kingpin))
}

/// An angle of the kingpin whose sign rests on the side of the vehicle: kingpin first, then spin axis.
pub(super) fn of_kingpin_and_spin_axis(
    names: &Names,
    angle: impl Fn(&Vector3<Number>, &Vector3<Number>) -> Number + Copy + 'static,
) -> Vec<Reading> {
    of_each_wheel(names, |rolling| {
        let axis = rolling.points.axis;
        let of = |kingpin| {
            reading(Kind::Angle, move |state| {
                angle(&from_to(state, kingpin), &from_to(state, axis))
            })
        };
        rolling.points.kingpin.map(of).into_iter().collect()
    })
}
