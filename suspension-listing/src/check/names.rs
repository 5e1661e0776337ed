//! Whether every name and operand of a listing makes sense: what names stand for.

mod constraints;
mod quantities;

use std::collections::BTreeMap;

use syn::Ident;

use super::{constant, is_reserved};
use crate::ast::{Constraint, Listing};
use crate::errors::{self, Errors};
use crate::name::Name;

/// Checks every name and operand of the listing.
pub fn names(listing: &Listing, errors: &mut Errors) {
    let mut check = Check {
        listing,
        taken: BTreeMap::new(),
        errors,
    };
    check.declarations();
    check.constraints();
    check.lengths_stated_once();
    check.drives();
    for measure in &listing.measures {
        check.measure(measure);
    }
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
                .for_each(|point| self.declare(&point.named.name, kind));
            if points.is_empty() {
                self.missing(errors::nothing_declared(listing.span, keyword));
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
        listing
            .measures
            .iter()
            .for_each(|measure| self.declare(&measure.named.name, "measure"));
        if listing.drives.is_empty() {
            self.missing(errors::nothing_declared(listing.span, "drive"));
        }
    }

    /// Reports that something is missing, unless a statement that could not be read may hold it.
    fn missing(&mut self, error: syn::Error) {
        if !self.listing.incomplete {
            self.errors.push(error);
        }
    }

    fn declare(&mut self, name: &Ident, kind: &'static str) {
        let constant = |name: &Ident| constant(Name::from(name).as_str());
        if is_reserved(&name.to_string()) {
            self.errors.push(errors::reserved_name(name));
        }
        let mut taken = self.taken.iter();
        if let Some((_, first)) = taken.find(|(taken, _)| constant(taken) == constant(name)) {
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
}
