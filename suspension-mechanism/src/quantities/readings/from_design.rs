//! Readings of each wheel relative to its design position.

use crate::file::Dimension;
use crate::mechanism::{Axle, Names};
use crate::quantities::formulas::Reading;
use crate::quantities::number::Number;
use crate::quantities::reader::Reader;
use crate::quantities::reader::wheel::{Rolling, Wheel};
use crate::quantities::readings::{of_each_wheel, reading};

/// The displacement of each wheel from the design position.
pub(crate) fn of_moved<N: Number>(
    names: &Names,
    on_ground: bool,
    moved: fn(&Wheel<N>, &Wheel<N>) -> N,
) -> Vec<Reading<N>> {
    of_each_wheel(names, &|rolling| {
        let has_value = rolling.is_on_ground() || !on_ground;
        has_value.then(|| length(rolling, moved))
    })
}

/// The displacement along the vehicle, for wheels whose axle is known: positive away from the other axle.
pub(crate) fn of_moved_from_other_axle<N: Number>(
    names: &Names,
    forward: fn(&Wheel<N>, &Wheel<N>) -> N,
) -> Vec<Reading<N>> {
    of_each_wheel(names, &|rolling| {
        let axle = names.wheels[rolling.number].axle;
        let axle = axle.filter(|_| rolling.is_on_ground())?;
        Some(match axle {
            Axle::Front => length(rolling, forward),
            Axle::Rear => length(rolling, move |now: &Wheel<N>, design: &Wheel<N>| {
                -forward(now, design)
            }),
        })
    })
}

fn length<N: Number>(
    rolling: Rolling,
    moved: impl Fn(&Wheel<N>, &Wheel<N>) -> N + 'static,
) -> Reading<N> {
    reading(Dimension::Length, move |reader: &Reader<'_, N>| {
        let design = reader.at_design(rolling);
        design.map_or_else(N::unknown, |design| moved(reader.wheel(rolling), design))
    })
}
