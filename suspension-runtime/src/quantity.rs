//! Quantities that are read off the points: the measures of the listing, and what a drive prescribes.

use nalgebra::Vector3;
use suspension_core::generated::dot;
use suspension_core::model::measure;
use suspension_core::{Real, Scalar, Signal};

use crate::model::Model;
use crate::plan::{Coordinate, Measure};
use crate::size::{Few, Points, Room, Size};
use crate::table::Table;

impl<T: Real, const N: usize> Model<'_, T, N>
where
    Room<N>: Size,
{
    /// The measures of the listing, from points by their indices.
    pub fn measures_of(
        &self,
        point: impl Fn(usize) -> Signal<Vector3<T>>,
    ) -> impl Iterator<Item = Signal<T>> {
        let quantities = self.plan().measures.iter();
        quantities.map(move |quantity| measured(quantity, |place| point(place.into())))
    }

    pub(crate) fn measures(&self, points: &Signal<Points<Vector3<T>, N>>) -> Signal<Few<T, N>> {
        let mut measures: Signal<Few<T, N>> = Signal::default();
        for (place, quantity) in (0..).zip(&self.plan().measures) {
            let each = measured(quantity, |place| points.map(|points| points.get(place)));
            measures.set(each, |measures| measures.place(place));
        }
        measures
    }
}

/// A quantity and its rates, from points by their indices.
pub(crate) fn measured<T: Real>(
    quantity: &Measure,
    point: impl Fn(u16) -> Signal<Vector3<T>>,
) -> Signal<T> {
    let line = |ends: [u16; 2]| {
        let [from, to] = ends.map(&point);
        Signal {
            value: to.value - from.value,
            rate: to.rate - from.rate,
            second_rate: to.second_rate - from.second_rate,
        }
    };
    match quantity {
        Measure::Sum(terms) => Signal {
            value: sum(terms, |place| point(place).value),
            rate: sum(terms, |place| point(place).rate),
            second_rate: sum(terms, |place| point(place).second_rate),
        },
        Measure::Angle { axis, line: ends } => {
            let mut along = Vector3::zeros();
            *coordinate_mut(&mut along, *axis) = T::one();
            measure::angle(&line(*ends), along)
        }
        Measure::Between { lines, about } => {
            let [first, second] = lines.map(line);
            match about.map(line) {
                Some(about) => measure::turn(&first, &second, &about),
                None => measure::between(&first, &second),
            }
        }
        Measure::Length { line: ends } => measure::length(&line(*ends)),
        Measure::Along {
            point: of,
            direction,
        } => {
            let direction = direction.map(T::constant).into();
            point(*of).map(|point| dot(*point, direction))
        }
    }
}

/// A sum of coordinates.
pub(crate) fn sum<T: Scalar>(terms: &[Coordinate], point: impl Fn(u16) -> Vector3<T>) -> T {
    let terms = terms.iter();
    let values =
        terms.map(|term| T::constant(term.factor) * coordinate(&point(term.point), term.axis));
    values
        .reduce(|sum, value| sum + value)
        .unwrap_or_else(T::zero)
}

pub(crate) fn coordinate<T: Scalar>(vector: &Vector3<T>, axis: u16) -> T {
    match axis {
        0 => vector.x,
        1 => vector.y,
        _ => vector.z,
    }
}

#[inline(always)]
pub(crate) fn coordinate_mut<T: Scalar>(vector: &mut Vector3<T>, axis: u16) -> &mut T {
    match axis {
        0 => &mut vector.x,
        1 => &mut vector.y,
        _ => &mut vector.z,
    }
}
