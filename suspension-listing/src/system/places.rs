//! Where the Jacobian is not always zero, and what of it elimination takes out first.

use std::collections::BTreeSet;

use syn::Ident;

use super::{Equation, Site, System};
use crate::eliminate::{Entry, Order, Step};
use crate::sample::{Design, derivative};

/// An entry of the Jacobian: which row of which equation depends on which coordinate.
pub struct Place<'a> {
    pub equation: &'a Equation,
    pub row_of_equation: usize,
    pub point: &'a Ident,
    pub axis: usize,
    pub row: usize,
    pub column: usize,
    /// Whether it is 1 in every position.
    unit: bool,
    /// See [`Entry::carried`].
    carried: bool,
}

/// A point that elimination takes out first: where the frame that carries it goes, it goes.
pub struct Substituted<'a> {
    pub body: &'a Ident,
    pub point: &'a Ident,
    /// The column of its first coordinate.
    pub column: usize,
    /// Those of the frame's points, where they are free.
    pub frame: [Option<usize>; 3],
}

impl Substituted<'_> {
    /// The rows of other equations that depend on it.
    pub fn rows(&self, order: &Order) -> BTreeSet<usize> {
        self.steps(order)
            .flat_map(|step| &step.below)
            .copied()
            .collect()
    }

    /// Its three steps, one an axis.
    pub fn steps<'a>(&self, order: &'a Order) -> impl Iterator<Item = &'a Step> {
        let columns = self.column..self.column + 3;
        let steps = order.steps.iter();
        steps.filter(move |step| step.carried && columns.contains(&step.column))
    }
}

/// That a row depends on a coordinate of a free point.
struct Dependence<'a> {
    point: &'a Ident,
    axis: usize,
    /// Whether the derivative is 1 in every position.
    unit: bool,
}

fn free_axes<'a>(sites: impl IntoIterator<Item = &'a Site>) -> Vec<Dependence<'a>> {
    let free = sites.into_iter().filter(|site| site.is_free());
    let all_axes = |point| {
        (0..3).map(move |axis| Dependence {
            point,
            axis,
            unit: false,
        })
    };
    free.flat_map(|site| all_axes(&site.name)).collect()
}

impl Equation {
    /// Whether it ties the point to a frame.
    fn carries(&self, name: &Ident) -> bool {
        matches!(self, Self::Carried { point, .. } if point.name == *name)
    }

    /// For each row, its dependences.
    fn columns(&self) -> Vec<Vec<Dependence<'_>>> {
        match self {
            Self::Distance { from, to, .. } => vec![free_axes([from, to])],
            Self::Carried { point, frame, .. } => (0..3)
                .map(|row| {
                    let mut columns = free_axes(frame.iter());
                    columns.push(Dependence {
                        point: &point.name,
                        axis: row,
                        unit: true,
                    });
                    columns
                })
                .collect(),
            Self::Coordinate {
                axis, of, minus, ..
            } => {
                let ends = [(Some(of), true), (minus.as_ref(), false)];
                let ends = ends.into_iter().filter_map(|(site, unit)| {
                    let point = &site.filter(|site| site.is_free())?.name;
                    Some(Dependence {
                        point,
                        axis: *axis,
                        unit,
                    })
                });
                vec![ends.collect()]
            }
        }
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

    /// The entries of the Jacobian that are not always zero, with their values in some positions.
    pub fn entries(&self, positions: &[Design]) -> Vec<Entry> {
        let places = self.places();
        let entries = places.iter().map(|place| {
            let &Place {
                equation,
                row_of_equation,
                point,
                axis,
                ..
            } = place;
            let values = positions
                .iter()
                .map(|design| derivative(equation, row_of_equation, point, axis, design));
            Entry {
                row: place.row,
                column: place.column,
                unit: place.unit,
                carried: place.carried,
                values: values.collect::<Option<Vec<f64>>>().unwrap_or_default(),
            }
        });
        entries.collect()
    }

    /// The column of a free point's first coordinate.
    fn first_column(&self, name: &Ident) -> Option<usize> {
        let index = self.free.iter().position(|free| free.name == *name);
        index.map(|index| 3 * index)
    }

    /// The free points that one frame carries and that carry no others.
    pub fn substituted(&self) -> Vec<Substituted<'_>> {
        let carried = self.equations.iter().filter_map(|equation| match equation {
            Equation::Carried { body, point, frame } => Some((body, point, frame)),
            _ => None,
        });
        let is_alone = |name: &Ident| {
            let carries =
                |(_, _, frame): (_, _, &[Site; 3])| frame.iter().any(|site| site.name == *name);
            carried
                .clone()
                .filter(|(_, point, _)| point.name == *name)
                .count()
                == 1
                && !carried.clone().any(carries)
        };
        let alone = carried
            .clone()
            .filter(|(_, point, _)| is_alone(&point.name));
        let substituted = alone.filter_map(|(body, point, frame)| {
            Some(Substituted {
                body,
                point: &point.name,
                column: self.first_column(&point.name)?,
                frame: frame.each_ref().map(|site| self.first_column(&site.name)),
            })
        });
        substituted.collect()
    }

    /// Where the Jacobian is not always zero.
    pub fn places(&self) -> Vec<Place<'_>> {
        let mut places = Vec::new();
        let substituted = self.substituted();
        let mut first_row = 0;
        for equation in &self.equations {
            let rows = equation.columns();
            for (row, columns) in rows.iter().enumerate() {
                for &Dependence { point, axis, unit } in columns {
                    let Some(first_column) = self.first_column(point) else {
                        continue;
                    };
                    places.push(Place {
                        equation,
                        row_of_equation: row,
                        point,
                        axis,
                        row: first_row + row,
                        column: first_column + axis,
                        unit,
                        carried: equation.carries(point)
                            && substituted.iter().any(|other| other.point == point),
                    });
                }
            }
            first_row += rows.len();
        }
        places
    }
}
