//! How a model's constants change.

use nalgebra::Vector3;
use suspension_core::generated::dot;
use suspension_core::model::constraint::{Carried, Frame};
use suspension_core::{Real, Scalar, Signal, Values};

use super::{Given, Start};
use crate::plan::{Drive, LineLength, Measure};
use crate::quantity::measured;
use crate::site::{Site, Sites};
use crate::size::{Few, Room, Size};
use crate::table::Table;

impl<T: Real, const N: usize> Given<'_, '_, T, N>
where
    Room<N>: Size,
{
    pub(super) fn carried(&self) -> Few<Carried<T>, N> {
        let Start {
            model, unknowns, ..
        } = self.start;
        let (at, moved) = (unknowns.sites(), self.moved.sites());
        let bodies = model.forms().bodies.iter();
        let points = bodies.flat_map(|body| body.carried.iter().map(move |point| (body, point)));
        let points = points.zip(model.carried.as_slice());
        let rates = points.map(|((body, carried), constant)| {
            let frames = body.frame(&at).zip(body.frame(&moved));
            let rate = frames.zip(moved.get(carried.point));
            rate.map(|(frames, by)| carried_rate(constant, frames, by))
        });
        Values::from_values(rates.map(Option::unwrap_or_default))
    }

    pub(super) fn markers(&self) -> Few<Carried<T>, N> {
        let Start { model, points, .. } = self.start;
        let plan = model.plan();
        let markers = (plan.chassis + plan.free..).zip(&plan.markers);
        let rates = markers.zip(model.markers.as_slice());
        Values::from_values(rates.map(|((marker, carriers), constant)| {
            let frames = (
                model.frame_of(*carriers, points),
                self.moved.frame(*carriers),
            );
            carried_rate(constant, frames, self.moved_by(marker))
        }))
    }

    pub(super) fn scales(&self) -> Few<T, N> {
        let Start {
            model, unknowns, ..
        } = self.start;
        let (at, moved) = (unknowns.sites(), self.moved.sites());
        let rates = model.forms().scales.iter().map(|scale| {
            // A mean of lengths is a factor of unknowns.
            let (kept, [line]) = (scale.kept?, scale.lines.as_slice()) else {
                return None;
            };
            let [d, by] = [&at, &moved].map(|sites| between(sites, *line));
            Some(dot(d?, by?) / dot(d?, d?) + self.longer(kept, d?))
        });
        Values::from_values(rates.map(Option::unwrap_or_default))
    }

    /// The relative increase of a line due to the lengths that change.
    pub(super) fn longer(&self, kept: LineLength, line: Vector3<T>) -> T {
        let LineLength::Given(Some(length)) = kept else {
            return T::zero();
        };
        self.longer_by(length) / line.norm()
    }

    /// The displacement of a point.
    fn moved_by(&self, point: u16) -> Vector3<T> {
        let points = self.points.iter();
        let of_it = points.filter(|(place, _)| *place == usize::from(point));
        of_it.fold(Vector3::zeros(), |sum, (_, by)| sum + by)
    }

    fn longer_by(&self, length: u16) -> T {
        let lengths = self.lengths.iter();
        let of_it = lengths.filter(|(place, _)| *place == usize::from(length));
        of_it.fold(T::zero(), |sum, (_, by)| sum + *by)
    }

    pub(super) fn coordinates(&self) -> Signal<Few<T, N>> {
        let point = |place| Signal {
            value: self.start.points.get(place),
            rate: self.moved_by(place),
            second_rate: Vector3::zeros(),
        };
        let mut coordinates: Signal<Few<T, N>> = Signal::default();
        for (place, drive) in (0..).zip(&self.start.model.plan().drives) {
            let moved = measured(&drive.quantity, point).rate;
            let change = self.coordinate(drive, self.start.drives.get(place), moved);
            coordinates.set(change, |coordinates| coordinates.place(place));
        }
        coordinates
    }

    /// The change of the coordinate that a drive prescribes: of its value and, for an angle, due to the length that
    /// converts it to a coordinate.
    fn coordinate(&self, drive: &Drive, value: T, moved: T) -> Signal<T> {
        let Start {
            model, unknowns, ..
        } = self.start;
        let per_drive = Signal {
            value,
            rate: T::one(),
            second_rate: T::zero(),
        };
        let Some(coordinate) = model.coordinate_of(drive, per_drive) else {
            return Signal::still(moved);
        };
        // The third derivative of a cosine, or of the sine of a quarter of the angle.
        let (third, longer) = match drive.quantity {
            Measure::Between { .. } => (-coordinate.rate / T::constant(16.0), T::zero()),
            _ => {
                let distance = drive
                    .angle_of
                    .and_then(|of| model.forms().distances.get(usize::from(of)));
                let longer = distance.and_then(|distance| {
                    let d = distance.span.vector(&unknowns.sites())?;
                    let by = distance.span.vector(&self.moved.sites())?;
                    Some(dot(d, by) / dot(d, d) + self.longer_by(distance.length) / d.norm())
                });
                (-coordinate.rate, longer.unwrap_or_else(T::zero))
            }
        };
        Signal {
            value: longer * coordinate.value + moved * coordinate.rate,
            rate: longer * coordinate.rate + moved * coordinate.second_rate,
            second_rate: longer * coordinate.second_rate + moved * third,
        }
    }
}

/// The vector from one site to another.
fn between<T: Scalar, F: Table<Vector3<T>>>(
    sites: &Sites<'_, T, F>,
    [from, to]: [Site; 2],
) -> Option<Vector3<T>> {
    Some(sites.get(to)? - sites.get(from)?)
}

/// The derivatives of the constants of a carried point when it and its frame are moved: the constants of its
/// displacement relative to the frame.
fn carried_rate<T: Real>(
    constant: &Carried<T>,
    (frame, moved): (Frame<T>, Frame<T>),
    by: Vector3<T>,
) -> Carried<T> {
    let against = by - constant.velocity(&frame, &moved);
    if against == Vector3::zeros() {
        return Carried::default();
    }
    Carried::new(frame.origin + against, &frame).unwrap_or_default()
}
