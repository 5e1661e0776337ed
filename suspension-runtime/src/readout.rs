//! All points and their rates from the unknowns, the measures of the listing, the values of drives and how they enter.

use nalgebra::{SVector, Vector3};
use suspension_core::generated::{dot, moved_along};
use suspension_core::model::constraint::{Carried, Frame, angle_to_coordinate, turn_to_coordinate};
use suspension_core::model::{measure, parts};
use suspension_core::{Real, Scalar, Signal, Values};

use crate::equations::rows;
use crate::form::{Walked, walk};
use crate::model::Model;
use crate::plan::{Coordinate, Drive, Measure};
use crate::site::{Site, Sites};
use crate::size::{Few, Points, Room, Size};
use crate::table::Table;

impl<T: Scalar, const N: usize> Model<'_, T, N>
where
    Room<N>: Size,
{
    /// Chassis points, free points, and markers, each made from the sites that carry it.
    pub(crate) fn all_points(
        &self,
        q: &SVector<T, N>,
        fixed: &Few<Vector3<T>, N>,
        marker: impl Fn(&Carried<T>, [Site; 3], &Frame<T>) -> Vector3<T>,
    ) -> Points<Vector3<T>, N> {
        let plan = self.plan();
        let sites = Sites::new(q.as_slice(), fixed);
        let [free] = &q.data.0;
        let (free, _) = free.as_chunks();
        let mut points = Points::<Vector3<T>, N>::default();
        let mut places = points.as_mut_slice().iter_mut();
        let chassis = fixed.as_slice().iter().take(plan.chassis.into());
        for (point, place) in chassis.zip(&mut places) {
            *place = *point;
        }
        for (&[x, y, z], place) in free.iter().take(plan.free.into()).zip(&mut places) {
            *place = Vector3::new(x, y, z);
        }
        let markers = plan.markers.iter().zip(self.markers.as_slice());
        for ((carriers, constant), place) in markers.zip(&mut places) {
            if let Some([a, b, c]) = sites.get_each(*carriers) {
                *place = marker(constant, *carriers, &Frame::new(a, b, c));
            }
        }
        points
    }

    /// Adds the effect of forces at markers to the forces at the points that carry them.
    pub(crate) fn carry_forces(
        &self,
        q: &SVector<T, N>,
        fixed: &Few<Vector3<T>, N>,
        forces: &mut Points<Vector3<T>, N>,
    ) {
        let plan = self.plan();
        let sites = Sites::new(q.as_slice(), fixed);
        let markers = plan.markers.iter().zip(self.markers.as_slice());
        for (marker, (carriers, constant)) in (plan.chassis + plan.free..).zip(markers) {
            if let Some([a, b, c]) = sites.get_each(*carriers) {
                let parts = constant.by_frame(forces.get(marker), &Frame::new(a, b, c));
                for (site, part) in carriers.iter().zip(parts) {
                    *forces.place(self.point(*site)) += part;
                }
            }
        }
    }

    /// The frame of three sites among all points.
    pub(crate) fn frame_of(&self, sites: [Site; 3], points: &Points<Vector3<T>, N>) -> Frame<T> {
        let [a, b, c] = sites.map(|site| points.get(self.point(site)));
        Frame::new(a, b, c)
    }

    /// The index of a site among all points.
    pub(crate) fn point(&self, site: Site) -> u16 {
        match site {
            Site::Free(first) => self.plan().chassis + first / 3,
            Site::Chassis(point) => point,
        }
    }

    pub(crate) fn unknowns(&self, points: &Points<Vector3<T>, N>) -> SVector<T, N> {
        let plan = self.plan();
        let free = (0..plan.free).map(|free| points.get(plan.chassis + free));
        let mut q = SVector::from([T::zero(); N]);
        let [places] = &mut q.data.0;
        let (places, _) = places.as_chunks_mut();
        for ([x, y, z], point) in places.iter_mut().zip(free) {
            (*x, *y, *z) = (point.x, point.y, point.z);
        }
        let chassis = points.values().take(plan.chassis.into());
        self.put_scalars(&mut q, &Few::<_, N>::from_values(chassis));
        q
    }

    /// Sets the unknowns that are not coordinates.
    pub(crate) fn put_scalars(&self, q: &mut SVector<T, N>, fixed: &Few<Vector3<T>, N>) {
        let q = rows(q);
        walk!(self.forms(), all(), self, |form, constant| {
            form.put_scalars(constant, q, fixed)
        });
    }

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
    pub(crate) fn put_drives(&self, fixed: &mut Few<Vector3<T>, N>, drives: &Few<T, N>) {
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
    /// The measures of the listing, from points by their indices.
    pub fn measures_of(
        &self,
        point: impl Fn(usize) -> Signal<Vector3<T>>,
    ) -> impl Iterator<Item = Signal<T>> {
        let quantities = self.plan().measures.iter();
        quantities.map(move |quantity| measured(quantity, |place| point(place.into())))
    }

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
fn sum<T: Scalar>(terms: &[Coordinate], point: impl Fn(u16) -> Vector3<T>) -> T {
    let terms = terms.iter();
    let values =
        terms.map(|term| T::constant(term.factor) * coordinate(&point(term.point), term.axis));
    values
        .reduce(|sum, value| sum + value)
        .unwrap_or_else(T::zero)
}

fn coordinate<T: Scalar>(vector: &Vector3<T>, axis: u16) -> T {
    match axis {
        0 => vector.x,
        1 => vector.y,
        _ => vector.z,
    }
}

#[inline(always)]
fn coordinate_mut<T: Scalar>(vector: &mut Vector3<T>, axis: u16) -> &mut T {
    match axis {
        0 => &mut vector.x,
        1 => &mut vector.y,
        _ => &mut vector.z,
    }
}
