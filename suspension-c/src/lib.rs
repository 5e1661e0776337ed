//! The solver for C: plain functions on objects that the caller owns.
//!
//! [`export!`] makes C functions from a [`linkage!`](suspension_core::linkage!) listing in one number
//! type, and a description of them that prints itself as a C header. Both come from the same lines,
//! so they cannot differ. [`catalogue`] exports the linkages of the catalogue.
//!
//! ```
//! suspension_core::linkage! {
//!     /// A rod in a plane.
//!     mod rod {
//!         fixed: a;
//!         free:  p;
//!         link rod: a -> p;
//!         drive y: p.y;
//!         drive z: p.z;
//!     }
//! }
//! suspension_c::export!(pub mod rod_f32 = rod, f32, "my_rod_f32");
//!
//! fn main() {
//!     let header = rod_f32::INTERFACE.to_string();
//!     assert!(header.contains("susp_status my_rod_f32_step("));
//! }
//! ```
//!
//! All state is in the caller's objects, so threads need no lock as long as only one of them writes an
//! object at a time. Every pointer is checked for null and alignment. Every object is checked: the function
//! that makes its kind must have made it. `unsafe` is in `pointer.rs` and its submodules, and where a
//! suspension keeps the listing that it borrows.
//!
//! [`listing`] reads listings from text onto the heap, with the feature `listings`; nothing else
//! allocates.
#![no_std]
#![cfg_attr(
    not(test),
    deny(
        clippy::unwrap_used,
        clippy::expect_used,
        clippy::panic,
        clippy::indexing_slicing
    )
)]

#[cfg(feature = "std")]
extern crate std;

mod convert;
mod curve;
mod describe;
mod export;
mod failure;
mod functions;
pub mod header;
mod linkage;
#[cfg(feature = "listings")]
pub mod listing;
mod masses;
mod names;
pub mod of;
mod pointer;
pub mod shared;
mod status;
mod values;

pub mod catalogue;

/// The items that [`export!`] uses in the calling crate.
#[doc(hidden)]
pub mod private {
    pub use core::marker::PhantomData;
    pub use suspension_core::linkage::{Designed, HasKingpin, HasWheel};
    pub use suspension_core::nalgebra::Vector3;
    pub use suspension_core::{self as solver, Build, Linkage};

    pub use crate::convert::{fill, kingpin_of, rotation_of, wheel_of, wheel_rates_of};
    pub use crate::describe::{Function, Interface, Names, Shape, Structure};
    pub use crate::failure::{Trouble, answer, respond};
    pub use crate::masses::{add_at, each_force, place};
    pub use crate::names::{Naming, Table, Text, terminated, terminated_length};
    pub use crate::of;
    pub use crate::pointer::{In, InOut, Object, Out, tag};
    pub use crate::status::Status;
    pub use crate::values::{
        Rates, Values, named, named_points, outputs_of, room, signal, unknowns, values,
        values_of_points,
    };
}

pub use describe::{Function, Interface, Shape, Structure};
#[cfg(feature = "listings")]
pub use pointer::{Create, Destroy};
pub use pointer::{In, InOut, Out};
pub use status::{Status, status_text};

#[cfg(all(feature = "panic-handler", not(feature = "std")))]
#[panic_handler]
fn halt(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {
        core::hint::spin_loop();
    }
}
