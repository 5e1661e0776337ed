//! Names for the rows and columns of the Jacobian.

use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};
use syn::Ident;
use syn::ext::IdentExt;

use suspension_listing::system::{AXES, System};

pub(super) fn modules(system: &System) -> TokenStream {
    let equations = constants(&system.rows());
    let unknowns: Vec<Ident> = system
        .free
        .iter()
        .flat_map(|point| unknown_names(&point.name))
        .collect();
    let unknowns = constants(&unknowns);
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

/// Names of the three coordinates of a point.
pub(super) fn unknown_names(point: &Ident) -> [Ident; 3] {
    AXES.map(|axis| format_ident!("{}_{axis}", point))
}

fn constants(names: &[Ident]) -> TokenStream {
    let mut seen = std::collections::BTreeSet::new();
    let distinct = names.iter().filter(|name| seen.insert(upper(name)));
    let constants = distinct.enumerate().map(|(index, name)| {
        let (name, index) = (upper(name), Literal::usize_unsuffixed(index));
        quote!(pub const #name: usize = #index;)
    });
    quote!(#(#constants)*)
}

fn upper(name: &Ident) -> Ident {
    Ident::new(
        &name.unraw().to_string().to_uppercase(),
        proc_macro2::Span::call_site(),
    )
}

/// `equation::NAME`.
pub(super) fn equation(row: &Ident) -> TokenStream {
    let name = upper(row);
    quote!(equation::#name)
}

/// `unknown::NAME`.
pub(super) fn unknown(column: &Ident) -> TokenStream {
    let name = upper(column);
    quote!(unknown::#name)
}
