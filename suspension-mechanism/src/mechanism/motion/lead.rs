//! A motion that a measure of the linkage leads in place of one of the drives.

use std::cell::Cell;

use suspension_core::path::{Leader, Led, measured};
use suspension_core::solve::report::Report;
use suspension_core::step::stepper::Stopped;
use suspension_core::{Inputs, Linkage, Signal, SolveError, Still, Values};

use crate::file::Unit;
use crate::mechanism::measure::nearest;
use crate::mechanism::motion::drive_laws::{DriveLaws, MAX_STEPS};
use crate::mechanism::motion::law::Law;
use crate::mechanism::parts::names::Names;
use crate::mechanism::parts::words::value_in_words;

/// The measure that leads instead of a drive.
#[derive(Clone, Debug)]
pub struct Lead<const N: usize> {
    /// The measure's number.
    pub measure: usize,
    /// The number of the drive that it sets free.
    pub drive: usize,
    /// The measure over time, for points in local coordinates.
    pub law: Law,
    /// The offset to be added to get the file's coordinates.
    pub offset: f64,
    /// The start of the motion.
    pub start: Led<f64, N>,
}

/// Leads a mechanism by a measure; angles are taken within half a turn of their target.
pub(crate) fn lead<L: Linkage<N, Scalar = f64>, const N: usize>(
    model: &L,
    measure: usize,
    held: impl Fn(f64) -> Inputs<Still, L::Drives>,
    target: impl Fn(f64) -> Signal<f64>,
    ends: [f64; 2],
    led: &mut Led<f64, N>,
) -> Result<Report<f64>, Stopped<f64>> {
    let leader = Leader {
        max_steps: MAX_STEPS,
        ..Leader::default()
    };
    let [reached, _] = ends;
    let quantity = measured(model, measure).ok_or(Stopped {
        reached,
        refused: None,
    })?;
    let kind = model.measure_kind(measure);
    let asked = Cell::new(0.0);
    let target = |at| {
        let target = target(at);
        asked.set(target.value);
        target
    };
    let quantity = |points: &Signal<L::Points>| {
        let signal = quantity(points);
        Signal {
            value: nearest(kind, signal.value, asked.get()),
            ..signal
        }
    };
    leader.advance(model, held, quantity, target, ends, led)
}

impl<const N: usize> Lead<N> {
    /// Follows the motion from one time to another, in as many steps as it takes.
    ///
    /// # Errors
    ///
    /// [`Stopped`] if the mechanism goes no further.
    pub fn follow<L: Linkage<N, Scalar = f64>>(
        &self,
        model: &L,
        drives: &DriveLaws,
        times: [f64; 2],
        led: &mut Led<f64, N>,
    ) -> Result<Report<f64>, Stopped<f64>> {
        let (held, target) = (|t| drives.inputs(t), |t| self.law.at(t));
        lead(model, self.measure, held, target, times, led)
    }

    /// The inputs `held`, with the free drive at its value in the mechanism.
    pub fn inputs<L: Linkage<N, Scalar = f64>>(
        &self,
        model: &L,
        held: &Inputs<Still, L::Drives>,
        led: &Led<f64, N>,
    ) -> Inputs<Still, L::Drives> {
        let free = led.drive(model, held);
        let index = self.drive;
        let Signal {
            value,
            rate,
            second_rate,
        } = held.drives;
        Inputs::still(Signal {
            value: value.with(index, free.value),
            rate: rate.with(index, free.rate),
            second_rate: second_rate.with(index, free.second_rate),
        })
    }

    /// A description of what leads at time `t`, such as `height = 50 mm`, with the measure in place of its drive.
    pub fn in_words(&self, names: &Names, drives: &[f64], t: f64, unit: Unit) -> String {
        let value = self.value_in_words(names, self.law.at(t).value, unit);
        let measure = format!("{} = {value}", names.measures[self.measure].name);
        names.drives_in_words(drives, unit, Some((self.drive, &measure)))
    }

    /// The reason why a step was refused.
    pub fn cause(&self, names: &Names, error: &SolveError<f64>, unit: Unit) -> String {
        match error {
            SolveError::TurningPoint { extreme, .. } => format!(
                "measure `{}` has an extreme value of {} and no values beyond it on this branch",
                names.measures[self.measure].name,
                self.value_in_words(names, *extreme, unit)
            ),
            _ => names.cause(error),
        }
    }

    fn value_in_words(&self, names: &Names, value: f64, unit: Unit) -> String {
        let kind = names.measures[self.measure].kind;
        value_in_words(value + self.offset, kind, unit)
    }
}
