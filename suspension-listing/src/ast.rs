//! What the user wrote: statements, names, docs and spans.

use proc_macro2::Span;
use syn::Ident;

use crate::name::{self, Name};
use crate::vector::Vector;

pub struct Listing {
    pub docs: Vec<String>,
    pub fixed: Vec<Point>,
    pub free: Vec<Point>,
    /// The token for messages about the listing as a whole.
    pub span: Span,
    /// Where the free points are declared: the token for messages about counts.
    pub free_span: Span,
    pub constraints: Vec<Constraint>,
    pub drives: Vec<Drive>,
    pub measures: Vec<Measure>,
    pub markers: Vec<Marker>,
    pub wheel: Vec<Axis>,
    pub kingpin: Vec<Axis>,
    /// Whether a statement could not be read, so that names may be missing through no other fault.
    pub incomplete: bool,
}

#[derive(Clone)]
pub struct Named {
    pub docs: Vec<String>,
    pub name: Ident,
}

/// A chassis point or a free point.
pub struct Point {
    pub named: Named,
    /// The design position, where it is stated.
    pub at: Option<Vector>,
}

pub enum Constraint {
    Link(Link),
    Body(Body),
}

/// `link name: from -> to;`
pub struct Link {
    pub named: Named,
    pub from: Ident,
    pub to: Ident,
}

/// `body name: points;`
pub struct Body {
    pub named: Named,
    pub points: Vec<Ident>,
}

/// `drive name: quantity;`
pub struct Drive {
    pub named: Named,
    pub quantity: Quantity,
}

pub enum Quantity {
    /// `of.axis` or `of.axis - minus.axis`.
    Coordinate {
        of: Coordinate,
        minus: Option<Coordinate>,
    },
    /// `angle(from -> to, axis)`.
    Angle { from: Ident, to: Ident, axis: Ident },
}

/// `measure name: quantity;`
pub struct Measure {
    pub named: Named,
    pub measured: Measured,
}

pub enum Measured {
    /// A coordinate or an angle, as a drive would prescribe it.
    Quantity(Quantity),
    /// `length(from -> to)`.
    Length { from: Ident, to: Ident },
}

pub struct Coordinate {
    pub point: Ident,
    pub axis: Ident,
}

/// `point name: body;` or `point name: a, b, c;`
pub struct Marker {
    pub named: Named,
    pub carriers: Vec<Ident>,
}

/// `wheel: from -> to;` or `kingpin: from -> to;`
pub struct Axis {
    pub keyword: Ident,
    pub from: Ident,
    pub to: Ident,
}

impl Named {
    /// The same without the place in the source.
    pub fn plain(&self) -> name::Named {
        name::Named {
            name: Name::from(&self.name),
            docs: self.docs.clone(),
        }
    }
}

impl Constraint {
    pub fn name(&self) -> &Ident {
        match self {
            Self::Link(link) => &link.named.name,
            Self::Body(body) => &body.named.name,
        }
    }

    pub fn points(&self) -> impl Iterator<Item = &Ident> {
        let (link, body) = match self {
            Self::Link(link) => (Some([&link.from, &link.to]), None),
            Self::Body(body) => (None, Some(&body.points)),
        };
        link.into_iter().flatten().chain(body.into_iter().flatten())
    }
}

impl Drive {
    /// What it prescribes, as text: equal for two drives of the same coordinate.
    pub fn prescribes(&self) -> [String; 3] {
        match &self.quantity {
            Quantity::Coordinate { of, minus } => {
                let minus = minus
                    .as_ref()
                    .map_or(String::new(), |minus| minus.point.to_string());
                let mut ends = [of.point.to_string(), minus];
                ends.sort();
                let [first, second] = ends;
                [first, second, of.axis.to_string()]
            }
            Quantity::Angle { from, to, axis } => {
                let mut ends = [to.to_string(), from.to_string()];
                ends.sort();
                let [first, second] = ends;
                [first, second, axis.to_string()]
            }
        }
    }
}

impl Measured {
    /// The points that it is measured by.
    pub fn points(&self) -> [Option<&Ident>; 2] {
        match self {
            Self::Quantity(Quantity::Coordinate { of, minus }) => {
                [Some(&of.point), minus.as_ref().map(|minus| &minus.point)]
            }
            Self::Quantity(Quantity::Angle { from, to, .. }) | Self::Length { from, to } => {
                [Some(from), Some(to)]
            }
        }
    }
}

impl Listing {
    /// The names that it declares.
    pub fn declared(&self) -> impl Iterator<Item = &Ident> {
        let points = self
            .fixed
            .iter()
            .chain(&self.free)
            .map(|point| &point.named);
        let constraints = self.constraints.iter().map(Constraint::name);
        let drives = self.drives.iter().map(|drive| &drive.named);
        let measures = self.measures.iter().map(|measure| &measure.named);
        let markers = self.markers.iter().map(|marker| &marker.named);
        let named = points.chain(drives).chain(measures).chain(markers);
        named.map(|named| &named.name).chain(constraints)
    }

    /// Where a statement is named, or an operand of it; where a point is declared, if the statement
    /// is not of the listing.
    pub fn place_of(&self, statement: &Name, operand: Option<&Name>) -> Span {
        let is = |ident: &&Ident, name: &Name| Name::from(*ident) == *name;
        let mut constraints = self.constraints.iter();
        let constraint = constraints.find(|constraint| is(&constraint.name(), statement));
        let operands = constraint.into_iter().flat_map(Constraint::points);
        let mut tokens = operands.chain(self.declared());
        let sought = operand.unwrap_or(statement);
        tokens
            .find(|token| is(token, sought))
            .map_or(self.span, Ident::span)
    }

    pub fn body(&self, name: &Ident) -> Option<&Body> {
        self.constraints
            .iter()
            .find_map(|constraint| match constraint {
                Constraint::Body(body) if body.named.name == *name => Some(body),
                _ => None,
            })
    }

    /// The points that carry a point rigidly: of its marker statement, or of a body that lists it.
    fn carriers(&self, point: &Ident) -> impl Iterator<Item = &[Ident]> {
        let marker = self
            .markers
            .iter()
            .find(|marker| marker.named.name == *point);
        let carried_by = marker.map(|marker| match marker.carriers.as_slice() {
            [body] => self.body(body).map_or(&[][..], |body| &body.points),
            points => points,
        });
        let bodies = self
            .constraints
            .iter()
            .filter_map(move |constraint| match constraint {
                Constraint::Body(body) if body.points.contains(point) => {
                    Some(body.points.as_slice())
                }
                _ => None,
            });
        carried_by.into_iter().chain(bodies)
    }

    /// The points of the body that carries both `a` and `b`: three or more.
    pub fn carrier_of(&self, a: &Ident, b: &Ident) -> Option<&[Ident]> {
        let carries = |points: &[Ident], point: &Ident| {
            points.contains(point) || self.carriers(point).any(|carriers| carriers == points)
        };
        let mut candidates = self.carriers(a).chain(self.carriers(b));
        let points = candidates.find(|points| carries(points, a) && carries(points, b))?;
        (points.len() >= 3).then_some(points)
    }
}
