//! The intermediate representation: named points, named equations, and which unknowns each
//! equation depends on. Emission sees nothing else.

mod places;

use proc_macro2::Span;
use quote::format_ident;
use syn::{Attribute, Ident, Visibility};

use crate::ast::Named;
use crate::sample::Design;

pub use places::Substituted;

pub const AXES: [&str; 3] = ["x", "y", "z"];

pub struct System {
    pub docs: Vec<Attribute>,
    pub vis: Visibility,
    pub name: Ident,
    pub free_span: Span,
    pub fixed: Vec<Named>,
    pub free: Vec<Named>,
    pub design: Design,
    pub markers: Vec<Marker>,
    pub bodies: Vec<Body>,
    /// Points that links alone make rigid bodies; they have no equations of their own.
    pub clusters: Vec<Body>,
    pub equations: Vec<Equation>,
    /// Bodies, each with two of its points whose distance another body keeps already.
    pub closed_twice: Vec<[Ident; 3]>,
    pub drives: Vec<Drive>,
    pub measures: Vec<Measure>,
    pub wheel: Option<Wheel>,
    pub kingpin: Option<[Ident; 2]>,
}

/// A point of the mechanism and how it moves.
#[derive(Clone)]
pub struct Site {
    pub name: Ident,
    pub motion: SiteMotion,
}

#[derive(Clone, Copy, PartialEq, Eq)]
pub enum SiteMotion {
    Free,
    /// On the chassis.
    Anchor,
    /// On the chassis, with a coordinate that a drive prescribes.
    DrivenAnchor,
}

impl Site {
    pub fn is_free(&self) -> bool {
        self.motion == SiteMotion::Free
    }
}

/// Equations of one kind; each is one row of the Jacobian, or three.
pub enum Equation {
    /// A constant length; where one end is on the chassis, it is `from`.
    Distance {
        named: Named,
        from: Site,
        to: Site,
        of_body: bool,
    },
    /// A point carried by the frame of a body: three rows.
    Carried {
        body: Ident,
        point: Site,
        frame: [Site; 3],
    },
    /// A prescribed coordinate, or difference of two.
    Coordinate {
        drive: Ident,
        axis: usize,
        of: Site,
        minus: Option<Site>,
    },
}

/// A body of three points or more, or a cluster of links that is as rigid.
pub struct Body {
    pub name: Ident,
    pub frame: [Site; 3],
    pub carried: Vec<Site>,
}

pub struct Drive {
    pub named: Named,
    pub axis: usize,
    pub of: Site,
    pub minus: Option<Ident>,
    /// The distance whose angle it is.
    pub angle_of: Option<Ident>,
}

/// A quantity that is read off the points.
pub struct Measure {
    pub named: Named,
    pub measured: Measured,
}

pub enum Measured {
    /// A coordinate, or difference of two.
    Coordinate {
        axis: usize,
        of: Ident,
        minus: Option<Ident>,
    },
    /// The angle of the line between two points from an axis.
    Angle { axis: usize, line: [Ident; 2] },
    /// The distance of two points.
    Length { line: [Ident; 2] },
}

pub struct Marker {
    pub named: Named,
    pub frame: [Site; 3],
}

pub struct Wheel {
    pub axis: [Ident; 2],
    pub carrier: [Ident; 3],
}

/// The frame of three points under its name in the generated code.
pub fn frame_name(owner: &Ident) -> Ident {
    format_ident!("{}_frame", owner)
}

/// The constants of a carried point under their name in the generated code.
pub fn carried_name(body: &Ident, point: &Ident) -> Ident {
    format_ident!("{}_{}", body, point, span = point.span())
}

/// The length between two points of a body under its name in the generated code.
pub fn pair_name(body: &Ident, a: &Ident, b: &Ident) -> Ident {
    format_ident!("{}_{}_{}", body, a, b, span = a.span())
}

/// The equation that keeps the distance of two points.
pub fn distance_between(equations: &[Equation], a: &Ident, b: &Ident) -> Option<Ident> {
    equations.iter().find_map(|equation| match equation {
        Equation::Distance {
            named, from, to, ..
        } if [[&from.name, &to.name], [&to.name, &from.name]].contains(&[a, b]) => {
            Some(named.name.clone())
        }
        _ => None,
    })
}

impl Body {
    /// All points, the frame's first.
    pub fn points(&self) -> impl Iterator<Item = &Site> {
        self.frame.iter().chain(&self.carried)
    }

    /// The frame's three pairs of points: first-second, first-third, second-third.
    pub fn frame_pairs(&self) -> [[&Site; 2]; 3] {
        let [a, b, c] = &self.frame;
        [[a, b], [a, c], [b, c]]
    }
}

impl Equation {
    /// The rows' names.
    pub fn rows(&self) -> Vec<Ident> {
        match self {
            Self::Distance { named, .. } => vec![named.name.clone()],
            Self::Carried { body, point, .. } => {
                let name = carried_name(body, &point.name);
                AXES.iter()
                    .map(|axis| format_ident!("{name}_{axis}"))
                    .collect()
            }
            Self::Coordinate { drive, .. } => vec![drive.clone()],
        }
    }
}

impl System {
    /// The number of unknowns.
    pub fn size(&self) -> usize {
        3 * self.free.len()
    }

    /// The rows' names, in order.
    pub fn rows(&self) -> Vec<Ident> {
        self.equations.iter().flat_map(Equation::rows).collect()
    }
}
