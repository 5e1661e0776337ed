//! A mechanism ready to move, whatever its linkage: the file's coordinates outside, local ones inside.

mod derivatives;
mod description;
mod drives;
mod end;
mod grid;
mod instants;
mod lead;
mod locking;
mod misfit;
mod moving;
mod names;
mod polynomial;
mod ready;
mod state;
mod through;
mod unit;
mod visit;
mod words;

pub use derivatives::Order;
pub use description::Description;
pub use drives::{DriveLaws, Law, follow};
pub use end::{End, Stop};
pub use grid::{From, Grid, evenly_spaced};
pub use instants::Instants;
pub use lead::Lead;
pub use locking::Lock;
pub(crate) use locking::from_design;
pub use names::{Axle, Car, Drive, Measure, Names, Suspension, Vehicle, WheelPoints};
pub use polynomial::Polynomial;
pub use ready::Mechanism;
pub use state::State;
pub use through::OnState;
pub use unit::Unit;
pub use visit::{OnPlace, VisitEnd, Visited};
pub(crate) use words::advice;
