//! `drive lift: e.z;`: a quantity that is prescribed. Of free points it is an equation; a coordinate of
//! a chassis point moves the point.

use syn::{Error, Ident};

use super::quantity::Quantity;
use super::{Head, Kind, Rank, Statement, Word};
use crate::check::Check;
use crate::errors::{self, Errors};
use crate::form::{Form, Linear};
use crate::listing::{Listing, Named};
use crate::lower::{Lowering, origin};
use crate::name::Name;
use crate::system::{self, Body, System, distance_between};

const KIND: Kind = Kind("drive");

pub(crate) const DRIVE: Word = Word {
    word: "drive",
    syntax: "drive lift: e.z;",
    read: |head: Head, input, listing| {
        let named = head.named(input)?;
        let quantity = Quantity::parse(input, unknown_quantity)?;
        if let Quantity::Length { line: [from, _] } = &quantity {
            return Err(unknown_quantity(&Ident::new("length", from.span())));
        }
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
        match self.moves() {
            Some(point) => self.bends_no_body(check, point),
            None => check.not_all_fixed(name, KIND, points),
        }
        let same = earlier.iter().find(|other| other.claim() == self.claim());
        if let Some((other, _)) = same.and_then(|other| other.named()) {
            check.report(driven_twice(name, &other.name));
        }
    }

    fn rank(&self) -> Rank {
        Rank::Drive
    }

    fn lower(&self, lowering: &mut Lowering<'_>) {
        let (name, quantity) = (Name::from(&self.named.name), self.quantity.plain());
        let moves = self.moves().map(|point| lowering.site(point));
        let moves = moves.filter(|site| !site.is_free());
        if moves.is_none() {
            let site = |point: &Ident| lowering.site(point);
            let form = Form::Linear(Linear {
                terms: self.quantity.terms(site),
                drive: name.clone(),
            });
            let origin = origin(KIND, &name, None);
            lowering.equation(self.named.plain(), origin, form);
        }
        let angle_of = match &quantity {
            system::Quantity::Angle { line: [a, b], .. } => {
                distance_between(&lowering.system.equations, a, b).cloned()
            }
            _ => None,
        };
        lowering.system.drives.push(system::Drive {
            named: self.named.plain(),
            quantity,
            moves,
            angle_of,
        });
    }

    /// Checks that an equation keeps the distance of the two points of an angle.
    fn check_lowered(&self, listing: &Listing, system: &System, errors: &mut Errors) {
        let Quantity::Angle {
            line: [from, to], ..
        } = &self.quantity
        else {
            return;
        };
        // Anything else is reported as an operand.
        let is = |name: &Ident, kind| listing.declared().any(|other| other == (name, kind));
        let ends = [from, to].map(|end| (is(end, Kind::FREE_POINT), is(end, Kind::CHASSIS_POINT)));
        let [(free, _), (other_free, _)] = ends;
        let all_known = ends.iter().all(|(free, fixed)| *free || *fixed);
        if from == to || !all_known || !(free || other_free) {
            return;
        }
        let [a, b] = [from, to].map(Name::from);
        if distance_between(&system.equations, &a, &b).is_some() {
            return;
        }
        let lists = |body: &Body, name: &Name| body.points().any(|site| site.name == *name);
        let mut bodies = system.bodies.iter();
        let body = bodies.find(|body| lists(body, &a) && lists(body, &b));
        errors.push(match body {
            Some(body) => angle_beside_frame([from, to], body),
            None => no_such_link(from, to),
        });
    }

    fn moves(&self) -> Option<&Ident> {
        match &self.quantity {
            Quantity::Coordinate { of, minus: None } => Some(&of.point),
            _ => None,
        }
    }

    fn claim(&self) -> Option<String> {
        Some(format!("drive {}", self.quantity.text()))
    }
}

impl Drive {
    /// Checks that a driven chassis point is not one of two in a body, whose size it would change.
    fn bends_no_body(&self, check: &mut Check<'_>, point: &Ident) {
        let listing = check.listing;
        for (body, points) in listing.bodies() {
            let anchors = check.anchors(points);
            if anchors.len() > 1 && anchors.contains(&point) {
                check.report(body_bent(&self.named.name, point, body));
            }
        }
    }
}

fn unknown_quantity(function: &Ident) -> Error {
    errors::at(
        function,
        format!(
            "a drive cannot prescribe `{function}(..)`; write `p.z`, `p.z - q.z` or `angle(p -> q, z)`"
        ),
    )
}

fn driven_twice(name: &Ident, other: &Ident) -> Error {
    errors::at(
        name,
        format!("drive `{other}` prescribes this coordinate already; remove one of them"),
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

fn no_such_link(from: &Ident, to: &Ident) -> Error {
    errors::at(
        from,
        format!(
            "an angle needs the length of a link, and no link joins `{from}` and `{to}`; declare \
             `link name: {from} -> {to};`"
        ),
    )
}

/// The distance of two points of a body is none of its frame's.
fn angle_beside_frame(ends: [&Ident; 2], body: &Body) -> Error {
    let [from, to] = ends;
    let Body { name, frame, .. } = body;
    let [a, b, c] = frame.each_ref().map(|site| &site.name);
    // A frame takes chassis points first, wherever they are listed.
    let anchors = frame.iter().filter(|site| !site.is_free());
    let anchors: Vec<&Name> = anchors.map(|site| &site.name).collect();
    let is_other = |end: &&&Ident| !anchors.contains(&&Name::from(**end));
    let others = ends.iter().filter(is_other).count();
    let remedy = if anchors.len() + others > 3 {
        String::new()
    } else {
        format!(", or list `{from}` and `{to}` among the first three points of the body")
    };
    errors::at(
        from,
        format!(
            "an angle needs a length that an equation keeps, and body `{name}` keeps those between \
             `{a}`, `{b}` and `{c}`; drive the angle between two of these{remedy}"
        ),
    )
}
