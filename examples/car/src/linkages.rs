//! The suspensions, compiled from their listings.

use suspension_core::linkage;

linkage! { pub mod front; }
linkage! { pub mod rear; }
