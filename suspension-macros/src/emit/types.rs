//! Named structs: points, drives, lengths, and the model.

use proc_macro2::TokenStream;
use quote::quote;
use syn::ext::IdentExt;
use syn::{Attribute, Ident};

use crate::system::{AXES, Body, Equation, System, carried_name, frame_name, pair_name};

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

    fn docs(&self) -> TokenStream {
        let Self { docs, fallback, .. } = self;
        if docs.is_empty() {
            quote!(#[doc = #fallback])
        } else {
            quote!(#(#docs)*)
        }
    }
}

pub(super) fn all(system: &System) -> TokenStream {
    let points = named(
        "Points",
        " Every point, with a position, velocity or acceleration each.",
        &quote!(Vector3<T>),
        &point_fields(system),
    );
    let fixed = named(
        "Fixed",
        " Chassis points.",
        &quote!(Vector3<T>),
        &fixed_fields(system),
    );
    let drives = named(
        "Drives",
        " The drives' values, or rates: coordinates in the unit of the points, angles in radians.",
        &quote!(T),
        &drive_fields(system),
    );
    let lengths = named(
        "Lengths",
        " The constant lengths of links and bodies.",
        &quote!(T),
        &length_fields(system),
    );
    let free = free(system);
    let model = model(system);
    quote!(#points #fixed #drives #lengths #free #model)
}

/// A struct with one value for each name.
pub(super) fn named(name: &str, doc: &str, value: &TokenStream, fields: &[Field]) -> TokenStream {
    let name = Ident::new(name, proc_macro2::Span::call_site());
    let docs = fields.iter().map(Field::docs);
    let names: Vec<&Ident> = fields.iter().map(|field| &field.name).collect();
    let strings: Vec<String> = names.iter().map(|name| name.unraw().to_string()).collect();
    let none = fields
        .is_empty()
        .then(|| quote!(no_fields: ::core::marker::PhantomData<T>));
    let no_value = none
        .is_some()
        .then(|| quote!(no_fields: ::core::marker::PhantomData));
    let from = if fields.is_empty() {
        quote!(_value)
    } else {
        quote!(mut value)
    };
    quote! {
        #[doc = #doc]
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct #name<T> {
            #(#docs pub #names: #value,)*
            #none
        }

        impl<T: Scalar> Named<#value> for #name<T> {
            const NAMES: &'static [&'static str] = &[#(#strings),*];

            fn from_fn(#from: impl FnMut(&'static str) -> #value) -> Self {
                Self { #(#names: value(#strings),)* #no_value }
            }

            fn values(&self) -> impl Iterator<Item = #value> {
                [#(self.#names),*].into_iter()
            }
        }

        impl<T: Scalar> Default for #name<T> {
            fn default() -> Self {
                Self::from_fn(|_| Default::default())
            }
        }
    }
}

fn point_fields(system: &System) -> Vec<Field> {
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

fn fixed_fields(system: &System) -> Vec<Field> {
    let fixed = system.fixed.iter();
    fixed
        .map(|p| Field::new(&p.docs, &p.name, format!(" Chassis point `{}`.", p.name)))
        .collect()
}

fn drive_fields(system: &System) -> Vec<Field> {
    let field = |drive: &crate::system::Drive| {
        let axis = AXES[drive.axis];
        let of = &drive.of.name;
        let fallback = match (&drive.minus, &drive.angle_of) {
            (Some(from), Some(_)) => {
                format!(" Angle of `{from} -> {of}` from the {axis} axis, radians.")
            }
            (Some(minus), None) => format!(" `{of}.{axis} - {minus}.{axis}`."),
            (None, _) => format!(" `{of}.{axis}`."),
        };
        Field::new(&drive.named.docs, &drive.named.name, fallback)
    };
    system.drives.iter().map(field).collect()
}

/// The lengths of links, of bodies of two points, and of larger bodies: the frame's own, then
/// from each carried point to the frame.
pub(super) fn length_fields(system: &System) -> Vec<Field> {
    let between = |a: &Ident, b: &Ident| format!(" From `{a}` to `{b}`.");
    let mut fields = Vec::new();
    for equation in &system.equations {
        if let Equation::Distance {
            named, from, to, ..
        } = equation
            && !system
                .bodies
                .iter()
                .any(|body| body.frame_lengths().any(|name| name == named.name))
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

impl Body {
    fn frame_lengths(&self) -> impl Iterator<Item = Ident> {
        self.frame_pairs()
            .into_iter()
            .map(|[a, b]| pair_name(&self.name, &a.name, &b.name))
    }
}

/// The free points under their names, from and to the vector of unknowns.
fn free(system: &System) -> TokenStream {
    let n = proc_macro2::Literal::usize_unsuffixed(system.size());
    let names: Vec<&Ident> = system.free.iter().map(|point| &point.name).collect();
    let coordinate = |axis: &'static str| {
        names
            .iter()
            .map(move |name| quote::format_ident!("{}_{axis}", name))
            .collect::<Vec<_>>()
    };
    let [x, y, z] = AXES.map(coordinate);
    quote! {
        /// The free points: the unknowns under their names.
        #[derive(Clone, Copy, Debug, PartialEq)]
        struct Free<T> {
            #(#names: Vector3<T>,)*
        }

        impl<T: Scalar> Free<T> {
            #[inline(always)]
            fn of(q: &SVector<T, #n>) -> Self {
                let [[#(#x, #y, #z),*]] = q.data.0;
                Self { #(#names: Vector3::new(#x, #y, #z)),* }
            }

            #[inline(always)]
            fn unknowns(&self) -> SVector<T, #n> {
                let Self { #(#names),* } = self;
                SVector::from([#(#names.x, #names.y, #names.z),*])
            }
        }
    }
}

/// Names and types of the model's constants: one for each length and each carried point.
fn model(system: &System) -> TokenStream {
    let links = system
        .equations
        .iter()
        .filter_map(|equation| match equation {
            Equation::Distance { named, .. } => Some(&named.name),
            _ => None,
        });
    let frames: Vec<Ident> = system
        .bodies
        .iter()
        .map(|body| frame_name(&body.name))
        .collect();
    let bodies = system.bodies.iter();
    let carried = bodies.flat_map(|b| {
        b.carried
            .iter()
            .map(|point| carried_name(&b.name, &point.name))
    });
    let markers = system.markers.iter().map(|marker| &marker.named.name);
    quote! {
        /// The geometry: chassis points at rest and the constants of every equation.
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct Model<T> {
            fixed: Fixed<T>,
            size: T,
            #(#links: Distance<T>,)*
            #(#frames: Frame<T>,)*
            #(#carried: Carried<T>,)*
            #(#markers: Carried<T>,)*
        }
    }
}
