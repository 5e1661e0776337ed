//! The declarations of a listing, and their places.

use proc_macro2::Span;
use syn::{Error, Ident};

use super::{Listing, Rigid};
use crate::errors;
use crate::kind::Kind;
use crate::name::Name;
use crate::sides::Sides;
use crate::system::{System, distance_between};
use crate::vector::{Vector, are_in_line, cross, minus, norm};

impl Listing {
    /// The declared names and their kinds.
    pub fn names(&self) -> Vec<(Name, Kind)> {
        let declared = self.declared();
        declared
            .map(|(name, kind)| (Name::from(name), kind))
            .collect()
    }

    /// The declared names and their kinds: points first, then in the order stated.
    pub(crate) fn declared(&self) -> impl Iterator<Item = (&Ident, Kind)> {
        let fixed = self.fixed.iter().map(|point| (point, Kind::CHASSIS_POINT));
        let free = self.free.iter().map(|point| (point, Kind::FREE_POINT));
        let points = fixed.chain(free);
        let statements = self.statements.iter();
        let statements = statements.filter_map(|statement| statement.named());
        points
            .map(|(point, kind)| (&point.named.name, kind))
            .chain(statements.map(|(named, kind)| (&named.name, kind)))
    }

    /// The names of the points, without markers.
    pub(crate) fn points(&self) -> impl Iterator<Item = &Ident> {
        let points = self.fixed.iter().chain(&self.free);
        points.map(|point| &point.named.name)
    }

    /// The place where a statement or one of its operands is named; if the statement is not in the listing, the place
    /// where a point is declared.
    pub fn place_of(&self, statement: &Name, operand: Option<&Name>) -> Span {
        let is = |token: &Ident, name: &Name| Name::from(token) == *name;
        let mut statements = self.statements.iter();
        let stated = statements.find(|stated| {
            let named = stated.named();
            named.is_some_and(|(named, _)| is(&named.name, statement))
        });
        let operands = stated.into_iter().flat_map(|stated| stated.operands());
        let mut tokens = operands.chain(self.declared().map(|(name, _)| name));
        let sought = operand.unwrap_or(statement);
        tokens
            .find(|token| is(token, sought))
            .map_or(self.span, Ident::span)
    }

    /// Whether a point is on the chassis and no drive moves it.
    pub(crate) fn is_at_rest(&self, point: &Ident) -> bool {
        let mut statements = self.statements.iter();
        self.fixed.iter().any(|fixed| fixed.named.name == *point)
            && !statements.any(|statement| statement.moves() == Some(point))
    }

    /// Whether all names are points other than markers; one that is not is reported as an operand.
    pub(crate) fn has_points<'a>(&self, names: impl IntoIterator<Item = &'a Ident>) -> bool {
        let is_point = |name: &Ident| self.points().any(|point| point == name);
        names.into_iter().all(is_point)
    }

    /// Whether two points keep their distance: by an equation, in a body or on the chassis.
    pub(crate) fn keeps_apart(&self, system: &System, ends: [&Ident; 2]) -> bool {
        let [a, b] = ends.map(Name::from);
        distance_between(&system.equations, &a, &b).is_some()
            || system.body_of(ends).is_some()
            || ends.iter().all(|end| self.is_at_rest(end))
    }

    /// The error that nothing keeps the distance of two points, although a line of theirs must keep its length.
    pub(crate) fn distance_not_constant(&self, ends: [&Ident; 2], line: &str) -> Error {
        let is_on_chassis = |end: &&Ident| self.fixed.iter().any(|fixed| fixed.named.name == **end);
        let both = ends.iter().all(is_on_chassis);
        let moved = ends.into_iter().find(|end| both && !self.is_at_rest(end));
        errors::distance_not_constant(ends, line, moved)
    }

    /// The bodies, each with its points.
    pub(crate) fn bodies(&self) -> impl Iterator<Item = (&Ident, &[Ident])> {
        let statements = self.statements.iter();
        statements.filter_map(|statement| match (statement.named(), statement.rigid()) {
            (Some((named, _)), Some(Rigid::Body(points))) => Some((&named.name, points)),
            _ => None,
        })
    }

    /// The two points of a link.
    pub(crate) fn ends_of_link(&self, name: &Ident) -> Option<&[Ident; 2]> {
        let mut statements = self.statements.iter();
        statements.find_map(|statement| match (statement.named()?, statement.rigid()?) {
            ((named, Kind::LINK), Rigid::Length(ends)) if named.name == *name => Some(ends),
            _ => None,
        })
    }

    /// The points of a body.
    pub(crate) fn body(&self, name: &Ident) -> Option<&[Ident]> {
        let (_, points) = self.bodies().find(|(other, _)| *other == name)?;
        Some(points)
    }

    /// The markers that a body named `body` carries.
    pub(crate) fn markers_on(&self, body: &Ident) -> impl Iterator<Item = &Ident> {
        let statements = self.statements.iter();
        statements.filter_map(move |statement| {
            let (named, _) = statement.named()?;
            let is_carrier = statement.carriers() == Some(std::slice::from_ref(body));
            is_carrier.then_some(&named.name)
        })
    }

    /// The body that carries a marker and is collinear with it, according to the stated positions.
    pub(crate) fn body_in_line_with(&self, marker: &Ident) -> Option<(&Ident, &[Ident])> {
        let mut statements = self.statements.iter();
        let stated = statements.find(|statement| {
            let named = statement.named();
            named.is_some_and(|(named, _)| named.name == *marker)
        })?;
        let carriers = stated.carriers()?;
        let mut bodies = self.bodies();
        let (body, points) = bodies.find(|(body, _)| carriers == std::slice::from_ref(*body))?;
        let places = points.iter().map(|point| self.position(point));
        let places = places.chain([stated.at()]);
        let places: Vec<Vector> = places.collect::<Option<_>>()?;
        are_in_line(&places).then_some((body, points))
    }

    /// The position that the listing states for a chassis point or a free point.
    fn position(&self, name: &Ident) -> Option<Vector> {
        let mut points = self.fixed.iter().chain(&self.free);
        points.find(|point| point.named.name == *name)?.at
    }

    /// Whether two lines are parallel to rounding, according to the stated positions, and no end of one is in the place of
    /// another point, which is a mistake of its own.
    pub(crate) fn are_parallel(&self, [first, second]: [&[Ident; 2]; 2]) -> bool {
        let line = |[from, to]: &[Ident; 2]| Some(minus(self.position(to)?, self.position(from)?));
        let Some((a, b)) = line(first).zip(line(second)) else {
            return false;
        };
        let is_elsewhere = |end: &Ident| {
            let mut others = second.iter().filter(|other| *other != end);
            others.all(|other| self.position(other) != self.position(end))
        };
        norm(cross(a, b)) < f64::EPSILON.sqrt() * norm(a) * norm(b)
            && first.iter().all(is_elsewhere)
    }

    /// Whether a point is a marker of a body with too few points to carry it.
    pub(crate) fn is_on_short_body(&self, point: &Ident) -> bool {
        let mut short = self.bodies().filter(|(_, points)| points.len() < 3);
        short.any(|(body, _)| self.markers_on(body).any(|marker| marker == point))
    }

    /// The points that carry a point rigidly: those of its marker statement, or those of a body that lists it.
    fn carriers(&self, point: &Ident) -> impl Iterator<Item = &[Ident]> {
        let statements = self.statements.iter();
        let carried_by = statements.filter_map(|statement| {
            let (named, _) = statement.named()?;
            let carriers = statement.carriers().filter(|_| named.name == *point)?;
            Some(match carriers {
                [body] => self.body(body).unwrap_or_default(),
                points => points,
            })
        });
        let bodies = self.bodies().map(|(_, points)| points);
        carried_by.chain(bodies.filter(|points| points.contains(point)))
    }

    /// The points of the body that carries both `a` and `b`: three or more.
    pub(crate) fn carrier_of(&self, a: &Ident, b: &Ident) -> Option<&[Ident]> {
        let carries = |points: &[Ident], point: &Ident| {
            points.contains(point) || self.carriers(point).any(|carriers| carriers == points)
        };
        let mut candidates = self.carriers(a).chain(self.carriers(b));
        let points = candidates.find(|points| carries(points, a) && carries(points, b))?;
        (points.len() >= 3).then_some(points)
    }

    /// If a body of three points or more has exactly one of two points, as its own or as its marker: the body, that
    /// point, and the other.
    pub(crate) fn one_carried<'a>(&'a self, a: &'a Ident, b: &'a Ident) -> Option<[&'a Ident; 3]> {
        let body_of = |point: &Ident| {
            let mut bodies = self.bodies().filter(|(_, points)| points.len() >= 3);
            let has = |body: &Ident| self.markers_on(body).any(|marker| marker == point);
            let (body, _) = bodies.find(|(body, points)| points.contains(point) || has(body))?;
            Some(body)
        };
        let ordered = [[a, b], [b, a]].into_iter();
        let mut carried = ordered.filter_map(|[one, other]| Some([body_of(one)?, one, other]));
        carried.next()
    }

    /// The word of the side that is stated for a mirror, if all of these points have it in their names.
    pub(crate) fn stated_side(&self, points: &[Ident]) -> Option<&str> {
        let are_stated = |sides: &&Sides| {
            let mut names = points.iter().map(ToString::to_string);
            names.all(|name| sides.is_stated(&name))
        };
        let Sides([stated, _]) = self.sides.iter().find(are_stated)?;
        Some(stated)
    }
}
