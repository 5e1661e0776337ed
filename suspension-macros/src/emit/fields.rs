//! The fields of the generated structs of names, with their docs.

use proc_macro2::{Literal, TokenStream};
use quote::quote;
use syn::{Attribute, Ident};

use suspension_listing::system::{
    AXES, Body, Drive, Equation, Measure, Measured, System, pair_name,
};

/// A field of a generated struct.
pub(super) struct Field {
    pub(super) docs: Vec<Attribute>,
    pub(super) name: Ident,
    /// Documents the field where the user did not.
    pub(super) fallback: String,
}

impl Field {
    pub(super) fn new(docs: &[Attribute], name: &Ident, fallback: String) -> Self {
        Self {
            docs: docs.to_vec(),
            name: name.clone(),
            fallback,
        }
    }

    pub(super) fn docs(&self) -> TokenStream {
        let Self { docs, fallback, .. } = self;
        if docs.is_empty() {
            quote!(#[doc = #fallback])
        } else {
            quote!(#(#docs)*)
        }
    }
}

pub(super) fn point_fields(system: &System) -> Vec<Field> {
    let free = system
        .free
        .iter()
        .map(|p| Field::new(&p.docs, &p.name, format!(" Free point `{}`.", p.name)));
    let markers = system.markers.iter().map(|marker| {
        let [a, b, c] = &marker.frame;
        let fallback = format!(
            " Marker, carried by `{}`, `{}`, `{}`.",
            a.name, b.name, c.name
        );
        Field::new(&marker.named.docs, &marker.named.name, fallback)
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
        .map(|p| Field::new(&p.docs, &p.name, format!(" Chassis point `{}`.", p.name)))
        .collect()
}

pub(super) fn drive_fields(system: &System) -> Vec<Field> {
    let field = |drive: &Drive| {
        let of = &drive.of.name;
        let fallback = match (&drive.minus, &drive.angle_of) {
            (Some(from), Some(_)) => angle_in_words([from, of], drive.axis),
            (minus, _) => coordinate_in_words(of, minus.as_ref(), drive.axis),
        };
        Field::new(&drive.named.docs, &drive.named.name, fallback)
    };
    system.drives.iter().map(field).collect()
}

pub(super) fn measure_fields(system: &System) -> Vec<Field> {
    let field = |Measure { named, measured }: &Measure| {
        let fallback = match measured {
            Measured::Coordinate { axis, of, minus } => {
                coordinate_in_words(of, minus.as_ref(), *axis)
            }
            Measured::Angle { axis, line } => angle_in_words(line.each_ref(), *axis),
            Measured::Length { line: [from, to] } => between(from, to),
        };
        Field::new(&named.docs, &named.name, fallback)
    };
    system.measures.iter().map(field).collect()
}

fn coordinate_in_words(of: &Ident, minus: Option<&Ident>, axis: usize) -> String {
    let axis = AXES[axis];
    let minus = minus.map_or(String::new(), |minus| format!(" - {minus}.{axis}"));
    format!(" `{of}.{axis}{minus}`.")
}

fn angle_in_words([from, to]: [&Ident; 2], axis: usize) -> String {
    let axis = AXES[axis];
    format!(" Angle of `{from} -> {to}` from the {axis} axis, radians.")
}

fn between(a: &Ident, b: &Ident) -> String {
    format!(" From `{a}` to `{b}`.")
}

/// The lengths of links, of bodies of two points, and of larger bodies: the frame's own, then
/// from each carried point to the frame.
pub(super) fn length_fields(system: &System) -> Vec<Field> {
    let mut fields = Vec::new();
    for equation in &system.equations {
        if let Equation::Distance {
            named, from, to, ..
        } = equation
            && !system
                .bodies
                .iter()
                .any(|body| frame_lengths(body).any(|name| name == named.name))
        {
            fields.push(Field::new(
                &named.docs,
                &named.name,
                between(&from.name, &to.name),
            ));
        }
    }
    for body in &system.bodies {
        for [a, b] in body
            .frame_pairs()
            .into_iter()
            .filter(|[a, b]| a.is_free() || b.is_free())
        {
            let name = pair_name(&body.name, &a.name, &b.name);
            fields.push(Field::new(&[], &name, between(&a.name, &b.name)));
        }
        for point in &body.carried {
            for of_frame in &body.frame {
                let name = pair_name(&body.name, &point.name, &of_frame.name);
                fields.push(Field::new(&[], &name, between(&point.name, &of_frame.name)));
            }
        }
    }
    fields
}

/// The index of a point among all.
pub(super) fn point_index(system: &System, name: &Ident) -> Literal {
    index(&point_fields(system), name)
}

/// The index of a length.
pub(super) fn length_index(system: &System, name: &Ident) -> Literal {
    index(&length_fields(system), name)
}

fn index(fields: &[Field], name: &Ident) -> Literal {
    let index = fields.iter().position(|field| field.name == *name);
    Literal::usize_unsuffixed(index.unwrap_or(fields.len()))
}

fn frame_lengths(body: &Body) -> impl Iterator<Item = Ident> {
    body.frame_pairs()
        .into_iter()
        .map(|[a, b]| pair_name(&body.name, &a.name, &b.name))
}
