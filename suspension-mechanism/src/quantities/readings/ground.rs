//! Readings of each wheel on the ground, and of its carrier in travel and in steering.

use nalgebra::Vector3;
use suspension_core::wheel::{Heading, SteeringAxis};

use crate::file::Dimension;
use crate::mechanism::Names;
use crate::quantities::axis::Axis;
use crate::quantities::formulas::Reading;
use crate::quantities::number::Number;
use crate::quantities::reader::Reader;
use crate::quantities::reader::wheel::{CarrierMotion, MovingWheel, Rolling, Wheel};
use crate::quantities::readings::{components, of_each_wheel, place, reading};

pub(crate) fn of_contact<N: Number>(names: &Names) -> Vec<Reading<N>> {
    of_each_wheel(names, &|rolling| {
        if !rolling.is_on_ground() {
            return Vec::new();
        }
        place(move |reader| reader.wheel(rolling).contact)
    })
}

/// The position of a steering axis relative to a point of the wheel.
type Offset<N> = fn(&SteeringAxis<N>, &Vector3<N>, &Heading<N>) -> N;

/// The position of the kingpin relative to the contact point.
pub(crate) fn of_kingpin_at_ground<N: Number>(names: &Names, offset: Offset<N>) -> Vec<Reading<N>> {
    of_kingpin_at(names, true, offset, |wheel| wheel.contact)
}

/// The position of the kingpin relative to the wheel centre.
pub(crate) fn of_kingpin_at_centre<N: Number>(names: &Names, offset: Offset<N>) -> Vec<Reading<N>> {
    of_kingpin_at(names, false, offset, |wheel| wheel.centre)
}

/// `on_ground` if the wheel radius is needed.
fn of_kingpin_at<N: Number>(
    names: &Names,
    on_ground: bool,
    offset: Offset<N>,
    point: fn(&Wheel<N>) -> Vector3<N>,
) -> Vec<Reading<N>> {
    of_each_wheel(names, &|rolling| {
        let ends = rolling.points.kingpin;
        ends.filter(|_| rolling.is_on_ground() || !on_ground)?;
        Some(reading(Dimension::Length, move |reader| {
            let (wheel, kingpin) = (reader.wheel(rolling), reader.kingpin(rolling));
            kingpin.map_or_else(N::unknown, |kingpin| {
                offset(kingpin, &point(wheel), &wheel.heading)
            })
        }))
    })
}

/// A number of each carrier in motion; `on_ground` if the wheel radius is needed.
pub(crate) fn of_moving<N: Number>(
    names: &Names,
    motion: CarrierMotion,
    dimension: Dimension,
    on_ground: bool,
    value: impl Fn(&MovingWheel<N>) -> N + Clone + 'static,
) -> Vec<Reading<N>> {
    of_each_wheel(names, &|rolling| {
        moving(rolling, motion, dimension, on_ground, value.clone())
    })
}

/// The same number, in travel and on the ground, for the carriers that no other wheel moves: a force on a wheel that
/// another one moves is borne by its links. `is_wanted` selects the wheels.
pub(crate) fn of_independent<N: Number>(
    names: &Names,
    is_wanted: impl Fn(Rolling) -> bool,
    dimension: Dimension,
    value: impl Fn(&MovingWheel<N>) -> N + Clone + 'static,
) -> Vec<Reading<N>> {
    of_each_wheel(names, &|rolling| {
        let is_moved = rolling.coupling.is_moved || rolling.shares_its_carrier;
        if is_moved || !is_wanted(rolling) {
            return None;
        }
        moving(
            rolling,
            CarrierMotion::Travel,
            dimension,
            true,
            value.clone(),
        )
    })
}

/// The same number for the carrier of one wheel.
pub(crate) fn moving<N: Number>(
    rolling: Rolling,
    motion: CarrierMotion,
    dimension: Dimension,
    on_ground: bool,
    value: impl Fn(&MovingWheel<N>) -> N + 'static,
) -> Option<Reading<N>> {
    let of_reader = move |reader: &Reader<'_, N>| {
        let moving = reader.moving(motion, rolling);
        moving.map_or_else(N::unknown, &value)
    };
    is_moved(&rolling, motion, on_ground).then(|| reading(dimension, of_reader))
}

/// Coordinates of a place that follows from the carrier's motion.
pub(crate) fn of_moving_place<N: Number>(
    names: &Names,
    motion: CarrierMotion,
    axes: &[Axis],
    place: fn(&MovingWheel<N>) -> Vector3<N>,
) -> Vec<Reading<N>> {
    of_each_wheel(names, &|rolling| {
        if !is_moved(&rolling, motion, false) {
            return Vec::new();
        }
        components(axes, move |reader| {
            let moving = reader.moving(motion, rolling);
            let place = moving.map_or_else(|| Vector3::repeat(N::unknown()), place);
            reader.axes.turned(place)
        })
    })
}

/// Whether the file names the drive that moves a wheel.
fn is_moved(rolling: &Rolling, motion: CarrierMotion, on_ground: bool) -> bool {
    rolling.drive(motion).is_some() && (rolling.is_on_ground() || !on_ground)
}
