//! Bakes motions into piecewise polynomials, for [`suspension_core::baked`].
//!
//! The solver gives the exact motion and its derivatives with respect to a drive at any place ([`path`]), or to a
//! measure that leads in place of one ([`LedPath`]). Each segment is the polynomial that meets them at given places
//! ([`scheme`]); the difference from the solver is then measured between those places ([`certify`]). The number of
//! segments is the smallest with which the tolerance is met ([`fit`]); two drives make a [`surface`]. Curves are
//! written as files that people read ([`source`]).

mod anchors;
mod baked;
pub mod certify;
mod driven;
mod exact;
pub mod fit;
mod led_path;
pub mod path;
pub mod scheme;
pub mod source;
pub mod surface;
pub mod widest;

pub use baked::{Baked, Wanted};
pub use certify::Reached;
pub use driven::{Derivatives, Output, RequestedPoints};
pub use exact::{Exact, OutOfReach};
pub use fit::{Unmet, bake};
pub use led_path::LedPath;
pub use path::Path;
pub use scheme::{Continuity, TERMS};
pub use surface::{BakedSurface, SurfaceReached, UnmetSurface, WantedSurface, bake_surface};
