//! A mechanism ready to move, whatever its linkage.

pub mod columns;
pub mod led;
mod moving;
pub mod sweep;

use std::ops::ControlFlow;
use std::sync::atomic::AtomicBool;
use std::time::{Duration, Instant};

use nalgebra::{Const, DimMin};
use suspension_core::linkage::Listing;
use suspension_core::{
    Advanced, Build, HasKingpin, HasWheel, Inputs, Linkage, LocalOrigin, Motion, SolveError, Still,
    Stopped, Tracker,
};

use crate::assemblies::{self, Listed, Wish};
use crate::bake::order::{Order, Ordered};
use crate::bake::source::Sheet;
use crate::chart;
use crate::chart::survey::{Effort, Survey};
use crate::failure::Failure;
use crate::failures;
use crate::input::drives::DriveLaws;
use crate::input::file::Unit;
use crate::input::instants::Instants;
use crate::number::{number, rounded};
use crate::range::course::DriveRange;
use crate::range::meeting::meeting;
use crate::range::station;
use columns::PointNames;
use led::Lead;
use toml::Spanned;

/// A linkage that this program can run: it carries a wheel on a kingpin.
pub trait Suspension<const N: usize>:
    Build<N, Scalar = f64, Points: HasWheel<f64> + HasKingpin<f64>>
    + Linkage<N, Listing: Listing<N, Model<f64> = Self, Model<f32>: Build<N, Scalar = f32>>>
    + 'static
{
}

impl<L, const N: usize> Suspension<N> for L where
    L: Build<N, Scalar = f64, Points: HasWheel<f64> + HasKingpin<f64>>
        + Linkage<N, Listing: Listing<N, Model<f64> = L, Model<f32>: Build<N, Scalar = f32>>>
        + 'static
{
}

/// Steps that the way from one instant to the next may take.
const MAX_STEPS: usize = 10_000;

/// Takes the row of one instant; may end the sweep.
pub type OnRow<'a> = dyn FnMut(&[f64]) -> Result<ControlFlow<()>, Failure> + 'a;

/// A mechanism ready to move.
pub trait Study {
    /// The linkage's name in the catalogue.
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

    /// Moves the mechanism from instant to instant. The first lies where the file's does.
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
    /// [`Failure::Input`] where the wish makes no sense, [`Failure::Interrupted`].
    fn assemblies(
        &self,
        file: &str,
        wish: &Wish,
        interrupted: &AtomicBool,
    ) -> Result<Vec<Listed>, Failure>;

    /// Puts every method of the chart through the motion between two times.
    ///
    /// # Errors
    ///
    /// [`Failure::Solver`] where there is no motion.
    fn chart(
        &self,
        ends: [f64; 2],
        effort: &Effort,
        interrupted: &AtomicBool,
    ) -> Result<Survey, Failure>;

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

    /// Counts, between two times, how often each method of the failure map fails.
    ///
    /// # Errors
    ///
    /// [`Failure::Solver`] where there is no motion.
    fn failures(
        &self,
        ends: [f64; 2],
        effort: &failures::survey::Effort,
        interrupted: &AtomicBool,
    ) -> Result<failures::survey::Counted, Failure>;
}

/// How a sweep ended.
#[derive(Clone, Debug, PartialEq)]
pub enum End {
    /// At the last instant.
    Complete,
    /// Where the receiver of the rows wanted it.
    Cut,
    /// Where the solver found no further configuration.
    Stopped(Stop),
}

/// Where and why the solver stopped.
#[derive(Clone, Debug, PartialEq)]
pub struct Stop {
    /// The instant that was asked for, s.
    pub asked: f64,
    /// The drives there.
    pub drives_asked: String,
    /// The last time at which the mechanism has a configuration, s.
    pub reached: f64,
    /// The drives there.
    pub drives_reached: String,
    /// What the last refused step failed with.
    pub cause: String,
    /// The drive that turns there, where one does: led by it, the mechanism locks.
    pub turns: Option<&'static str>,
}

/// What a step takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Timing {
    /// The median over the passes of a pass' time divided by its steps.
    pub per_step: Duration,
    /// Steps of a pass.
    pub steps: usize,
    /// Passes through the motion.
    pub passes: usize,
}

/// A linkage in the configuration of the first instant, with its drives over time.
#[derive(Clone, Debug)]
pub struct Assembled<L, const N: usize> {
    /// The linkage's name in the catalogue.
    pub linkage: &'static str,
    /// The unit of its lengths.
    pub unit: Unit,
    /// Where the file's coordinates have the origin of all below: zero, save far from the points.
    pub origin: LocalOrigin<f64>,
    /// The geometry.
    pub model: L,
    /// The first instant, s.
    pub first: f64,
    /// The configuration there.
    pub start: Motion<f64, N>,
    /// The drives; one for which a measure leads stays as it is there.
    pub drives: DriveLaws,
    /// The measure that leads in place of a drive.
    pub lead: Option<Lead<N>>,
}

impl<L: Suspension<N>, const N: usize> Study for Assembled<L, N>
where
    Const<N>: DimMin<Const<N>, Output = Const<N>>,
{
    fn linkage(&self) -> &'static str {
        self.linkage
    }

    fn unit(&self) -> Unit {
        self.unit
    }

    fn columns(&self) -> Vec<String> {
        columns::names::<L, N>(self.unit)
    }

    fn measures(&self) -> Vec<String> {
        columns::measures::<L, N>(self.unit)
    }

    fn leader(&self) -> Option<&Spanned<String>> {
        self.lead.as_ref().map(|lead| &lead.stand_in.key)
    }

    fn points(&self) -> PointNames {
        PointNames::of::<L, N>()
    }

    fn sweep(&self, instants: &Instants, on_row: &mut OnRow<'_>) -> Result<End, Failure> {
        let mut moving = self.moving();
        let [mut last, _] = instants.ends();
        for t in instants.iter() {
            match self.follow([last, t], &mut moving) {
                Ok(advanced) => {
                    let inputs = self.inputs(t, &moving);
                    let row = columns::row(self, t, &inputs, &moving.motion(), &advanced);
                    if on_row(&row)?.is_break() {
                        return Ok(End::Cut);
                    }
                }
                Err(stopped) => {
                    return Ok(End::Stopped(self.stop(t, &stopped, &moving)));
                }
            }
            last = t;
        }
        Ok(End::Complete)
    }

    fn time_a_step(&self, ends: [f64; 2]) -> Option<Timing> {
        const STEP: f64 = 1e-3;
        const ENOUGH: Duration = Duration::from_millis(250);
        const PASSES: std::ops::RangeInclusive<usize> = 3..=51;
        let instants = Instants::stepped(ends[0], ends[1], STEP.copysign(ends[1] - ends[0]));
        let inputs: Vec<_> = instants.iter().map(|t| self.drives.inputs(t)).collect();
        let (first, steps) = inputs.split_first()?;
        let dt = STEP.copysign(ends[1] - ends[0]);
        let began = Instant::now();
        let mut passes = Vec::new();
        while passes.len() < *PASSES.start()
            || (passes.len() < *PASSES.end() && began.elapsed() < ENOUGH)
        {
            passes.push(self.timed_pass(first, steps, dt)?);
        }
        passes.sort_unstable();
        let steps = u32::try_from(steps.len()).ok().filter(|count| *count > 0)?;
        Some(Timing {
            per_step: passes[passes.len() / 2] / steps,
            steps: steps as usize,
            passes: passes.len(),
        })
    }

    fn bake(&self, file: &str, instants: &Instants, order: &Order) -> Result<Sheet, Failure> {
        let ordered = Ordered {
            file,
            assembled: self,
            instants,
            order,
        };
        ordered.sheet()
    }

    fn assemblies(
        &self,
        file: &str,
        wish: &Wish,
        interrupted: &AtomicBool,
    ) -> Result<Vec<Listed>, Failure> {
        assemblies::list(self, file, wish, interrupted)
    }

    fn chart(
        &self,
        ends: [f64; 2],
        effort: &Effort,
        interrupted: &AtomicBool,
    ) -> Result<Survey, Failure> {
        chart::measure(self, ends, effort, interrupted)
    }

    fn range_columns(&self) -> Vec<String> {
        station::names::<L, N>(self.unit)
    }

    fn ranges(
        &self,
        instants: &Instants,
        interrupted: &AtomicBool,
    ) -> Result<Vec<DriveRange>, Failure> {
        let [first, _] = instants.ends();
        let drives = 0..L::DRIVE_KINDS.len();
        drives
            .map(|index| self.range(first, index, interrupted))
            .collect()
    }

    fn meeting(&self, drive: usize, ends: [f64; 2], instants: &Instants) -> Option<(f64, usize)> {
        let driven = self.lead.is_none();
        driven.then(|| meeting::<L, N>(&self.drives, drive, ends, instants))?
    }

    fn failures(
        &self,
        ends: [f64; 2],
        effort: &failures::survey::Effort,
        interrupted: &AtomicBool,
    ) -> Result<failures::survey::Counted, Failure> {
        failures::measure(self, ends, effort, interrupted)
    }
}

impl<L: Suspension<N>, const N: usize> Assembled<L, N> {
    fn timed_pass(
        &self,
        first: &Inputs<Still, L::Drives>,
        steps: &[Inputs<Still, L::Drives>],
        dt: f64,
    ) -> Option<Duration> {
        let tracker = Tracker::default();
        let mut motion = self.start;
        tracker.step(&self.model, first, 0.0, &mut motion).ok()?;
        let began = Instant::now();
        for inputs in steps {
            tracker.step(&self.model, inputs, dt, &mut motion).ok()?;
        }
        let took = began.elapsed();
        std::hint::black_box(motion);
        Some(took)
    }
}

/// Follows the motion from one time to another, in as many steps as it takes.
pub(crate) fn follow<L: Suspension<N>, const N: usize>(
    model: &L,
    drives: &DriveLaws,
    [from, to]: [f64; 2],
    motion: &mut Motion<f64, N>,
) -> Result<Advanced<f64>, Stopped<f64>> {
    let tracker = Tracker {
        max_steps: MAX_STEPS,
        ..Tracker::default()
    };
    tracker.advance(model, |t| drives.inputs(t), from, to, motion)
}

/// Why a step was refused, with the listing's names.
pub(crate) fn cause<L: Suspension<N>, const N: usize>(
    error: &SolveError<f64>,
    unit: Unit,
) -> String {
    let name = error.culprit(&L::EQUATIONS, &L::UNKNOWNS);
    let unit = unit.symbol();
    match error {
        SolveError::NotFinite { .. } => {
            format!("the residual of equation `{name}` is not a finite number")
        }
        SolveError::Overflow { .. } => {
            format!("the change of unknown `{name}` is not a finite number")
        }
        SolveError::CrossedSingularity { .. } => {
            format!("a step of unknown `{name}` ended in another assembly")
        }
        SolveError::Mirrored { .. } => format!(
            "point `{name}` would stand on the wrong side of the points that links join it to"
        ),
        SolveError::TooFar { .. } => {
            format!("the step of unknown `{name}` is too long to tell assemblies apart")
        }
        SolveError::Singular { .. } => format!("unknown `{name}` is no longer determined"),
        SolveError::Diverging { .. } => {
            format!("no root near by, the corrections of unknown `{name}` do not shrink")
        }
        SolveError::StepTooLong { .. } => {
            format!("the series of unknown `{name}` is not good for so long a step")
        }
        SolveError::TurningPoint { asked, extreme, .. } => format!(
            "the leading quantity turns at {}, on the way to {}",
            number(*extreme),
            number(*asked)
        ),
        SolveError::NotConverged {
            residual,
            iterations,
            ..
        } => format!(
            "equation `{name}` is still off by {} {unit} after {iterations} iterations",
            rounded(*residual, 2)
        ),
    }
}
