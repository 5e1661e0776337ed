//! The intermediate representation: named points, named equations, and which unknowns each
//! equation depends on. Emission sees nothing else.

mod places;

use proc_macro2::Span;
use quote::format_ident;
use syn::{Attribute, Ident, Visibility};

use crate::ast::Named;
use crate::sample::Design;

pub(crate) use places::Substituted;

pub(crate) const AXES: [&str; 3] = ["x", "y", "z"];

pub(crate) struct System {
    pub(crate) docs: Vec<Attribute>,
    pub(crate) vis: Visibility,
    pub(crate) name: Ident,
    pub(crate) free_span: Span,
    pub(crate) fixed: Vec<Named>,
    pub(crate) free: Vec<Named>,
    pub(crate) design: Design,
    pub(crate) markers: Vec<Marker>,
    pub(crate) bodies: Vec<Body>,
    /// Points that links alone make rigid bodies; they have no equations of their own.
    pub(crate) clusters: Vec<Body>,
    pub(crate) equations: Vec<Equation>,
    /// Bodies, each with two of its points whose distance another body keeps already.
    pub(crate) closed_twice: Vec<[Ident; 3]>,
    pub(crate) drives: Vec<Drive>,
    pub(crate) measures: Vec<Measure>,
    pub(crate) wheel: Option<Wheel>,
    pub(crate) kingpin: Option<[Ident; 2]>,
}

/// A point of the mechanism and how it moves.
#[derive(Clone)]
pub(crate) struct Site {
    pub(crate) name: Ident,
    pub(crate) motion: SiteMotion,
}

#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum SiteMotion {
    Free,
    /// On the chassis.
    Anchor,
    /// On the chassis, with a coordinate that a drive prescribes.
    DrivenAnchor,
}

impl Site {
    pub(crate) fn is_free(&self) -> bool {
        self.motion == SiteMotion::Free
    }
}

/// Equations of one kind; each is one row of the Jacobian, or three.
pub(crate) enum Equation {
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
pub(crate) struct Body {
    pub(crate) name: Ident,
    pub(crate) frame: [Site; 3],
    pub(crate) carried: Vec<Site>,
}

pub(crate) struct Drive {
    pub(crate) named: Named,
    pub(crate) axis: usize,
    pub(crate) of: Site,
    pub(crate) minus: Option<Ident>,
    /// The distance whose angle it is.
    pub(crate) angle_of: Option<Ident>,
}

/// A quantity that is read off the points.
pub(crate) struct Measure {
    pub(crate) named: Named,
    pub(crate) measured: Measured,
}

pub(crate) enum Measured {
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

pub(crate) struct Marker {
    pub(crate) named: Named,
    pub(crate) frame: [Site; 3],
}

pub(crate) struct Wheel {
    pub(crate) axis: [Ident; 2],
    pub(crate) carrier: [Ident; 3],
}

/// The frame of three points under its name in the generated code.
pub(crate) fn frame_name(owner: &Ident) -> Ident {
    format_ident!("{}_frame", owner)
}

/// The constants of a carried point under their name in the generated code.
pub(crate) fn carried_name(body: &Ident, point: &Ident) -> Ident {
    format_ident!("{}_{}", body, point, span = point.span())
}

/// The length between two points of a body under its name in the generated code.
pub(crate) fn pair_name(body: &Ident, a: &Ident, b: &Ident) -> Ident {
    format_ident!("{}_{}_{}", body, a, b, span = a.span())
}

/// The equation that keeps the distance of two points.
pub(crate) fn distance_between(equations: &[Equation], a: &Ident, b: &Ident) -> Option<Ident> {
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
    pub(crate) fn points(&self) -> impl Iterator<Item = &Site> {
        self.frame.iter().chain(&self.carried)
    }

    /// The frame's three pairs of points: first-second, first-third, second-third.
    pub(crate) fn frame_pairs(&self) -> [[&Site; 2]; 3] {
        let [a, b, c] = &self.frame;
        [[a, b], [a, c], [b, c]]
    }
}

impl Equation {
    /// The rows' names.
    pub(crate) fn rows(&self) -> Vec<Ident> {
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
    pub(crate) fn size(&self) -> usize {
        3 * self.free.len()
    }

    /// The rows' names, in order.
    pub(crate) fn rows(&self) -> Vec<Ident> {
        self.equations.iter().flat_map(Equation::rows).collect()
    }
}
