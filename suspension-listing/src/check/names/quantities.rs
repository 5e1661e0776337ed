//! The operands of drives, measures, markers and roles.

use syn::Ident;

use super::Check;
use crate::ast::{Axis, Constraint, Coordinate, Drive, Marker, Measure, Measured, Quantity};
use crate::errors;
use crate::system::AXES;

impl Check<'_> {
    pub(super) fn drives(&mut self) {
        let drives = &self.listing.drives;
        for (index, drive) in drives.iter().enumerate() {
            self.drive(drive);
            let same = drives
                .iter()
                .take(index)
                .find(|earlier| earlier.prescribes() == drive.prescribes());
            if let Some(earlier) = same {
                let error = errors::coordinate_driven_twice(&drive.named.name, &earlier.named.name);
                self.errors.push(error);
            }
        }
    }

    fn drive(&mut self, drive: &Drive) {
        match &drive.quantity {
            Quantity::Coordinate { of, minus } => {
                self.axis(&of.axis);
                self.sites(
                    [&of.point]
                        .into_iter()
                        .chain(minus.iter().map(|minus| &minus.point)),
                );
                if minus.is_none() {
                    self.bends_no_body(&drive.named.name, &of.point);
                }
                if let Some(minus) = minus {
                    self.along_one_axis(of, minus);
                    self.not_all_fixed(&drive.named.name, [&of.point, &minus.point]);
                }
            }
            Quantity::Angle { from, to, axis } => {
                self.axis(axis);
                self.sites([from, to]);
                self.not_all_fixed(&drive.named.name, [from, to]);
            }
        }
    }

    pub(super) fn measure(&mut self, measure: &Measure) {
        match &measure.measured {
            Measured::Quantity(Quantity::Coordinate { of, minus: None }) => {
                self.axis(&of.axis);
                self.placed(&of.point);
            }
            Measured::Quantity(Quantity::Coordinate {
                of,
                minus: Some(minus),
            }) => {
                self.axis(&of.axis);
                self.along_one_axis(of, minus);
                self.two_placed([&of.point, &minus.point]);
            }
            Measured::Quantity(Quantity::Angle { from, to, axis }) => {
                self.axis(axis);
                self.two_placed([from, to]);
            }
            Measured::Length { from, to } => self.two_placed([from, to]),
        }
    }

    fn along_one_axis(&mut self, of: &Coordinate, minus: &Coordinate) {
        if minus.axis != of.axis {
            self.errors
                .push(errors::different_axes(&minus.axis, &of.axis));
        }
    }

    /// Checks that a point exists, a marker or not.
    fn placed(&mut self, point: &Ident) {
        let kinds = ["free point", "chassis point", "marker"];
        if !kinds.iter().any(|kind| self.is(point, kind)) {
            self.missing(errors::unknown_point(point));
        }
    }

    fn two_placed(&mut self, points: [&Ident; 2]) {
        points.into_iter().for_each(|point| self.placed(point));
        let [first, second] = points;
        if first == second {
            self.errors.push(errors::same_point_twice(second));
        }
    }

    /// Checks that a driven chassis point is not one of two in a body, whose size it would change.
    fn bends_no_body(&mut self, drive: &Ident, point: &Ident) {
        for constraint in &self.listing.constraints {
            let Constraint::Body(body) = constraint else {
                continue;
            };
            let mut anchors = body.points.clone();
            anchors.retain(|point| self.is(point, "chassis point"));
            if anchors.len() > 1 && anchors.contains(point) {
                self.errors
                    .push(errors::body_bent(drive, point, &body.named.name));
            }
        }
    }

    fn not_all_fixed(&mut self, drive: &Ident, points: [&Ident; 2]) {
        if points.iter().all(|point| self.is(point, "chassis point")) {
            self.errors.push(errors::all_fixed(drive, "drive"));
        }
    }

    fn axis(&mut self, axis: &Ident) {
        if !AXES.iter().any(|name| axis == name) {
            self.errors.push(errors::unknown_axis(axis));
        }
    }

    pub(super) fn marker(&mut self, marker: &Marker) {
        match marker.carriers.as_slice() {
            [body]
                if self
                    .listing
                    .body(body)
                    .is_some_and(|body| body.points.len() >= 3) => {}
            [_, _, _] => self.sites(&marker.carriers),
            carriers => self.missing(errors::bad_carriers(&marker.named.name, carriers)),
        }
    }

    pub(super) fn role(&mut self, stated: &[Axis]) {
        for repeated in stated.iter().skip(1) {
            self.errors
                .push(errors::role_stated_twice(&repeated.keyword));
        }
        for Axis { from, to, .. } in stated {
            self.two_placed([from, to]);
        }
    }

    pub(super) fn wheel_carrier(&mut self, Axis { from, to, .. }: &Axis) {
        let known = [from, to]
            .iter()
            .all(|point| self.taken.contains_key(point));
        if known && from != to && self.listing.carrier_of(from, to).is_none() {
            self.missing(errors::wheel_without_carrier(from, to));
        }
    }
}
