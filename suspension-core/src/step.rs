//! The ways to step from one configuration to the next.
//!
//! - A [`Tracker`](crate::Tracker) iterates to rounding and divides a step that is too long. A [`Corner`](crate::Corner) uses it.
//! - A [`Bounded`](crate::Bounded) step costs the same for any data, or is refused: see
//!   [`controller`](crate::controller). The `Lanes` of the crate `suspension-lanes` take four or eight such steps at once.
//! - A [`SeriesTracker`](series::SeriesTracker) takes long steps; a [`Series`](series::Series) has all instants of one.
//!
//! Each is a [`Stepper`](crate::Stepper): it moves a [`Motion`](crate::Motion) to the inputs at the end of the step,
//! and leaves it unchanged if it fails. If a drive locks, a [`path::Leader`](crate::path::Leader) leads on by a
//! measure.

pub mod bounded;
pub mod series;
pub mod stepper;
pub(crate) mod substeps;
pub mod tracker;
