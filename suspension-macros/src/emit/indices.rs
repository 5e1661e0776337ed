//! Names for the rows and columns of the Jacobian.

use proc_macro2::{Literal, TokenStream};
use quote::quote;
use syn::Ident;

use suspension_listing::name::Name;
use suspension_listing::system::{System, coordinate_name};

pub(super) fn modules(system: &System) -> TokenStream {
    let equations = constants(&system.rows());
    let unknowns = constants(&unknowns(system));
    quote! {
        /// Rows of the residual and the Jacobian.
        #[allow(missing_docs)]
        pub mod equation {
            #equations
        }

        /// Entries of `q`, columns of the Jacobian.
        #[allow(missing_docs)]
        pub mod unknown {
            #unknowns
        }
    }
}

/// The names of the three coordinates of a point.
pub(super) fn unknown_names(point: &Name) -> [Name; 3] {
    [0, 1, 2].map(|axis| coordinate_name(point, axis))
}

/// The names of the unknowns.
pub(super) fn unknowns(system: &System) -> Vec<Name> {
    let free = system.free.iter();
    free.flat_map(|point| unknown_names(&point.named.name))
        .chain(system.scalars.iter().cloned())
        .collect()
}

fn constants(names: &[Name]) -> TokenStream {
    let mut seen = std::collections::BTreeSet::new();
    let distinct = names.iter().filter(|name| seen.insert(upper(name)));
    let constants = distinct.enumerate().map(|(index, name)| {
        let (name, index) = (upper(name), Literal::usize_unsuffixed(index));
        quote!(pub const #name: usize = #index;)
    });
    quote!(#(#constants)*)
}

fn upper(name: &Name) -> Ident {
    Ident::new(
        &name.as_str().to_uppercase(),
        proc_macro2::Span::call_site(),
    )
}

/// `equation::NAME`.
pub(super) fn equation(row: &Name) -> TokenStream {
    let name = upper(row);
    quote!(equation::#name)
}

/// `unknown::NAME`.
pub(super) fn unknown(column: &Name) -> TokenStream {
    let name = upper(column);
    quote!(unknown::#name)
}
