//! A corner from points.

use super::Corner;
use super::clock::Clock;
use crate::arithmetic::scalar::Real;
use crate::error::{Failure, GeometryError, SolveError};
use crate::linkage::{Build, Designed};
use crate::signal::{Inputs, Signal};
use crate::solve::assemble::assemble;
use crate::solve::motion::Motion;
use crate::solve::newton::Newton;
use crate::solve::pivots::check_regular;
use crate::step::tracker::Tracker;

impl<L: Build<N, Scalar: Real, Listing: Default>, const N: usize> Corner<L, N> {
    /// A corner at rest at the points that the listing states: see [`Corner::new`].
    ///
    /// # Errors
    ///
    /// See [`Corner::new`].
    pub fn design() -> Result<Self, Failure<GeometryError, L::Listing>>
    where
        L: Designed<N>,
    {
        Self::new(&L::design())
    }

    /// A corner at rest at the given points, which give links and bodies their lengths. The points need not satisfy
    /// what else the listing states, for example that a point lies on the line of a `slide`: they are used as given
    /// until the first step, which moves them to where they do. [`Corner::assembled`] moves them at once.
    ///
    /// # Errors
    ///
    /// See [`Build::new`]; [`GeometryError::Singular`] if the mechanism locks at the points or a drive has no effect.
    pub fn new(points: &L::Points) -> Result<Self, Failure<GeometryError, L::Listing>> {
        let build = || {
            let model = L::new(points)?;
            check_regular(&model, points)?;
            Ok(Self::of(model, points))
        };
        build().map_err(|error: GeometryError| error.named(L::Listing::default()))
    }
}

impl<T: Real, L: Build<N, Scalar = T>, const N: usize> Corner<L, N> {
    /// A corner at rest at the given points, with a model that was built from them; for any other model see
    /// [`Corner::assembled`].
    pub fn of(model: L, points: &L::Points) -> Self {
        let motion = Motion::at_rest(model.unknowns(points));
        let drives = Signal::still(model.drives_at(points));
        Self::resumed(model, motion, drives, T::zero())
    }

    /// A corner that goes on where another one was: from that corner's [`model`](Self::model) and its stored
    /// [`motion`](Self::motion), [`drive_signal`](Self::drive_signal) and [`time`](Self::time), which are used as given.
    /// The same steps then give the same motion, bit by bit. The time of an `f32` clock may differ in its last digit,
    /// because the rounding error that the clock carries along is not stored.
    pub fn resumed(model: L, motion: Motion<T, N>, drives: Signal<L::Drives>, time: T) -> Self {
        Self {
            tracker: Tracker::default(),
            motion,
            drives,
            clock: Clock::at(time),
            model,
        }
    }

    /// A corner at rest with a model whose lengths are not those of the points. The drives have the values that the
    /// points give, and the configuration is the one nearest to the points.
    ///
    /// # Errors
    ///
    /// As [`assemble()`].
    pub fn assembled(
        model: L,
        points: &L::Points,
    ) -> Result<Self, Failure<SolveError<T>, L::Listing>> {
        let mut corner = Self::of(model, points);
        let inputs = Inputs::still(corner.drives);
        let unknowns = &mut corner.motion.position;
        match assemble(&Newton::from_afar(), &corner.model, &inputs, unknowns) {
            Ok(_) => Ok(corner),
            Err(error) => Err(error.named(corner.model.listing())),
        }
    }
}
