//! `hinge arm: a, b -> c, d;`: a rigid body that turns about the line of two chassis points.

use proc_macro2::Span;
use syn::{Error, Ident, Token};

use super::operands::names;
use super::word::{Head, Word};
use crate::errors;
use crate::kind::Kind;
use crate::listing::{Check, Lowering, Named, Rigid, Statement};

const KIND: Kind = Kind::HINGE;

pub(crate) const HINGE: Word = Word {
    word: "hinge",
    syntax: "hinge arm: a, b -> c, d;",
    read: |head: Head, input, listing| {
        let named = head.named(input)?;
        let mut points = names(input)?;
        if points.len() != 2 {
            return Err(not_two_points(named.name.span(), points.len()));
        }
        input.parse::<Token![->]>()?;
        points.extend(names(input)?);
        listing.statements.push(Box::new(Hinge { named, points }));
        Ok(())
    },
};

struct Hinge {
    named: Named,
    /// The points, chassis points first.
    points: Vec<Ident>,
}

impl Statement for Hinge {
    fn named(&self) -> Option<(&Named, Kind)> {
        Some((&self.named, KIND))
    }

    fn operands(&self) -> Vec<&Ident> {
        self.points.iter().collect()
    }

    fn check(&self, check: &mut Check<'_>, earlier: &[Box<dyn Statement>]) {
        check.sites(&self.points);
        let (line, carried) = self.points.split_at(2);
        let mut moving = line
            .iter()
            .filter(|point| check.is(point, Kind::FREE_POINT));
        if let Some(point) = moving.next() {
            check.report(self.not_on_the_chassis(point));
        }
        for point in check.anchors(carried) {
            check.report(cannot_turn(&self.named.name, point));
        }
        check.lengths_stated_once(self, earlier);
    }

    fn lower(&self, lowering: &mut Lowering<'_>) {
        lowering.body(KIND, &self.named, &self.points);
    }

    fn rigid(&self) -> Option<Rigid<'_>> {
        Some(Rigid::Body(&self.points))
    }
}

impl Hinge {
    fn not_on_the_chassis(&self, point: &Ident) -> Error {
        let points: Vec<String> = self.points.iter().map(Ident::to_string).collect();
        errors::at(
            point,
            format!(
                "a hinge turns about chassis points, and `{point}` is a free point; write `body {}: {};`, which turns about the two points \
                 that it shares with another body",
                self.named.name,
                points.join(", ")
            ),
        )
    }
}

fn not_two_points(span: Span, count: usize) -> Error {
    Error::new(
        span,
        format!(
            "a hinge turns about the line of two chassis points; name two before the arrow, not {count}"
        ),
    )
}

fn cannot_turn(hinge: &Ident, point: &Ident) -> Error {
    errors::at(
        point,
        format!(
            "`{point}` is on the chassis and cannot turn with `{hinge}`; name it before the arrow, \
             or declare it under `free:`"
        ),
    )
}
