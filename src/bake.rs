//! Bakes a motion into a piecewise polynomial of one drive, for
//! [`suspension_core::baked::Curve`].
//!
//! The solver gives the exact motion and its derivatives with respect to the drive at any place
//! ([`path`]); each segment is the polynomial that meets them at given places ([`scheme`]); the
//! difference from the solver is then measured between those places ([`certify`]). The number of
//! segments is the smallest with which the tolerance is met ([`fit`]).

pub mod certify;
pub mod fit;
pub mod order;
pub mod path;
pub mod scheme;
pub mod source;

pub use certify::Reached;
pub use fit::{Baked, Unmet, Wanted, bake};
pub use order::Order;
pub use path::{Exact, OutOfReach, Output, Path, Wish};
pub use scheme::{Continuity, TERMS};
