//! Readings of axles: of two wheels each, one on each side of the vehicle.

use nalgebra::Vector3;
use suspension_core::wheel::Turn;

use crate::file::Dimension;
use crate::mechanism::{self, Names, Pair};
use crate::quantities::axis::Axis;
use crate::quantities::formulas::Reading;
use crate::quantities::number::Number;
use crate::quantities::reader::Reader;
use crate::quantities::reader::axle_in_roll::PerRoll;
use crate::quantities::reader::wheel::{Rolling, Wheel};
use crate::quantities::readings::{components, of_each_wheel, reading, spin_axis};

/// A steer angle of a degree. If a wheel is steered by less, toe, and not the steering, determines the difference
/// between the wheels of an axle.
const STRAIGHT: f64 = std::f64::consts::PI / 180.0;

/// Two wheels opposite each other.
pub(crate) struct Axle {
    /// The common part of their names, if the linkage has other wheels too.
    name: Option<String>,
    pub(crate) wheels: [Rolling; 2],
}

impl Axle {
    /// All axles of a linkage.
    pub(crate) fn all(names: &Names) -> Vec<Self> {
        let wheels: Vec<Rolling> = Rolling::each(names).map(|(_, rolling)| rolling).collect();
        let of_pair = |pair: Pair| Self {
            name: (!pair.name.is_empty()).then_some(pair.name),
            wheels: pair.wheels.map(|wheel| wheels[wheel]),
        };
        Pair::all(&names.wheels).into_iter().map(of_pair).collect()
    }

    /// Whether the radius of its wheels is known.
    fn is_on_ground(&self) -> bool {
        self.wheels.iter().all(Rolling::is_on_ground)
    }

    /// Whether each wheel has a drive of travel of its own, so that it can roll.
    fn rolls(&self) -> bool {
        self.is_on_ground() && self.has_travel()
    }

    /// Whether each wheel has a drive of travel of its own.
    pub(crate) fn has_travel(&self) -> bool {
        let [a, b] = self.wheels.map(|wheel| wheel.travel);
        a != b && a.and(b).is_some()
    }

    fn has(&self, rolling: Rolling) -> bool {
        let mut wheels = self.wheels.iter();
        wheels.any(|wheel| wheel.number == rolling.number)
    }

    fn is_steered(&self) -> bool {
        self.wheels.iter().all(|wheel| wheel.steer.is_some())
    }
}

/// The readings of each requested axle, under its name. (`dyn`, so that this is not compiled for each quantity.)
pub(crate) fn of_each_axle<N: Number, R: IntoIterator<Item = Reading<N>>>(
    names: &Names,
    is_wanted: &dyn Fn(&Axle) -> bool,
    read: &dyn Fn([Rolling; 2]) -> R,
) -> Vec<Reading<N>> {
    let of_one = |Axle { name, wheels }: Axle| {
        read(wheels).into_iter().map(move |reading| Reading {
            wheel: name.clone(),
            ..reading
        })
    };
    let axles = Axle::all(names).into_iter().filter(is_wanted);
    axles.flat_map(of_one).collect()
}

/// The left wheel and the right one; `None` if both are on one side.
fn sided<N: Number>(reader: &Reader<'_, N>, [a, b]: [Rolling; 2]) -> Option<[Rolling; 2]> {
    let is_right = |rolling| reader.wheel(rolling).axis.y.is_below_zero();
    match (is_right(a), is_right(b)) {
        (false, true) => Some([a, b]),
        (true, false) => Some([b, a]),
        _ => None,
    }
}

/// A number of both wheels of each axle, the left one first; `on_ground` if the wheel radius is needed.
pub(crate) fn of_both<N: Number>(
    names: &Names,
    dimension: Dimension,
    on_ground: bool,
    value: impl Fn([&Wheel<N>; 2]) -> N + Clone + 'static,
) -> Vec<Reading<N>> {
    let is_wanted = |axle: &Axle| axle.is_on_ground() || !on_ground;
    of_each_axle(names, &is_wanted, &|wheels| {
        Some(both(wheels, dimension, value.clone()))
    })
}

/// A number of both wheels of an axle, now and at the design position.
type FromDesign<N> = fn([&Wheel<N>; 2], [&Wheel<N>; 2]) -> N;

/// The same number for wheels on the ground, now and at the design position.
pub(crate) fn of_both_from_design<N: Number>(
    names: &Names,
    dimension: Dimension,
    value: FromDesign<N>,
) -> Vec<Reading<N>> {
    of_each_axle(names, &Axle::is_on_ground, &|wheels| {
        Some(reading(dimension, move |reader: &Reader<'_, N>| {
            let number = || {
                let [left, right] = sided(reader, wheels)?;
                let [of_left, of_right] = [left, right].map(|rolling| reader.at_design(rolling));
                let now = [reader.wheel(left), reader.wheel(right)];
                Some(value(now, [of_left?, of_right?]))
            };
            number().unwrap_or_else(N::unknown)
        }))
    })
}

/// The same number for one axle.
fn both<N: Number>(
    wheels: [Rolling; 2],
    dimension: Dimension,
    value: impl Fn([&Wheel<N>; 2]) -> N + 'static,
) -> Reading<N> {
    reading(dimension, move |reader: &Reader<'_, N>| {
        let wheels = sided(reader, wheels);
        wheels.map_or_else(N::unknown, |wheels| {
            value(wheels.map(|rolling| reader.wheel(rolling)))
        })
    })
}

/// An angle of the spin axis of each wheel of a steered axle.
pub(crate) fn of_steered_wheels<N: Number>(
    names: &Names,
    angle: fn(&Vector3<N>) -> N,
) -> Vec<Reading<N>> {
    let axles = Axle::all(names);
    of_each_wheel(names, &|rolling| {
        let mut steered = axles.iter().filter(|axle| axle.is_steered());
        let is_steered = steered.any(|axle| axle.has(rolling));
        is_steered.then(|| spin_axis(rolling, angle))
    })
}

/// A number of each axle that steers a vehicle of known wheelbase, computed from the turn, the wheelbase and the
/// track. It does not exist straight ahead, nor where toe turns a wheel the other way. The centre of the turn is on the line of
/// the rear axle only if its wheels are not steered.
pub(crate) fn of_turn<N: Number>(
    names: &Names,
    dimension: Dimension,
    value: fn(&Turn<N>, N, N) -> N,
) -> Vec<Reading<N>> {
    let Some(wheelbase) = names.vehicle.wheelbase else {
        return Vec::new();
    };
    let is_rear = |wheel: &mechanism::Wheel| wheel.axle == Some(mechanism::Axle::Rear);
    let mut rear = names.wheels.iter().filter(|wheel| is_rear(wheel));
    if rear.any(|wheel| wheel.steer.is_some()) {
        return Vec::new();
    }
    let steers = |axle: &Axle| axle.is_on_ground() && axle.is_steered();
    of_each_axle(names, &steers, &|wheels| {
        Some(both(wheels, dimension, move |wheels: [&Wheel<N>; 2]| {
            let turn = Turn::of(wheels.map(|wheel| &wheel.axis));
            let mut steered = [turn.inner, turn.outer].into_iter().map(N::value);
            if steered.any(|angle| angle < STRAIGHT) {
                return N::unknown();
            }
            value(&turn, N::still(wheelbase), track(wheels))
        }))
    })
}

/// The distance from the right contact point to the left one, along y.
pub(crate) fn track<N: Number>([left, right]: [&Wheel<N>; 2]) -> N {
    left.contact.y - right.contact.y
}

/// The position of each axle's roll centre, in the front view.
pub(crate) fn of_roll_centre<N: Number>(names: &Names) -> Vec<Reading<N>> {
    of_each_axle(names, &Axle::rolls, &|wheels| {
        components(&[Axis::Y, Axis::Z], move |reader| {
            let wheels = sided(reader, wheels);
            let in_roll = wheels.and_then(|wheels| reader.in_roll(wheels));
            let centre = in_roll.map_or(Vector3::repeat(N::unknown()), |in_roll| in_roll.centre);
            reader.axes.turned(centre)
        })
    })
}

/// A value of each wheel per radian of its axle's roll.
pub(crate) fn of_roll<N: Number>(names: &Names, value: fn(PerRoll<N>) -> N) -> Vec<Reading<N>> {
    let axles: Vec<Axle> = Axle::all(names).into_iter().filter(Axle::rolls).collect();
    of_each_wheel(names, &|rolling| {
        let wheels = axles.iter().find(|axle| axle.has(rolling))?.wheels;
        Some(reading(Dimension::AnglePerAngle, move |reader| {
            let wheels = sided(reader, wheels);
            let in_roll = wheels.and_then(|wheels| reader.in_roll(wheels));
            let per_roll = in_roll.and_then(|in_roll| in_roll.per_roll(rolling.number));
            per_roll.map_or_else(N::unknown, value)
        }))
    })
}
