//! `link rod: a -> c;`: a constant length between two points.

use syn::Ident;

use super::operands::arrow;
use super::word::{Head, Word};
use crate::kind::Kind;
use crate::listing::{Check, Lowering, Named, Rigid, Statement};
use crate::lower::origin;
use crate::name::Name;

const KIND: Kind = Kind::LINK;

pub(crate) const LINK: Word = Word {
    word: "link",
    syntax: "link rod: a -> c;",
    read: |head: Head, input, listing| {
        let link = Link {
            named: head.named(input)?,
            ends: arrow(input)?,
        };
        listing.statements.push(Box::new(link));
        Ok(())
    },
};

struct Link {
    named: Named,
    ends: [Ident; 2],
}

impl Statement for Link {
    fn named(&self) -> Option<(&Named, Kind)> {
        Some((&self.named, KIND))
    }

    fn operands(&self) -> Vec<&Ident> {
        self.ends.iter().collect()
    }

    fn check(&self, check: &mut Check<'_>, earlier: &[Box<dyn Statement>]) {
        check.joins(self);
        check.lengths_stated_once(self, earlier);
    }

    fn lower(&self, lowering: &mut Lowering<'_>) {
        let ends = self.ends.each_ref().map(|end| lowering.site(end));
        let origin = origin(KIND, &Name::from(&self.named.name), None);
        lowering.distance(self.named.plain(), origin, ends);
    }

    fn rigid(&self) -> Option<Rigid<'_>> {
        Some(Rigid::Length(&self.ends))
    }
}
