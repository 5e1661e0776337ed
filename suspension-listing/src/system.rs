//! The system to which a listing is lowered: named points and named equations, as plain data. Both back ends, the one that
//! writes Rust and the one that walks it at run time, use nothing else.

mod bodies;
mod lengths;
mod names;
mod places;
mod positions;

use crate::form::Form;
use crate::kind::Kind;
use crate::name::{Name, Named};
use crate::vector::Vector;

pub use crate::site::{Site, SiteMotion};
pub use lengths::Length;
pub use names::{carried_name, coordinate_name, frame_name, length_name, pair_name};
pub(crate) use names::{distance_name, turn_name};
pub use places::{Place, Substituted};
pub use positions::Positions;

pub const AXES: [&str; 3] = ["x", "y", "z"];

#[derive(Clone, Debug)]
pub struct System {
    pub docs: Vec<String>,
    pub fixed: Vec<Point>,
    pub free: Vec<Point>,
    pub markers: Vec<Marker>,
    pub bodies: Vec<Body>,
    /// Points that links alone join to rigid bodies; they have no equations of their own.
    pub clusters: Vec<Body>,
    /// The unknowns that are not coordinates of free points.
    pub scalars: Vec<Name>,
    pub equations: Vec<Equation>,
    pub drives: Vec<Drive>,
    pub measures: Vec<Measure>,
    pub wheels: Vec<Wheel>,
}

/// A chassis point or a free point.
#[derive(Clone, Debug)]
pub struct Point {
    pub named: Named,
    /// The design position, if it is stated.
    pub at: Option<Vector>,
}

/// Named rows over a form.
#[derive(Clone, Debug)]
pub struct Equation {
    pub named: Named,
    pub origin: Origin,
    pub form: Form,
}

/// The part of the listing that an equation comes from.
#[derive(Clone, Debug)]
pub struct Origin {
    /// The kind of the statement.
    pub kind: Kind,
    /// The statement's name.
    pub statement: Name,
    /// The operand that it is about, if it is not about the whole statement.
    pub operand: Option<Name>,
}

/// A body of three points or more, or a cluster of links that is as rigid as a body.
#[derive(Clone, Debug)]
pub struct Body {
    pub name: Name,
    pub frame: [Site; 3],
    pub carried: Vec<Site>,
}

#[derive(Clone, Debug)]
pub struct Drive {
    pub named: Named,
    pub quantity: Quantity,
    /// The chassis point that it moves; a drive of free points is an equation.
    pub moves: Option<Site>,
    /// The equation whose length converts an angle to a coordinate.
    pub angle_of: Option<Name>,
}

/// A quantity that is read from the points.
#[derive(Clone, Debug)]
pub struct Measure {
    pub named: Named,
    pub quantity: Quantity,
}

/// A quantity that is prescribed, or read from the points.
#[derive(Clone, Debug)]
pub enum Quantity {
    /// A sum of coordinates.
    Sum(Vec<Term>),
    /// The angle of the line between two points from an axis, radians.
    Angle { axis: usize, line: [Name; 2] },
    /// The angle between two lines, radians: from -pi to pi about a third one, otherwise from 0 to pi.
    Between {
        lines: [[Name; 2]; 2],
        about: Option<[Name; 2]>,
    },
    /// The distance between two points.
    Length { line: [Name; 2] },
    /// The coordinate of a point along a unit vector.
    Along { point: Name, direction: Vector },
}

/// A coordinate of a point, times a factor.
#[derive(Clone, Debug)]
pub struct Term {
    pub factor: f64,
    pub point: Name,
    pub axis: usize,
}

#[derive(Clone, Debug)]
pub struct Marker {
    pub named: Named,
    pub frame: [Site; 3],
    /// The design position, if it is stated.
    pub at: Option<Vector>,
}

#[derive(Clone, Debug)]
pub struct Wheel {
    /// Its name; `None` for a single wheel that is stated without one.
    pub name: Option<Name>,
    pub axis: [Name; 2],
    pub carrier: [Name; 3],
    pub kingpin: Option<[Name; 2]>,
}

/// The equation that keeps the distance between two points.
pub fn distance_between<'a>(equations: &'a [Equation], a: &Name, b: &Name) -> Option<&'a Name> {
    let mut equations = equations.iter();
    let equation = equations.find(|equation| {
        let kept = equation.form.equations().keeps();
        kept.is_some_and(|[from, to]| {
            [[&from.name, &to.name], [&to.name, &from.name]].contains(&[a, b])
        })
    })?;
    Some(&equation.named.name)
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
    pub fn rows(&self) -> Vec<Name> {
        let name = &self.named.name;
        match self.form.equations().rows() {
            1 => vec![name.clone()],
            rows => (0..rows).map(|axis| coordinate_name(name, axis)).collect(),
        }
    }
}

impl System {
    /// The number of unknowns.
    pub fn size(&self) -> usize {
        3 * self.free.len() + self.scalars.len()
    }

    /// The index of a scalar, by its name.
    pub fn scalar(&self, name: &Name) -> Option<usize> {
        self.scalars.iter().position(|scalar| scalar == name)
    }

    /// The column of a scalar.
    pub fn scalar_column(&self, name: &Name) -> Option<usize> {
        let scalar = self.scalar(name)?;
        Some(3 * self.free.len() + scalar)
    }

    /// The rows' names, in order.
    pub fn rows(&self) -> Vec<Name> {
        self.equations.iter().flat_map(Equation::rows).collect()
    }

    /// The points' names: chassis points, free points, markers.
    pub fn points(&self) -> Vec<&Name> {
        let points = self.fixed.iter().chain(&self.free);
        let markers = self.markers.iter().map(|marker| &marker.named.name);
        points
            .map(|point| &point.named.name)
            .chain(markers)
            .collect()
    }
}
