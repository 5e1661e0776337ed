//! `plane guide: centre on a, b, c;`: a point in the plane through three others, which may move. Its distances from the
//! first, along the lines to the second and the third, become unknowns.

use proc_macro2::Span;
use syn::{Error, Ident};

use super::operands::{names, point_on};
use super::word::{Head, Word};
use crate::errors::{self, Errors};
use crate::form::{Along, Form};
use crate::kind::Kind;
use crate::listing::{Listing, Lowering, Named, Statement};
use crate::name::Name;
use crate::system::{System, distance_name};

const KIND: Kind = Kind("plane");

pub(crate) const PLANE: Word = Word {
    word: "plane",
    syntax: "plane guide: d on a, b, c;",
    read: |head: Head, input, listing| {
        let named = head.named(input)?;
        let point = point_on(input, "plane name: point on a, b, c;")?;
        let corners = names(input)?;
        let [a, b, c] = <[Ident; 3]>::try_from(corners)
            .map_err(|corners| not_three_points(named.name.span(), corners.len()))?;
        let points = [point, a, b, c];
        listing.statements.push(Box::new(Plane { named, points }));
        Ok(())
    },
};

struct Plane {
    named: Named,
    /// The point in the plane, and the three points that the plane goes through.
    points: [Ident; 4],
}

impl Statement for Plane {
    fn named(&self) -> Option<(&Named, Kind)> {
        Some((&self.named, KIND))
    }

    fn operands(&self) -> Vec<&Ident> {
        self.points.iter().collect()
    }

    fn lower(&self, lowering: &mut Lowering<'_>) {
        let name = Name::from(&self.named.name);
        let [point, from, b, c] = self.points.each_ref().map(|point| lowering.site(point));
        let distances = [&b, &c].map(|end| distance_name(&name, &end.name));
        lowering.system.scalars.extend(distances.clone());
        let form = Form::Along(Along {
            from,
            ends: vec![b, c],
            point,
            distances: distances.to_vec(),
        });
        lowering.equation_of(KIND, &self.named, form);
    }

    /// Checks that the point is not fixed to the plane.
    fn check_lowered(&self, _listing: &Listing, system: &System, errors: &mut Errors) {
        if let Some(body) = system.body_of(&self.points) {
            let [point, ..] = &self.points;
            let plane = format!("`{point}` and the plane that it stays in are points");
            errors.push(errors::points_of_one_body(
                point,
                &plane,
                body,
                "; take a plane",
            ));
        }
    }
}

fn not_three_points(span: Span, count: usize) -> Error {
    Error::new(
        span,
        format!("a plane goes through three points; name three after `on`, not {count}"),
    )
}
