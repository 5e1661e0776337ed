//! What the user wrote: points, and the statements about them, with their places in the source.

use proc_macro2::Span;
use syn::Ident;

use crate::name::{self, Name};
use crate::statement::{Kind, Rigid, Statement};
use crate::vector::Vector;

pub struct Listing {
    pub(crate) docs: Vec<String>,
    pub(crate) fixed: Vec<Point>,
    pub(crate) free: Vec<Point>,
    /// All others, in the order stated.
    pub(crate) statements: Vec<Box<dyn Statement>>,
    /// The token for messages about the listing as a whole.
    pub(crate) span: Span,
    /// Where the free points are declared: the token for messages about counts.
    pub(crate) free_span: Span,
    /// Whether a statement could not be read, so that names may be missing through no other fault.
    pub(crate) incomplete: bool,
}

/// A name with its docs.
pub(crate) struct Named {
    pub(crate) docs: Vec<String>,
    pub(crate) name: Ident,
}

/// A chassis point or a free point.
pub(crate) struct Point {
    pub(crate) named: Named,
    /// The design position, where it is stated.
    pub(crate) at: Option<Vector>,
}

impl Named {
    /// The same without the place in the source.
    pub(crate) fn plain(&self) -> name::Named {
        name::Named {
            name: Name::from(&self.name),
            docs: self.docs.clone(),
        }
    }
}

impl Listing {
    pub(crate) fn empty(span: Span) -> Self {
        Self {
            docs: Vec::new(),
            fixed: Vec::new(),
            free: Vec::new(),
            statements: Vec::new(),
            span,
            free_span: span,
            incomplete: false,
        }
    }

    /// The names that it declares, and of what.
    pub fn names(&self) -> Vec<(Name, Kind)> {
        let declared = self.declared();
        declared
            .map(|(name, kind)| (Name::from(name), kind))
            .collect()
    }

    /// The names that it declares, and of what: points first, then in the order stated.
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

    /// Where a statement is named, or an operand of it; where a point is declared, if the statement
    /// is not of the listing.
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

    /// The bodies, each with its points.
    pub(crate) fn bodies(&self) -> impl Iterator<Item = (&Ident, &[Ident])> {
        let statements = self.statements.iter();
        statements.filter_map(|statement| match (statement.named(), statement.rigid()) {
            (Some((named, _)), Some(Rigid::Body(points))) => Some((&named.name, points)),
            _ => None,
        })
    }

    /// The points of a body.
    pub(crate) fn body(&self, name: &Ident) -> Option<&[Ident]> {
        let (_, points) = self.bodies().find(|(other, _)| *other == name)?;
        Some(points)
    }

    /// The points that carry a point rigidly: of its marker statement, or of a body that lists it.
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
}
