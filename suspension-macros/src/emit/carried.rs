//! Carried points in the elimination. Each is where its frame carries it, so that its rows express it by
//! the frame's points in closed form: a few cross products, instead of rows of nine entries that
//! would be stored and loaded again in every solution.

use std::collections::BTreeSet;

use proc_macro2::TokenStream;
use quote::{ToTokens, quote};

use super::terms::ident;
use super::unrolled::Unrolled;
use suspension_listing::name::Name;
use suspension_listing::system::{AXES, Substituted, System, carried_name, frame_name};

/// A substituted point in the generated code.
pub(super) trait Emitted {
    /// Its constants under their name.
    fn constants(&self) -> Name;

    /// Its frame under its name.
    fn frame_name(&self) -> Name;
}

impl Emitted for Substituted<'_> {
    fn constants(&self) -> Name {
        carried_name(self.body, self.point)
    }

    fn frame_name(&self) -> Name {
        frame_name(self.body)
    }
}

/// One frame a body.
pub(super) fn frames(substituted: &[Substituted<'_>]) -> Vec<Name> {
    let mut names: Vec<Name> = substituted.iter().map(Emitted::frame_name).collect();
    names.dedup();
    names
}

/// Fields of the factors.
pub(super) fn fields(system: &System) -> TokenStream {
    let substituted = system.substituted();
    let constants = substituted.iter().map(Emitted::constants);
    let frames = frames(&substituted);
    quote!(#(#frames: Frame<T>,)* #(#constants: Carried<T>,)*)
}

/// Their values.
pub(super) fn values(system: &System) -> TokenStream {
    let substituted = system.substituted();
    let constants: Vec<Name> = substituted.iter().map(Emitted::constants).collect();
    let frames = frames(&substituted);
    quote!(#(#frames,)* #(#constants: self.#constants,)*)
}

/// Rows that depend on carried points depend on their frames instead.
pub(super) fn reduce(unrolled: &Unrolled<'_>, filled: &mut Vec<(usize, usize)>) -> TokenStream {
    let mut statements = TokenStream::new();
    for point in unrolled.system.substituted() {
        let (constants, frame) = (point.constants(), point.frame_name());
        for row in point.rows(unrolled.order) {
            let gradient = point.steps(unrolled.order).map(|step| {
                if step.below.contains(&row) {
                    unrolled.entry(row, step.column).into_token_stream()
                } else {
                    quote!(T::zero())
                }
            });
            let (names, entries) = by_frame(point.frame, |column, value| {
                let entry = unrolled.entry(row, column);
                if unrolled.fills(row, column, filled) {
                    quote!(let #entry = #value;)
                } else {
                    quote!(let #entry = #entry + #value;)
                }
            });
            statements.extend(quote! {
                let #names = self.#constants.by_frame(Vector3::new(#(#gradient),*), &#frame);
                #entries
            });
        }
    }
    statements
}

/// The pattern for what `by_frame` gives, and what is made of each column's number.
fn by_frame(
    frame: [Option<usize>; 3],
    mut write: impl FnMut(usize, TokenStream) -> TokenStream,
) -> (TokenStream, TokenStream) {
    let (mut names, mut entries) = (Vec::new(), TokenStream::new());
    for (name, column) in ["origin", "second", "third"].into_iter().zip(frame) {
        let Some(column) = column else {
            names.push(quote!(_));
            continue;
        };
        let name = ident(name);
        for (axis, component) in AXES.map(ident).iter().enumerate() {
            entries.extend(write(column + axis, quote!(#name.#component)));
        }
        names.push(quote!(#name));
    }
    (quote!([#(#names),*]), entries)
}

/// The carried points' unknowns, once those of their frames are found. Only the rows of `live` are
/// not zero.
pub(super) fn substituted(unrolled: &Unrolled<'_>, live: &BTreeSet<usize>) -> TokenStream {
    let mut statements = TokenStream::new();
    let mut last_frame = None;
    for point in unrolled.system.substituted() {
        let (constants, frame) = (point.constants(), point.frame_name());
        if last_frame.as_ref() != Some(&frame) {
            let changes = point.frame.map(|column| change(unrolled, column));
            statements.extend(quote!(let #frame = Frame::new(#(#changes),*);));
        }
        let unknowns = AXES
            .iter()
            .zip(point.steps(unrolled.order))
            .map(|(axis, step)| {
                let (axis, unknown) = (ident(axis), unrolled.column(step.column));
                let row = unrolled.row(step.row);
                let row = live.contains(&step.row).then(|| quote!(rows[#row] +));
                quote!(unknowns[#unknown] = #row carried.#axis;)
            });
        statements.extend(quote! {
            let carried = self.#constants.velocity(&self.#frame, &#frame);
            #(#unknowns)*
        });
        last_frame = Some(frame);
    }
    statements
}

/// A point's unknowns by the column of the first; zero where it is on the chassis.
fn change(unrolled: &Unrolled<'_>, column: Option<usize>) -> TokenStream {
    let axes = [0, 1, 2].map(|axis| match column {
        Some(first) => {
            let unknown = unrolled.column(first + axis);
            quote!(unknowns[#unknown])
        }
        None => quote!(T::zero()),
    });
    quote!(Vector3::new(#(#axes),*))
}

/// What the carried points' unknowns add to those of their frames in a transposed solution.
pub(super) fn transposed(unrolled: &Unrolled<'_>) -> TokenStream {
    let of_point = |point: Substituted<'_>| {
        let (constants, frame) = (point.constants(), point.frame_name());
        let gradient = change(unrolled, Some(point.column));
        let (names, sums) = by_frame(point.frame, |column, value| {
            let unknown = unrolled.column(column);
            quote!(unknowns[#unknown] += #value;)
        });
        quote! {
            let #names = self.#constants.by_frame(#gradient, &self.#frame);
            #sums
        }
    };
    unrolled
        .system
        .substituted()
        .into_iter()
        .map(of_point)
        .collect()
}
