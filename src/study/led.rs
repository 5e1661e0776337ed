//! A motion that a measure of the linkage leads in place of one of the drives.

use suspension_core::path::{Leader, Led, measured};
use suspension_core::{Advanced, Inputs, Parts, Signal, SolveError, Still, Stopped, Values};

use crate::input::drives::{DriveLaws, Law, each_in_words};
use crate::input::file::Unit;
use crate::input::leading::StandIn;
use crate::number::number;
use crate::study::columns::unit_of_measure;
use crate::study::{MAX_STEPS, Suspension, cause};

/// What leads in place of a drive.
#[derive(Clone, Debug)]
pub struct Lead<const N: usize> {
    /// The measure, and the drive that it sets free.
    pub stand_in: StandIn,
    /// The measure over time, of points in local coordinates.
    pub law: Law,
    /// What to add for the file's coordinates.
    pub offset: f64,
    /// Where the motion starts.
    pub start: Led<f64, N>,
}

impl<const N: usize> Lead<N> {
    /// Follows the motion from one time to another, in as many steps as it takes.
    pub(crate) fn follow<L: Suspension<N>>(
        &self,
        model: &L,
        drives: &DriveLaws,
        times: [f64; 2],
        led: &mut Led<f64, N>,
    ) -> Result<Advanced<f64>, Stopped<f64>> {
        let leader = Leader {
            max_steps: MAX_STEPS,
            ..Leader::default()
        };
        let Some(quantity) = measured(model, self.stand_in.measure) else {
            let [reached, _] = times;
            return Err(Stopped {
                reached,
                refused: None,
            });
        };
        let target = |t| self.law.at(t);
        leader.advance(model, |t| drives.inputs(t), quantity, target, times, led)
    }

    /// The inputs `held`, the free drive as the mechanism has it.
    pub(crate) fn inputs<L: Suspension<N>>(
        &self,
        model: &L,
        held: &Inputs<Still, L::Drives>,
        led: &Led<f64, N>,
    ) -> Inputs<Still, L::Drives> {
        let free = led.drive(model, held);
        let index = self.stand_in.drive;
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

    /// What leads at time `t` in words, as `height = 50 mm`, the measure in place of its drive.
    pub(crate) fn in_words<L: Suspension<N>>(
        &self,
        drives: &L::Drives,
        t: f64,
        unit: Unit,
    ) -> String {
        let mut each = each_in_words::<L, N>(drives, unit);
        if let Some(words) = each.get_mut(self.stand_in.drive) {
            *words = format!(
                "{} = {}",
                self.name(),
                self.value_in_words::<L>(self.law.at(t).value, unit)
            );
        }
        each.join(", ")
    }

    /// Why a step was refused.
    pub(crate) fn cause<L: Suspension<N>>(&self, error: &SolveError<f64>, unit: Unit) -> String {
        match error {
            SolveError::TurningPoint { extreme, .. } => format!(
                "measure `{}` turns at {}, there is none beyond on this branch",
                self.name(),
                self.value_in_words::<L>(*extreme, unit)
            ),
            _ => cause::<L, N>(error, unit),
        }
    }

    fn name(&self) -> &str {
        self.stand_in.key.get_ref()
    }

    fn value_in_words<L: Suspension<N>>(&self, value: f64, unit: Unit) -> String {
        let kind = L::Listing::default().measure_kind(self.stand_in.measure);
        let unit = unit_of_measure(kind, unit);
        format!("{} {unit}", number(value + self.offset))
    }
}
