//! The named parts of a mechanism, with what a motion file states of them.

pub(super) mod driven_length;
pub(super) mod guide;
pub(super) mod hinge;
pub(super) mod mass;
pub(super) mod names;
pub(super) mod sides;
pub(super) mod spring;
pub(super) mod vehicle;
pub(super) mod words;
