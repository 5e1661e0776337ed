//! What exerts the forces of a part: its own equations, and what drives or holds an angle of which it carries a line.

use std::ops::Range;

use nalgebra::Vector3;
use suspension_core::statics::Loads;
use suspension_core::{Linkage, Values};
use suspension_listing::Kind;
use suspension_listing::form::Form;
use suspension_listing::system::Quantity;

use crate::listing::Listing;
use crate::statement::Statement;

/// A line of an angle, and the part that carries it, which a moment about the angle acts on.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AngleLine {
    /// Its ends, by their places among all points.
    pub ends: [usize; 2],
    /// The end that is of no other line of the angle: the force there is that on this line alone.
    alone: usize,
    /// The number of the part, of [`Listing::parts`].
    pub part: usize,
}

impl AngleLine {
    /// The couple of forces on both ends, of all forces that belong to the angle.
    pub fn couple(&self, at: impl Fn(usize) -> Vector3<f64>) -> [Vector3<f64>; 2] {
        let force = at(self.alone);
        if self.alone == self.ends[1] {
            [-force, force]
        } else {
            [force, -force]
        }
    }
}

/// What exerts the forces of a part.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Exerting {
    equations: Vec<Range<usize>>,
    /// Lines with the equations of their angles: with 1 where the part carries the line, with -1 where the angle is the part
    /// itself and another one carries it.
    lines: Vec<(f64, AngleLine, Vec<Range<usize>>)>,
}

impl Exerting {
    /// Whether moments about angles act on the part.
    pub fn has_lines(&self) -> bool {
        self.lines.iter().any(|(sign, ..)| *sign > 0.0)
    }

    /// Whether other parts carry all that it is.
    pub fn is_of_others(&self) -> bool {
        let others = self.lines.iter().filter(|(sign, ..)| *sign < 0.0);
        others.count() == ANGLE
    }

    /// The forces that the part exerts on chassis points and free points, as [`Loads::by`] has those of equations.
    pub fn forces<L: Linkage<N, Scalar = f64>, const N: usize>(
        &self,
        loads: &Loads<'_, L, N>,
    ) -> L::Points {
        let none = L::Points::from_values([]);
        let by = |equations: &[Range<usize>]| {
            let each = equations.iter().map(|rows| loads.by(rows.clone()));
            each.fold(none, |sum, by| {
                let each = sum.values().zip(by.values());
                L::Points::from_values(each.map(|(sum, by)| sum + by))
            })
        };
        let nth = |points: &L::Points, place: usize| points.values().nth(place).unwrap_or_default();
        let mut forces = by(&self.equations);
        for (sign, line, equations) in &self.lines {
            let all = by(equations);
            let couple = line.couple(|place| nth(&all, place));
            for (end, force) in line.ends.into_iter().zip(couple) {
                forces = forces.with(end, nth(&forces, end) + force * *sign);
            }
        }
        forces
    }
}

/// Lines of an angle that is held.
const ANGLE: usize = 2;

impl Listing {
    /// What exerts the forces of each of [`parts`](Self::parts).
    pub fn exerting(&self) -> Vec<Exerting> {
        let parts: Vec<_> = self.parts().collect();
        let mut exerting: Vec<Exerting> = parts.iter().map(Exerting::of).collect();
        for statement in self.statements() {
            let itself = parts.iter().position(|part| part.name == statement.name);
            for line in self.carried(&self.lines_of(&statement), &parts) {
                let equations = statement.equations.clone();
                let mut add = |part: usize, sign: f64| {
                    if let Some(part) = exerting.get_mut(part) {
                        part.lines.push((sign, line.clone(), equations.clone()));
                    }
                };
                add(line.part, 1.0);
                if let Some(itself) = itself {
                    add(itself, -1.0);
                }
            }
        }
        exerting
    }

    /// The lines of a measured angle that parts carry.
    pub fn lines_of_measure(&self, measure: usize) -> Vec<AngleLine> {
        let parts: Vec<_> = self.parts().collect();
        let measure = self.system().measures.get(measure);
        let lines = measure.map(|measure| self.lines_of_quantity(&measure.quantity));
        self.carried(&lines.unwrap_or_default(), &parts)
    }

    /// The lines of a statement that drives or holds an angle, its axis behind them.
    fn lines_of(&self, statement: &Statement<'_>) -> Vec<[usize; 2]> {
        let system = self.system();
        let mut drives = system.drives.iter();
        if let Some(drive) = drives.find(|drive| drive.named.name.as_str() == statement.name) {
            return self.lines_of_quantity(&drive.quantity);
        }
        let own = |name: &str| name == statement.name;
        let mut equations = system.equations.iter();
        let equation = equations.find(|equation| own(equation.origin.statement.as_str()));
        match equation.map(|equation| &equation.form) {
            Some(Form::Product(product)) => {
                let lines = product.lines.iter();
                let places = lines.map(|line| line.each_ref().map(|site| self.place_of(site)));
                places.collect()
            }
            _ => Vec::new(),
        }
    }

    fn lines_of_quantity(&self, quantity: &Quantity) -> Vec<[usize; 2]> {
        let lines = match quantity {
            Quantity::Angle { line, .. } => vec![line],
            Quantity::Between { lines, about } => lines.iter().chain(about).collect(),
            _ => Vec::new(),
        };
        let places = lines
            .into_iter()
            .map(|[from, to]| Some([self.point(from.as_str())?, self.point(to.as_str())?]));
        places.collect::<Option<_>>().unwrap_or_default()
    }

    /// Of lines, behind which their axis may be, those that a part carries: a body or a hinge, or else a link.
    fn carried(&self, lines: &[[usize; 2]], parts: &[Statement<'_>]) -> Vec<AngleLine> {
        let ends: Vec<usize> = lines.iter().flatten().copied().collect();
        let is_alone = |end: usize| ends.iter().filter(|other| **other == end).count() == 1;
        let carriers = self.carriers();
        let places = |end: usize| {
            let carrier = carriers.iter().find(|(marker, _)| *marker == end);
            carrier.map_or_else(|| vec![end], |(_, body)| body.to_vec())
        };
        let of_line = |line: &[usize; 2]| {
            let alone = line.iter().rev().copied().find(|end| is_alone(*end))?;
            let points: Vec<usize> = line.iter().flat_map(|end| places(*end)).collect();
            let carries = |kinds: &[Kind]| {
                parts.iter().position(|part| {
                    let has = |point: &usize| part.points.contains(point);
                    kinds.contains(&part.kind) && points.iter().all(has)
                })
            };
            let part = carries(&[Kind::BODY, Kind::HINGE]).or_else(|| carries(&[Kind::LINK]))?;
            Some(AngleLine {
                ends: *line,
                alone,
                part,
            })
        };
        lines.iter().take(ANGLE).filter_map(of_line).collect()
    }
}

impl Exerting {
    fn of(part: &Statement<'_>) -> Self {
        Self {
            equations: part.equations.clone(),
            lines: Vec::new(),
        }
    }
}
