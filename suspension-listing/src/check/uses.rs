//! Whether the chassis points are used, and angles have a length.

use std::collections::BTreeSet;

use syn::Ident;

use crate::ast::{Listing, Quantity};
use crate::errors::{self, Errors};
use crate::name::Name;
use crate::system::System;

/// Checks that an equation keeps the distance of the two points of each angle.
pub fn angles(listing: &Listing, system: &System, errors: &mut Errors) {
    if listing.incomplete {
        return;
    }
    for (stated, drive) in listing.drives.iter().zip(&system.drives) {
        let Quantity::Angle { from, to, .. } = &stated.quantity else {
            continue;
        };
        // Anything else is reported as an operand.
        let is_free = |name: &Ident| listing.free.iter().any(|point| point.named.name == *name);
        let is_fixed = |name: &Ident| listing.fixed.iter().any(|point| point.named.name == *name);
        let can_turn =
            (is_free(from) && (is_free(to) || is_fixed(to))) || (is_fixed(from) && is_free(to));
        if drive.angle_of.is_some() || !can_turn || from == to {
            continue;
        }
        let body = system.bodies.iter().find(|body| {
            let lists = |name: &Ident| {
                let mut sites = body.frame.iter().chain(&body.carried);
                sites.any(|site| site.name == Name::from(name))
            };
            lists(from) && lists(to)
        });
        errors.push(match body {
            Some(body) => errors::angle_beside_frame([from, to], body),
            None => errors::no_such_link(from, to),
        });
    }
}

/// Checks that something depends on each chassis point.
pub fn chassis_points(listing: &Listing, errors: &mut Errors) {
    let used = used_points(listing);
    for point in listing.fixed.iter().map(|point| &point.named.name) {
        if used.contains(point) {
            continue;
        }
        let mut drives = listing.drives.iter();
        let driven = drives.find_map(|drive| match &drive.quantity {
            Quantity::Coordinate { of, minus: None } if of.point == *point => Some(&of.point),
            _ => None,
        });
        errors.push(match driven {
            Some(token) => errors::drive_moves_nothing(token),
            None => errors::unused_chassis_point(point),
        });
    }
}

/// Points of everything but drives of their own coordinates.
fn used_points(listing: &Listing) -> BTreeSet<&Ident> {
    let mut used = BTreeSet::new();
    for constraint in &listing.constraints {
        used.extend(constraint.points());
    }
    for drive in &listing.drives {
        match &drive.quantity {
            Quantity::Coordinate { minus: None, .. } => {}
            Quantity::Coordinate {
                of,
                minus: Some(minus),
            } => used.extend([&of.point, &minus.point]),
            Quantity::Angle { from, to, .. } => used.extend([from, to]),
        }
    }
    for measure in &listing.measures {
        used.extend(measure.measured.points().into_iter().flatten());
    }
    for marker in &listing.markers {
        used.extend(&marker.carriers);
    }
    for axis in listing.wheel.iter().chain(&listing.kingpin) {
        used.extend([&axis.from, &axis.to]);
    }
    used
}
