//! The unrolled Jacobian: each equation writes its non-zero entries under their names.

use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};
use syn::Ident;

use super::indices;
use super::terms::{Binding, bind, frames, ident, parameter, vector};
use crate::system::{Equation, Site, System, carried_name, frame_name};

pub(super) fn jacobian(system: &System) -> TokenStream {
    let n = Literal::usize_unsuffixed(system.size());
    let (free, fixed) = (&ident("free"), &ident("fixed"));
    let entries = system.equations.iter().map(entries);
    let result = quote! {
        let mut columns = [[T::zero(); #n]; #n];
        #(#entries)*
        from_columns(columns)
    };
    let bindings = [Binding::free(free, "q")]
        .into_iter()
        .chain(frames(system, "", free, fixed));
    let body = bind(bindings.collect(), result);
    let q = parameter("q", &quote!(&SVector<T, #n>), &body);
    let fixed = parameter("fixed", &quote!(&Fixed<T>), &body);
    quote! {
        #[inline(always)]
        fn jacobian(&self, #q, #fixed) -> SMatrix<T, #n, #n> {
            #body
        }
    }
}

fn entries(equation: &Equation) -> TokenStream {
    let rows: Vec<TokenStream> = equation.rows().iter().map(indices::equation).collect();
    match equation {
        Equation::Distance {
            named, from, to, ..
        } => {
            let vector = vector(from, to, &ident("free"), &ident("fixed"));
            let name = &named.name;
            let to = gradient_entries(to, &rows[0], &quote!());
            let from = gradient_entries(from, &rows[0], &quote!(-));
            quote! {
                let gradient = self.#name.gradient(#vector);
                #to
                #from
            }
        }
        Equation::Carried { body, point, frame } => {
            let (name, frame_of) = (carried_name(body, &point.name), frame_name(body));
            let identity = identity_entries(point, &rows);
            let blocks = ["origin", "second", "third"].into_iter().zip(frame);
            let blocks = blocks.map(|(block, site)| block_entries(site, &rows, &ident(block)));
            quote! {
                let gradient = self.#name.gradient(&#frame_of);
                #identity
                #(#blocks)*
            }
        }
        Equation::Coordinate {
            axis, of, minus, ..
        } => {
            let row = &rows[0];
            let entry = |site: &Site, value: TokenStream| {
                let column = &indices::unknowns(&site.name)[*axis];
                site.is_free()
                    .then(|| quote!(columns[#column][#row] = #value;))
            };
            let of = entry(of, quote!(T::one()));
            let minus = minus
                .as_ref()
                .and_then(|minus| entry(minus, quote!(-T::one())));
            quote!(#of #minus)
        }
    }
}

fn gradient_entries(site: &Site, row: &TokenStream, sign: &TokenStream) -> Option<TokenStream> {
    let [x, y, z] = indices::unknowns(&site.name);
    site.is_free().then(|| {
        quote! {
            columns[#x][#row] = #sign gradient.x;
            columns[#y][#row] = #sign gradient.y;
            columns[#z][#row] = #sign gradient.z;
        }
    })
}

fn identity_entries(site: &Site, rows: &[TokenStream]) -> TokenStream {
    let columns = indices::unknowns(&site.name);
    quote!(#(columns[#columns][#rows] = T::one();)*)
}

fn block_entries(site: &Site, rows: &[TokenStream], block: &Ident) -> Option<TokenStream> {
    if !site.is_free() {
        return None;
    }
    let mut entries = TokenStream::new();
    for (i, row) in (1..).zip(rows) {
        for (j, column) in (1..).zip(indices::unknowns(&site.name)) {
            let entry = format_ident!("m{i}{j}");
            entries.extend(quote!(columns[#column][#row] = gradient.#block.#entry;));
        }
    }
    Some(entries)
}
