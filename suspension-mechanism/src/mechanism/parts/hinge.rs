//! Bodies that turn about lines or points on the chassis.

use std::ops::Range;

use nalgebra::SVector;
use suspension_core::listing::{Part, Parts};
use suspension_listing::Kind;
use suspension_runtime::{Listing, Statement};

/// A body that turns about a line on the chassis, or about a point (as an arm of a twist beam on its bush does), or
/// about a line of another body that moves.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Hinge {
    /// The body's name.
    pub name: String,
    /// The points about which it turns: two on the line, or a single one.
    pub axis: Vec<String>,
    equations: Vec<Range<usize>>,
    /// The numbers of its free points.
    free: Vec<usize>,
}

impl Hinge {
    /// All hinges of a listing with this number of chassis points.
    pub(crate) fn all(listing: &Listing, chassis: usize) -> Vec<Self> {
        let mut bodies = listing.statements();
        bodies.retain(|statement| [Kind::HINGE, Kind::BODY].contains(&statement.kind));
        let name = |point: &usize| listing.name(Part::Point(*point)).to_owned();
        let hinges = bodies.iter().filter_map(|body| {
            let axis = axis(body, &bodies, chassis)?;
            let free = body.points.iter();
            Some(Self {
                name: body.name.to_owned(),
                axis: axis.iter().map(name).collect(),
                equations: body.equations.clone(),
                free: free
                    .filter_map(|point| point.checked_sub(chassis))
                    .collect(),
            })
        });
        hinges.collect()
    }

    /// Whether a change of the unknowns moves it.
    pub(crate) fn moves<const N: usize>(&self, change: &SVector<f64, N>) -> bool {
        /// The smallest change, as a fraction of that of the unknown that changes most.
        const LEAST: f64 = 1e-3;
        let least = LEAST * change.amax();
        let mut coordinates = self.free.iter().flat_map(|point| 3 * point..3 * point + 3);
        coordinates.any(|unknown| change[unknown].abs() > least)
    }

    /// Whether an equation, by its number, belongs to it.
    pub(crate) fn has(&self, equation: usize) -> bool {
        self.equations.iter().any(|rows| rows.contains(&equation))
    }

    /// The message that it keeps the mechanism from going on.
    pub(crate) fn fault(&self) -> String {
        let joint_or_hinge = match self.axis.as_slice() {
            [_] => "joint",
            _ => "hinge",
        };
        let axis = self.axis.iter().map(|point| format!("`{point}`"));
        let axis = axis.collect::<Vec<_>>().join(", ");
        format!(
            "`{}` on its {joint_or_hinge} {axis} reaches no further",
            self.name
        )
    }
}

/// The points of a body on the chassis, otherwise the two that it shares with another body.
fn axis(body: &Statement<'_>, bodies: &[Statement<'_>], chassis: usize) -> Option<Vec<usize>> {
    let points = || body.points.iter().copied();
    let on_chassis: Vec<usize> = points().filter(|point| *point < chassis).collect();
    if !on_chassis.is_empty() {
        return Some(on_chassis);
    }
    let others = bodies.iter().filter(|other| other.name != body.name);
    let mut shared = others.map(|other| {
        points()
            .filter(|point| other.points.contains(point))
            .collect()
    });
    shared.find(|shared: &Vec<usize>| shared.len() == 2)
}
