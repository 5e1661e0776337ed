//! Moments about angles: the parts on which they act, and their forces.
//!
//! A statement that drives, holds or measures an angle acts with a moment on the parts that carry the angle's lines. In
//! place of this moment the angle's equations, or the derivatives of a measured angle, have forces at the ends of the lines.
//! These count as forces on the parts, which pass them on to their joints.

use nalgebra::Vector3;
use suspension_listing::Kind;
use suspension_listing::form::Form;
use suspension_listing::name::Name;
use suspension_listing::system::Quantity;

use crate::listing::Listing;
use crate::statement::Statement;

/// The largest angle between two directions that count as one, radians.
const PARALLEL: f64 = 1e-6;

/// A line of an angle, which a part or the chassis carries. Points are numbers among all points.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Line {
    ends: [usize; 2],
    /// The end that the line shares neither with the other line nor with the axis: the force there comes from this
    /// line alone.
    free_end: usize,
    /// For an angle about an axis: the ends of the axis, and two points of the line's carrier along it.
    axis: Option<[[usize; 2]; 2]>,
}

type OnPoint = (usize, Vector3<f64>);

impl Line {
    /// The forces at the line's ends and, for an angle about an axis, at two more points, so that only a moment about
    /// the axis is left.
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

/// The share of a part in the forces that an angle exerts.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AngleShare {
    /// The number of the part in [`Listing::parts`].
    pub part: usize,
    of: Share,
}

#[derive(Clone, Debug, PartialEq, Eq)]
enum Share {
    /// The part carries a line, on which a moment acts.
    Line(Line),
    /// The part carries the axis, whose ends bear what the shares of the lines leave over.
    Axis { ends: [usize; 2], lines: Vec<Line> },
}

impl AngleShare {
    /// The forces on the part, at points, in the unit of the `force` that the angle exerts at a point, for the
    /// positions `at` of the points.
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

    /// Whether the part carries a line, and not the axis.
    pub(crate) fn is_of_line(&self) -> bool {
        matches!(self.of, Share::Line(_))
    }
}

/// The lines of an angle, and its axis.
#[derive(Default)]
struct Lines {
    lines: Vec<[usize; 2]>,
    about: Option<[usize; 2]>,
}

impl Listing {
    /// For each measure, the shares of parts in the force along it if it is an angle.
    pub fn shares_in_measures(&self) -> Vec<Vec<AngleShare>> {
        let parts: Vec<_> = self.parts().collect();
        let measures = self.system().measures.iter();
        let lines = measures.map(|measure| self.lines_of_quantity(&measure.quantity));
        lines.map(|lines| self.shares(&lines, &parts)).collect()
    }

    /// The shares of parts in what a statement drives or holds, if that is an angle.
    pub(crate) fn shares_in(
        &self,
        statement: &Statement<'_>,
        parts: &[Statement<'_>],
    ) -> Vec<AngleShare> {
        self.shares(&self.lines_of_statement(statement), parts)
    }

    /// The lines of the angle that a statement drives or holds.
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
        let place = |name: &Name| self.point(name.as_str());
        let places = |[from, to]: &[Name; 2]| Some([place(from)?, place(to)?]);
        Lines {
            lines: lines.into_iter().filter_map(places).collect(),
            about: about.and_then(places),
        }
    }

    /// The shares of the bodies, hinges and links that carry the lines and the axis. A line or an axis between
    /// chassis points belongs to the chassis.
    fn shares(&self, Lines { lines, about }: &Lines, parts: &[Statement<'_>]) -> Vec<AngleShare> {
        let chassis = self.system().fixed.len();
        let is_fixed = |ends: &[usize; 2]| ends.iter().all(|end| *end < chassis);
        let ends: Vec<usize> = lines.iter().chain(about).flatten().copied().collect();
        let is_free = |end: &&usize| ends.iter().filter(|other| other == end).count() == 1;
        let line = |ends: &[usize; 2], axis: Option<[[usize; 2]; 2]>| {
            Some(Line {
                ends: *ends,
                free_end: *ends.iter().rev().find(is_free)?,
                axis,
            })
        };
        let of_part = |ends: &[usize; 2]| {
            let part = self.carrier_of(ends, parts)?;
            let own = |about: [usize; 2]| Some([about, self.along(parts.get(part)?, about)?]);
            Some((part, line(ends, about.and_then(own))?))
        };
        let (fixed, moving): (Vec<_>, Vec<_>) = lines.iter().partition(|ends| is_fixed(ends));
        let of_parts: Vec<(usize, Line)> = moving.into_iter().filter_map(of_part).collect();
        let mut of_all: Vec<Line> = of_parts.iter().map(|(_, line)| line.clone()).collect();
        // The axis does not bear again the force that the chassis bears at an end shared by a line and the axis.
        of_all.extend(fixed.into_iter().filter_map(|ends| line(ends, None)));
        let axis = about.filter(|about| !is_fixed(about) && of_all.len() == lines.len());
        let axis = axis.and_then(|ends| {
            Some(AngleShare {
                part: self.carrier_of(&ends, parts)?,
                of: Share::Axis {
                    ends,
                    lines: of_all,
                },
            })
        });
        let of_parts = of_parts.into_iter().map(|(part, line)| AngleShare {
            part,
            of: Share::Line(line),
        });
        of_parts.chain(axis).collect()
    }

    /// The part that keeps two points, or the bodies of markers, apart: a body or a hinge, otherwise a link.
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

    /// Two points of a part that may be along an axis: the ends of the axis itself, or those that a hinge has on the
    /// chassis.
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
