//! A check that the chassis points are used.

use std::collections::BTreeSet;

use syn::{Error, Ident};

use crate::errors::{self, Errors};
use crate::listing::Listing;

/// Checks that each chassis point is used.
pub(crate) fn chassis_points(listing: &Listing, errors: &mut Errors) {
    let used = used_points(listing);
    for point in listing.fixed.iter().map(|point| &point.named.name) {
        if used.contains(point) {
            continue;
        }
        let mut moved = listing.statements.iter().filter_map(|other| other.moves());
        errors.push(match moved.find(|moved| *moved == point) {
            Some(token) => drive_moves_nothing(token),
            None => unused_chassis_point(point),
        });
    }
}

/// The points of all statements except those that move points.
fn used_points(listing: &Listing) -> BTreeSet<&Ident> {
    let statements = listing.statements.iter();
    let depend = statements.filter(|statement| statement.moves().is_none());
    depend.flat_map(|statement| statement.operands()).collect()
}

fn drive_moves_nothing(point: &Ident) -> Error {
    errors::at(
        point,
        format!(
            "the drive moves chassis point `{point}`, to which nothing is attached; join `{point}` by a link \
             or a body, or remove the drive"
        ),
    )
}

fn unused_chassis_point(point: &Ident) -> Error {
    errors::at(
        point,
        format!(
            "nothing depends on chassis point `{point}`; join it by a link or a body, or remove it"
        ),
    )
}
