//! A mechanism ready to move, whatever its linkage.

mod assembled;
mod cause;
pub mod columns;
mod end;
pub mod led;
mod moving;
pub mod sweep;
mod timing;

use std::ops::ControlFlow;
use std::sync::atomic::AtomicBool;

use nalgebra::Vector3;
use suspension_core::linkage::Listing;
use suspension_core::{Build, HasKingpin, HasWheel, Linkage, Named, Parts};
use toml::Spanned;

use crate::assemblies::{OnListed, Wish};
use crate::bake::order::Order;
use crate::bake::source::Sheet;
use crate::failure::Failure;
use crate::input::file::Unit;
use crate::input::instants::Instants;
use crate::range::course::DriveRange;
use columns::PointNames;

pub use assembled::Assembled;
pub use assembled::follow;
pub use cause::cause;
pub use end::{End, Stop};
pub use timing::Timing;

/// A linkage that this program can run: it carries a wheel on a kingpin.
pub trait Suspension<const N: usize>:
    Build<N, Scalar = f64, Lengths: Named<f64>>
    + Linkage<
        N,
        Points: HasWheel<f64> + HasKingpin<f64> + Named<Vector3<f64>>,
        Fixed: Named<Vector3<f64>>,
        Drives: Named<f64>,
        Measures: Named<f64>,
    > + Linkage<
        N,
        Listing: Parts
                     + Default
                     + Listing<N, Model<f64> = Self, Model<f32>: Build<N, Scalar = f32>>,
    > + 'static
{
}

impl<L, const N: usize> Suspension<N> for L where
    L: Build<N, Scalar = f64, Lengths: Named<f64>>
        + Linkage<
            N,
            Points: HasWheel<f64> + HasKingpin<f64> + Named<Vector3<f64>>,
            Fixed: Named<Vector3<f64>>,
            Drives: Named<f64>,
            Measures: Named<f64>,
        > + Linkage<
            N,
            Listing: Parts
                         + Default
                         + Listing<N, Model<f64> = L, Model<f32>: Build<N, Scalar = f32>>,
        > + 'static
{
}

/// Work on a mechanism, whatever its linkage.
pub trait Work {
    /// What comes of it.
    type Answer;

    /// Does the work.
    ///
    /// # Errors
    ///
    /// See [`Failure`].
    fn on<L: Suspension<N>, const N: usize>(
        self,
        mechanism: &Assembled<L, N>,
    ) -> Result<Self::Answer, Failure>;
}

/// Steps that the way from one instant to the next may take.
const MAX_STEPS: usize = 10_000;

/// Takes the row of one instant; may end the sweep.
pub type OnRow<'a> = dyn FnMut(&[f64]) -> Result<ControlFlow<()>, Failure> + 'a;

/// A mechanism ready to move.
pub trait Study {
    /// The linkage's name in motion files.
    fn linkage(&self) -> &'static str;

    /// The unit of lengths.
    fn unit(&self) -> Unit;

    /// The names of a row's columns.
    fn columns(&self) -> Vec<String>;

    /// Those of them that are what the linkage measures.
    fn measures(&self) -> Vec<String>;

    /// The measure that leads in place of a drive, with its place in the file.
    fn leader(&self) -> Option<&Spanned<String>>;

    /// The points' names.
    fn points(&self) -> PointNames;

    /// Moves the mechanism from instant to instant. The first lies where the file's does. Where the
    /// mechanism locks or the caller stops, that is the [`End`]: not an error.
    ///
    /// # Errors
    ///
    /// What `on_row` fails with.
    fn sweep(&self, instants: &Instants, on_row: &mut OnRow<'_>) -> Result<End, Failure>;

    /// Measures what one step of a millisecond takes: position, velocity and acceleration.
    /// `None` where the motion is too short to tell, or stops.
    fn time_a_step(&self, ends: [f64; 2]) -> Option<Timing>;

    /// Bakes the motion along one drive. `file` and `instants` are those that it was loaded from.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] where the order makes no sense, [`Failure::Solver`] where it cannot be
    /// met.
    fn bake(&self, file: &str, instants: &Instants, order: &Order) -> Result<Sheet, Failure>;

    /// Lists all assemblies. `file` is what it was loaded from.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] where the wish makes no sense, [`Failure::Interrupted`], and what
    /// `on_listed` fails with.
    fn assemblies(
        &self,
        file: &str,
        wish: &Wish,
        interrupted: &AtomicBool,
        on_listed: &mut OnListed<'_>,
    ) -> Result<(), Failure>;

    /// The columns of a place on a drive's curve.
    fn range_columns(&self) -> Vec<String>;

    /// The range of each drive, the others held as at the first instant.
    ///
    /// # Errors
    ///
    /// [`Failure::Solver`] where a curve has no start.
    fn ranges(
        &self,
        instants: &Instants,
        interrupted: &AtomicBool,
    ) -> Result<Vec<DriveRange>, Failure>;

    /// When the motion is at an end of a drive's range, and at which, where it moves this drive
    /// alone.
    fn meeting(&self, drive: usize, ends: [f64; 2], instants: &Instants) -> Option<(f64, usize)>;
}
