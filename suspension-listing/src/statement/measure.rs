//! `measure gauge: length(a -> hub);`: a quantity computed from the points.

use syn::Ident;

use super::quantity::Quantity;
use super::word::{Head, Word};
use crate::kind::Kind;
use crate::listing::{Check, Lowering, Named, Rank, Statement};
use crate::system;

const KIND: Kind = Kind("measure");

pub(crate) const MEASURE: Word = Word {
    word: "measure",
    syntax: "measure gauge: length(a -> hub);",
    read: |head: Head, input, listing| {
        let measure = Measure {
            named: head.named(input)?,
            quantity: Quantity::parse(input)?,
        };
        listing.statements.push(Box::new(measure));
        Ok(())
    },
};

struct Measure {
    named: Named,
    quantity: Quantity,
}

impl Statement for Measure {
    fn named(&self) -> Option<(&Named, Kind)> {
        Some((&self.named, KIND))
    }

    fn operands(&self) -> Vec<&Ident> {
        self.quantity.points()
    }

    fn check(&self, check: &mut Check<'_>, _earlier: &[Box<dyn Statement>]) {
        self.quantity.check(check);
        check.placed(self.quantity.points());
    }

    fn rank(&self) -> Rank {
        Rank::Reading
    }

    fn lower(&self, lowering: &mut Lowering<'_>) {
        lowering.system.measures.push(system::Measure {
            named: self.named.plain(),
            quantity: self.quantity.plain(),
        });
    }
}
