//! Whether the equations can determine the unknowns: counts and structural rank.

use quote::format_ident;
use syn::Ident;

use super::{constant, is_reserved};
use crate::errors::{self, Errors};
use crate::system::{AXES, Equation, System, carried_name, frame_name, pair_name};

/// Checks that no generated name stands for two things, that there are as many equations as
/// unknowns, and that each equation can be given an unknown of its own (structural rank).
pub fn determined(system: &System, errors: &mut Errors) {
    generated_names(system, errors);
    for [body, a, b] in &system.closed_twice {
        errors.push(errors::closed_twice(body, a, b));
    }
    if system.rows().len() == system.size() {
        structural_rank(system, errors);
    } else {
        errors.push(wrong_count(system));
    }
}

/// Checks the names that bodies are given in the generated code against each other and against
/// the user's.
fn generated_names(system: &System, errors: &mut Errors) {
    let (mut constants, mut lengths) = (Vec::new(), Vec::new());
    for body in &system.bodies {
        let frame = frame_name(&body.name);
        constants.extend(["_v", "_w"].map(|suffix| format_ident!("{frame}{suffix}")));
        constants.push(frame);
        for point in &body.carried {
            let name = carried_name(&body.name, &point.name);
            constants.extend(AXES.map(|axis| format_ident!("{name}_{axis}", span = name.span())));
            constants.push(name);
            let pairs = body.frame.iter();
            lengths.extend(pairs.map(|site| pair_name(&body.name, &point.name, &site.name)));
        }
    }
    for cluster in &system.clusters {
        let points = cluster.carried.iter();
        constants.push(frame_name(&cluster.name));
        constants.extend(points.map(|point| carried_name(&cluster.name, &point.name)));
    }
    let mut stated: Vec<Ident> = Vec::new();
    for equation in &system.equations {
        match equation {
            Equation::Distance { named, .. } => stated.push(named.name.clone()),
            Equation::Coordinate { drive, .. } => constants.push(drive.clone()),
            Equation::Carried { .. } => {}
        }
    }
    let markers = system.markers.iter();
    constants.extend(markers.map(|marker| marker.named.name.clone()));
    for names in [constants, lengths] {
        let mut taken: Vec<String> = Vec::new();
        for name in names.iter().chain(&stated) {
            let key = constant(name);
            if is_reserved(name) || taken.contains(&key) {
                errors.push(errors::reserved_name(name));
            }
            taken.push(key);
        }
    }
}

fn wrong_count(system: &System) -> syn::Error {
    let count = |kind: fn(&Equation) -> bool| -> usize {
        let equations = system.equations.iter().filter(|equation| kind(equation));
        equations.map(|equation| equation.rows().len()).sum()
    };
    let links = count(|e| matches!(e, Equation::Distance { of_body: false, .. }));
    let drives = count(|e| matches!(e, Equation::Coordinate { .. }));
    let bodies = system.rows().len() - links - drives;
    let drives_chassis = system
        .drives
        .iter()
        .any(|drive| !drive.of.is_free() && drive.minus.is_none());
    errors::wrong_count(
        system.free_span,
        system.size(),
        [links, bodies, drives],
        drives_chassis,
    )
}

fn structural_rank(system: &System, errors: &mut Errors) {
    let pattern = system.pattern();
    let mut row_of = vec![None; system.size()];
    for (row, name) in system.rows().iter().enumerate() {
        if !augment(row, &pattern, &mut row_of, &mut vec![false; system.size()]) {
            errors.push(errors::redundant_equation(name));
        }
    }
    for column in (0..system.size()).filter(|column| row_of[*column].is_none()) {
        let point = &system.free[column / 3].name;
        errors.push(errors::undetermined(point, AXES[column % 3]));
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
