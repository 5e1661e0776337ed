//! The entries of the Jacobian that its factors are made of, each as a variable.

use proc_macro2::TokenStream;
use quote::quote;

use super::form::gradients;
use super::gradient::{By, Gradient};
use super::unrolled::Unrolled;
use suspension_listing::system::Site;

pub(super) fn entries(unrolled: &Unrolled<'_>) -> TokenStream {
    let equations = gradients(unrolled.system).map(|(row, _, Gradient { statements, by })| {
        let entries: TokenStream = by
            .iter()
            .map(|by| entries_by_unknowns(unrolled, row, by))
            .collect();
        (!entries.is_empty()).then(|| quote!(#statements #entries))
    });
    quote!(#(#equations)*)
}

/// The derivatives of one row, or of three, with respect to a point or a scalar.
fn entries_by_unknowns(unrolled: &Unrolled<'_>, row: usize, by: &By<'_>) -> TokenStream {
    let column = |site: &Site| site.first_column().unwrap_or_default();
    let scalar = |name| unrolled.system.scalar_column(name).unwrap_or_default();
    match by {
        By::Point(site, value) => {
            let places = [0, 1, 2].map(|axis| (row, column(site) + axis));
            unpacked(unrolled, places, &quote!(xyz(#value)))
        }
        By::Coordinate(site, axis, value) => variable(unrolled, (row, column(site) + axis), value),
        By::Scalar(name, value) => variable(unrolled, (row, scalar(name)), value),
        By::PointOfThree(site, value) => {
            let of_column = |axis| {
                let places = [0, 1, 2].map(|i| (row + i, column(site) + axis));
                unpacked(unrolled, places, &quote!(#value.data.0[#axis]))
            };
            (0..3).map(of_column).collect()
        }
        By::Diagonal(site, value) => {
            let on_axis = |axis| variable(unrolled, (row + axis, column(site) + axis), value);
            (0..3).map(on_axis).collect()
        }
        By::ScalarOfThree(name, value) => {
            let places = [0, 1, 2].map(|i| (row + i, scalar(name)));
            unpacked(unrolled, places, &quote!(xyz(#value)))
        }
    }
}

fn variable(
    unrolled: &Unrolled<'_>,
    (row, column): (usize, usize),
    value: &TokenStream,
) -> TokenStream {
    let entry = unrolled.entry(row, column);
    let is_stored = unrolled.is_stored(row, column);
    let variable = is_stored.then(|| quote!(let #entry = #value;));
    quote!(#variable)
}

/// Three entries from an array.
fn unpacked(
    unrolled: &Unrolled<'_>,
    places: [(usize, usize); 3],
    array: &TokenStream,
) -> TokenStream {
    let entries = places.map(|(row, column)| {
        let stored = unrolled.is_stored(row, column);
        stored.then(|| unrolled.entry(row, column))
    });
    if entries.iter().all(Option::is_none) {
        return TokenStream::new();
    }
    let entries = entries.map(|entry| entry.map_or(quote!(_), |entry| quote!(#entry)));
    quote!(let [#(#entries),*] = #array;)
}
