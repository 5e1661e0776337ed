//! `wheel: d -> hub;`: the spin axis, outboard, with the wheel's centre last. `kingpin: c -> d;`: upwards.

use syn::parse::ParseStream;
use syn::{Error, Ident, Token};

use super::operands::arrow;
use super::word::{Head, Word};
use crate::errors;
use crate::kind::Kind;
use crate::listing::{Check, Listing, Lowering, Named, Rank, Statement};
use crate::name::Name;
use crate::system;

pub(crate) const WHEEL: Word = Word {
    word: "wheel",
    syntax: "wheel: d -> hub;",
    read: |head, input, listing| read(Role::Wheel, head, input, listing),
};

pub(crate) const KINGPIN: Word = Word {
    word: "kingpin",
    syntax: "kingpin: c -> d;",
    read: |head, input, listing| read(Role::Kingpin, head, input, listing),
};

#[derive(Clone, Copy, PartialEq, Eq)]
enum Role {
    Wheel,
    Kingpin,
}

struct Axis {
    role: Role,
    word: Ident,
    ends: [Ident; 2],
}

fn read(role: Role, head: Head, input: ParseStream<'_>, listing: &mut Listing) -> syn::Result<()> {
    input.parse::<Token![:]>()?;
    let axis = Axis {
        role,
        word: head.word,
        ends: arrow(input)?,
    };
    listing.statements.push(Box::new(axis));
    Ok(())
}

impl Statement for Axis {
    fn named(&self) -> Option<(&Named, Kind)> {
        None
    }

    fn operands(&self) -> Vec<&Ident> {
        self.ends.iter().collect()
    }

    fn check(&self, check: &mut Check<'_>, earlier: &[Box<dyn Statement>]) {
        if earlier.iter().any(|other| other.claim() == self.claim()) {
            check.report(role_stated_twice(&self.word));
        }
        check.placed(&self.ends);
        let [from, to] = &self.ends;
        let known = check.is_declared(from) && check.is_declared(to) && from != to;
        if self.role == Role::Wheel && known && check.listing.carrier_of(from, to).is_none() {
            check.report_missing(wheel_without_carrier(from, to));
        }
    }

    fn rank(&self) -> Rank {
        Rank::Reading
    }

    fn lower(&self, lowering: &mut Lowering<'_>) {
        let axis = self.ends.each_ref().map(Name::from);
        match self.role {
            Role::Wheel if lowering.system.wheel.is_none() => {
                lowering.system.wheel = self
                    .carrier(lowering)
                    .map(|carrier| system::Wheel { axis, carrier });
            }
            Role::Kingpin if lowering.system.kingpin.is_none() => {
                lowering.system.kingpin = Some(axis);
            }
            _ => {}
        }
    }

    fn claim(&self) -> Option<String> {
        Some(self.word.to_string())
    }
}

impl Axis {
    /// Three points of the body that carries both ends.
    fn carrier(&self, lowering: &Lowering<'_>) -> Option<[Name; 3]> {
        let [from, to] = &self.ends;
        let points = lowering.listing.carrier_of(from, to)?;
        let names: Vec<Name> = points.iter().map(Name::from).collect();
        match (lowering.system.body_of(&names), names.as_slice()) {
            (Some(body), _) => Some(body.frame.each_ref().map(|site| site.name.clone())),
            (None, [a, b, c, ..]) => Some([a, b, c].map(Name::clone)),
            _ => None,
        }
    }
}

fn role_stated_twice(word: &Ident) -> Error {
    errors::at(word, format!("`{word}` is stated twice; remove one"))
}

fn wheel_without_carrier(from: &Ident, to: &Ident) -> Error {
    errors::at(
        from,
        format!(
            "no body carries both `{from}` and `{to}`; list them in one body, or declare one as \
             `point` carried by three points"
        ),
    )
}
