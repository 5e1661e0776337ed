//! Through the published motion, one counted call a step.

use suspension_core::{Bounded, Build, Inputs, Motion, Real, Still};

use crate::baked::Wheel;
use crate::checksum::{Bits, Checksum};
use crate::published::{self, Knuckle, STEPS, Stepped};

/// Counts instructions.
pub trait Counter {
    /// What the work results in, and how many instructions it takes: those of a call, less those of
    /// a call that does nothing.
    fn count<R>(&self, work: impl FnOnce() -> R) -> (R, u32);
}

/// What a mode did over the motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Report {
    /// The name of the mode: linkage, number, method and rates.
    pub mode: &'static str,
    /// The fewest instructions of a step.
    pub least: u32,
    /// The most instructions of a step.
    pub most: u32,
    /// Made of all numbers of the states after each step.
    pub checksum: u64,
    /// The largest residual that a step was accepted with, m; zero where none is formed.
    pub residual: f64,
}

impl Report {
    fn new(mode: &'static str) -> Self {
        Self {
            mode,
            least: u32::MAX,
            most: 0,
            checksum: 0,
            residual: 0.0,
        }
    }

    fn add(&mut self, instructions: u32) {
        self.least = self.least.min(instructions);
        self.most = self.most.max(instructions);
    }
}

/// Follows the motion with the steps of a solver; `None` where one fails.
pub fn solved<T, L, R>(
    counter: &impl Counter,
    mode: &'static str,
    step: fn(&L, &Inputs<Still, L::Drives>, &mut Motion<T, 15>) -> Stepped<R, T>,
    residual: impl Fn(R) -> T,
) -> Option<Report>
where
    T: Real + Bits + Into<f64>,
    L: Build<15, Scalar = T> + Knuckle,
{
    let (model, mut motion) = published::start::<T, L>()?;
    let at = published::inputs::<T, L>;
    // From rest to the rates of the motion.
    let set_off = Bounded::<T>::default();
    set_off.step(&model, &at(0), T::zero(), &mut motion).ok()?;
    let mut report = Report::new(mode);
    let mut checksum = Checksum::new();
    for number in 1..=STEPS {
        let inputs = at(number);
        let (stepped, instructions) = counter.count(|| step(&model, &inputs, &mut motion));
        report.add(instructions);
        report.residual = report.residual.max(residual(stepped.ok()?).into());
        checksum.add(&motion.position);
        checksum.add(&motion.velocity);
        checksum.add(&motion.acceleration);
    }
    report.checksum = checksum.value();
    Some(report)
}

/// Looks the motion up in a baked one; `None` outside its range.
pub fn baked<T: Real + Bits>(
    counter: &impl Counter,
    mode: &'static str,
    wheel: &Wheel<T>,
    look_up: fn(&Wheel<T>, &[T; 3], &mut [[T; 6]; 3]) -> bool,
) -> Option<Report> {
    let mut report = Report::new(mode);
    let mut checksum = Checksum::new();
    for number in 0..=STEPS {
        let drive = published::theta(number).map(T::constant);
        let mut pose = [[T::zero(); 6]; 3];
        let (is_inside, instructions) = counter.count(|| look_up(wheel, &drive, &mut pose));
        if !is_inside {
            return None;
        }
        report.add(instructions);
        checksum.add(pose.as_flattened());
    }
    report.checksum = checksum.value();
    Some(report)
}
