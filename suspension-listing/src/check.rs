//! Checks of a listing: names and operands first, then uses, counts and structural rank.

mod determined;
mod freedom;
mod generated;
mod held;
mod lengths;
mod mirrored;
mod neither_side;
mod reserved;
mod uses;

use std::collections::{BTreeMap, BTreeSet};

use syn::Ident;

use crate::errors::{self, Errors};
use crate::kind::Kind;
use crate::listing::{Check, Listing, Rank, Statement};
use crate::name::Name;

pub(crate) use determined::determined;
pub(crate) use generated::generated_names;
pub(crate) use mirrored::report_one_side;
use neither_side::same_again;
use reserved::{constant, is_reserved};
pub(crate) use uses::chassis_points;

/// Checks every name and operand of the listing.
pub(crate) fn names(listing: &Listing, errors: &mut Errors) {
    let mut check = Check {
        listing,
        taken: BTreeMap::new(),
        errors,
    };
    check.declarations();
    for (index, statement) in listing.statements.iter().enumerate() {
        match same_again(listing, statement.as_ref()) {
            Some(error) => check.report(error),
            None => statement.check(&mut check, &listing.statements[..index]),
        }
    }
}

impl<'a> Check<'a> {
    fn declarations(&mut self) {
        let listing = self.listing;
        for (word, points) in [("fixed", &listing.fixed), ("free", &listing.free)] {
            if points.is_empty() {
                self.report_missing(errors::nothing_declared(listing.span, word));
            }
        }
        for (name, kind) in listing.declared() {
            self.declare(name, kind);
        }
        let mut statements = listing.statements.iter();
        if !statements.any(|statement| statement.rank() == Rank::Drive) {
            self.report_missing(errors::nothing_declared(listing.span, "drive"));
        }
    }

    fn declare(&mut self, name: &Ident, kind: Kind) {
        let constant = |name: &Ident| constant(Name::from(name).as_str());
        if is_reserved(&name.to_string()) {
            self.report(errors::reserved_name(name));
        }
        let mut taken = self.taken.iter();
        if let Some(first) = taken.find(|(taken, _)| constant(taken) == constant(name)) {
            let error = errors::duplicate_name(name, first);
            self.report(error);
        }
        self.taken.entry(name.clone()).or_insert(kind);
    }

    pub(crate) fn report(&mut self, error: syn::Error) {
        self.errors.push(error);
    }

    /// Reports that something is missing, unless a statement that could not be read may hold it.
    pub(crate) fn report_missing(&mut self, error: syn::Error) {
        if !self.listing.incomplete {
            self.report(error);
        }
    }

    /// Whether a name belongs to a statement that is a mirror image.
    pub(crate) fn is_image(&self, name: &Ident) -> bool {
        self.listing.images.contains(&name.to_string())
    }

    pub(crate) fn is_declared(&self, name: &Ident) -> bool {
        self.taken.contains_key(name)
    }

    pub(crate) fn is(&self, name: &Ident, kind: Kind) -> bool {
        self.taken.get(name) == Some(&kind)
    }

    fn is_any(&self, name: &Ident, kinds: &[Kind]) -> bool {
        kinds.iter().any(|kind| self.is(name, *kind))
    }

    /// Reports that there is no such point of the kinds that are allowed here.
    fn report_unknown(&mut self, point: &Ident, kinds: &[Kind]) {
        let known = self.taken.iter().filter(|(_, kind)| kinds.contains(kind));
        let may_be_marker = kinds.contains(&Kind::MARKER);
        let error = errors::unknown_point(point, may_be_marker, known.map(|(name, _)| name));
        self.report_missing(error);
    }

    /// Reports a marker where a point with unknowns is required.
    fn report_marker(&mut self, marker: &Ident) {
        let error = match self.listing.body_in_line_with(marker) {
            Some((body, [from, to, ..])) => errors::marker_in_line(marker, body, [from, to]),
            _ => errors::marker_in_constraint(marker),
        };
        self.report(error);
    }

    /// The chassis points among some points.
    pub(crate) fn anchors<'p>(
        &self,
        points: impl IntoIterator<Item = &'p Ident>,
    ) -> Vec<&'p Ident> {
        let points = points.into_iter();
        points
            .filter(|point| self.is(point, Kind::CHASSIS_POINT))
            .collect()
    }

    /// Checks that points exist, with unknowns or on the chassis, and are not repeated.
    pub(crate) fn sites<'p>(&mut self, points: impl IntoIterator<Item = &'p Ident>) {
        let kinds = [Kind::FREE_POINT, Kind::CHASSIS_POINT];
        let mut seen = BTreeSet::new();
        for point in points {
            if self.is(point, Kind::MARKER) {
                self.report_marker(point);
            } else if !self.is_any(point, &kinds) {
                self.report_unknown(point, &kinds);
            } else if seen.contains(point) {
                self.report(errors::same_point_twice(point));
            }
            seen.insert(point);
        }
    }

    /// Checks that points exist, markers or not, and are not repeated.
    pub(crate) fn placed<'p>(&mut self, points: impl IntoIterator<Item = &'p Ident>) {
        let kinds = [Kind::FREE_POINT, Kind::CHASSIS_POINT, Kind::MARKER];
        let mut seen = BTreeSet::new();
        for point in points {
            if !self.is_any(point, &kinds) {
                self.report_unknown(point, &kinds);
            }
            if !seen.insert(point) {
                self.report(errors::same_point_twice(point));
            }
        }
    }

    /// Checks that no earlier statement prescribes the same.
    pub(crate) fn prescribed_once(
        &mut self,
        later: &dyn Statement,
        earlier: &[Box<dyn Statement>],
    ) {
        let same = earlier.iter().find(|other| other.claim() == later.claim());
        let other = same.and_then(|other| other.named());
        if let (Some((other, kind)), Some((named, _))) = (other, later.named()) {
            let (name, other) = (&named.name, &other.name);
            // Images come last.
            let error = if self.is_image(name) && !self.is_image(other) {
                errors::prescribed_by_image(other, name, kind)
            } else {
                errors::prescribed_twice(name, other, kind)
            };
            self.report(error);
        }
    }

    /// Checks the points that a statement joins, and that one of them can move.
    pub(crate) fn joins(&mut self, statement: &(impl Statement + ?Sized)) {
        let points = statement.operands();
        self.sites(points.iter().copied());
        if let Some((named, kind)) = statement.named() {
            self.not_all_fixed(&named.name, kind, points);
        }
    }

    /// Checks that one of the points of a statement can move.
    pub(crate) fn not_all_fixed<'p>(
        &mut self,
        name: &Ident,
        kind: Kind,
        points: impl IntoIterator<Item = &'p Ident>,
    ) {
        let mut points = points.into_iter();
        if points.all(|point| self.is(point, Kind::CHASSIS_POINT)) {
            self.report(errors::joins_only_chassis(name, kind));
        }
    }
}
