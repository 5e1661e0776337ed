//! `wheel: d -> hub;`: the spin axis, outboard, with the wheel's centre last. `kingpin: c -> d;`: upwards. Several
//! wheels have names, `wheel left: d -> hub;`, and each kingpin has the name of its wheel.

use syn::parse::ParseStream;
use syn::{Error, Ident, Token};

use super::operands::{self, arrow};
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

/// The largest number of wheels that a listing may state.
const MOST_WHEELS: usize = 8;

#[derive(Clone, Copy, PartialEq, Eq)]
enum Role {
    Wheel,
    Kingpin,
}

struct Axis {
    role: Role,
    word: Ident,
    /// The wheel's name, if it has one.
    wheel: Option<Ident>,
    ends: [Ident; 2],
}

fn read(role: Role, head: Head, input: ParseStream<'_>, listing: &mut Listing) -> syn::Result<()> {
    let is_named = !input.peek(Token![:]);
    let wheel = is_named.then(|| operands::name(input)).transpose()?;
    input.parse::<Token![:]>()?;
    let axis = Axis {
        role,
        word: head.word,
        wheel,
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
        if claims(earlier).any(|claim| claim == self.claimed()) {
            check.report(self.stated_twice());
        }
        match self.role {
            Role::Wheel => self.check_beside(check, earlier),
            Role::Kingpin => self.check_wheel(check),
        }
        check.placed(&self.ends);
        let [from, to] = &self.ends;
        let known = check.is_declared(from) && check.is_declared(to) && from != to;
        let is_carried = check.listing.carrier_of(from, to).is_some()
            || self
                .ends
                .iter()
                .any(|end| check.listing.is_on_short_body(end));
        if self.role == Role::Wheel && known {
            let stands = |end| check.is(end, Kind::CHASSIS_POINT);
            if !is_carried {
                let carried = check.listing.one_carried(from, to);
                check.report_missing(wheel_without_carrier(from, to, carried));
            } else if self.ends.iter().all(stands) {
                check.report(wheel_on_chassis(from, to));
            }
        }
    }

    fn rank(&self) -> Rank {
        match self.role {
            Role::Wheel => Rank::Reading,
            Role::Kingpin => Rank::OfReading,
        }
    }

    fn lower(&self, lowering: &mut Lowering<'_>) {
        let axis = self.ends.each_ref().map(Name::from);
        let name = self.wheel.as_ref().map(Name::from);
        match self.role {
            Role::Wheel => {
                let wheel = self.carrier(lowering).map(|carrier| system::Wheel {
                    name,
                    axis,
                    carrier,
                    kingpin: None,
                });
                lowering.system.wheels.extend(wheel);
            }
            Role::Kingpin => {
                let mut wheels = lowering.system.wheels.iter_mut();
                if let Some(wheel) = wheels.find(|wheel| wheel.name == name) {
                    wheel.kingpin = Some(axis);
                }
            }
        }
    }

    fn claim(&self) -> Option<String> {
        Some(self.claimed())
    }
}

/// The claims of the listing's statements, which must not be stated twice.
fn claims(statements: &[Box<dyn Statement>]) -> impl Iterator<Item = String> {
    statements.iter().filter_map(|statement| statement.claim())
}

/// The claim of a wheel or a kingpin, with a colon, which the claims of quantities do not have.
fn claim(word: &str, wheel: Option<&Ident>) -> String {
    let wheel = wheel.map(ToString::to_string).unwrap_or_default();
    format!("{word}:{wheel}")
}

impl Axis {
    fn claimed(&self) -> String {
        claim(&self.word.to_string(), self.wheel.as_ref())
    }

    /// Checks a wheel against the earlier ones: if there are several, also by a `mirror`, all must have names, and there
    /// must not be too many.
    fn check_beside(&self, check: &mut Check<'_>, earlier: &[Box<dyn Statement>]) {
        if let (None, Some(side)) = (&self.wheel, check.listing.stated_side(&self.ends)) {
            check.report(wheel_without_image(&self.word, side));
        }
        let unnamed = claim(WHEEL.word, None);
        let wheels = claims(earlier).filter(|claim| claim.starts_with(&unnamed));
        let wheels: Vec<String> = wheels.collect();
        let is_mixed = wheels
            .first()
            .is_some_and(|first| (*first == unnamed) == self.wheel.is_some());
        if is_mixed {
            check.report(named_and_unnamed(&self.word));
        }
        if wheels.len() == MOST_WHEELS {
            check.report(too_many_wheels(&self.word));
        }
    }

    /// Checks that a kingpin's wheel is stated.
    fn check_wheel(&self, check: &mut Check<'_>) {
        let wheel = claim(WHEEL.word, self.wheel.as_ref());
        if !claims(&check.listing.statements).any(|claim| claim == wheel) {
            check.report_missing(self.kingpin_without_wheel());
        }
    }

    /// Three points of the body that carries both ends.
    fn carrier(&self, lowering: &Lowering<'_>) -> Option<[Name; 3]> {
        let [from, to] = &self.ends;
        let points = lowering.listing.carrier_of(from, to)?;
        match (lowering.system.body_of(points), points) {
            (Some(body), _) => Some(body.frame.each_ref().map(|site| site.name.clone())),
            (None, [a, b, c, ..]) => Some([a, b, c].map(Name::from)),
            _ => None,
        }
    }

    fn stated_twice(&self) -> Error {
        let word = &self.word;
        match &self.wheel {
            Some(name) => errors::at(
                name,
                format!("`{word} {name}` is stated twice; remove one, or give it another name"),
            ),
            None => errors::at(
                word,
                format!(
                    "`{word}` is stated twice; remove one, or give each a name, \
                     `{word} left: ...`"
                ),
            ),
        }
    }

    fn kingpin_without_wheel(&self) -> Error {
        let (token, wheel) = match &self.wheel {
            Some(name) => (name, format!("wheel {name}")),
            None => (&self.word, "wheel".to_owned()),
        };
        errors::at(
            token,
            format!(
                "there is no `{wheel}` for the kingpin; state it, or give the kingpin the name of its wheel"
            ),
        )
    }
}

fn named_and_unnamed(word: &Ident) -> Error {
    errors::at(
        word,
        "one wheel has a name and another has none; give each of several wheels a name, `wheel left: ...`",
    )
}

fn wheel_without_image(word: &Ident, side: &str) -> Error {
    errors::at(
        word,
        format!(
            "`{word}` has no name, and `mirror` makes no image of it: name it, and its kingpin, `{side}`, as in `{word} {side}: ...`"
        ),
    )
}

fn too_many_wheels(word: &Ident) -> Error {
    errors::at(
        word,
        format!("a listing states at most {MOST_WHEELS} wheels; remove this one"),
    )
}

fn wheel_on_chassis(from: &Ident, to: &Ident) -> Error {
    errors::at(
        from,
        format!(
            "the wheel's points `{from}` and `{to}` are chassis points, which no drive moves; name points of the body that carries the wheel"
        ),
    )
}

/// If a body has only one of the two points, `carried` is the body, that point, and the other.
fn wheel_without_carrier(from: &Ident, to: &Ident, carried: Option<[&Ident; 3]>) -> Error {
    let remedy = carried.map_or_else(
        || {
            format!(
                "list them in one body, or declare one as a marker of the body that has the other: `point {from}: BODY;`"
            )
        },
        |[body, one, other]| {
            format!(
                "`{body}` has `{one}`: list `{other}` there too, or declare it as its marker: `point {other}: {body};`"
            )
        },
    );
    errors::at(
        from,
        format!("no body carries both `{from}` and `{to}`; {remedy}"),
    )
}
