//! The exact motion as a function of a measure that leads in place of a drive.

use suspension_core::listing::MeasureKind;
use suspension_core::path::{Curve, Led};
use suspension_core::{Inputs, Linkage, Motion, Signal, Still, Values};

use crate::bake::anchors::Anchors;
use crate::bake::driven::{Derivatives, Driven, Output, RequestedPoints};
use crate::bake::exact::{Exact, OutOfReach, Stop};
use crate::mechanism::{Suspension, inputs_at_rest, lead, nearest};

/// The mechanism moved by a measure, with one drive free and the others held.
#[derive(Clone)]
pub struct LedPath<'a, L: Linkage<N>, const N: usize> {
    way: Way<'a, L, N>,
    anchors: Anchors<Led<f64, N>>,
}

/// The way along the measure.
#[derive(Clone)]
struct Way<'a, L: Linkage<N>, const N: usize> {
    driven: Driven<'a, L>,
    held: Inputs<Still, L::Drives>,
    measure: usize,
}

impl<'a, L: Suspension<N>, const N: usize> LedPath<'a, L, N> {
    /// The path of measure number `measure` over `range` instead of drive number `drive`, with the other drives held
    /// at `held`. The mechanism is led there from the configuration `start` at `held`.
    ///
    /// # Errors
    ///
    /// [`OutOfReach`] if the mechanism cannot be led through the range, for example because the measure turns back.
    pub fn new(
        model: &'a L,
        start: &Motion<f64, N>,
        held: L::Drives,
        [measure, drive]: [usize; 2],
        range: [f64; 2],
        points: RequestedPoints,
    ) -> Result<Self, OutOfReach> {
        let way = Way {
            driven: Driven::new(model, points),
            held: inputs_at_rest(held),
            measure,
        };
        let unreached = |cause| OutOfReach {
            reached: range,
            cause,
        };
        let curve = Curve::new(model, &way.held, drive).ok_or_else(|| unreached(None))?;
        let led = Led::at_rest(&curve, &start.position);
        let led = led.map_err(|cause| unreached(Some(cause)))?;
        let [from, to] = range;
        let now = nearest(way.kind(), way.measured(&led), 0.5 * (from + to));
        let anchors = Anchors::new(range, (now, led), |ends, led| way.follow(ends, led))?;
        Ok(Self { way, anchors })
    }
}

impl<L: Suspension<N>, const N: usize> Way<'_, L, N> {
    fn kind(&self) -> MeasureKind {
        self.driven.model().measure_kind(self.measure)
    }

    fn measured(&self, led: &Led<f64, N>) -> f64 {
        let model = self.driven.model();
        let measures = model.measures(&led.points(model, &self.held)).value;
        let value = measures.values().nth(self.measure);
        value.unwrap_or_default()
    }

    /// Leads from one value to another, with rates per unit of the measure.
    fn follow(&self, ends: [f64; 2], led: &mut Led<f64, N>) -> Result<(), Stop> {
        let target = |value| Signal {
            value,
            rate: 1.0,
            second_rate: 0.0,
        };
        let (model, held) = (self.driven.model(), |_| self.held);
        let led = lead(model, self.measure, held, target, ends, led);
        led.map(drop)
            .map_err(|stopped| (stopped.reached, stopped.refused.map(|(_, cause)| cause)))
    }
}

impl<L: Suspension<N>, const N: usize> Exact for LedPath<'_, L, N> {
    fn outputs(&self) -> Vec<Output> {
        self.way.driven.outputs()
    }

    fn at(&self, at: f64) -> Result<Vec<Derivatives>, OutOfReach> {
        let Way { driven, held, .. } = &self.way;
        let follow = |ends, led: &mut _| self.way.follow(ends, led);
        let led = self.anchors.led_to(at, follow)?;
        Ok(driven.read(&led.points(driven.model(), held)))
    }
}
