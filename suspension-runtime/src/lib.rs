//! Suspension listings from text, solved without a Rust compiler.
//!
//! [`Listing::parse`] reads the statements that stand inside the braces of `linkage!`. From a listing and hardpoints
//! [`Listing::corner`] makes a suspension that moves, [`Listing::model`] a [`Model`] alone.
//!
//! A model walks a list of equations, and the order in which their Jacobian is eliminated. It computes the same bits
//! as the code that `linkage!` writes, in 1.3 to 3.1 times the time; only the threshold that a refusal as singular
//! reports may differ. It implements the core's [`Linkage`](suspension_core::Linkage) and
//! [`Build`](suspension_core::Build), so that every solver works on it. Names are looked up once, and nothing on the
//! solving path allocates.
//!
//! ```
//! use suspension_core::{Signal, Values};
//! use suspension_runtime::Listing;
//!
//! let listing = Listing::parse(
//!     "fixed: hinge at [0.0, 0.0, 0.0];
//!      free: tip at [0.0, 0.4, 0.3];
//!      link arm: hinge -> tip;
//!      drive turn: angle(hinge -> tip, z);
//!      drive along: tip.x;",
//! )?;
//! let (tip, turn) = (listing.point("tip").unwrap(), listing.drive("turn").unwrap());
//! let mut corner = listing.corner::<15>(&listing.design().unwrap())?;
//!
//! let angle = 1.0;
//! let drives = Signal::still(corner.drives().with(turn, angle));
//! corner.step(1e-3, drives).map_err(|failure| failure.to_string())?;
//! let at = corner.points().value.values().nth(tip).unwrap();
//! assert!((at.z - 0.5 * angle.cos()).abs() < 1e-15);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! The number in `corner::<15>` is the capacity for unknowns: 15, 30, 60 or 120, see [`Size`]. [`Listing::size`] returns the
//! number of unknowns of a listing; 120 is enough for any. A failure borrows the listing to name its parts: to return it from
//! the function that owns the listing, convert it to text as above.
//!
//! A struct that keeps corners for as long as the program runs takes them from a listing that is never freed. Its failures
//! borrow nothing, and `?` returns them:
//!
//! ```
//! use suspension_core::{Corner, Signal};
//! use suspension_runtime::{Listing, Model, catalogue};
//!
//! struct Vehicle {
//!     corners: [Corner<Model<'static, f64, 15>, 15>; 4],
//! }
//!
//! fn vehicle(text: &str) -> Result<Vehicle, Box<dyn std::error::Error>> {
//!     let listing: &'static Listing = Box::leak(Box::new(Listing::parse(text)?));
//!     let mut corner = listing.corner(&listing.design().ok_or("a point without a position")?)?;
//!     corner.step(1e-3, Signal::still(corner.drives()))?;
//!     Ok(Vehicle { corners: [corner; 4] })
//! }
//!
//! let vehicle = vehicle(catalogue::listing("double_wishbone").unwrap())?;
//! assert!(vehicle.corners.iter().all(|corner| corner.wheel().is_some()));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
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

mod angle_share;
mod best_fit;
mod bound_to_axes;
mod build;
pub mod catalogue;
mod catalogue_and_files;
mod design_change;
mod drives;
mod equations;
mod factors;
mod fitted;
mod flat_body;
mod form;
mod hardpoints;
mod lengths;
mod linkage;
mod listing;
mod model;
mod names;
mod part_forces;
mod plan;
mod points;
mod quantity;
mod site;
mod size;
mod statement;
mod table;

pub use angle_share::AngleShare;
pub use catalogue_and_files::CatalogueAndFiles;
pub use design_change::{AlongDrive, DesignChange, Start, Unknowns};
pub use factors::Factors;
pub use fitted::{Fitted, Work};
pub use flat_body::FlatBody;
pub use hardpoints::ModelError;
pub use listing::Listing;
pub use model::Model;
pub use part_forces::PartForces;
pub use size::{Room, Size};
pub use statement::Statement;
pub use suspension_listing::include::{IncludeSource, Wanted};
pub use suspension_listing::text::{Mistake, Mistakes};
pub use table::{Masked, Table, Value};
