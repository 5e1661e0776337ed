//! `drive lift: e.z;`: a prescribed quantity. For free points it is an equation; a coordinate of
//! a chassis point moves the point.

mod kept;
mod turned;

use syn::{Error, Ident};

use super::quantity::Quantity;
use super::sum::Term;
use super::word::{Head, Word};
use crate::errors::{self, Errors};
use crate::form::{Form, Linear, Prescribed, Stretch};
use crate::kind::Kind;
use crate::listing::{Check, Listing, Lowering, Named, Rank, Statement};
use crate::lower::origin;
use crate::name::{self, Name};
use crate::system::{self, System, distance_between, length_name};

const KIND: Kind = Kind::DRIVE;

pub(crate) const DRIVE: Word = Word {
    word: "drive",
    syntax: "drive lift: e.z;",
    read: |head: Head, input, listing| {
        let named = head.named(input)?;
        let quantity = Quantity::parse(input)?;
        listing.statements.push(Box::new(Drive { named, quantity }));
        Ok(())
    },
};

struct Drive {
    named: Named,
    quantity: Quantity,
}

impl Statement for Drive {
    fn named(&self) -> Option<(&Named, Kind)> {
        Some((&self.named, KIND))
    }

    fn operands(&self) -> Vec<&Ident> {
        self.quantity.points()
    }

    fn check(&self, check: &mut Check<'_>, earlier: &[Box<dyn Statement>]) {
        let (name, points) = (&self.named.name, self.quantity.points());
        self.quantity.check(check);
        check.sites(points.iter().copied());
        if let Quantity::Between { about: None, .. } = self.quantity {
            check.report(turned::missing_axis(name));
        }
        match self.moves() {
            Some(point) => {
                self.check_bends_no_body(check, point);
                self.check_moves_alone(check, point, earlier);
            }
            None => match self.scaled() {
                Some(term) if check.is(&term.point, Kind::CHASSIS_POINT) => {
                    check.report(takes_no_factor(name, term));
                }
                _ => check.not_all_fixed(name, KIND, points),
            },
        }
        check.prescribed_once(self, earlier);
    }

    fn rank(&self) -> Rank {
        Rank::Drive
    }

    fn lower(&self, lowering: &mut Lowering<'_>) {
        let (name, quantity) = (Name::from(&self.named.name), self.quantity.plain());
        let moves = self.moves().map(|point| lowering.site(point));
        let moves = moves.filter(|site| !site.is_free());
        let (scalar, turned) = match &self.quantity {
            Quantity::Length { line } => (Some(self.stretch(lowering, line)), None),
            Quantity::Between {
                lines,
                about: Some(about),
            } => {
                let turned::Turned { sine, equation } =
                    turned::lower(lowering, &name, lines, about);
                (Some(sine), Some(equation))
            }
            _ => (None, None),
        };
        if moves.is_none() {
            let terms = self.quantity.terms(|point| lowering.site(point));
            let form = match scalar {
                Some(scalar) => Linear::scalar(scalar, name),
                None => Linear::sum(terms, Prescribed::Drive(name)),
            };
            lowering.equation_of(KIND, &self.named, Form::Linear(form));
        }
        let angle_of = match &quantity {
            system::Quantity::Angle { line: [a, b], .. } => {
                distance_between(&lowering.system.equations, a, b).cloned()
            }
            _ => turned,
        };
        lowering.system.drives.push(system::Drive {
            named: self.named.plain(),
            quantity,
            moves,
            angle_of,
        });
    }

    fn check_lowered(&self, listing: &Listing, system: &System, errors: &mut Errors) {
        let found = match &self.quantity {
            Quantity::Angle { line, .. } => kept::angle(line, listing, system),
            Quantity::Length { line } => kept::length(line, system),
            Quantity::Between {
                lines,
                about: Some(about),
            } => turned::check(&self.named.name, lines, about, listing, system),
            _ => None,
        };
        if let Some(error) = found {
            errors.push(error);
        }
    }

    fn moves(&self) -> Option<&Ident> {
        match &self.quantity {
            Quantity::Sum(sum) => sum.single(),
            Quantity::Along { point, .. } => Some(point),
            _ => None,
        }
    }

    fn is_skew(&self) -> bool {
        matches!(self.quantity, Quantity::Along { .. })
    }

    fn claim(&self) -> Option<String> {
        Some(self.quantity.text())
    }
}

impl Drive {
    /// The coordinate, if the drive prescribes a multiple of only one.
    fn scaled(&self) -> Option<&Term> {
        match &self.quantity {
            Quantity::Sum(sum) => match sum.terms.as_slice() {
                [term] => Some(term),
                _ => None,
            },
            _ => None,
        }
    }

    /// Makes the length between two points an unknown with the drive's name.
    fn stretch(&self, lowering: &mut Lowering<'_>, line: &[Ident; 2]) -> Name {
        let name = Name::from(&self.named.name);
        let [a, b] = line.each_ref().map(|end| lowering.site(end));
        let (from, to) = if b.is_free() { (a, b) } else { (b, a) };
        let form = Form::Stretch(Stretch {
            from,
            to,
            length: name.clone(),
        });
        let named = name::Named {
            name: length_name(&name),
            docs: Vec::new(),
        };
        let origin = origin(KIND, &name, None);
        lowering.system.scalars.push(name.clone());
        lowering.equation(named, origin, form);
        name
    }

    /// Checks that a point that one drive moves along a direction is not moved by another.
    fn check_moves_alone(
        &self,
        check: &mut Check<'_>,
        point: &Ident,
        earlier: &[Box<dyn Statement>],
    ) {
        // Drives that prescribe the same are reported as such.
        let others = earlier
            .iter()
            .filter(|other| other.moves() == Some(point) && other.claim() != self.claim());
        for other in others {
            if let (Some((named, _)), true) = (other.named(), self.is_skew() || other.is_skew()) {
                let (name, other) = (&self.named.name, &named.name);
                // Images come last.
                check.report(if check.is_image(name) && !check.is_image(other) {
                    moved_beside_image(other, point, name)
                } else {
                    moved_twice(name, point, other)
                });
            }
        }
    }

    /// Checks that a driven chassis point is not one of two in a body, whose size it would change.
    fn check_bends_no_body(&self, check: &mut Check<'_>, point: &Ident) {
        let listing = check.listing;
        for (body, points) in listing.bodies() {
            let anchors = check.anchors(points);
            if anchors.len() > 1 && anchors.contains(&point) {
                check.report(body_bent(&self.named.name, point, body));
            }
        }
    }
}

fn moved_twice(name: &Ident, point: &Ident, other: &Ident) -> Error {
    errors::at(
        name,
        format!(
            "drive `{other}` moves `{point}` already, and a point driven along a direction can have \
             only one drive; remove one of them, or write both as coordinates"
        ),
    )
}

fn moved_beside_image(name: &Ident, point: &Ident, image: &Ident) -> Error {
    errors::at(
        name,
        format!(
            "`mirror` makes drive `{image}`, which moves `{point}` too, and a point driven along a direction can have only one drive; \
             remove `{name}`, or write both as coordinates"
        ),
    )
}

fn body_bent(drive: &Ident, point: &Ident, body: &Ident) -> Error {
    errors::at(
        drive,
        format!(
            "`{point}` is one of two chassis points of body `{body}`: to move it alone would bend \
             the body; drive a free point of the body instead"
        ),
    )
}

fn takes_no_factor(name: &Ident, term: &Term) -> Error {
    let Term { point, axis, .. } = term;
    let remedy = if term.factor < 0.0 {
        let mut direction = [0; 3];
        if let Some(number) = direction.get_mut(term.axis()) {
            *number = -1;
        }
        format!("to count it the other way write `{point} along {direction:?}`")
    } else {
        format!("write `{point}.{axis}`")
    };
    errors::at(
        name,
        format!(
            "drive `{name}` moves chassis point `{point}`, whose coordinate takes no factor; {remedy}"
        ),
    )
}
