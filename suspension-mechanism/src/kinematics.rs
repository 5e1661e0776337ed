//! A mechanism of any linkage, without type parameters: what commands work on.

mod assemblies;
mod changed;
mod design_derivatives;
mod equations;
mod misplaced_points;

use std::ops::Deref;
use std::sync::atomic::AtomicBool;
use std::time::{Duration, Instant};

use nalgebra::Vector3;
use suspension_core::{Inputs, Still, Tracker, Values};
use suspension_runtime::PartForces;

use crate::assemblies::Watch;
use crate::bake::{
    BakedSurface, Exact, LedPath, OutOfReach, Path, RequestedPoints, UnmetSurface, WantedSurface,
    bake_surface,
};
use crate::failure::Failure;
use crate::mechanism::{
    Borne, CountedFrom, DerivativeOrder, Description, DesignDerivatives, End, Grid, Instants, Lock,
    Mechanism, OnPlace, OnState, Place, State, Suspension, VisitEnd, Visited,
};
use crate::reach::{self, DriveRange};
use assemblies::Enumerated;

pub use assemblies::{Assembled, Assembly};
pub use changed::{Changes, Unbuilt};
pub(crate) use design_derivatives::design_derivatives;
pub use equations::Equations;
pub use misplaced_points::misplaced_points;

/// A mechanism of any linkage at the first instant of its motion. It can be read as its [`Description`].
pub trait Kinematics: Deref<Target = Description> {
    /// All points at the first instant, in the file's coordinates.
    fn points(&self) -> Vec<Vector3<f64>>;

    /// See [`Mechanism::move_through`].
    ///
    /// # Errors
    ///
    /// The error of `on_state`.
    fn move_through(&self, instants: &Instants, on_state: &mut OnState<'_>)
    -> Result<End, Failure>;

    /// Solves each place of a grid that the mechanism reaches; [`visit`](#method.visit) collects what is read there.
    fn visit_each(
        &self,
        grid: &Grid,
        order: DerivativeOrder,
        interrupted: &AtomicBool,
        on_place: &mut OnPlace<'_>,
    ) -> VisitEnd;

    /// See [`Mechanism::apply_forces`].
    fn apply_forces(
        &self,
        state: &State,
        forces: &[Vector3<f64>],
        parts: &[PartForces],
    ) -> Option<Borne>;

    /// See [`Mechanism::gradients`].
    fn gradients(&self, state: &State) -> Vec<Vec<Vector3<f64>>>;

    /// See [`reach::range`].
    ///
    /// # Errors
    ///
    /// [`Failure::Solver`] if the curve has no start.
    fn range(&self, drive: usize, interrupted: &AtomicBool) -> Result<DriveRange, Failure>;

    /// The lock on the way of one drive from the first instant to a value, in local coordinates, with the others
    /// held; `None` if the mechanism gets there.
    fn lock_before(&self, drive: usize, value: f64) -> Option<Lock>;

    /// The equations at the first instant.
    fn equations(&self) -> Equations;

    /// The search for assemblies.
    fn assemblies<'a>(&'a self, watch: &'a Watch<'a>) -> Box<dyn Assembled + 'a>;

    /// The motion along one drive over a range, or along a measure in place of the drive, by their numbers; in local
    /// coordinates, with the other drives held as at the first instant.
    ///
    /// # Errors
    ///
    /// [`OutOfReach`] if the drive or the measure does not lead the mechanism through the range.
    fn path(
        &self,
        drive: usize,
        measure: Option<usize>,
        range: [f64; 2],
        points: RequestedPoints,
    ) -> Result<Box<dyn Exact + '_>, OutOfReach>;

    /// The motion over two drives as polynomials, with the others held as at the first instant; in local coordinates.
    ///
    /// # Errors
    ///
    /// See [`UnmetSurface`].
    fn bake_surface(
        &self,
        wanted: &WantedSurface,
        interrupted: &AtomicBool,
    ) -> Result<BakedSurface, UnmetSurface>;

    /// The mechanism with other hardpoints, at its own design position, and then with other lengths.
    ///
    /// # Errors
    ///
    /// [`Unbuilt`] if it does not exist.
    fn changed(&self, changes: &Changes) -> Result<Box<dyn Kinematics + '_>, Unbuilt>;

    /// The mechanism at its start, and how it changes with its design; `None` if it locks there, and for a model that
    /// `linkage!` has written.
    fn design_derivatives(&self) -> Option<Box<dyn DesignDerivatives + '_>>;

    /// The time that the motion takes in steps of `dt`, without the first step, and the number of steps; `None` if it
    /// has none, or stops.
    fn time_steps(&self, dt: f64) -> Option<(Duration, u32)>;
}

/// Reads a place of a grid.
pub type Read<'a, R> = dyn FnMut(&dyn Place) -> R + 'a;

impl dyn Kinematics + '_ {
    /// Solves the mechanism at each place of a grid; derivatives of quantities have the requested order.
    pub fn visit<R>(
        &self,
        grid: &Grid,
        order: DerivativeOrder,
        interrupted: &AtomicBool,
        read: &mut Read<'_, R>,
    ) -> Visited<R> {
        let mut places = Vec::new();
        places.resize_with(grid.places().unwrap_or_default(), || None);
        let end = self.visit_each(grid, order, interrupted, &mut |number, place| {
            places[number] = Some(read(place));
        });
        Visited { places, end }
    }

    /// Reads the place where the mechanism starts, the only one of a grid without axes.
    pub fn at_start<R>(&self, read: &mut Read<'_, R>) -> Option<R> {
        let here = Grid::new(self, Vec::new(), CountedFrom::Start).ok()?;
        let never = AtomicBool::new(false);
        let visited = self.visit(&here, DerivativeOrder::First, &never, read);
        visited.places.into_iter().flatten().next()
    }

    /// Whether the drives determine the motion where the mechanism starts.
    pub fn is_determined(&self) -> bool {
        self.at_start(&mut |place| place.per(0).is_some()) == Some(true)
    }
}

impl<L: Suspension<N>, const N: usize> Kinematics for Mechanism<L, N> {
    fn points(&self) -> Vec<Vector3<f64>> {
        let points = self.start_points();
        let points = points.values().take(self.names.points.len());
        points.map(|point| point + self.origin).collect()
    }

    fn move_through(
        &self,
        instants: &Instants,
        on_state: &mut OnState<'_>,
    ) -> Result<End, Failure> {
        self.move_through(instants, on_state)
    }

    fn visit_each(
        &self,
        grid: &Grid,
        order: DerivativeOrder,
        interrupted: &AtomicBool,
        on_place: &mut OnPlace<'_>,
    ) -> VisitEnd {
        self.visit_each(grid, order, interrupted, on_place)
    }

    fn apply_forces(
        &self,
        state: &State,
        forces: &[Vector3<f64>],
        parts: &[PartForces],
    ) -> Option<Borne> {
        self.apply_forces(state, forces, parts)
    }

    fn gradients(&self, state: &State) -> Vec<Vec<Vector3<f64>>> {
        self.gradients(state)
    }

    fn range(&self, drive: usize, interrupted: &AtomicBool) -> Result<DriveRange, Failure> {
        reach::range(self, drive, interrupted)
    }

    fn lock_before(&self, drive: usize, value: f64) -> Option<Lock> {
        self.lock_before(drive, value)
    }

    fn equations(&self) -> Equations {
        Equations::evaluate(self)
    }

    fn assemblies<'a>(&'a self, watch: &'a Watch<'a>) -> Box<dyn Assembled + 'a> {
        Box::new(Enumerated::new(self, watch))
    }

    fn path(
        &self,
        drive: usize,
        measure: Option<usize>,
        range: [f64; 2],
        points: RequestedPoints,
    ) -> Result<Box<dyn Exact + '_>, OutOfReach> {
        let held = self.start_drives();
        let (model, start) = (&self.model, &self.start);
        Ok(match measure {
            None => Box::new(Path::new(model, start, held, drive, range, points)?),
            Some(measure) => {
                let leads = [measure, drive];
                Box::new(LedPath::new(model, start, held, leads, range, points)?)
            }
        })
    }

    fn bake_surface(
        &self,
        wanted: &WantedSurface,
        interrupted: &AtomicBool,
    ) -> Result<BakedSurface, UnmetSurface> {
        let held = self.start_drives();
        bake_surface(&self.model, &self.start, held, wanted, interrupted)
    }

    fn changed(&self, changes: &Changes) -> Result<Box<dyn Kinematics + '_>, Unbuilt> {
        Ok(Box::new(changed::changed(self, changes)?))
    }

    fn design_derivatives(&self) -> Option<Box<dyn DesignDerivatives + '_>> {
        (self.design_derivatives?)(self)
    }

    fn time_steps(&self, dt: f64) -> Option<(Duration, u32)> {
        let [from, to] = self.instants.ends();
        let instants = Instants::stepped(from, to, dt);
        let inputs = instants.iter().map(|t| self.drives.inputs(t));
        let inputs: Vec<Inputs<Still, L::Drives>> = inputs.collect();
        let (first, steps) = inputs.split_first()?;
        let count = u32::try_from(steps.len()).ok().filter(|count| *count > 0)?;
        let tracker = Tracker::default();
        let mut motion = self.start;
        tracker.step(&self.model, first, 0.0, &mut motion).ok()?;
        let began = Instant::now();
        for inputs in steps {
            tracker.step(&self.model, inputs, dt, &mut motion).ok()?;
        }
        let took = began.elapsed();
        std::hint::black_box(motion);
        Some((took, count))
    }
}
