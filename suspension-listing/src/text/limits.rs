//! How large a text may be that is read at run time: enough for any corner of a vehicle, and little enough that
//! no text takes long or much memory.

use syn::Error;

use crate::lexed::MOST_BYTES;
use crate::listing::Listing;
use crate::mistake::Mistake;

/// The most statements beside those that declare points.
pub const MOST_STATEMENTS: usize = 256;

/// The most chassis points and free points, and the most names in one statement.
pub const MOST_POINTS: usize = 128;

/// The most unknowns.
pub const MOST_UNKNOWNS: usize = 60;

/// Refuses a text that is too long.
pub(super) fn length(text: &str) -> Result<(), Mistake> {
    if text.len() <= MOST_BYTES {
        return Ok(());
    }
    Err(Mistake {
        message: format!(
            "the text is {} bytes long; at most {MOST_BYTES} are allowed",
            text.len()
        ),
        line: 1,
        column: 1,
        length: 0,
    })
}

/// Refuses a listing that is too large.
pub(super) fn listing(listing: &Listing) -> syn::Result<()> {
    let points = listing.fixed.len() + listing.free.len();
    let most_names = listing
        .statements
        .iter()
        .map(|other| other.operands().len());
    let counts = [
        (points, MOST_POINTS, "points"),
        (listing.statements.len(), MOST_STATEMENTS, "statements"),
        (
            most_names.max().unwrap_or(0),
            MOST_POINTS,
            "names in one statement",
        ),
    ];
    for (count, most, what) in counts {
        if count > most {
            return Err(too_many(listing, count, most, what));
        }
    }
    unknowns(listing, 3 * listing.free.len())
}

/// Refuses a system that is too large.
pub(super) fn unknowns(listing: &Listing, count: usize) -> syn::Result<()> {
    if count > MOST_UNKNOWNS {
        return Err(too_many(listing, count, MOST_UNKNOWNS, "unknowns"));
    }
    Ok(())
}

fn too_many(listing: &Listing, count: usize, most: usize, what: &str) -> Error {
    let message =
        format!("{count} {what}; at most {most} are allowed in a listing read at run time");
    Error::new(listing.free_span, message)
}
