//! `#[derive(Named)]`: a struct whose fields are values of one type, by name and in order.

use proc_macro2::TokenStream;
use quote::quote;
use syn::ext::IdentExt;
use syn::{Data, DeriveInput, Error, Field, Ident, Type};

/// Implements `Values`, `Named` and `Default` for a struct that `linkage!` has written, for example `Points<T>`. A
/// struct without names has a field that is an array of no values.
pub(crate) fn named(input: TokenStream) -> syn::Result<TokenStream> {
    let DeriveInput { ident, data, .. } = syn::parse2(input)?;
    let Data::Struct(data) = data else {
        return Err(Error::new(ident.span(), "a struct is expected"));
    };
    let fields: Vec<&Field> = data.fields.iter().collect();
    let (value, fields) = match fields.as_slice() {
        [
            Field {
                ty: Type::Array(none),
                ..
            },
        ] => (&*none.elem, [].as_slice()),
        [first, ..] => (&first.ty, fields.as_slice()),
        [] => return Err(Error::new(ident.span(), "a field is expected")),
    };
    let names: Vec<&Ident> = fields
        .iter()
        .filter_map(|field| field.ident.as_ref())
        .collect();
    let strings = names.iter().map(|name| name.unraw().to_string());
    let strings: Vec<String> = strings.collect();
    let none = fields.is_empty().then(|| quote!(no_names: []));
    Ok(quote! {
        #[allow(unused_mut, unused_variables)]
        impl<T: Scalar> Values<#value> for #ident<T> {
            #[inline(always)]
            fn from_values(values: impl IntoIterator<Item = #value>) -> Self {
                let mut values = values.into_iter();
                Self::from_fn(|_| values.next().unwrap_or_default())
            }

            #[inline(always)]
            fn values(&self) -> impl Iterator<Item = #value> {
                [#(self.#names),*].into_iter()
            }
        }

        #[allow(unused_mut, unused_variables)]
        impl<T: Scalar> Named<#value> for #ident<T> {
            const NAMES: &'static [&'static str] = &[#(#strings),*];

            #[inline(always)]
            fn from_fn(mut value: impl FnMut(&'static str) -> #value) -> Self {
                Self { #(#names: value(#strings),)* #none }
            }
        }

        impl<T: Scalar> Default for #ident<T> {
            #[inline(always)]
            fn default() -> Self {
                Self { #(#names: Default::default(),)* #none }
            }
        }
    })
}
