//! Carried points in the elimination. Each is where its frame carries it, so that its rows express it by
//! the frame's points in closed form: a few cross products, instead of rows of nine entries that
//! would be stored and loaded again in every solution.

use proc_macro2::TokenStream;
use quote::{ToTokens, quote};
use syn::Ident;

use super::terms::ident;
use super::unrolled::Unrolled;
use suspension_listing::name::Name;
use suspension_listing::system::{AXES, Substituted, System, carried_name, frame_name};

/// The names of a substituted point's constants and of its frame in the generated code.
fn names(point: &Substituted<'_>) -> [Name; 2] {
    [
        carried_name(point.body, point.point),
        frame_name(point.body),
    ]
}

/// The frames, one per body.
pub(super) fn frames(substituted: &[Substituted<'_>]) -> Vec<Name> {
    let bodies = substituted.iter().map(|point| frame_name(point.body));
    let mut frames: Vec<Name> = bodies.collect();
    frames.dedup();
    frames
}

fn constants(substituted: &[Substituted<'_>]) -> Vec<Name> {
    let names = substituted.iter().map(names);
    names.map(|[constants, _]| constants).collect()
}

/// The fields of the factors.
pub(super) fn fields(system: &System) -> TokenStream {
    let substituted = system.substituted();
    let constants = constants(&substituted);
    let frames = frames(&substituted);
    quote!(#(#frames: Frame<T>,)* #(#constants: Carried<T>,)*)
}

/// The values of these fields.
pub(super) fn values(system: &System) -> TokenStream {
    let substituted = system.substituted();
    let constants = constants(&substituted);
    let frames = frames(&substituted);
    quote!(#(#frames,)* #(#constants: self.#constants,)*)
}

/// Makes rows that depend on carried points depend on their frames instead.
pub(super) fn reduce(unrolled: &Unrolled<'_>, filled: &mut Vec<(usize, usize)>) -> TokenStream {
    let mut statements = TokenStream::new();
    for point in unrolled.system.substituted() {
        let [constants, frame] = names(&point);
        for row in point.rows(unrolled.order) {
            let gradient = point.steps(unrolled.order).map(|step| {
                if step.below.contains(&row) {
                    unrolled.entry(row, step.column).into_token_stream()
                } else {
                    quote!(T::zero())
                }
            });
            let by_frame = gradient_pattern(&point);
            let vectors = columns_by_frame(&point);
            let entries = vectors.map(|(vector, columns)| {
                let entries = columns.map(|column| unrolled.entry(row, column));
                let new = columns.map(|column| unrolled.fills(row, column, filled));
                assign_vector(&ident(vector), &entries, new)
            });
            let entries: TokenStream = entries.collect();
            statements.extend(quote! {
                let gradient = Vector3::new(#(#gradient),*);
                let #by_frame = self.#constants.by_frame(gradient, &#frame);
                #entries
            });
        }
    }
    statements
}

/// Assigns the components of a vector to variables, or adds them to these.
fn assign_vector(vector: &Ident, variables: &[Ident; 3], new: [bool; 3]) -> TokenStream {
    if new == [true; 3] {
        return quote!(let [#(#variables),*] = xyz(#vector););
    }
    let each = variables.iter().zip(AXES.map(ident)).zip(new);
    each.map(|((variable, axis), is_new)| {
        let sum = (!is_new).then(|| quote!(#variable +));
        quote!(let #variable = #sum #vector.#axis;)
    })
    .collect()
}

/// The points of a frame in gradients.
pub(super) const BLOCKS: [&str; 3] = ["origin", "second", "third"];

/// The pattern for the result of `by_frame`.
fn gradient_pattern(point: &Substituted<'_>) -> TokenStream {
    let names = BLOCKS.map(ident).into_iter().zip(point.frame);
    let names = names.map(|(name, column)| match column {
        Some(_) => quote!(#name),
        None => quote!(_),
    });
    quote!([#(#names),*])
}

/// Each of its vectors that belongs to a free point, with the columns of this point.
fn columns_by_frame(
    point: &Substituted<'_>,
) -> impl Iterator<Item = (&'static str, [usize; 3])> + use<> {
    let columns = BLOCKS.into_iter().zip(point.frame);
    columns.filter_map(|(name, column)| {
        let first = column?;
        Some((name, [first, first + 1, first + 2]))
    })
}

/// The unknowns of carried points, once those of their frames are found.
pub(super) fn substituted(unrolled: &Unrolled<'_>) -> TokenStream {
    let mut statements = TokenStream::new();
    let mut last_frame = None;
    for point in unrolled.system.substituted() {
        let [constants, frame] = names(&point);
        if last_frame.as_ref() != Some(&frame) {
            let changes = point.frame.map(|column| change(unrolled, column));
            statements.extend(quote!(let #frame = Frame::new(#(#changes),*);));
        }
        let axes = AXES.map(ident).into_iter();
        let unknowns = axes.zip(point.steps(unrolled.order)).map(|(axis, step)| {
            let (unknown, row) = (unrolled.column(step.column), unrolled.row(step.row));
            quote!(let #unknown = #row + carried.#axis;)
        });
        statements.extend(quote! {
            let carried = self.#constants.velocity(&self.#frame, &#frame);
            #(#unknowns)*
        });
        last_frame = Some(frame);
    }
    statements
}

/// The change of a point, by the column of its first coordinate; zero if it is on the chassis.
fn change(unrolled: &Unrolled<'_>, column: Option<usize>) -> TokenStream {
    let Some(first) = column else {
        return quote!(Vector3::new(T::zero(), T::zero(), T::zero()));
    };
    let axes = [0, 1, 2].map(|axis| unrolled.column(first + axis));
    quote!(Vector3::new(#(#axes),*))
}

/// Adds the contributions of the carried points' unknowns to those of their frames in a transposed solution.
pub(super) fn transposed(unrolled: &Unrolled<'_>) -> TokenStream {
    let of_point = |point: Substituted<'_>| {
        let [constants, frame] = names(&point);
        let gradient = [0, 1, 2].map(|axis| unrolled.column(point.column + axis));
        let by_frame = gradient_pattern(&point);
        let sums = columns_by_frame(&point).map(|(vector, columns)| {
            let unknowns = columns.map(|column| unrolled.column(column).clone());
            assign_vector(&ident(vector), &unknowns, [false; 3])
        });
        quote! {
            let gradient = Vector3::new(#(#gradient),*);
            let #by_frame = self.#constants.by_frame(gradient, &self.#frame);
            #(#sums)*
        }
    };
    let points = unrolled.system.substituted().into_iter();
    points.map(of_point).collect()
}
