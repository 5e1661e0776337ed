//! Suspension kinematics in point coordinates, `no_std` and without heap.
//!
//! A suspension is a list of at-most-quadratic constraints over points. [`linkage!`] expands the
//! list at compile time into straight-line, stack-only code (an implementation of [`Linkage`]);
//! this crate runs Newton's method on it ([`Newton`]), takes velocities and accelerations from
//! one factorisation ([`Tangent`]), follows a motion in time to a tolerance ([`Tracker`]), at a fixed
//! cost ([`Bounded`]), through the turning points of its drives ([`path`]) or by its Taylor series ([`Series`]), looks up a motion that was baked
//! ([`baked`]), and reads off the wheel what engineers want to know ([`wheel`]). How to put it on a
//! controller, and what it costs there, is told at [`controller`].
#![no_std]
#![forbid(unsafe_code)]
// Nothing on the solving path may panic.
#![cfg_attr(
    not(test),
    deny(
        clippy::unwrap_used,
        clippy::expect_used,
        clippy::panic,
        clippy::indexing_slicing
    )
)]

pub mod assemble;
pub mod baked;
pub mod body;
pub mod bounded;
pub mod certificate;
pub mod chassis;
pub mod constraint;
#[doc = include_str!("../docs/controller.md")]
pub mod controller {}
mod entrywise;
pub mod error;
mod expansion;
pub mod factored;
#[doc(hidden)]
pub mod generated;
pub mod handedness;
pub mod linkage;
pub mod linkages;
pub mod listing;
pub mod local;
pub mod lu;
mod magnitude;
pub mod measure;
pub mod motion;
pub mod newton;
pub mod parts;
pub mod path;
pub mod report;
pub mod scalar;
pub mod series;
pub mod signal;
pub mod stepper;
mod substeps;
pub mod tolerance;
pub mod tracker;
pub mod trigonometry;
mod vector;
pub mod wheel;

pub use nalgebra;

pub use assemble::assemble;
pub use bounded::{Bounded, Outputs};
pub use certificate::{Certificate, Certifier, Unproved};
pub use chassis::RigidMotion;
pub use error::{GeometryError, SolveError};
pub use linkage::{Build, HasKingpin, HasWheel, Linkage, Listing, Named, Values};
pub use listing::{DriveKind, Kind, MeasureKind, Part, Parts};
pub use local::LocalOrigin;
pub use motion::{Motion, Tangent};
pub use newton::Newton;
pub use report::Report;
pub use scalar::{Real, Scalar};
pub use series::{InputSeries, Jet, Series, SeriesTracker};
pub use signal::{ChassisMotion, Inputs, Signal, Still};
pub use stepper::Stepper;
pub use substeps::Stopped;
pub use tolerance::Tolerance;
pub use tracker::Tracker;
