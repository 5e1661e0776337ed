//! The statements of a listing that have equations.

use std::collections::BTreeSet;
use std::ops::Range;

use suspension_listing::Kind;
use suspension_listing::name::Name;
use suspension_listing::system::{Equation, Quantity, Site};

use crate::listing::Listing;

/// A statement, and its part of the model.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Statement<'l> {
    /// Its name.
    pub name: &'l str,
    /// The kind of part that the name stands for.
    pub kind: Kind,
    /// Its equations by number, in runs that equations of other statements do not interrupt.
    pub equations: Vec<Range<usize>>,
    /// The chassis points and free points that they join, by their indices among all points.
    pub points: Vec<usize>,
}

impl Listing {
    /// The statements that have equations, in the order of their equations.
    pub fn statements(&self) -> Vec<Statement<'_>> {
        let mut statements: Vec<Statement<'_>> = Vec::new();
        let mut first = 0;
        for equation in &self.system().equations {
            let rows = first..first + equation.form.equations().rows();
            first = rows.end;
            let name = equation.origin.statement.as_str();
            let at = match statements.iter().position(|other| other.name == name) {
                Some(at) => at,
                None => {
                    statements.push(Statement::new(equation));
                    statements.len() - 1
                }
            };
            if let Some(statement) = statements.get_mut(at) {
                statement.add(rows);
                let sites = equation.form.equations().sites().into_iter();
                statement.join(sites.map(|site| self.place_of(site)));
            }
        }
        statements
    }

    /// The statements that bear loads: all that have equations, except drives.
    pub fn parts(&self) -> impl Iterator<Item = Statement<'_>> {
        let statements = self.statements().into_iter();
        statements.filter(|statement| statement.kind != Kind::DRIVE)
    }

    /// The statements that drive lengths, which push two points apart.
    pub fn actuators(&self) -> impl Iterator<Item = Statement<'_>> {
        let is_of_length = |name: &str| {
            let mut drives = self.system().drives.iter();
            drives.any(|drive| {
                drive.named.name.as_str() == name
                    && matches!(drive.quantity, Quantity::Length { .. })
            })
        };
        let statements = self.statements().into_iter();
        statements
            .filter(move |statement| statement.kind == Kind::DRIVE && is_of_length(statement.name))
    }

    /// The chassis points that drives move, by their indices among all points.
    pub fn driven_points(&self) -> Vec<usize> {
        let moved = self.system().drives.iter();
        let moved = moved.filter_map(|drive| drive.moves.as_ref());
        moved.map(|site| self.place_of(site)).collect()
    }

    /// The chassis points to which nothing is joined, by name: only drives and measures read them.
    pub fn unjoined_points(&self) -> Vec<&str> {
        let joined: BTreeSet<usize> = self.parts().flat_map(|part| part.points).collect();
        let chassis = self.system().fixed.iter().enumerate();
        let unjoined = chassis.filter(|(place, _)| !joined.contains(place));
        unjoined
            .map(|(_, point)| point.named.name.as_str())
            .collect()
    }

    /// Markers, each with two of the points that carry it whose distance neither an equation, nor a body, nor the
    /// chassis keeps, by name.
    pub fn loose_markers(&self) -> Vec<[&str; 3]> {
        let system = self.system();
        let markers = system.markers.iter();
        let loose = markers.flat_map(|marker| {
            let pairs = system.loose_pairs(&marker.frame).into_iter();
            pairs.map(|[from, to]| [&marker.named.name, from, to].map(|name| name.as_str()))
        });
        loose.collect()
    }

    /// Each marker, by its index among all points, with three points of the body that carries it.
    pub fn carriers(&self) -> Vec<(usize, [usize; 3])> {
        let system = self.system();
        let before = system.fixed.len() + system.free.len();
        let frames = system.markers.iter().map(|marker| marker.frame.each_ref());
        let places = frames.map(|frame| frame.map(|site: &Site| self.place_of(site)));
        (before..).zip(places).collect()
    }

    /// The markers of [`Self::carriers`] whose three points are rigid: those that are not among [`Self::loose_markers`].
    pub fn rigid_carriers(&self) -> Vec<(usize, [usize; 3])> {
        let loose = self.loose_markers().into_iter();
        let loose: BTreeSet<Option<usize>> = loose.map(|[marker, ..]| self.point(marker)).collect();
        let carriers = self.carriers().into_iter();
        carriers
            .filter(|(marker, _)| !loose.contains(&Some(*marker)))
            .collect()
    }

    /// For each measure, the points that its value depends on, by their indices among all points; none for an angle.
    pub fn points_of_measures(&self) -> Vec<Vec<usize>> {
        let measures = self.system().measures.iter();
        let names = measures.map(|measure| match &measure.quantity {
            Quantity::Sum(terms) => terms.iter().map(|term| &term.point).collect(),
            Quantity::Length { line } => line.iter().collect(),
            Quantity::Along { point, .. } => vec![point],
            Quantity::Angle { .. } | Quantity::Between { .. } => Vec::new(),
        });
        let places = names.map(|names: Vec<&Name>| {
            let places = names
                .into_iter()
                .filter_map(|name| self.point(name.as_str()));
            let distinct: BTreeSet<usize> = places.collect();
            distinct.into_iter().collect()
        });
        places.collect()
    }
}

impl<'l> Statement<'l> {
    fn new(equation: &'l Equation) -> Self {
        Self {
            name: equation.origin.statement.as_str(),
            kind: equation.origin.kind,
            equations: Vec::new(),
            points: Vec::new(),
        }
    }

    /// The ends of a link.
    pub fn ends(&self) -> Option<[usize; 2]> {
        match self.points.as_slice() {
            [from, to] if self.kind == Kind::LINK => Some([*from, *to]),
            _ => None,
        }
    }

    fn add(&mut self, rows: Range<usize>) {
        match self.equations.last_mut() {
            Some(last) if last.end == rows.start => last.end = rows.end,
            _ => self.equations.push(rows),
        }
    }

    fn join(&mut self, points: impl Iterator<Item = usize>) {
        for point in points {
            if !self.points.contains(&point) {
                self.points.push(point);
            }
        }
    }
}
