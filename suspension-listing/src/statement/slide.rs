//! `slide strut: top on low -> high;`: a point on the line through two others, which a body or the chassis
//! carries. The strut's length, from `low` to `top`, becomes an unknown.

use syn::Ident;

use super::operands::{arrow, point_on};
use super::word::{Head, Word};
use crate::errors::{self, Errors};
use crate::form::{Along, Form};
use crate::kind::Kind;
use crate::listing::{Listing, Lowering, Named, Statement};
use crate::name::Name;
use crate::system::System;

pub(crate) const SLIDE: Word = Word {
    word: "slide",
    syntax: "slide strut: top on low -> high;",
    read: |head: Head, input, listing| {
        let named = head.named(input)?;
        let point = point_on(input, "slide name: point on from -> to;")?;
        let [from, to] = arrow(input)?;
        let points = [point, from, to];
        listing.statements.push(Box::new(Slide { named, points }));
        Ok(())
    },
};

struct Slide {
    named: Named,
    /// The sliding point, and the ends of the line.
    points: [Ident; 3],
}

impl Statement for Slide {
    fn named(&self) -> Option<(&Named, Kind)> {
        Some((&self.named, Kind::SLIDE))
    }

    fn operands(&self) -> Vec<&Ident> {
        self.points.iter().collect()
    }

    fn lower(&self, lowering: &mut Lowering<'_>) {
        let name = Name::from(&self.named.name);
        let [point, from, to] = self.points.each_ref().map(|point| lowering.site(point));
        let form = Form::Along(Along {
            from,
            ends: vec![to],
            point,
            distances: vec![name.clone()],
        });
        lowering.system.scalars.push(name);
        lowering.equation_of(Kind::SLIDE, &self.named, form);
    }

    /// Checks that the line keeps its length, and that the point is not fixed to it.
    fn check_lowered(&self, listing: &Listing, system: &System, errors: &mut Errors) {
        let [point, from, to] = &self.points;
        if !listing.has_points(&self.points) || from == to {
            return;
        }
        if let Some(body) = system.body_of(&self.points) {
            let line = format!("`{point}` and the line that it slides on are points");
            errors.push(errors::points_of_one_body(
                point,
                &line,
                body,
                "; take the line",
            ));
        }
        if !listing.keeps_apart(system, [from, to]) {
            errors.push(listing.distance_not_constant([from, to], "a line to slide on"));
        }
    }
}
