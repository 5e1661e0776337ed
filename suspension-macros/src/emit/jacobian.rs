//! The unrolled Jacobian: each equation gives its non-zero entries under their names.

use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};
use syn::Ident;

use super::terms::{Binding, bind, frames, ident, parameter, vector};
use super::{indices, written_out};
use suspension_listing::system::{AXES, Equation, Site, System, carried_name, frame_name};

/// Writes an entry: its row, its column, its value.
type Write<'a> = dyn Fn(&Ident, &Ident, TokenStream) -> TokenStream + 'a;

pub(super) fn jacobian(system: &System) -> TokenStream {
    let n = Literal::usize_unsuffixed(system.size());
    let entries = entries(system, &|row, column, value| {
        let (row, column) = (indices::equation(row), indices::unknown(column));
        quote!(columns[#column][#row] = #value;)
    });
    let body = with_points(
        system,
        quote! {
            let mut columns = [[T::zero(); #n]; #n];
            #entries
            from_columns(columns)
        },
    );
    let [q, fixed] = parameters(system, &body);
    written_out(&quote! {
        fn jacobian(&self, #q, #fixed) -> SMatrix<T, #n, #n> {
            #body
        }
    })
}

/// `q` and `fixed`.
pub(super) fn parameters(system: &System, body: &TokenStream) -> [TokenStream; 2] {
    let n = Literal::usize_unsuffixed(system.size());
    [
        parameter("q", &quote!(&SVector<T, #n>), body),
        parameter("fixed", &quote!(&Fixed<T>), body),
    ]
}

/// `body` behind the free points and frames that it reads.
pub(super) fn with_points(system: &System, body: TokenStream) -> TokenStream {
    let (free, fixed) = (&ident("free"), &ident("fixed"));
    let bindings = [Binding::free(free, "q")]
        .into_iter()
        .chain(frames(system, "", free, fixed));
    bind(bindings.collect(), body)
}

/// All entries that are not always zero, each passed through `write`.
pub(super) fn entries(system: &System, write: &Write<'_>) -> TokenStream {
    let of_equations = system
        .equations
        .iter()
        .map(|equation| of_equation(equation, write));
    quote!(#(#of_equations)*)
}

fn of_equation(equation: &Equation, write: &Write<'_>) -> TokenStream {
    let rows = equation.rows();
    match equation {
        Equation::Distance {
            named, from, to, ..
        } => {
            let vector = vector(from, to, &ident("free"), &ident("fixed"));
            let name = &named.name;
            let to = of_gradient(to, &rows[0], &quote!(), write);
            let from = of_gradient(from, &rows[0], &quote!(-), write);
            quote! {
                let gradient = self.#name.gradient(#vector);
                #to
                #from
            }
        }
        Equation::Carried { body, point, frame } => {
            let (name, frame_of) = (carried_name(body, &point.name), frame_name(body));
            let columns = indices::unknown_names(&point.name);
            let identity = rows.iter().zip(&columns);
            let identity = identity.map(|(row, column)| write(row, column, quote!(T::one())));
            let blocks = ["origin", "second", "third"].into_iter().zip(frame);
            let blocks = blocks.map(|(block, site)| of_block(site, &rows, &ident(block), write));
            let entries = quote!(#(#identity)* #(#blocks)*);
            let gradient = (!entries.is_empty())
                .then(|| quote!(let gradient = self.#name.gradient(&#frame_of);));
            quote!(#gradient #entries)
        }
        Equation::Coordinate {
            axis, of, minus, ..
        } => {
            let entry = |site: &Site, value: TokenStream| {
                let column = &indices::unknown_names(&site.name)[*axis];
                site.is_free().then(|| write(&rows[0], column, value))
            };
            let of = entry(of, quote!(T::one()));
            let minus = minus
                .as_ref()
                .and_then(|minus| entry(minus, quote!(-T::one())));
            quote!(#of #minus)
        }
    }
}

fn of_gradient(site: &Site, row: &Ident, sign: &TokenStream, write: &Write<'_>) -> TokenStream {
    let columns = indices::unknown_names(&site.name);
    let free = columns.iter().zip(AXES).filter(|_| site.is_free());
    let entries = free.map(|(column, axis)| {
        let axis = ident(axis);
        write(row, column, quote!(#sign gradient.#axis))
    });
    quote!(#(#entries)*)
}

fn of_block(site: &Site, rows: &[Ident], block: &Ident, write: &Write<'_>) -> TokenStream {
    if !site.is_free() {
        return TokenStream::new();
    }
    let mut entries = TokenStream::new();
    for (i, row) in (1..).zip(rows) {
        for (j, column) in (1..).zip(&indices::unknown_names(&site.name)) {
            let entry = format_ident!("m{i}{j}");
            entries.extend(write(row, column, quote!(gradient.#block.#entry)));
        }
    }
    entries
}
