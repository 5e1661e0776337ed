//! Drives: the coordinates that they prescribe, and their values at given points.

use nalgebra::Vector3;
use suspension_core::generated::{dot, moved_along};
use suspension_core::model::constraint::{angle_to_coordinate, turn_to_coordinate};
use suspension_core::model::parts;
use suspension_core::{Real, Scalar, Signal, Values};

use crate::model::Model;
use crate::plan::{Drive, Measure};
use crate::quantity::{coordinate, coordinate_mut, measured, sum};
use crate::size::{Chassis, Few, Points, Room, Size};
use crate::table::Table;

impl<T: Scalar, const N: usize> Model<'_, T, N>
where
    Room<N>: Size,
{
    /// Sets the coordinate that each driving angle prescribes.
    #[inline(never)]
    pub(crate) fn put_angles(&self, drives: &mut Signal<Few<T, N>>) {
        for (place, drive) in (0..).zip(&self.plan().drives) {
            let angle = drives.map(|each| each.get(place));
            if let Some(coordinate) = self.coordinate_of(drive, angle) {
                drives.set(coordinate, |drives| drives.place(place));
            }
        }
    }

    /// The coordinate that a driving angle prescribes.
    #[inline(always)]
    pub(crate) fn coordinate_of(&self, drive: &Drive, angle: Signal<T>) -> Option<Signal<T>> {
        let of = drive.angle_of?;
        Some(match drive.quantity {
            Measure::Between { .. } => turn_to_coordinate(self.turns.get(of).length(), angle),
            _ => {
                let distance = self.distances.get(of);
                angle_to_coordinate(distance.length(), angle)
            }
        })
    }

    #[inline(always)]
    pub(crate) fn put_drives(&self, fixed: &mut Chassis<T, N>, drives: &Few<T, N>) {
        for (place, drive) in (0..).zip(&self.plan().drives) {
            let Some(point) = drive.moves else {
                continue;
            };
            let (point, value) = (fixed.place(point), drives.get(place));
            match &drive.quantity {
                Measure::Sum(terms) => {
                    for term in terms {
                        *coordinate_mut(point, term.axis) = value;
                    }
                }
                Measure::Along { direction, .. } => {
                    *point = moved_along(*point, direction.map(T::constant).into(), value);
                }
                _ => {}
            }
        }
    }
}

impl<T: Real, const N: usize> Model<'_, T, N>
where
    Room<N>: Size,
{
    /// The values of the drives at points.
    pub(crate) fn drives_at(&self, points: &Points<Vector3<T>, N>) -> Few<T, N> {
        let drives = self
            .plan()
            .drives
            .iter()
            .map(|drive| match &drive.quantity {
                Measure::Sum(terms) => sum(terms, |place| points.get(place)),
                Measure::Angle { axis, line } => {
                    let [from, to] = line.map(|point| coordinate(&points.get(point), *axis));
                    let of = drive.angle_of;
                    let distance = of.map(|distance| self.distances.get(distance));
                    let length = distance.map_or(T::zero(), |distance| distance.length());
                    parts::angle(to - from, length)
                }
                Measure::Between { .. } => {
                    measured(&drive.quantity, |place| Signal::still(points.get(place))).value
                }
                Measure::Length { line } => {
                    let [from, to] = line.map(|point| points.get(point));
                    (to - from).norm()
                }
                Measure::Along { point, direction } => {
                    dot(points.get(*point), direction.map(T::constant).into())
                }
            });
        Few::<T, N>::from_values(drives)
    }
}
