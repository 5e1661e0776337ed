//! `angle square: a -> c, d -> e;`: two lines whose angle stays as it is in the design. Something keeps the length of
//! each.

use syn::{Error, Ident, Token};

use super::operands::arrow;
use super::word::{Head, Word};
use crate::errors::{self, Errors};
use crate::form::{Form, Product};
use crate::kind::Kind;
use crate::listing::{Check, Listing, Lowering, Named, Rank, Statement};
use crate::lower::origin;
use crate::name::Name;
use crate::system::{Body, System};

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

    fn check(&self, check: &mut Check<'_>, _earlier: &[Box<dyn Statement>]) {
        let points = self.operands();
        check.sites(points.iter().copied());
        check.not_all_fixed(&self.named.name, KIND, points);
    }

    fn rank(&self) -> Rank {
        Rank::Constraint
    }

    fn lower(&self, lowering: &mut Lowering<'_>) {
        let lines = self.lines.each_ref();
        let form = Form::Product(Product {
            lines: lines.map(|line| line.each_ref().map(|end| lowering.site(end))),
        });
        let origin = origin(KIND, &Name::from(&self.named.name), None);
        lowering.equation(self.named.plain(), origin, form);
    }

    /// Checks that the lines keep their lengths, and that they are not of one body.
    fn check_lowered(&self, listing: &Listing, system: &System, errors: &mut Errors) {
        if !listing.declares(self.operands()) {
            return;
        }
        let names: Vec<Name> = self.operands().into_iter().map(Name::from).collect();
        if let Some(body) = system.body_of(&names) {
            errors.push(of_one_body(&self.named.name, body));
        }
        for [from, to] in &self.lines {
            if from != to && !listing.keeps_apart(system, [from, to]) {
                errors.push(errors::loose(from, to, "as a line at an angle"));
            }
        }
    }
}

fn of_one_body(angle: &Ident, body: &Body) -> Error {
    errors::at(
        angle,
        format!(
            "both lines of `{angle}` are of body `{}`, which keeps their angle; remove it, or take \
             a line of another body",
            body.name
        ),
    )
}
