//! The fields of the generated structs of names, with their docs.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::quantity;
use suspension_listing::name::{Name, Named};
use suspension_listing::system::System;

/// A field of a generated struct.
pub(super) struct Field {
    pub(super) docs: Vec<String>,
    pub(super) name: Name,
    /// The documentation of the field if the user gives none.
    pub(super) fallback: String,
}

impl Field {
    pub(super) fn new(Named { name, docs }: &Named, fallback: String) -> Self {
        Self {
            docs: docs.clone(),
            name: name.clone(),
            fallback,
        }
    }

    pub(super) fn undocumented(name: Name, fallback: String) -> Self {
        let docs = Vec::new();
        Self::new(&Named { name, docs }, fallback)
    }

    pub(super) fn docs(&self) -> TokenStream {
        let Self { docs, fallback, .. } = self;
        if docs.is_empty() {
            quote!(#[doc = #fallback])
        } else {
            quote!(#(#[doc = #docs])*)
        }
    }
}

pub(super) fn point_fields(system: &System) -> Vec<Field> {
    let free = system.free.iter();
    let free = free.map(|p| Field::new(&p.named, format!(" Free point `{}`.", p.named.name)));
    let markers = system.markers.iter().map(|marker| {
        let [a, b, c] = &marker.frame;
        let fallback = format!(
            " Marker, carried by `{}`, `{}`, `{}`.",
            a.name, b.name, c.name
        );
        Field::new(&marker.named, fallback)
    });
    fixed_fields(system)
        .into_iter()
        .chain(free)
        .chain(markers)
        .collect()
}

pub(super) fn fixed_fields(system: &System) -> Vec<Field> {
    let fixed = system.fixed.iter();
    fixed
        .map(|p| Field::new(&p.named, format!(" Chassis point `{}`.", p.named.name)))
        .collect()
}

pub(super) fn drive_fields(system: &System) -> Vec<Field> {
    let drives = system.drives.iter();
    drives
        .map(|drive| Field::new(&drive.named, quantity::describe(&drive.quantity)))
        .collect()
}

pub(super) fn measure_fields(system: &System) -> Vec<Field> {
    let measures = system.measures.iter();
    measures
        .map(|measure| Field::new(&measure.named, quantity::describe(&measure.quantity)))
        .collect()
}

pub(super) fn length_fields(system: &System) -> Vec<Field> {
    let lengths = system.lengths().into_iter();
    lengths
        .map(|length| {
            let [a, b] = &length.between;
            Field::new(&length.named, format!(" From `{a}` to `{b}`."))
        })
        .collect()
}

/// The index of a point among all points.
pub(super) fn point_index(system: &System, name: &Name) -> Literal {
    index(system.points().into_iter(), name)
}

/// The index of a length.
pub(super) fn length_index(system: &System, name: &Name) -> Literal {
    index(
        system.lengths().iter().map(|length| &length.named.name),
        name,
    )
}

fn index<'a>(mut names: impl Iterator<Item = &'a Name>, name: &Name) -> Literal {
    let index = names.position(|other| other == name);
    Literal::usize_unsuffixed(index.unwrap_or_default())
}
