//! The Jacobian's numbers at the design position that a listing states, and around it. The
//! choice of pivots uses them; none are emitted.

mod entries;
mod gradient;
mod likely;
mod path;

pub use entries::entries;
pub use likely::likely;
pub use path::positions;

/// The number of unknowns above which sampling would hold up a compiler.
pub(crate) const MOST_SAMPLED: usize = 120;
