//! Bodies that turn about lines on the chassis.

use std::ops::Range;

use suspension_core::listing::{Part, Parts};
use suspension_listing::Kind;
use suspension_runtime::Listing;

/// A body that turns about a line on the chassis.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Hinge {
    /// The body's name.
    pub name: String,
    /// The points on the chassis about whose line it turns.
    pub axis: Vec<String>,
    equations: Vec<Range<usize>>,
}

impl Hinge {
    /// Those of a listing with so many chassis points.
    pub(crate) fn all(listing: &Listing, chassis: usize) -> Vec<Self> {
        let statements = listing.statements().into_iter();
        let hinges = statements.filter(|statement| statement.kind == Kind::HINGE);
        let hinges = hinges.map(|hinge| {
            let axis = hinge.points.iter().filter(|point| **point < chassis);
            Self {
                name: hinge.name.to_owned(),
                axis: axis
                    .map(|point| listing.name(Part::Point(*point)).to_owned())
                    .collect(),
                equations: hinge.equations,
            }
        });
        hinges.collect()
    }

    /// Whether an equation, by its number, is of it.
    pub(crate) fn has(&self, equation: usize) -> bool {
        self.equations.iter().any(|rows| rows.contains(&equation))
    }

    /// That it keeps the mechanism from going on, in words.
    pub(crate) fn fault(&self) -> String {
        let axis = self.axis.iter().map(|point| format!("`{point}`"));
        let axis = axis.collect::<Vec<_>>().join(", ");
        format!("`{}` on its hinge {axis} reaches no further", self.name)
    }
}
