//! The forces of the parts of a listing on the points that they join.
//!
//! What drives, holds or measures an angle acts with a moment on the parts that carry the angle's lines. The angle's equations,
//! or its derivatives, have forces at the lines' ends in its place: these count as forces on the parts, which pass them on to
//! their joints.

use std::ops::Range;

use nalgebra::Vector3;
use suspension_core::statics::Loads;
use suspension_core::{Linkage, Values};
use suspension_listing::Kind;
use suspension_listing::form::Form;
use suspension_listing::system::Quantity;

use crate::listing::Listing;
use crate::statement::Statement;

/// An angle has two lines, or one and an axis of the chassis.
const LINES_OF_AN_ANGLE: usize = 2;

/// How far two directions may be apart to count as one, radians.
const PARALLEL: f64 = 1e-6;

/// A line of an angle, and the part that carries it. Points are numbers among all points.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AngleLine {
    ends: [usize; 2],
    /// The end that neither the other line has nor the axis: the force there is of this line alone.
    free_end: usize,
    /// Of an angle about an axis the ends of that, and two points of the part along it.
    axis: Option<[[usize; 2]; 2]>,
    /// The number of the part, of [`Listing::parts`].
    pub part: usize,
}

impl AngleLine {
    /// The forces on the part that its share of the angle's moment consists of, of the `force` that the angle exerts at a point, and
    /// the places `at` which points are: those at the line's ends, and about an axis two more that leave a moment about that
    /// alone. In the unit of the forces.
    pub fn couple(
        &self,
        force: impl Fn(usize) -> Vector3<f64>,
        at: impl Fn(usize) -> Vector3<f64>,
    ) -> impl Iterator<Item = (usize, Vector3<f64>)> {
        let [from, to] = self.ends;
        let on_free_end = force(self.free_end);
        let on_end = if self.free_end == to {
            on_free_end
        } else {
            -on_free_end
        };
        let moment = (at(to) - at(from)).cross(&on_end);
        let across = self.axis.and_then(|[about, own]| {
            let [axis, apart] = [about, own].map(|[from, to]| at(to) - at(from));
            let direction = axis.normalize();
            let is_along = direction.cross(&apart).norm() <= PARALLEL * apart.norm();
            let across = moment - direction * moment.dot(&direction);
            is_along.then(|| (own, apart.cross(&across) / apart.norm_squared()))
        });
        let pair = |[from, to]: [usize; 2], on_end: Vector3<f64>| [(from, -on_end), (to, on_end)];
        let others = across.map(|(own, on_end)| pair(own, on_end));
        pair(self.ends, on_end)
            .into_iter()
            .chain(others.into_iter().flatten())
    }
}

/// A moment about an angle that equations drive or hold.
#[derive(Clone, Debug, PartialEq)]
struct Moment {
    line: AngleLine,
    equations: Vec<Range<usize>>,
    /// Whether it acts on the part; if not, the part is the angle itself, and another one carries the line.
    acts: bool,
}

/// What the forces of a part consist of.
#[derive(Clone, Debug, PartialEq)]
pub struct PartForces {
    equations: Vec<Range<usize>>,
    moments: Vec<Moment>,
}

impl PartForces {
    /// Whether moments about angles that are driven or held act on the part.
    pub fn bears_moments(&self) -> bool {
        self.moments.iter().any(|moment| moment.acts)
    }

    /// Whether the part is an angle that is held, and other parts carry both its lines: all its forces are theirs.
    pub fn are_of_others(&self) -> bool {
        let others = self.moments.iter().filter(|moment| !moment.acts);
        others.count() == LINES_OF_AN_ANGLE
    }

    /// The forces that the part exerts on chassis points and free points, zero at markers, in the unit of the loads, with the
    /// points where `at` has them.
    pub fn under<L: Linkage<N, Scalar = f64>, const N: usize>(
        &self,
        loads: &Loads<'_, L, N>,
        at: &L::Points,
    ) -> L::Points {
        let mut forces = by(loads, &self.equations);
        for moment in &self.moments {
            let of_angle = by(loads, &moment.equations);
            let couple = moment
                .line
                .couple(|point| nth(&of_angle, point), |point| nth(at, point));
            for (point, force) in couple {
                let force = if moment.acts { force } else { -force };
                forces = forces.with(point, nth(&forces, point) + force);
            }
        }
        forces
    }
}

/// The forces that equations exert on all points.
fn by<L: Linkage<N, Scalar = f64>, const N: usize>(
    loads: &Loads<'_, L, N>,
    equations: &[Range<usize>],
) -> L::Points {
    let each = equations.iter().map(|rows| loads.by(rows.clone()));
    each.fold(L::Points::from_values([]), |sum, by| {
        let each = sum.values().zip(by.values());
        L::Points::from_values(each.map(|(sum, by)| sum + by))
    })
}

fn nth<P: Values<Vector3<f64>>>(points: &P, point: usize) -> Vector3<f64> {
    points.values().nth(point).unwrap_or_default()
}

/// The lines of an angle, and its axis.
#[derive(Default)]
struct Lines {
    lines: Vec<[usize; 2]>,
    about: Option<[usize; 2]>,
}

impl Listing {
    /// What the forces of each of [`parts`](Self::parts) consist of.
    pub fn part_forces(&self) -> Vec<PartForces> {
        let parts: Vec<_> = self.parts().collect();
        let of_own = parts.iter().map(|part| PartForces {
            equations: part.equations.clone(),
            moments: Vec::new(),
        });
        let mut forces: Vec<PartForces> = of_own.collect();
        for statement in self.statements() {
            let itself = parts.iter().position(|part| part.name == statement.name);
            for line in self.carried(&self.lines_of_statement(&statement), &parts) {
                let on_parts = [(Some(line.part), true), (itself, false)];
                for (part, acts) in on_parts {
                    let part = part.and_then(|part| forces.get_mut(part));
                    if let Some(part) = part {
                        part.moments.push(Moment {
                            line: line.clone(),
                            equations: statement.equations.clone(),
                            acts,
                        });
                    }
                }
            }
        }
        forces
    }

    /// Of each measure the lines of an angle that parts carry.
    pub fn lines_of_measures(&self) -> Vec<Vec<AngleLine>> {
        let parts: Vec<_> = self.parts().collect();
        let measures = self.system().measures.iter();
        let lines = measures.map(|measure| self.lines_of_quantity(&measure.quantity));
        lines.map(|lines| self.carried(&lines, &parts)).collect()
    }

    /// The lines of what a statement drives or holds.
    fn lines_of_statement(&self, statement: &Statement<'_>) -> Lines {
        let system = self.system();
        let mut drives = system.drives.iter();
        if let Some(drive) = drives.find(|drive| drive.named.name.as_str() == statement.name) {
            return self.lines_of_quantity(&drive.quantity);
        }
        let mut equations = system.equations.iter();
        let equation =
            equations.find(|equation| equation.origin.statement.as_str() == statement.name);
        match equation.map(|equation| &equation.form) {
            Some(Form::Product(product)) => {
                let lines = product.lines.iter();
                let lines = lines.map(|line| line.each_ref().map(|site| self.place_of(site)));
                Lines {
                    lines: lines.collect(),
                    about: None,
                }
            }
            _ => Lines::default(),
        }
    }

    fn lines_of_quantity(&self, quantity: &Quantity) -> Lines {
        let (lines, about) = match quantity {
            Quantity::Angle { line, .. } => (vec![line], None),
            Quantity::Between { lines, about } => (lines.iter().collect(), about.as_ref()),
            _ => (Vec::new(), None),
        };
        let places = |[from, to]: &[_; 2]| Some([self.point(name(from))?, self.point(name(to))?]);
        Lines {
            lines: lines.into_iter().filter_map(places).collect(),
            about: about.and_then(places),
        }
    }

    /// The lines that a body or a hinge carries, or else a link.
    fn carried(&self, Lines { lines, about }: &Lines, parts: &[Statement<'_>]) -> Vec<AngleLine> {
        let carriers = self.carriers();
        let places = |end: &usize| {
            let carrier = carriers.iter().find(|(marker, _)| marker == end);
            carrier.map_or_else(|| vec![*end], |(_, body)| body.to_vec())
        };
        let ends: Vec<usize> = lines.iter().chain(about).flatten().copied().collect();
        let is_free = |end: &&usize| ends.iter().filter(|other| other == end).count() == 1;
        let of_line = |ends: &[usize; 2]| {
            let points: Vec<usize> = ends.iter().flat_map(places).collect();
            let carries = |kinds: &[Kind]| {
                parts.iter().position(|part| {
                    let has = |point: &usize| part.points.contains(point);
                    kinds.contains(&part.kind) && points.iter().all(has)
                })
            };
            let part = carries(&[Kind::BODY, Kind::HINGE]).or_else(|| carries(&[Kind::LINK]))?;
            let own = |about: [usize; 2]| Some([about, self.along(parts.get(part)?, about)?]);
            Some(AngleLine {
                ends: *ends,
                free_end: *ends.iter().rev().find(is_free)?,
                axis: about.and_then(own),
                part,
            })
        };
        lines.iter().filter_map(of_line).collect()
    }

    /// Two points of a part that may be along an axis: the axis' own ends, or those that a hinge has on the chassis.
    fn along(&self, part: &Statement<'_>, about: [usize; 2]) -> Option<[usize; 2]> {
        if about.iter().all(|end| part.points.contains(end)) {
            return Some(about);
        }
        let chassis = self.system().fixed.len();
        let mut points = part.points.iter().filter(|point| **point < chassis);
        let ends = [*points.next()?, *points.next()?];
        (part.kind == Kind::HINGE).then_some(ends)
    }
}

fn name(name: &suspension_listing::name::Name) -> &str {
    name.as_str()
}
