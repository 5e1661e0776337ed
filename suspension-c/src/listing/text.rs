//! Functions that read a listing and report its parts.
#![allow(unsafe_code, reason = "names for the linker")]

use super::kind::Kind;
use super::objects::Listing;
use super::parsed::{self, Parsed};
use crate::convert::fill;
use crate::failure::answer;
use crate::names::Text;
use crate::pointer::{Create, Destroy, In, Object, Out};
use crate::status::Status;

/// The number type.
pub(super) type Number = f64;
/// A byte of a text.
type Char = u8;

/// Checks the length of an array.
pub(super) fn check_count(count: usize, expected: usize) -> Result<(), Status> {
    if count == expected {
        Ok(())
    } else {
        Err(Status::Size)
    }
}

crate::functions! { "susp":
    /// Parses a listing: `length` bytes of UTF-8, the statements as in a `.linkage` file. If the result is
    /// SUSP_ERROR_LISTING, `message` receives every mistake on a line of its own, as
    /// `listing:LINE:COLUMN: what is wrong and what to write instead`, truncated to `size` bytes and
    /// terminated by a zero; `needed` receives the size of the whole message. Both may be NULL.
    fn listing_parse(text: In<Char>, length: usize, listing: Create<Listing>, message: Out<Char>, size: usize, needed: Out<usize>) -> Status {
        answer(|| {
            let (text, listing) = (text.many(length)?, listing.get()?);
            let (message, needed) = (message.optional_many(size)?, needed.optional()?);
            match Parsed::new(text) {
                Ok(parsed) => {
                    listing.write(Object::on_heap(parsed));
                    Ok(())
                }
                Err(mistakes) => {
                    parsed::copy(&mistakes, message.unwrap_or_default());
                    fill(needed, mistakes.len() + 1);
                    Err(Status::Listing)
                }
            }
        })
    }

    /// Frees a listing; NULL has no effect. Corners made from it stay valid.
    fn listing_destroy(listing: Destroy<Listing>) -> Status {
        answer(|| listing.end())
    }

    /// The number of parts of a kind in a listing.
    fn listing_count(listing: In<Listing>, kind: Kind, count: Out<usize>) -> Status {
        answer(|| {
            let (listing, count) = (listing.object()?, count.get()?);
            count.write(listing.names(kind)?.len());
            Ok(())
        })
    }

    /// The name of a part by its number, from 0: a text that lives as long as the listing. NULL beyond the
    /// last number, and if `listing` is not a listing or there is no such kind.
    fn listing_name(listing: In<Listing>, kind: Kind, index: usize) -> Text {
        let names = listing.object().and_then(|listing| listing.names(kind));
        let name = names.ok().and_then(|names| names.get(index));
        name.map_or(Text::NONE, |name| name.as_c_str().into())
    }

    /// The number of a part by its name, a text terminated by a zero; SUSP_ERROR_ABSENT if there is no such
    /// part.
    fn listing_find(listing: In<Listing>, kind: Kind, name: In<Char>, index: Out<usize>) -> Status {
        answer(|| {
            let (listing, name, index) = (listing.object()?, name.text()?, index.get()?);
            index.write(listing.find(kind, name)?);
            Ok(())
        })
    }

    /// The positions that the listing states, `points[POINTS][3]`; NaN for points without a position.
    fn listing_design(listing: In<Listing>, points: Out<Number>, count: usize) -> Status {
        answer(|| {
            let (listing, points) = (listing.object()?, points.many(count)?);
            check_count(count, 3 * listing.counts().points)?;
            listing.write_design(points);
            Ok(())
        })
    }
}
