//! `angle square: a -> c, d -> e;`: two lines whose angle stays as in the design. Other statements must keep the length of
//! each.

use syn::{Ident, Token};

use super::operands::arrow;
use super::word::{Head, Word};
use crate::errors::{self, Errors};
use crate::form::{Form, Product};
use crate::kind::Kind;
use crate::listing::{Check, Listing, Lowering, Named, Statement};
use crate::system::System;

const KIND: Kind = Kind("angle");

pub(crate) const ANGLE: Word = Word {
    word: "angle",
    syntax: "angle square: a -> c, d -> e;",
    read: |head: Head, input, listing| {
        let (named, first) = (head.named(input)?, arrow(input)?);
        input.parse::<Token![,]>()?;
        let lines = [first, arrow(input)?];
        listing.statements.push(Box::new(Angle { named, lines }));
        Ok(())
    },
};

struct Angle {
    named: Named,
    lines: [[Ident; 2]; 2],
}

impl Angle {
    /// The point that both lines have, where the second one has it, and the other end of each.
    fn corner(&self) -> Option<(&Ident, [&Ident; 2])> {
        let [[a, b], [c, d]] = &self.lines;
        let pairs = [
            (a, c, [b, d]),
            (a, d, [b, c]),
            (b, c, [a, d]),
            (b, d, [a, c]),
        ];
        let (_, shared, ends) = pairs.into_iter().find(|(one, other, _)| one == other)?;
        let [from, to] = ends;
        (from != to && !ends.contains(&shared)).then_some((shared, ends))
    }
}

impl Statement for Angle {
    fn named(&self) -> Option<(&Named, Kind)> {
        Some((&self.named, KIND))
    }

    fn operands(&self) -> Vec<&Ident> {
        self.lines.iter().flatten().collect()
    }

    fn check(&self, check: &mut Check<'_>, _earlier: &[Box<dyn Statement>]) {
        match self.corner() {
            Some((shared, [from, to])) => {
                check.report(errors::lines_meet(&self.named.name, shared, [from, to]));
                check.sites([shared, from, to]);
            }
            None => check.joins(self),
        }
    }

    fn lower(&self, lowering: &mut Lowering<'_>) {
        let lines = self.lines.each_ref();
        let form = Form::Product(Product {
            lines: lines.map(|line| line.each_ref().map(|end| lowering.site(end))),
        });
        lowering.equation_of(KIND, &self.named, form);
    }

    /// Checks that the lines keep their lengths, and that they do not belong to one body.
    fn check_lowered(&self, listing: &Listing, system: &System, errors: &mut Errors) {
        if !listing.has_points(self.operands()) {
            return;
        }
        if let Some(body) = system.body_of(self.operands()) {
            let name = &self.named.name;
            let lines = format!("both lines of `{name}` are");
            let remedy = ", which keeps their angle; remove it, or take a line";
            errors.push(errors::points_of_one_body(name, &lines, body, remedy));
        }
        for [from, to] in &self.lines {
            if from != to && !listing.keeps_apart(system, [from, to]) {
                errors.push(listing.distance_not_constant([from, to], "a line at an angle"));
            }
        }
    }
}
