//! The operands of links and bodies.

use std::collections::BTreeSet;

use syn::Ident;

use super::Check;
use crate::ast::{Body, Constraint, Link};
use crate::errors;

impl Check<'_> {
    pub(super) fn constraints(&mut self) {
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
    pub(super) fn lengths_stated_once(&mut self) {
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
}
