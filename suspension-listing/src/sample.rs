//! The Jacobian's numbers in the design position that a listing states, and around it: what the
//! choice of pivots goes by. Nothing of it is emitted.

mod gradient;
mod likely;
mod path;

pub use gradient::{Gradient, gradients};
pub use likely::likely;
pub use path::positions;

/// More unknowns than a compiler should be held up with.
const MOST_UNKNOWNS: usize = 60;
