//! Bodies that turn about lines or points on the chassis.

use std::ops::Range;

use suspension_core::listing::{Part, Parts};
use suspension_listing::Kind;
use suspension_runtime::Listing;

/// A body that turns about a line on the chassis, or about a point, as an arm of a twist beam on its bush.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Hinge {
    /// The body's name.
    pub name: String,
    /// The points on the chassis about which it turns: two on the line, or one alone.
    pub axis: Vec<String>,
    equations: Vec<Range<usize>>,
}

impl Hinge {
    /// Those of a listing with so many chassis points.
    pub(crate) fn all(listing: &Listing, chassis: usize) -> Vec<Self> {
        let statements = listing.statements().into_iter();
        let is_body = |kind: &Kind| [Kind::HINGE, Kind::BODY].contains(kind);
        let bodies = statements.filter(|statement| is_body(&statement.kind));
        let hinges = bodies.filter_map(|body| {
            let axis = body.points.iter().filter(|point| **point < chassis);
            let axis = axis.map(|point| listing.name(Part::Point(*point)).to_owned());
            let axis: Vec<String> = axis.collect();
            (!axis.is_empty()).then(|| Self {
                name: body.name.to_owned(),
                axis,
                equations: body.equations,
            })
        });
        hinges.collect()
    }

    /// Whether an equation, by its number, is of it.
    pub(crate) fn has(&self, equation: usize) -> bool {
        self.equations.iter().any(|rows| rows.contains(&equation))
    }

    /// That it keeps the mechanism from going on, in words.
    pub(crate) fn fault(&self) -> String {
        let on = match self.axis.as_slice() {
            [_] => "joint",
            _ => "hinge",
        };
        let axis = self.axis.iter().map(|point| format!("`{point}`"));
        let axis = axis.collect::<Vec<_>>().join(", ");
        format!("`{}` on its {on} {axis} reaches no further", self.name)
    }
}
