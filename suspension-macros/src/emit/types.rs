//! Named structs: points, drives, lengths, and the model.

use proc_macro2::{Literal, TokenStream};
use quote::quote;
use syn::Ident;

use super::fields::{
    Field, drive_fields, fixed_fields, length_fields, measure_fields, point_fields,
};
use super::short::ShortNames;
use super::{clusters, form, frames, readout};
use crate::module::Module;
use suspension_listing::name::Name;
use suspension_listing::system::{System, frame_name};

pub(super) fn types(module: &Module, system: &System) -> TokenStream {
    let points = named(
        "Points",
        " Every point, with a position, velocity or acceleration each.",
        &quote!(Vector3<T>),
        module,
        &point_fields(system),
    );
    let fixed = named(
        "Fixed",
        " Chassis points.",
        &quote!(Vector3<T>),
        module,
        &fixed_fields(system),
    );
    let drives = named(
        "Drives",
        " The drives' values, or rates: coordinates in the unit of the points, angles in radians.",
        &quote!(T),
        module,
        &drive_fields(system),
    );
    let measures = named(
        "Measures",
        " What is measured, or its rates: coordinates and lengths in the unit of the points, angles \
         in radians.",
        &quote!(T),
        module,
        &measure_fields(system),
    );
    let lengths = named(
        "Lengths",
        " The constant lengths of links and bodies.",
        &quote!(T),
        module,
        &length_fields(system),
    );
    let points_impl = readout::points_impl(system);
    let free = free(system);
    let model = model(system);
    let corner = corner(system);
    quote!(#points #fixed #drives #measures #lengths #points_impl #free #model #corner)
}

/// The model with its motion and drives.
pub(super) fn corner(system: &System) -> TokenStream {
    let n = Literal::usize_unsuffixed(system.size());
    quote! {
        /// A suspension of this listing that moves.
        pub type Corner<T = f64> = corner::Corner<Model<T>, #n>;
    }
}

/// A struct with one value for each name, which an editor finds in the listing.
pub(super) fn named(
    name: &str,
    doc: &str,
    value: &TokenStream,
    module: &Module,
    fields: &[Field],
) -> TokenStream {
    let name = Ident::new(name, proc_macro2::Span::call_site());
    let docs = fields.iter().map(Field::docs);
    let declared = |field: &Field| field.name.at(module.place_of(&field.name));
    let names = fields.iter().map(declared);
    let none = fields.is_empty().then(|| quote!(no_names: [#value; 0]));
    quote! {
        #[doc = #doc]
        #[derive(Clone, Copy, Debug, PartialEq, Named)]
        pub struct #name<T = f64> {
            #(#docs pub #names: #value,)*
            #none
        }
    }
}

/// The free points under their names, with conversions from and to the vector of unknowns.
fn free(system: &System) -> TokenStream {
    let n = proc_macro2::Literal::usize_unsuffixed(system.size());
    let names: Vec<&Name> = system.free.iter().map(|point| &point.named.name).collect();
    let frames = frames::methods_of_free(system);
    let columns = ShortNames::new(system).columns;
    let points = names.iter().zip(columns.chunks(3));
    let points = points.map(|(name, coordinates)| quote!(#name: Vector3::new(#(#coordinates),*)));
    let short = columns.iter().skip(3 * names.len());
    let scalars = &system.scalars;
    quote! {
        /// The free points: the unknowns under their names.
        #[derive(Clone, Copy)]
        struct Free<T> {
            #(#names: Vector3<T>,)*
            #(#scalars: T,)*
        }

        impl<T: Scalar> Free<T> {
            #[inline(always)]
            fn of(q: &SVector<T, #n>) -> Self {
                let [[#(#columns),*]] = q.data.0;
                Self { #(#points),* #(, #scalars: #short)* }
            }

            #[inline(always)]
            fn unknowns(&self) -> SVector<T, #n> {
                vector_of![#(self.#names.x, self.#names.y, self.#names.z),* #(, self.#scalars)*]
            }

            #frames
        }
    }
}

fn model(system: &System) -> TokenStream {
    let (names, kinds): (Vec<Name>, Vec<TokenStream>) = constants(system).unzip();
    quote! {
        /// The geometry: chassis points at rest and the constants of every equation.
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct Model<T = f64> {
            fixed: Fixed<T>,
            size: T,
            #(#names: #kinds<T>,)*
        }
    }
}

/// The names and types of the model's constants: one for each length and for each carried or clustered point.
pub(super) fn constants(system: &System) -> impl Iterator<Item = (Name, TokenStream)> {
    let [stated, framed] = [false, true].map(|framed| {
        let constants = form::constants(system, framed);
        constants.map(|constant| (constant.name.clone(), constant.kind))
    });
    let frames = system.bodies.iter().map(|body| frame_name(&body.name));
    let frames = frames.map(|name| (name, quote!(Frame)));
    let markers = system.markers.iter();
    let markers = markers.map(|marker| (marker.named.name.clone(), quote!(Carried)));
    let clusters = clusters::constants(system);
    stated
        .chain(frames)
        .chain(framed)
        .chain(markers)
        .chain(clusters)
}
