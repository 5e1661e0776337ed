//! `angle square: a -> c, d -> e;`: two lines whose angle stays as in the design. Other statements must keep the length of
//! each.

use syn::{Ident, Token};

use super::operands::arrow;
use super::word::{Head, Word};
use crate::errors::{self, Errors};
use crate::form::{Form, Product};
use crate::kind::Kind;
use crate::listing::{Listing, Lowering, Named, Statement};
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

impl Statement for Angle {
    fn named(&self) -> Option<(&Named, Kind)> {
        Some((&self.named, KIND))
    }

    fn operands(&self) -> Vec<&Ident> {
        self.lines.iter().flatten().collect()
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
        if !listing.declares(self.operands()) {
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
                errors.push(errors::distance_not_constant(
                    from,
                    to,
                    "a line at an angle",
                ));
            }
        }
    }
}
