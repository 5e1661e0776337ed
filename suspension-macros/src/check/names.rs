//! Whether every name and operand of a listing makes sense.

use std::collections::{BTreeMap, BTreeSet};

use syn::Ident;

use super::{constant, is_reserved};
use crate::ast::{Axis, Body, Constraint, Drive, Link, Listing, Marker, Quantity};
use crate::errors::{self, Errors};
use crate::system::AXES;

/// Checks every name and operand of the listing.
pub(crate) fn names(listing: &Listing, errors: &mut Errors) {
    let mut check = Check {
        listing,
        taken: BTreeMap::new(),
        errors,
    };
    check.declarations();
    check.constraints();
    check.lengths_stated_once();
    check.drives();
    for marker in &listing.markers {
        check.marker(marker);
    }
    check.role(&listing.wheel);
    check.role(&listing.kingpin);
    if let [wheel] = listing.wheel.as_slice() {
        check.wheel_carrier(wheel);
    }
}

struct Check<'a> {
    listing: &'a Listing,
    /// What each name stands for.
    taken: BTreeMap<Ident, &'static str>,
    errors: &'a mut Errors,
}

impl<'a> Check<'a> {
    fn declarations(&mut self) {
        let listing = self.listing;
        for (kind, keyword, points) in [
            ("chassis point", "fixed", &listing.fixed),
            ("free point", "free", &listing.free),
        ] {
            points
                .iter()
                .for_each(|point| self.declare(&point.name, kind));
            if points.is_empty() {
                self.missing(errors::nothing_declared(&listing.name, keyword));
            }
        }
        listing
            .markers
            .iter()
            .for_each(|marker| self.declare(&marker.named.name, "marker"));
        for constraint in &listing.constraints {
            match constraint {
                Constraint::Link(link) => self.declare(&link.named.name, "link"),
                Constraint::Body(body) => self.declare(&body.named.name, "body"),
            }
        }
        listing
            .drives
            .iter()
            .for_each(|drive| self.declare(&drive.named.name, "drive"));
        if listing.drives.is_empty() {
            self.missing(errors::nothing_declared(&listing.name, "drive"));
        }
    }

    /// Reports that something is missing, unless a statement that could not be read may hold it.
    fn missing(&mut self, error: syn::Error) {
        if !self.listing.incomplete {
            self.errors.push(error);
        }
    }

    fn declare(&mut self, name: &Ident, kind: &'static str) {
        if is_reserved(name) {
            self.errors.push(errors::reserved_name(name));
        }
        let first = self
            .taken
            .iter()
            .find(|(taken, _)| constant(taken) == constant(name));
        if let Some((_, first)) = first {
            self.errors.push(errors::duplicate_name(name, first));
        } else {
            self.taken.insert(name.clone(), kind);
        }
    }

    fn is(&self, name: &Ident, kind: &str) -> bool {
        self.taken.get(name).is_some_and(|taken| *taken == kind)
    }

    /// Checks that points exist, with unknowns or on the chassis, and are not repeated.
    fn sites<'p>(&mut self, points: impl IntoIterator<Item = &'p Ident>) {
        let mut seen: Vec<&Ident> = Vec::new();
        for point in points {
            if self.is(point, "marker") {
                self.errors.push(errors::marker_in_constraint(point));
            } else if !self.is(point, "free point") && !self.is(point, "chassis point") {
                self.missing(errors::unknown_point(point));
            } else if seen.contains(&point) {
                self.errors.push(errors::same_point_twice(point));
            }
            seen.push(point);
        }
    }

    fn constraints(&mut self) {
        for constraint in &self.listing.constraints {
            match constraint {
                Constraint::Link(link) => self.link(link),
                Constraint::Body(body) => self.body(body),
            }
        }
    }

    fn link(&mut self, Link { named, from, to }: &Link) {
        self.sites([from, to]);
        if self.is(from, "chassis point") && self.is(to, "chassis point") {
            self.errors.push(errors::all_fixed(&named.name, "link"));
        }
    }

    fn body(&mut self, Body { named, points }: &Body) {
        self.sites(points);
        let anchors = points
            .iter()
            .filter(|point| self.is(point, "chassis point"))
            .count();
        if points.len() < 2 {
            self.errors.push(errors::too_few_points(&named.name));
        } else if anchors == points.len() {
            self.errors.push(errors::all_fixed(&named.name, "body"));
        } else if anchors > 2 {
            self.errors.push(errors::immovable_body(&named.name));
        }
    }

    /// Checks that no two constraints keep the distance of the same two points, save the common
    /// edge of two hinged bodies.
    fn lengths_stated_once(&mut self) {
        let constraints = &self.listing.constraints;
        for (index, later) in constraints.iter().enumerate() {
            for earlier in constraints.iter().take(index) {
                let common: BTreeSet<&Ident> = later
                    .points()
                    .filter(|point| earlier.points().any(|p| p == *point))
                    .collect();
                if !common.iter().any(|point| self.is(point, "free point")) {
                    continue;
                }
                match (later, earlier, common.len()) {
                    (Constraint::Body(a), Constraint::Body(b), 3..) => {
                        self.errors
                            .push(errors::shared_triangle(&a.named.name, &b.named.name));
                    }
                    (Constraint::Body(_), Constraint::Body(_), _) | (_, _, 0 | 1) => {}
                    (Constraint::Link(_), _, _) => self.stated_twice(later, earlier),
                    (_, Constraint::Link(_), _) => self.stated_twice(earlier, later),
                }
            }
        }
    }

    fn stated_twice(&mut self, link: &Constraint, other: &Constraint) {
        let other = other.name().to_string();
        self.errors
            .push(errors::length_stated_twice(link.name(), &other));
    }

    fn drives(&mut self) {
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
                    if minus.axis != of.axis {
                        self.errors
                            .push(errors::different_axes(&minus.axis, &of.axis));
                    }
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

    /// Checks that a driven chassis point is not one of two in a body, whose size it would change.
    fn bends_no_body(&mut self, drive: &Ident, point: &Ident) {
        for constraint in &self.listing.constraints {
            let Constraint::Body(body) = constraint else {
                continue;
            };
            let anchors = body
                .points
                .iter()
                .filter(|point| self.is(point, "chassis point"));
            let bent = anchors.count() > 1 && body.points.contains(point);
            if bent && self.is(point, "chassis point") {
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

    fn marker(&mut self, marker: &Marker) {
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

    fn role(&mut self, stated: &[Axis]) {
        for repeated in stated.iter().skip(1) {
            self.errors
                .push(errors::role_stated_twice(&repeated.keyword));
        }
        for Axis { from, to, .. } in stated {
            for point in [from, to] {
                if !["free point", "chassis point", "marker"]
                    .iter()
                    .any(|kind| self.is(point, kind))
                {
                    self.missing(errors::unknown_point(point));
                }
            }
            if from == to {
                self.errors.push(errors::same_point_twice(to));
            }
        }
    }

    fn wheel_carrier(&mut self, Axis { from, to, .. }: &Axis) {
        let known = [from, to]
            .iter()
            .all(|point| self.taken.contains_key(point));
        if known && from != to && self.listing.carrier_of(from, to).is_none() {
            self.missing(errors::wheel_without_carrier(from, to));
        }
    }
}
