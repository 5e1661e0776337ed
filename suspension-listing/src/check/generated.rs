//! A check that the names in the generated code differ from each other and from the user's.

use proc_macro2::Span;

use super::determined::{place_of, place_of_scalar};
use super::reserved::{constant, is_reserved};
use crate::errors::{self, Errors};
use crate::listing::Listing;
use crate::name::Name;
use crate::system::{Body, System, carried_name, coordinate_name, frame_name, pair_name};

/// A name in the generated code, and the place in the listing of what it is made from.
type Generated = (Name, Span);

/// Checks that no generated name stands for two things.
pub(crate) fn generated_names(listing: &Listing, system: &System, errors: &mut Errors) {
    let mut constants: Vec<Generated> = Vec::new();
    for body in &system.bodies {
        let frame = frame_name(&body.name);
        let rates = ["_v", "_w"].map(|suffix| Name::made(format!("{frame}{suffix}")));
        let at = listing.place_of(&body.name, None);
        constants.extend(rates.into_iter().chain([frame]).map(|name| (name, at)));
    }
    let clusters = system.clusters.iter();
    constants.extend(clusters.flat_map(|cluster| names_of_cluster(listing, cluster)));
    let mut distances = Vec::new();
    for equation in &system.equations {
        let (name, at) = (&equation.named.name, place_of(listing, equation));
        if equation.form.equations().keeps().is_some() {
            distances.push((name.clone(), at));
        } else {
            let rows = equation.rows().into_iter().filter(|row| row != name);
            constants.extend(rows.chain([name.clone()]).map(|name| (name, at)));
        }
    }
    let markers = system.markers.iter().map(|marker| &marker.named.name);
    constants.extend(markers.map(|name| (name.clone(), listing.place_of(name, None))));
    let bodies = system.bodies.iter();
    let lengths = bodies.flat_map(|body| lengths_of(listing, body));
    check_distinct(constants.into_iter().chain(distances.clone()), errors);
    check_distinct(lengths.chain(distances), errors);
    check_distinct(unknowns(listing, system), errors);
}

fn check_distinct(names: impl Iterator<Item = Generated>, errors: &mut Errors) {
    let mut taken: Vec<String> = Vec::new();
    for (name, at) in names {
        let key = constant(name.as_str());
        if is_reserved(name.as_str()) || taken.contains(&key) {
            errors.push(errors::reserved_name(&name.at(at)));
        }
        taken.push(key);
    }
}

fn names_of_cluster(listing: &Listing, cluster: &Body) -> Vec<Generated> {
    let at = |point: &Name| listing.place_of(&cluster.name, Some(point));
    let [.., third] = &cluster.frame;
    let frame = (frame_name(&cluster.name), at(&third.name));
    let carried = cluster.carried.iter();
    let carried = carried.map(|point| {
        let name = carried_name(&cluster.name, &point.name);
        (name, at(&point.name))
    });
    [frame].into_iter().chain(carried).collect()
}

/// The lengths from a body's carried points to its frame.
fn lengths_of(listing: &Listing, body: &Body) -> Vec<Generated> {
    let pairs = body.carried.iter().flat_map(|point| {
        let at = listing.place_of(&body.name, Some(&point.name));
        let of_frame = body.frame.iter();
        of_frame.map(move |site| (pair_name(&body.name, &point.name, &site.name), at))
    });
    pairs.collect()
}

fn unknowns(listing: &Listing, system: &System) -> impl Iterator<Item = Generated> {
    let free = system.free.iter().map(|point| &point.named.name);
    let coordinates = free.flat_map(|point| {
        let at = listing.place_of(point, None);
        let names = (0..3).map(|axis| coordinate_name(point, axis));
        // Scalars are in the same struct as the points.
        let names = names.chain([point.clone()]);
        names.map(move |name| (name, at))
    });
    let scalars = system.scalars.iter();
    let scalars = scalars.map(|name| (name.clone(), place_of_scalar(listing, system, name)));
    coordinates.chain(scalars)
}
