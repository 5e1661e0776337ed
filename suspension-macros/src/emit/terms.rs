//! Terms common to the emitted methods: points, frames and carried points under their names.

use proc_macro2::{Literal, Spacing, Span, TokenStream, TokenTree};
use quote::{ToTokens, format_ident, quote};
use syn::Ident;

use super::indices;
use suspension_listing::name::Name;
use suspension_listing::system::{AXES, Site, System, coordinate_name};

pub(super) fn ident(name: &str) -> Ident {
    Ident::new(name, proc_macro2::Span::call_site())
}

/// A point's value, from the one of two structs to which it belongs.
pub(super) fn value_of(site: &Site, free: &Ident, fixed: &Ident) -> TokenStream {
    let name = &site.name;
    if site.is_free() {
        quote!(#free.#name)
    } else {
        quote!(#fixed.#name)
    }
}

/// `name = value`, which becomes a `let` if something reads it.
pub(super) struct Binding {
    name: Ident,
    value: TokenStream,
}

impl Binding {
    pub(super) fn new(name: &Name, value: TokenStream) -> Self {
        let name = name.at(Span::call_site());
        Self { name, value }
    }

    /// `name = Free::of(vector)`.
    pub(super) fn free(name: &Ident, vector: &str) -> Self {
        let (name, vector) = (name.clone(), ident(vector));
        let value = quote!(Free::of(#vector));
        Self { name, value }
    }
}

/// `result` after the bindings that it, or a later binding, reads.
pub(super) fn bind(bindings: Vec<Binding>, result: TokenStream) -> TokenStream {
    let bind = |rest: TokenStream, Binding { name, value }| {
        if mentions(&rest, &name) {
            quote!(let #name = #value; #rest)
        } else {
            rest
        }
    };
    bindings.into_iter().rev().fold(result, bind)
}

/// `name: kind`, or `_name: kind` if the body does not read it.
pub(super) fn parameter(name: &str, kind: &TokenStream, body: &TokenStream) -> TokenStream {
    let read = ident(name);
    if mentions(body, &read) {
        quote!(#read: #kind)
    } else {
        let unread = format_ident!("_{name}");
        quote!(#unread: #kind)
    }
}

/// The parameters `q` and `fixed`.
pub(super) fn position_parameters(system: &System, body: &TokenStream) -> [TokenStream; 2] {
    let n = Literal::usize_unsuffixed(system.size());
    [
        parameter("q", &quote!(&SVector<T, #n>), body),
        parameter("fixed", &quote!(&Fixed<T>), body),
    ]
}

/// Whether the tokens read the variable `name`, which does not include a field after a dot or before a colon.
fn mentions(tokens: &TokenStream, name: &Ident) -> bool {
    let tokens: Vec<TokenTree> = tokens.clone().into_iter().collect();
    let is_dot = |token: &TokenTree| matches!(token, TokenTree::Punct(p) if p.as_char() == '.');
    let is_colon = |token: &TokenTree| matches!(token, TokenTree::Punct(p) if p.as_char() == ':' && p.spacing() == Spacing::Alone);
    tokens.iter().enumerate().any(|(index, token)| match token {
        TokenTree::Group(group) => mentions(&group.stream(), name),
        TokenTree::Ident(ident) => {
            let is_field = index > 0 && is_dot(&tokens[index - 1])
                || tokens.get(index + 1).is_some_and(is_colon);
            ident == name && !is_field
        }
        _ => false,
    })
}

/// `rows[equation::NAME] = term;`
pub(super) fn assign(row: &Name, term: &TokenStream) -> TokenStream {
    let row = indices::equation(row);
    quote!(rows[#row] = #term;)
}

/// The same for the three rows of a vector equation.
pub(super) fn assign_vector(name: &Name, vector: &impl ToTokens) -> TokenStream {
    let entries = (0..3).map(|axis| {
        let row = coordinate_name(name, axis);
        let axis = ident(AXES[axis]);
        assign(&row, &quote!(term.#axis))
    });
    quote!(let term = #vector; #(#entries)*)
}

/// The vector from one point to another, from two structs of points.
pub(super) fn line(ends: [&Site; 2], free: &str, fixed: &str) -> TokenStream {
    let (free, fixed) = (ident(free), ident(fixed));
    let [from, to] = ends.map(|site| value_of(site, &free, &fixed));
    quote!(difference(#to, #from))
}

/// A vector whose rows are zero except those that are set, after the variables that it reads. The zeros are negative:
/// a compiler that keeps to the rules of arithmetic leaves out the addition of a negative zero, but not of a positive
/// one.
pub(super) fn vector(
    system: &System,
    bindings: impl IntoIterator<Item = Binding>,
    rows: impl Iterator<Item = TokenStream>,
) -> TokenStream {
    let n = Literal::usize_unsuffixed(system.size());
    let rows = TokenStream::from_iter(rows);
    let vector = if rows.is_empty() {
        quote!(SVector::zeros())
    } else {
        quote! {
            let mut rows = [-T::zero(); #n];
            #rows
            SVector::from(rows)
        }
    };
    bind(Vec::from_iter(bindings), vector)
}
