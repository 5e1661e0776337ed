//! What the user wrote: statements, names, docs and spans.

use proc_macro2::Span;
use syn::{Attribute, Ident, Visibility};

pub struct Listing {
    pub docs: Vec<Attribute>,
    pub vis: Visibility,
    pub name: Ident,
    pub fixed: Vec<Named>,
    pub free: Vec<Named>,
    /// Design positions, of the points that state one.
    pub design: Vec<(Ident, [f64; 3])>,
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
    pub docs: Vec<Attribute>,
    pub name: Ident,
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
