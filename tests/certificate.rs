//! Proofs of roots: none is false, and where a root is regular there is one.

mod support;

#[path = "certificate/motion.rs"]
mod motion;
