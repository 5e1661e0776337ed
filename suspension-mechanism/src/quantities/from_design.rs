//! Readings of each wheel against where it is at the design position.

use crate::mechanism::{Axle, Names};
use crate::quantities::kind::Kind;
use crate::quantities::quantity::Reading;
use crate::quantities::reader::Reader;
use crate::quantities::readings::{of_each_wheel, reading};
use crate::quantities::wheel::{Number, Rolling, UNKNOWN, Wheel};

/// How far each wheel has moved from the design position.
pub(super) fn of_moved(
    names: &Names,
    on_ground: bool,
    moved: fn(&Wheel, &Wheel) -> Number,
) -> Vec<Reading> {
    of_each_wheel(names, |rolling| {
        let told = rolling.is_on_ground() || !on_ground;
        told.then(|| length(rolling, moved)).into_iter().collect()
    })
}

/// The same along the vehicle, of wheels of whose axle is known which one it is: positive away from the other axle.
pub(super) fn of_moved_from_other_axle(
    names: &Names,
    forward: fn(&Wheel, &Wheel) -> Number,
) -> Vec<Reading> {
    of_each_wheel(names, |rolling| {
        let axle = names.wheels[rolling.number].axle;
        let axle = axle.filter(|_| rolling.is_on_ground());
        let of = |axle| match axle {
            Axle::Front => length(rolling, forward),
            Axle::Rear => length(rolling, move |now, design| -forward(now, design)),
        };
        axle.map(of).into_iter().collect()
    })
}

fn length(rolling: Rolling, moved: impl Fn(&Wheel, &Wheel) -> Number + 'static) -> Reading {
    reading(Kind::Length, move |reader: &Reader<'_>| {
        let design = Wheel::at_design(reader, rolling);
        design.map_or(UNKNOWN, |design| moved(reader.wheel(rolling), &design))
    })
}
