//! The computation of a quantity's numbers from a state.

pub(super) mod axle;
pub(super) mod brake_and_drive;
pub(super) mod from_design;
pub(super) mod ground;
pub(super) mod masses;
pub(super) mod springs;
pub(super) mod steering_wheel;

use nalgebra::Vector3;

use crate::file::Dimension;
use crate::mechanism::{Names, State};
use crate::quantities::axis::Axis;
use crate::quantities::formulas::Reading;
use crate::quantities::number::Number;
use crate::quantities::reader::Reader;
use crate::quantities::reader::wheel::Rolling;

/// One number of any state, whose derivatives are not known.
pub(super) fn number<N: Number>(dimension: Dimension, value: fn(&State) -> f64) -> Vec<Reading<N>> {
    vec![without_derivatives(dimension, move |state| {
        Some(value(state))
    })]
}

/// One number, by a formula of positions.
pub(super) fn reading<N: Number>(
    dimension: Dimension,
    value: impl Fn(&Reader<'_, N>) -> N + 'static,
) -> Reading<N> {
    Reading {
        name: None,
        wheel: None,
        dimension,
        axis: None,
        has_derivatives: true,
        value: Box::new(value),
    }
}

/// One number for each of several things that the linkage names.
pub(super) fn each<'a, N: Number>(
    things: impl Iterator<Item = (&'a str, Dimension)>,
    has_derivatives: bool,
    value: fn(&Reader<'_, N>, usize) -> N,
) -> Vec<Reading<N>> {
    let of_one = |(index, (name, dimension)): (usize, (&str, Dimension))| Reading {
        name: Some(name.to_owned()),
        has_derivatives,
        ..reading(dimension, move |state| value(state, index))
    };
    things.enumerate().map(of_one).collect()
}

/// A number whose derivatives are not known; none if the state does not provide it.
pub(super) fn without_derivatives<N: Number>(
    dimension: Dimension,
    value: impl Fn(&State) -> Option<f64> + 'static,
) -> Reading<N> {
    Reading {
        has_derivatives: false,
        ..reading(dimension, move |reader| {
            N::alone(value(reader).unwrap_or(f64::NAN))
        })
    }
}

/// Components of a vector whose derivatives are not known.
pub(super) fn vector<N: Number>(
    name: Option<&str>,
    dimension: Dimension,
    value: impl Fn(&State) -> Vector3<f64> + Copy + 'static,
) -> Vec<Reading<N>> {
    let component = |axis| Reading {
        name: name.map(str::to_owned),
        axis: Some(axis),
        ..without_derivatives(dimension, move |state| Some(value(state)[axis as usize]))
    };
    Axis::ALL.map(component).into()
}

/// Components of a place, by a formula of positions.
pub(super) fn components<N: Number>(
    axes: &[Axis],
    place: impl Fn(&Reader<'_, N>) -> Vector3<N> + Copy + 'static,
) -> Vec<Reading<N>> {
    let component = |axis: &Axis| {
        let axis = *axis;
        Reading {
            axis: Some(axis),
            ..reading(Dimension::Length, move |reader| {
                place(reader)[axis as usize]
            })
        }
    };
    axes.iter().map(component).collect()
}

/// The coordinates of a place in the file's axes, by a formula of positions in local coordinates and the axes of
/// ISO 8855.
pub(super) fn place<N: Number>(
    local: impl Fn(&Reader<'_, N>) -> Vector3<N> + Copy + 'static,
) -> Vec<Reading<N>> {
    components(&Axis::ALL, move |reader| {
        reader
            .axes
            .turned(local(reader) + reader.positions.origin())
    })
}

/// Positions, velocities or accelerations of a point.
pub(super) fn point<N: Number>(
    names: &Names,
    point: usize,
    dimension: Dimension,
) -> Vec<Reading<N>> {
    let name = Some(names.points[point].as_str());
    match dimension {
        Dimension::Velocity => vector(name, dimension, move |state| state.points.rate[point]),
        Dimension::Acceleration => vector(name, dimension, move |state| {
            state.points.second_rate[point]
        }),
        _ => Axis::ALL.map(|axis| coordinate(name, point, axis)).into(),
    }
}

fn coordinate<N: Number>(name: Option<&str>, point: usize, axis: Axis) -> Reading<N> {
    let component = axis as usize;
    Reading {
        name: name.map(str::to_owned),
        axis: Some(axis),
        ..reading(Dimension::Length, move |reader| {
            reader.positions.numbers.point(point)[component] + N::still(reader.origin[component])
        })
    }
}

/// The readings of each wheel: several, or one or none. (`dyn`, so that this is not compiled for each quantity.)
pub(super) fn of_each_wheel<N: Number, R: IntoIterator<Item = Reading<N>>>(
    names: &Names,
    read: &dyn Fn(Rolling) -> R,
) -> Vec<Reading<N>> {
    let of_one = |(name, rolling): (&str, Rolling)| {
        let wheel = (!name.is_empty()).then(|| name.to_owned());
        read(rolling).into_iter().map(move |reading| Reading {
            wheel: wheel.clone(),
            ..reading
        })
    };
    Rolling::each(names).flat_map(of_one).collect()
}

pub(super) fn of_spin_axis<N: Number>(
    names: &Names,
    angle: fn(&Vector3<N>) -> N,
) -> Vec<Reading<N>> {
    of_each_wheel(names, &|rolling| Some(spin_axis(rolling, angle)))
}

/// An angle of the spin axis of one wheel.
pub(super) fn spin_axis<N: Number>(rolling: Rolling, angle: fn(&Vector3<N>) -> N) -> Reading<N> {
    reading(Dimension::Angle, move |reader| {
        angle(&reader.wheel(rolling).axis)
    })
}

pub(super) fn of_kingpin<N: Number>(names: &Names, angle: fn(&Vector3<N>) -> N) -> Vec<Reading<N>> {
    of_kingpin_and_spin_axis(names, move |kingpin, _| angle(kingpin))
}

/// An angle of the kingpin whose sign depends on the side of the vehicle: kingpin first, then spin axis.
pub(super) fn of_kingpin_and_spin_axis<N: Number>(
    names: &Names,
    angle: impl Fn(&Vector3<N>, &Vector3<N>) -> N + Copy + 'static,
) -> Vec<Reading<N>> {
    of_each_wheel(names, &|rolling| {
        rolling.points.kingpin?;
        Some(reading(Dimension::Angle, move |reader: &Reader<'_, N>| {
            let (wheel, kingpin) = (reader.wheel(rolling), reader.kingpin(rolling));
            kingpin.map_or_else(N::unknown, |kingpin| angle(&kingpin.direction, &wheel.axis))
        }))
    })
}
