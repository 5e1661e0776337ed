//! `couple rack: c.y = d.y;`: coordinates that move as one. The left side less the right side keeps its value
//! in the design.

use syn::{Ident, Token};

use super::sum::Sum;
use super::word::{Head, Word};
use crate::form::{Form, Linear, Prescribed};
use crate::kind::Kind;
use crate::listing::{Check, Lowering, Named, Statement};

const KIND: Kind = Kind("couple");

pub(crate) const COUPLE: Word = Word {
    word: "couple",
    syntax: "couple rack: c.y = d.y;",
    read: |head: Head, input, listing| {
        let named = head.named(input)?;
        let mut sum: Sum = input.parse()?;
        input.parse::<Token![=]>()?;
        let mut right: Sum = input.parse()?;
        for term in &mut right.terms {
            term.factor = -term.factor;
        }
        sum.terms.extend(right.terms);
        listing.statements.push(Box::new(Couple { named, sum }));
        Ok(())
    },
};

struct Couple {
    named: Named,
    /// The sum that keeps its value.
    sum: Sum,
}

impl Statement for Couple {
    fn named(&self) -> Option<(&Named, Kind)> {
        Some((&self.named, KIND))
    }

    fn operands(&self) -> Vec<&Ident> {
        self.sum.points()
    }

    fn check(&self, check: &mut Check<'_>, earlier: &[Box<dyn Statement>]) {
        self.sum.check(check);
        check.joins(self);
        check.prescribed_once(self, earlier);
    }

    fn lower(&self, lowering: &mut Lowering<'_>) {
        let terms = self.sum.terms(|point| lowering.site(point));
        let form = Form::Linear(Linear::sum(terms, Prescribed::Design));
        lowering.equation_of(KIND, &self.named, form);
    }

    fn claim(&self) -> Option<String> {
        Some(format!("sum {}", self.sum.text()))
    }
}
