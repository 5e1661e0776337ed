//! From one configuration to the next: the ways to step.
//!
//! - A [`Tracker`](crate::Tracker) iterates to rounding, and divides a step that is too long: a [`Corner`](crate::Corner) steps by it.
//! - A [`Bounded`](crate::Bounded) step costs the same whatever the data, or is refused: see [`controller`](crate::controller). Four or
//!   eight at once are the `Lanes` of the crate `suspension-lanes`.
//! - A [`SeriesTracker`](series::SeriesTracker) takes long steps; a [`Series`](series::Series) has all instants of one.
//!
//! Each is a [`Stepper`](crate::Stepper): it leads a [`Motion`](crate::Motion) to the inputs at the end of the step, and leaves it as it was
//! where it fails. Where a drive locks, a [`path::Leader`](crate::path::Leader) leads on by a measure.

pub mod bounded;
pub mod series;
pub mod stepper;
pub(crate) mod substeps;
pub mod tracker;
