//! Proofs of roots: none is false, and where a root is regular there is one.

mod judge;
mod random;
mod refine;

mod arithmetic;
mod far_from_singular;
mod hostile;
mod near_singular;
mod near_turning_points;
