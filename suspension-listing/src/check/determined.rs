//! Whether the equations can determine the unknowns: counts and structural rank.

use proc_macro2::Span;
use syn::{Error, Ident};

use super::{constant, is_reserved};
use crate::errors::{self, Errors};
use crate::listing::Listing;
use crate::name::Name;
use crate::statement::Kind;
use crate::system::{
    AXES, Body, Equation, System, carried_name, coordinate_name, frame_name, pair_name,
};

/// Checks that no generated name stands for two things, that there are as many equations as
/// unknowns, and that each equation can be given an unknown of its own (structural rank).
pub(crate) fn determined(listing: &Listing, system: &System, errors: &mut Errors) {
    generated_names(listing, system, errors);
    if system.rows().len() == system.size() {
        structural_rank(listing, system, errors);
    } else {
        errors.push(wrong_count(listing, system));
    }
}

/// A name in the generated code, and what of the listing it is made of.
type Generated = (Name, Span);

/// Checks the names that bodies are given in the generated code against each other and against
/// the user's.
fn generated_names(listing: &Listing, system: &System, errors: &mut Errors) {
    let (mut constants, mut lengths) = (Vec::new(), Vec::new());
    for body in &system.bodies {
        let frame = frame_name(&body.name);
        let rates = ["_v", "_w"].map(|suffix| Name::made(format!("{frame}{suffix}")));
        let at = listing.place_of(&body.name, None);
        constants.extend(rates.into_iter().chain([frame]).map(|name| (name, at)));
        let [of_points, of_pairs] = carried_names(listing, body);
        constants.extend(of_points);
        lengths.extend(of_pairs);
    }
    for cluster in &system.clusters {
        let [.., third] = &cluster.frame;
        let at = |point: &Name| listing.place_of(&cluster.name, Some(point));
        constants.push((frame_name(&cluster.name), at(&third.name)));
        let points = cluster.carried.iter();
        let names = points.map(|point| {
            let name = carried_name(&cluster.name, &point.name);
            (name, at(&point.name))
        });
        constants.extend(names);
    }
    let mut stated: Vec<Generated> = Vec::new();
    for equation in &system.equations {
        let (name, form) = (&equation.named.name, equation.form.equations());
        if form.keeps().is_some() {
            stated.push((name.clone(), place_of(listing, equation)));
        } else if form.drive().is_some() {
            constants.push((name.clone(), place_of(listing, equation)));
        }
    }
    let markers = system.markers.iter().map(|marker| &marker.named.name);
    constants.extend(markers.map(|name| (name.clone(), listing.place_of(name, None))));
    for names in [constants, lengths] {
        let mut taken: Vec<String> = Vec::new();
        for (name, at) in names.iter().chain(&stated) {
            let key = constant(name.as_str());
            if is_reserved(name.as_str()) || taken.contains(&key) {
                errors.push(errors::reserved_name(&name.at(*at)));
            }
            taken.push(key);
        }
    }
}

/// Those of a body's carried points, and of the lengths to them.
fn carried_names(listing: &Listing, body: &Body) -> [Vec<Generated>; 2] {
    let (mut constants, mut lengths) = (Vec::new(), Vec::new());
    for point in &body.carried {
        let name = carried_name(&body.name, &point.name);
        let at = listing.place_of(&body.name, Some(&point.name));
        let rows = (0..3).map(|axis| coordinate_name(&name, axis));
        constants.extend(rows.chain([name.clone()]).map(|name| (name, at)));
        let of_frame = body.frame.iter();
        let pairs = of_frame.map(|site| pair_name(&body.name, &point.name, &site.name));
        lengths.extend(pairs.map(|name| (name, at)));
    }
    [constants, lengths]
}

fn place_of(listing: &Listing, equation: &Equation) -> Span {
    let origin = &equation.origin;
    listing.place_of(&origin.statement, origin.operand.as_ref())
}

fn wrong_count(listing: &Listing, system: &System) -> Error {
    let (equations, unknowns) = (system.rows().len(), system.size());
    let remedy = if equations < unknowns {
        let missing = unknowns - equations;
        format!("{missing} more needed: add a link, a drive, or list a point in its body")
    } else {
        let excess = equations - unknowns;
        format!("{excess} too many: remove a link or a drive")
    };
    let drives_chassis = system.drives.iter().any(|drive| drive.moves.is_some());
    let note = if drives_chassis {
        " (a drive of a chassis point adds no equation)"
    } else {
        ""
    };
    let (by_kind, points) = (by_kind(listing, system), system.free.len());
    Error::new(
        listing.free_span,
        format!(
            "{equations} equations for {unknowns} unknowns: {by_kind}, against 3 x {points} free \
             points; {remedy}{note}"
        ),
    )
}

/// How many equations are of the statements of each kind.
fn by_kind(listing: &Listing, system: &System) -> String {
    let mut kinds: Vec<Kind> = Vec::new();
    for (_, kind) in listing.declared() {
        if !kinds.contains(&kind) {
            kinds.push(kind);
        }
    }
    let counts = kinds.into_iter().map(|kind| {
        let equations = system.equations.iter();
        let of_kind = equations.filter(|equation| equation.origin.kind == kind);
        let count: usize = of_kind.map(|equation| equation.rows().len()).sum();
        (kind, count)
    });
    let stated = counts.filter(|(_, count)| *count > 0);
    let words = stated.map(|(kind, count)| format!("{count} of {}", kind.plural()));
    words.collect::<Vec<_>>().join(" + ")
}

fn structural_rank(listing: &Listing, system: &System, errors: &mut Errors) {
    let pattern = system.pattern();
    let mut row_of = vec![None; system.size()];
    let equations = system.equations.iter();
    let rows = equations.flat_map(|equation| equation.rows().into_iter().map(move |_| equation));
    let names = system.rows();
    for (row, (equation, name)) in rows.zip(&names).enumerate() {
        if !augment(row, &pattern, &mut row_of, &mut vec![false; system.size()]) {
            let name = name.at(place_of(listing, equation));
            errors.push(redundant_equation(&name));
        }
    }
    for column in (0..system.size()).filter(|column| row_of[*column].is_none()) {
        let point = &system.free[column / 3].named.name;
        let point = point.at(listing.place_of(point, None));
        errors.push(undetermined(&point, AXES[column % 3]));
    }
}

/// Finds a column for `row`, moving earlier rows to other columns where need be (augmenting path
/// of a bipartite matching).
fn augment(
    row: usize,
    pattern: &[Vec<usize>],
    row_of: &mut [Option<usize>],
    seen: &mut [bool],
) -> bool {
    pattern[row].iter().any(|&column| {
        if std::mem::replace(&mut seen[column], true) {
            return false;
        }
        let free = row_of[column].is_none_or(|other| augment(other, pattern, row_of, seen));
        if free {
            row_of[column] = Some(row);
        }
        free
    })
}

fn redundant_equation(name: &Ident) -> Error {
    errors::at(
        name,
        format!(
            "`{name}` is one equation too many for the points it joins, while others have too few; move it there"
        ),
    )
}

fn undetermined(point: &Ident, axis: &str) -> Error {
    errors::at(
        point,
        format!(
            "no equation is left to determine `{point}.{axis}`; join `{point}` by a link or a body"
        ),
    )
}
