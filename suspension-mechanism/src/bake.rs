//! Bakes motions into piecewise polynomials, for [`suspension_core::baked`].
//!
//! The solver gives the exact motion and its derivatives with respect to a drive at any place ([`Path`]), or to a
//! measure that leads in place of one ([`LedPath`]). Each segment is the polynomial that meets them at given places
//! (`scheme`); the difference from the solver is then measured between those places (`certify`). The number of
//! segments is the smallest with which the tolerance is met ([`bake()`]); two drives make a surface
//! ([`bake_surface`]). Curves are written as files that people read ([`source`]).

mod anchors;
mod baked;
mod certify;
mod driven;
mod exact;
mod fit;
mod led_path;
mod path;
mod scheme;
pub mod source;
mod surface;
mod widest;

pub use baked::{Baked, Wanted};
pub use certify::Reached;
pub use driven::{Derivatives, Output, RequestedPoints};
pub use exact::{Exact, OutOfReach};
pub use fit::{MOST_SEGMENTS, Unmet, bake};
pub use led_path::LedPath;
pub use path::Path;
pub use scheme::{Continuity, TERMS};
pub use surface::{
    BakedSurface, MOST_PATCHES, SurfaceReached, UnmetSurface, WantedSurface, bake_surface,
};
pub use widest::widest;
