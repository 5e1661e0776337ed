//! Proofs of roots: no proof is false, and every regular root is proved.

mod judge;
mod random;
mod refine;

mod arithmetic;
mod far_from_singular;
mod hostile;
mod near_singular;
mod near_turning_points;
