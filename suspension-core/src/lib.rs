//! Suspension kinematics in point coordinates, `no_std` and without heap.
//!
//! A suspension is a list of constraints on points, each at most quadratic. [`linkage!`] expands the list at
//! compile time into straight-line code that uses only the stack; this crate solves it. Start with [`Corner`], a
//! moving suspension:
//!
//! ```
//! use suspension_core::Signal;
//!
//! suspension_core::linkage! {
//!     /// A wishbone that carries a wheel.
//!     mod arm {
//!         fixed: front at [0.2, 0.3, 0.2], rear at [-0.2, 0.3, 0.2];
//!         free:  hub at [0.0, 0.7, 0.3], spring_outer at [0.0, 0.55, 0.25];
//!         hinge wishbone: front, rear -> hub, spring_outer;
//!         point inner: wishbone at [0.0, 0.6, 0.3];
//!         fixed: spring_inner at [0.0, 0.4, 0.6];
//!         drive bump: hub.z;
//!         measure spring: length(spring_inner -> spring_outer);
//!         wheel: inner -> hub;
//!     }
//! }
//! use arm::{Corner, Drives};
//!
//! let mut corner: Corner = Corner::design()?;
//! let start = corner.drives();
//! corner.advance(1.0, |time| Signal::line(start, Drives { bump: 0.05 }, time))?;
//! let camber = corner.wheel().map_or(0.0, |wheel| wheel.camber.to_degrees());
//! let motion_ratio = corner.per(Drives { bump: 1.0 })?.measures.rate.spring;
//! assert_eq!(format!("{camber:.3} deg, {motion_ratio:.3}"), "-7.298 deg, -0.661");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Below it are the parts:
//!
//! - [`model`]: what a listing becomes; [`signal`]: what is prescribed, a value with its rates;
//! - [`solve`]: one configuration, found from a guess ([`assemble()`]) or corrected by Newton's method ([`Newton`]), with
//!   velocities and accelerations from one factorisation ([`Tangent`]);
//! - [`step`]: the ways from one configuration to the next ([`Stepper`]): to a tolerance ([`Tracker`]), at a fixed cost
//!   ([`Bounded`]), by Taylor [`series`](step::series);
//! - [`path`]: motions through the turning points of the drives; [`baked`]: motions as polynomials;
//! - [`wheel`]: camber, toe and what else is read off; [`directions`]: derivatives per drive;
//! - [`statics`]: the forces in the parts; [`inertia`]: weight and inertia as forces;
//! - [`chassis`]: a chassis in rigid motion; [`certificate`]: a proof that the root is the one near by.
//!
//! The page [`controller`] shows how to run it on a controller, and what a step costs there.
//!
//! The feature `macros`, on by default, enables [`linkage!`] and the layouts compiled in [`linkages`]. A program that reads
//! all its listings at run time builds faster without it.
#![no_std]
#![forbid(unsafe_code)]
// Functions of the solving path are `inline(always)` in release builds, so that a step is straight-line code. A build
// with debug assertions, such as that of the tests, compiles all but the smallest functions once, which takes less time.

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

pub mod arithmetic;
pub mod baked;
pub mod body;
pub mod certificate;
pub mod chassis;
pub mod corner;
#[doc = include_str!("../docs/controller.md")]
pub mod controller {}
pub mod directions;
pub mod error;
#[cfg(feature = "macros")]
mod expansion;
#[doc(hidden)]
pub mod generated;
pub mod inertia;
pub mod linkage;
pub mod linkages;
pub mod listing;
pub mod model;
pub mod path;
pub mod signal;
pub mod solve;
pub mod statics;
pub mod step;
pub mod values;
pub mod wheel;

pub use nalgebra;

pub use arithmetic::scalar::{Real, Scalar};
pub use corner::Corner;
pub use error::{GeometryError, SolveError};
pub use linkage::{Build, Linkage, Listing, Values};
pub use signal::{Inputs, Signal, Still};
pub use solve::assemble::assemble;
pub use solve::motion::{Motion, Tangent};
pub use solve::newton::Newton;
pub use step::bounded::Bounded;
pub use step::stepper::Stepper;
pub use step::tracker::Tracker;
