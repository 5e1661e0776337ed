//! What the user wrote: statements, names, docs and spans.

use proc_macro2::Span;
use syn::{Attribute, Ident, Visibility};

pub(crate) struct Listing {
    pub(crate) docs: Vec<Attribute>,
    pub(crate) vis: Visibility,
    pub(crate) name: Ident,
    pub(crate) fixed: Vec<Named>,
    pub(crate) free: Vec<Named>,
    /// Design positions, of the points that state one.
    pub(crate) design: Vec<(Ident, [f64; 3])>,
    /// Where the free points are declared: the token for messages about counts.
    pub(crate) free_span: Span,
    pub(crate) constraints: Vec<Constraint>,
    pub(crate) drives: Vec<Drive>,
    pub(crate) measures: Vec<Measure>,
    pub(crate) markers: Vec<Marker>,
    pub(crate) wheel: Vec<Axis>,
    pub(crate) kingpin: Vec<Axis>,
    /// Whether a statement could not be read, so that names may be missing through no other fault.
    pub(crate) incomplete: bool,
}

#[derive(Clone)]
pub(crate) struct Named {
    pub(crate) docs: Vec<Attribute>,
    pub(crate) name: Ident,
}

pub(crate) enum Constraint {
    Link(Link),
    Body(Body),
}

/// `link name: from -> to;`
pub(crate) struct Link {
    pub(crate) named: Named,
    pub(crate) from: Ident,
    pub(crate) to: Ident,
}

/// `body name: points;`
pub(crate) struct Body {
    pub(crate) named: Named,
    pub(crate) points: Vec<Ident>,
}

/// `drive name: quantity;`
pub(crate) struct Drive {
    pub(crate) named: Named,
    pub(crate) quantity: Quantity,
}

pub(crate) enum Quantity {
    /// `of.axis` or `of.axis - minus.axis`.
    Coordinate {
        of: Coordinate,
        minus: Option<Coordinate>,
    },
    /// `angle(from -> to, axis)`.
    Angle { from: Ident, to: Ident, axis: Ident },
}

/// `measure name: quantity;`
pub(crate) struct Measure {
    pub(crate) named: Named,
    pub(crate) measured: Measured,
}

pub(crate) enum Measured {
    /// A coordinate or an angle, as a drive would prescribe it.
    Quantity(Quantity),
    /// `length(from -> to)`.
    Length { from: Ident, to: Ident },
}

pub(crate) struct Coordinate {
    pub(crate) point: Ident,
    pub(crate) axis: Ident,
}

/// `point name: body;` or `point name: a, b, c;`
pub(crate) struct Marker {
    pub(crate) named: Named,
    pub(crate) carriers: Vec<Ident>,
}

/// `wheel: from -> to;` or `kingpin: from -> to;`
pub(crate) struct Axis {
    pub(crate) keyword: Ident,
    pub(crate) from: Ident,
    pub(crate) to: Ident,
}

impl Constraint {
    pub(crate) fn name(&self) -> &Ident {
        match self {
            Self::Link(link) => &link.named.name,
            Self::Body(body) => &body.named.name,
        }
    }

    pub(crate) fn points(&self) -> impl Iterator<Item = &Ident> {
        let (link, body) = match self {
            Self::Link(link) => (Some([&link.from, &link.to]), None),
            Self::Body(body) => (None, Some(&body.points)),
        };
        link.into_iter().flatten().chain(body.into_iter().flatten())
    }
}

impl Drive {
    /// What it prescribes, as text: equal for two drives of the same coordinate.
    pub(crate) fn prescribes(&self) -> [String; 3] {
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
    pub(crate) fn points(&self) -> [Option<&Ident>; 2] {
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
    pub(crate) fn body(&self, name: &Ident) -> Option<&Body> {
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
    pub(crate) fn carrier_of(&self, a: &Ident, b: &Ident) -> Option<&[Ident]> {
        let carries = |points: &[Ident], point: &Ident| {
            points.contains(point) || self.carriers(point).any(|carriers| carriers == points)
        };
        let mut candidates = self.carriers(a).chain(self.carriers(b));
        let points = candidates.find(|points| carries(points, a) && carries(points, b))?;
        (points.len() >= 3).then_some(points)
    }
}
