//! Mistakes in mirror images, reported at the original statements.

use proc_macro2::Span;
use syn::Error;

use crate::check::neither_side::WithoutImage;
use crate::errors::Errors;
use crate::listing::Listing;
use crate::sides::Sides;

/// The errors without those of images whose originals have the same error. Of those that follow from a name for
/// neither side only the first is kept, after that cause. The others say what the image is an image of.
pub(crate) fn report_one_side(listing: &Listing, errors: Errors) -> Errors {
    let sides = &listing.sides;
    let mut reported: Vec<(Span, String)> = Vec::new();
    let mut causes: Vec<Span> = Vec::new();
    let is_reported_at = |causes: &[Span], place| causes.iter().any(|cause| is_same(*cause, place));
    let mut of_one_side = Errors::default();
    for error in errors.all() {
        let (place, message) = (error.span(), error.to_string());
        let is_reported = |sides: &Sides| {
            let of_original = sides.exchanged(&message);
            let mut reported = reported.iter();
            reported.any(|(at, other)| {
                is_same(*at, place) && without_suggestion(other) == without_suggestion(&of_original)
            })
        };
        if sides.iter().any(is_reported) {
            continue;
        }
        if let Some(cause) = cause(listing, &message) {
            if !is_reported_at(&causes, cause.place()) {
                causes.push(cause.place());
                of_one_side.push(cause.prepend_to(&error));
            }
            continue;
        }
        // Missing equations name their cause themselves, and another error may have named it already.
        if is_reported_at(&causes, place) {
            continue;
        }
        let mut sides = sides.iter();
        let image = sides.find_map(|sides| image_at(sides, place, &message));
        of_one_side.push(image.map_or(error, |image| {
            let end = if message.ends_with('?') { "" } else { ";" };
            Error::new(place, format!("{message}{end} {image}"))
        }));
        reported.push((place, message));
    }
    of_one_side
}

/// A message without the names that may have been meant, which may be of both sides.
fn without_suggestion(message: &str) -> &str {
    let (mistake, _) = message
        .split_once("; did you mean")
        .unwrap_or((message, ""));
    mistake
}

/// The statement in a message about an image that has no image and should have one.
fn cause<'a>(listing: &'a Listing, message: &str) -> Option<WithoutImage<'a>> {
    let mut images = listing.images.iter();
    let is_of_image = images.any(|image| message.contains(&format!("`{image}`")));
    WithoutImage::all(listing).find(|cause| is_of_image && cause.is_in(message))
}

/// Whether two places are the same: images have the places of their originals.
fn is_same(one: Span, other: Span) -> bool {
    let ends = |place: Span| (place.file(), place.start(), place.end());
    ends(one) == ends(other)
}

/// A note on the image of a name, if a message has that name at a place where another one is written.
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
