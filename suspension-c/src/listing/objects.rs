//! The objects that C holds.

use super::{parsed, placed};
use crate::pointer::{Object, tag};

/// A parsed listing.
pub type Listing = Object<parsed::Parsed, { tag("susp_listing") }>;

/// A suspension that moves.
pub type Corner = Object<placed::Placed, { tag("susp_corner") }>;
