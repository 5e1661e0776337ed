//! The published motion, with one counted call per step.

use suspension_core::nalgebra::{SVector, Vector3};
use suspension_core::solve::report as solver;
use suspension_core::{Inputs, Linkage, Motion, Real, SolveError, Still, Values};

use crate::baked::Wheel;
use crate::checksum::{Bits, Checksum};
use crate::published::{self, Published, STEPS};

/// Measures the cost of a call: instructions, or bytes of stack.
pub trait Gauge {
    /// Returns the result of the call, and its cost.
    fn gauge<R>(&self, call: impl FnOnce() -> R) -> (R, u32);
}

/// The results of a mode over the motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Report {
    /// The least that a step took.
    pub least: u32,
    /// The most that a step took.
    pub most: u32,
    /// Made of all numbers of the states after each step.
    pub checksum: u64,
    /// The largest residual of an accepted step, m; zero if none is computed.
    pub residual: f64,
}

impl Report {
    fn new() -> Self {
        Self {
            least: u32::MAX,
            most: 0,
            checksum: 0,
            residual: 0.0,
        }
    }

    fn add(&mut self, taken: u32) {
        self.least = self.least.min(taken);
        self.most = self.most.max(taken);
    }
}

/// The results of forces.
pub struct Borne<T> {
    /// The multiplier of each equation.
    pub multipliers: SVector<T, 15>,
    /// The force on the drive.
    pub on_drive: T,
}

/// Computes the results of forces at the points of a position.
pub type OfForces<T, L> = fn(
    &L,
    &<L as Linkage<15>>::Drives,
    &SVector<T, 15>,
    &<L as Linkage<15>>::Points,
) -> Result<Borne<T>, SolveError<T>>;

/// A look-up of the pose at a drive with its rates; false outside the range.
pub type LookUp<T> = fn(&Wheel<T>, &[T; 3], &mut [[T; 6]; 3]) -> bool;

/// Follows the motion with the steps of a solver; returns the number of the first step that fails. The type parameter for
/// each step makes its call a direct one.
pub fn solved<T, L, E>(
    gauge: &impl Gauge,
    step: impl Fn(&L, &Inputs<Still, L::Drives>, &mut Motion<T, 15>) -> Result<solver::Report<T>, E>,
) -> Result<Report, u32>
where
    T: Real + Bits + Into<f64>,
    L: Published<Scalar = T>,
{
    let (model, mut motion) = L::start().ok_or(0_u32)?;
    let mut report = Report::new();
    let mut checksum = Checksum::new();
    for number in 1..=STEPS {
        let inputs = published::inputs::<T, L>(number);
        let (done, taken) = gauge.gauge(|| step(&model, &inputs, &mut motion));
        report.add(taken);
        let done = done.map_err(|_| number)?;
        report.residual = report.residual.max(done.residual().into());
        checksum.add(&motion.position);
        checksum.add(&motion.velocity);
        checksum.add(&motion.acceleration);
    }
    report.checksum = checksum.value();
    Ok(report)
}

/// Follows the motion to the tolerance, and loads each state; or the number of the first step that fails.
pub fn loaded<T, L>(gauge: &impl Gauge, of_forces: OfForces<T, L>) -> Result<Report, u32>
where
    T: Real + Bits + Into<f64>,
    L: Published<Scalar = T>,
{
    let (model, mut motion) = L::start().ok_or(0_u32)?;
    // On each point of the chassis and of the knuckle, N.
    let forces = (0..11_u8).map(|point| {
        let number = T::constant(f64::from(point));
        Vector3::new(number, T::one() - number, T::constant(100.0))
    });
    let forces = L::Points::from_values(forces);
    let mut report = Report::new();
    let mut checksum = Checksum::new();
    for number in 1..=STEPS {
        let inputs = published::inputs::<T, L>(number);
        if !model.advance(number, &mut motion) {
            return Err(number);
        }
        let drives = &inputs.drives.value;
        let (borne, taken) = gauge.gauge(|| of_forces(&model, drives, &motion.position, &forces));
        report.add(taken);
        let borne = borne.map_err(|_| number)?;
        checksum.add(&borne.multipliers);
        checksum.add(&SVector::from([borne.on_drive]));
    }
    report.checksum = checksum.value();
    Ok(report)
}

/// Looks the motion up in a baked one; returns the number of the first step outside its range.
pub fn baked<T: Real + Bits>(
    gauge: &impl Gauge,
    wheel: &Wheel<T>,
    look_up: LookUp<T>,
) -> Result<Report, u32> {
    let mut report = Report::new();
    let mut checksum = Checksum::new();
    for number in 0..=STEPS {
        let drive = published::theta(number).map(T::constant);
        let mut pose = [[T::zero(); 6]; 3];
        let (is_inside, taken) = gauge.gauge(|| look_up(wheel, &drive, &mut pose));
        if !is_inside {
            return Err(number);
        }
        report.add(taken);
        checksum.add(pose.as_flattened());
    }
    report.checksum = checksum.value();
    Ok(report)
}
