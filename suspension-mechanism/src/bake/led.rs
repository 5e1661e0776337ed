//! The exact motion as a function of a measure that leads in place of a drive.

use suspension_core::listing::MeasureKind;
use suspension_core::path::{Curve, Leader, Led};
use suspension_core::stepper::Stopped;
use suspension_core::{Inputs, Linkage, Motion, Signal, Still, Values};

use crate::bake::driven::{Derivatives, Driven, Output, Wish};
use crate::bake::path::{ANCHORS, Exact, OutOfReach};
use crate::mechanism::{Suspension, lead, nearest};

/// The mechanism moved by a measure, one drive free and the others held.
#[derive(Clone, Debug)]
pub struct LedPath<'a, L: Linkage<N>, const N: usize> {
    driven: Driven<'a, L>,
    held: Inputs<Still, L::Drives>,
    measure: usize,
    /// Configurations evenly over the range, with the measure's value.
    anchors: Vec<(f64, Led<f64, N>)>,
}

impl<'a, L: Suspension<N>, const N: usize> LedPath<'a, L, N> {
    /// The path of measure number `measure` over `range` in place of drive number `drive`, with the other drives held
    /// at `held`. The mechanism is led there from the configuration `start` at `held`.
    ///
    /// # Errors
    ///
    /// [`OutOfReach`] where the mechanism cannot be led through the range, as where the measure turns back.
    pub fn new(
        model: &'a L,
        start: &Motion<f64, N>,
        held: L::Drives,
        [measure, drive]: [usize; 2],
        range: [f64; 2],
        wish: Wish,
    ) -> Result<Self, OutOfReach> {
        let mut path = Self {
            driven: Driven::new(model, wish),
            held: Inputs::still(Signal::still(held)),
            measure,
            anchors: Vec::new(),
        };
        let unreached = |cause| OutOfReach {
            reached: range,
            cause,
        };
        let curve = Curve::new(model, &path.held, drive).ok_or_else(|| unreached(None))?;
        let led = Led::at_rest(&curve, &start.position);
        let led = led.map_err(|cause| unreached(Some(cause)))?;
        let [from, to] = range;
        let now = nearest(path.kind(), path.measured(&led), 0.5 * (from + to));
        let [mut first, mut last] = [led; 2];
        let ways = [
            path.follow([now, from], &mut first),
            path.follow([now, to], &mut last),
        ];
        if ways.iter().any(Result::is_err) {
            let reached = |way: &Result<(), Stopped<f64>>, end| match way {
                Ok(()) => end,
                Err(stopped) => stopped.reached,
            };
            let [down, up] = &ways;
            let mut refused = ways.iter().filter_map(|way| way.err()?.refused);
            return Err(OutOfReach {
                reached: [reached(down, from), reached(up, to)],
                cause: refused.next().map(|(_, cause)| cause),
            });
        }
        let (mut at, mut led) = (from, first);
        for part in 0..ANCHORS {
            let next = from + (to - from) * f64::from(part) / f64::from(ANCHORS - 1);
            path.lead([at, next], &mut led)?;
            path.anchors.push((next, led));
            at = next;
        }
        Ok(path)
    }

    fn kind(&self) -> MeasureKind {
        self.driven.model().measure_kind(self.measure)
    }

    /// The measure's value.
    fn measured(&self, led: &Led<f64, N>) -> f64 {
        let model = self.driven.model();
        let measures = model.measures(&led.points(model, &self.held)).value;
        let value = measures.values().nth(self.measure);
        value.unwrap_or_default()
    }

    /// Leads from one value to another, rates those per unit of the measure.
    fn follow(&self, way: [f64; 2], led: &mut Led<f64, N>) -> Result<(), Stopped<f64>> {
        let leader = Leader {
            max_steps: 10_000,
            ..Leader::default()
        };
        let target = |value| Signal {
            value,
            rate: 1.0,
            second_rate: 0.0,
        };
        let (model, held) = (self.driven.model(), |_| self.held);
        lead(leader, model, self.measure, held, target, way, led)?;
        Ok(())
    }

    fn lead(&self, way: [f64; 2], led: &mut Led<f64, N>) -> Result<(), OutOfReach> {
        let [from, _] = way;
        self.follow(way, led).map_err(|stopped| OutOfReach {
            reached: [from, stopped.reached],
            cause: stopped.refused.map(|(_, cause)| cause),
        })
    }
}

impl<L: Suspension<N>, const N: usize> Exact for LedPath<'_, L, N> {
    fn outputs(&self) -> Vec<Output> {
        self.driven.outputs()
    }

    fn at(&self, at: f64) -> Result<Vec<Derivatives>, OutOfReach> {
        let distance = |(from, _): &&(f64, Led<f64, N>)| (from - at).abs();
        let anchors = self.anchors.iter();
        let nearest = anchors.min_by(|a, b| distance(a).total_cmp(&distance(b)));
        let Some((from, mut led)) = nearest.copied() else {
            return Ok(Vec::new());
        };
        self.lead([from, at], &mut led)?;
        let points = led.points(self.driven.model(), &self.held);
        Ok(self.driven.read(&points))
    }
}
