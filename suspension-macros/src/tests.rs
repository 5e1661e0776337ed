//! The expansions of the catalogue's listings.

mod expansion;
