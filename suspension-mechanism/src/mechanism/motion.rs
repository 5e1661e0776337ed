//! A mechanism over time: its drives, or a measure in place of one, lead it from instant to instant.

pub(super) mod drive_laws;
pub(super) mod end;
pub(super) mod law;
pub(super) mod lead;
pub(super) mod moving;
pub(super) mod spline;
