//! What the catalogue expands to.

mod expansion;
