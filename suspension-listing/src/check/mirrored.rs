//! Mistakes of mirror images are reported at the statements that they are images of.

use proc_macro2::Span;
use syn::Error;

use crate::errors::Errors;
use crate::sides::Sides;

/// The errors without those of images whose originals have the same one. The others say what the image is of.
pub(crate) fn told_of_one_side(sides: &[Sides], errors: Errors) -> Errors {
    let mut told: Vec<(Span, String)> = Vec::new();
    let mut of_one_side = Errors::default();
    for error in errors.all() {
        let (place, message) = (error.span(), error.to_string());
        let is_told = |sides: &Sides| {
            let of_original = sides.exchanged(&message);
            let mut told = told.iter();
            told.any(|(at, other)| is_same(*at, place) && *other == of_original)
        };
        if sides.iter().any(is_told) {
            continue;
        }
        let mut sides = sides.iter();
        let image = sides.find_map(|sides| image_at(sides, place, &message));
        of_one_side.push(image.map_or(error, |image| {
            let end = if message.ends_with('?') { "" } else { ";" };
            Error::new(place, format!("{message}{end} {image}"))
        }));
        told.push((place, message));
    }
    of_one_side
}

/// Whether two places are the same: images have those of their originals.
fn is_same(one: Span, other: Span) -> bool {
    let ends = |place: Span| (place.file(), place.start(), place.end());
    ends(one) == ends(other)
}

/// What makes the name that a message has where another one is written.
fn image_at(sides: &Sides, place: Span, message: &str) -> Option<String> {
    let original = place.source_text()?;
    let image = sides.exchanged(&original);
    let is_of_image = message.contains(&image) && !message.contains(&original);
    (is_of_image && !message.contains("`mirror`")).then(|| {
        format!(
            "`mirror` makes `{image}`, as the image of `{original}`: {}",
            sides.how_named()
        )
    })
}
