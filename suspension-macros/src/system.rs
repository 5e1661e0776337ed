//! The intermediate representation: named points, named equations, and which unknowns each
//! equation depends on. Emission sees nothing else.

use proc_macro2::Span;
use quote::format_ident;
use syn::{Attribute, Ident, Visibility};

use crate::ast::Named;
use crate::eliminate::Entry;
use crate::sample::{Design, derivative};

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

/// An entry of the Jacobian: which row of which equation depends on which coordinate.
pub(crate) struct Place<'a> {
    pub(crate) equation: &'a Equation,
    pub(crate) row_of_equation: usize,
    pub(crate) point: &'a Ident,
    pub(crate) axis: usize,
    pub(crate) row: usize,
    pub(crate) column: usize,
    /// Whether it is 1 in every position.
    unit: bool,
    /// See [`Entry::carried`].
    carried: bool,
}

/// A point that elimination takes out first: where the frame that carries it goes, it goes.
pub(crate) struct Substituted<'a> {
    pub(crate) body: &'a Ident,
    pub(crate) point: &'a Ident,
    /// The column of its first coordinate.
    pub(crate) column: usize,
    /// Those of the frame's points, where they are free.
    pub(crate) frame: [Option<usize>; 3],
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

impl System {
    /// The number of unknowns.
    pub(crate) fn size(&self) -> usize {
        3 * self.free.len()
    }

    /// The rows' names, in order.
    pub(crate) fn rows(&self) -> Vec<Ident> {
        self.equations.iter().flat_map(Equation::rows).collect()
    }

    /// The column of each entry of each row that is not always zero.
    pub(crate) fn pattern(&self) -> Vec<Vec<usize>> {
        let mut pattern = vec![Vec::new(); self.rows().len()];
        for place in self.places() {
            pattern[place.row].push(place.column);
        }
        pattern
    }

    /// The entries of the Jacobian that are not always zero, with their values in some positions.
    pub(crate) fn entries(&self, positions: &[Design]) -> Vec<Entry> {
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
    pub(crate) fn substituted(&self) -> Vec<Substituted<'_>> {
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
    pub(crate) fn places(&self) -> Vec<Place<'_>> {
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
