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
struct Line {
    ends: [usize; 2],
    /// The end that neither the other line has nor the axis: the force there is of this line alone.
    free_end: usize,
    /// Of an angle about an axis the ends of that, and two points of the part along it.
    axis: Option<[[usize; 2]; 2]>,
    part: usize,
}

type OnPoint = (usize, Vector3<f64>);

impl Line {
    /// The forces at the line's ends, and about an axis at two more points, which leave a moment about that alone.
    fn couple(
        &self,
        force: impl Fn(usize) -> Vector3<f64>,
        at: impl Fn(usize) -> Vector3<f64>,
    ) -> [Option<OnPoint>; 4] {
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
        let [first, second] = match across {
            Some(([from, to], on_end)) => [Some((from, -on_end)), Some((to, on_end))],
            None => [None; 2],
        };
        [Some((from, -on_end)), Some((to, on_end)), first, second]
    }
}

/// The share of a part in what an angle exerts.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AngleShare {
    /// The number of the part, of [`Listing::parts`].
    pub part: usize,
    of: Share,
}

#[derive(Clone, Debug, PartialEq, Eq)]
enum Share {
    /// The part carries a line: a moment.
    Line(Line),
    /// The part carries the axis, which has at its ends what is left beside the shares of lines.
    Axis { ends: [usize; 2], lines: Vec<Line> },
}

impl AngleShare {
    /// The forces on the part, at points, in the unit of the `force` that the angle exerts at a point, with the points where `at` has
    /// them.
    pub fn forces(
        &self,
        force: impl Fn(usize) -> Vector3<f64>,
        at: impl Fn(usize) -> Vector3<f64>,
    ) -> impl Iterator<Item = OnPoint> {
        let forces = match &self.of {
            Share::Line(line) => line.couple(force, at),
            Share::Axis { ends, lines } => {
                let [from, to] = ends.map(|end| {
                    let couples = lines.iter().flat_map(|line| line.couple(&force, &at));
                    let there = couples.flatten().filter(|(point, _)| *point == end);
                    let of_lines: Vector3<f64> = there.map(|(_, force)| force).sum();
                    Some((end, force(end) - of_lines))
                });
                [from, to, None, None]
            }
        };
        forces.into_iter().flatten()
    }

    fn is_of_line(&self) -> bool {
        matches!(self.of, Share::Line(_))
    }
}

/// A moment about an angle that equations drive or hold.
#[derive(Clone, Debug, PartialEq)]
struct Moment {
    share: AngleShare,
    equations: Vec<Range<usize>>,
    /// Whether it acts on the part; if not, the part is the angle itself, and the share is another's.
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
        let shares = self.moments.iter().filter(|moment| !moment.acts);
        shares.filter(|moment| moment.share.is_of_line()).count() == LINES_OF_AN_ANGLE
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
            let share = &moment.share;
            let on_part = share.forces(|point| nth(&of_angle, point), |point| nth(at, point));
            for (point, force) in on_part {
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
            for share in self.shares(&self.lines_of_statement(&statement), &parts) {
                let on_parts = [(Some(share.part), true), (itself, false)];
                for (part, acts) in on_parts {
                    let part = part.and_then(|part| forces.get_mut(part));
                    if let Some(part) = part {
                        part.moments.push(Moment {
                            share: share.clone(),
                            equations: statement.equations.clone(),
                            acts,
                        });
                    }
                }
            }
        }
        forces
    }

    /// Of each measure the shares of parts in what acts along it, where it is an angle.
    pub fn shares_in_measures(&self) -> Vec<Vec<AngleShare>> {
        let parts: Vec<_> = self.parts().collect();
        let measures = self.system().measures.iter();
        let lines = measures.map(|measure| self.lines_of_quantity(&measure.quantity));
        lines.map(|lines| self.shares(&lines, &parts)).collect()
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

    /// The shares of the bodies, hinges and links that carry lines and axis; a line or an axis between chassis points is the
    /// chassis'.
    fn shares(&self, Lines { lines, about }: &Lines, parts: &[Statement<'_>]) -> Vec<AngleShare> {
        let chassis = self.system().fixed.len();
        let is_fixed = |ends: &[usize; 2]| ends.iter().all(|end| *end < chassis);
        let moving = || lines.iter().filter(|line| !is_fixed(line));
        let ends: Vec<usize> = lines.iter().chain(about).flatten().copied().collect();
        let is_free = |end: &&usize| ends.iter().filter(|other| other == end).count() == 1;
        let of_line = |ends: &[usize; 2]| {
            let part = self.carrier_of(ends, parts)?;
            let own = |about: [usize; 2]| Some([about, self.along(parts.get(part)?, about)?]);
            Some(Line {
                ends: *ends,
                free_end: *ends.iter().rev().find(is_free)?,
                axis: about.and_then(own),
                part,
            })
        };
        let of_lines: Vec<Line> = moving().filter_map(of_line).collect();
        let axis = about.filter(|about| !is_fixed(about) && of_lines.len() == moving().count());
        let axis = axis.and_then(|ends| {
            let lines = of_lines.clone();
            Some(AngleShare {
                part: self.carrier_of(&ends, parts)?,
                of: Share::Axis { ends, lines },
            })
        });
        let of_lines = of_lines.into_iter().map(|line| AngleShare {
            part: line.part,
            of: Share::Line(line),
        });
        of_lines.chain(axis).collect()
    }

    /// The part that keeps two points apart, or the bodies of markers: a body or a hinge, or else a link.
    fn carrier_of(&self, ends: &[usize; 2], parts: &[Statement<'_>]) -> Option<usize> {
        let carriers = self.carriers();
        let places = |end: &usize| {
            let carrier = carriers.iter().find(|(marker, _)| marker == end);
            carrier.map_or_else(|| vec![*end], |(_, body)| body.to_vec())
        };
        let points: Vec<usize> = ends.iter().flat_map(places).collect();
        let carries = |kinds: &[Kind]| {
            parts.iter().position(|part| {
                let has = |point: &usize| part.points.contains(point);
                kinds.contains(&part.kind) && points.iter().all(has)
            })
        };
        carries(&[Kind::BODY, Kind::HINGE]).or_else(|| carries(&[Kind::LINK]))
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
