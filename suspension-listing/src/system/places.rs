//! The non-zero entries of the Jacobian, and those that are eliminated first.

use std::collections::BTreeSet;

use super::{Site, System};
use crate::eliminate::{EliminationOrder, Step};
use crate::form::{Carried, Dependence};
use crate::name::Name;

/// An entry of the Jacobian: which row of which equation depends on which coordinate.
pub struct Place<'a> {
    pub row: usize,
    pub column: usize,
    pub(crate) equation: usize,
    pub(crate) row_of_equation: usize,
    /// The number of the coordinate or scalar among those of the equation: the coordinates of its sites come first.
    pub(crate) argument: usize,
    point: Option<&'a Name>,
    /// Whether it is 1 in every position.
    pub(crate) unit: bool,
    /// See [`Entry::carried`](crate::eliminate::Entry::carried).
    pub(crate) carried: bool,
}

/// A carried point that elimination substitutes first: it moves with its frame.
pub struct Substituted<'a> {
    pub body: &'a Name,
    pub point: &'a Name,
    /// The column of its first coordinate.
    pub column: usize,
    /// The columns of the frame's points, if they are free.
    pub frame: [Option<usize>; 3],
}

impl Substituted<'_> {
    /// The rows of other equations that depend on it.
    pub fn rows(&self, order: &EliminationOrder) -> BTreeSet<usize> {
        self.steps(order)
            .flat_map(|step| &step.below)
            .copied()
            .collect()
    }

    /// Its three steps, one per axis.
    pub fn steps<'a>(&self, order: &'a EliminationOrder) -> impl Iterator<Item = &'a Step> {
        let columns = self.column..self.column + 3;
        let steps = order.steps.iter();
        steps.filter(move |step| step.carried && columns.contains(&step.column))
    }
}

impl System {
    /// The column of each entry of each row that is not always zero.
    pub fn pattern(&self) -> Vec<Vec<usize>> {
        let mut pattern = vec![Vec::new(); self.rows().len()];
        for place in self.places() {
            pattern[place.row].push(place.column);
        }
        pattern
    }

    /// The free points that one frame carries and that carry no others.
    pub fn substituted(&self) -> Vec<Substituted<'_>> {
        let carried = || {
            let equations = self.equations.iter();
            equations.filter_map(|equation| equation.form.equations().carries())
        };
        let is_alone = |name: &Name| {
            let carries = |other: &Carried| other.frame.iter().any(|site| site.name == *name);
            let times = carried().filter(|other| other.point.name == *name).count();
            times == 1 && !carried().any(carries)
        };
        let alone = carried().filter(|carried| is_alone(&carried.point.name));
        let substituted = alone.filter_map(|Carried { body, frame, point }| {
            Some(Substituted {
                body,
                point: &point.name,
                column: point.first_column()?,
                frame: frame.each_ref().map(Site::first_column),
            })
        });
        substituted.collect()
    }

    /// The places where the Jacobian is not always zero.
    pub fn places(&self) -> Vec<Place<'_>> {
        let mut places = Vec::new();
        let mut first_row = 0;
        for index in 0..self.equations.len() {
            let rows = self.equations[index].form.equations().rows();
            for row in 0..rows {
                places.extend(self.places_of_row(index, row, first_row + row));
            }
            first_row += rows;
        }
        let substituted = self.substituted();
        for place in &mut places {
            place.carried &= substituted
                .iter()
                .any(|other| Some(other.point) == place.point);
        }
        places
    }

    /// The places of one row of an equation, in the given row of the Jacobian.
    fn places_of_row(
        &self,
        equation: usize,
        row_of_equation: usize,
        row: usize,
    ) -> impl Iterator<Item = Place<'_>> {
        let form = self.equations[equation].form.equations();
        let carried = form.carries().map(|carried| &carried.point.name);
        let place = move |argument, column, point, unit| Place {
            row,
            column,
            equation,
            row_of_equation,
            argument,
            point,
            unit,
            carried: point.is_some() && carried == point,
        };
        let sites = form.sites();
        let first_scalar = 3 * sites.len();
        let scalars = form.scalars().into_iter().enumerate();
        let scalars = scalars.filter_map(move |(index, (name, dependence))| {
            let unit = dependence == Dependence::Unit;
            let column = self.scalar_column(name)?;
            Some(place(first_scalar + index, column, None, unit))
        });
        let sites = sites.into_iter().enumerate();
        let axes = sites.flat_map(|(site, point)| (0..3).map(move |axis| (site, point, axis)));
        let coordinates = axes.filter_map(move |(site, point, axis)| {
            let dependence = form.dependence(row_of_equation, site, axis);
            let column = point.first_column()? + axis;
            let unit = dependence == Dependence::Unit;
            (dependence != Dependence::Never)
                .then(|| place(3 * site + axis, column, Some(&point.name), unit))
        });
        coordinates.chain(scalars)
    }
}
