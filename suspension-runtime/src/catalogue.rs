//! The layouts of the catalogue, by name.

use suspension_core::linkages::LISTINGS;
use suspension_listing::did_you_mean::did_you_mean;

/// The listing of a layout.
pub fn listing(name: &str) -> Option<&'static str> {
    let mut listings = LISTINGS.iter();
    listings.find_map(|(known, text)| (*known == name).then_some(*text))
}

/// The message that the catalogue has no such layout: it names the layout that may be meant, or otherwise all of
/// them, and what there is `besides`.
pub fn unknown(name: &str, besides: &str) -> String {
    let known: Vec<&str> = LISTINGS.iter().map(|(known, _)| *known).collect();
    let hint = did_you_mean(name, known.iter().copied());
    if !hint.is_empty() {
        return format!("unknown linkage `{name}`{hint}");
    }
    let known = known.join(", ");
    format!("unknown linkage `{name}`; known are {known}{besides}")
}
