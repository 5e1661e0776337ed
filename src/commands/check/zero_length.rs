//! Measured lengths that are zero at the design position.

use suspension_runtime::Listing;

use crate::kinematics::Kinematics;
use crate::mechanism::extent;

/// A length that is this part of the suspension's size is zero but for rounding.
const ROUNDING: f64 = 1e-9;

/// Returns a note for each measured length whose ends are in the same place.
pub(super) fn notes(mechanism: &dyn Kinematics, listing: &Listing) -> impl Iterator<Item = String> {
    let at = mechanism.points();
    let least = ROUNDING * extent(at.iter().copied()).norm();
    let lengths = listing.driven_and_measured_lengths().into_iter();
    let zero = lengths.filter(move |[from, to]| (at[*to] - at[*from]).norm() <= least);
    zero.map(|ends| {
        let [from, to] = ends.map(|end| &mechanism.names.points[end]);
        format!(
            "`{from}` and `{to}` are in the same place at the design position: the length between them has no motion ratio \
             there, and no force acts along it"
        )
    })
}
