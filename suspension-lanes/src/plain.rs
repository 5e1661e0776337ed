//! The step, one lane after the other, for processors without vector instructions.

use suspension_core::solve::motion::Prescribed;
use suspension_core::step::bounded::{Evidence, Outputs, Step};
use suspension_core::{Inputs, Listing, Motion, Real, Signal, Still};

use crate::engine::Engine;

/// Lanes of plain numbers.
pub(crate) struct Plain<
    G: Listing<N>,
    T: Real,
    const N: usize,
    const LANES: usize,
    const CORRECTIONS: usize,
    const ORDER: usize,
> {
    models: [G::Model<T>; LANES],
    last: [Motion<T, N>; LANES],
    next: [Motion<T, N>; LANES],
}

impl<
    G: Listing<N>,
    T: Real,
    const N: usize,
    const LANES: usize,
    const CORRECTIONS: usize,
    const ORDER: usize,
> Plain<G, T, N, LANES, CORRECTIONS, ORDER>
{
    pub(crate) fn new(models: [G::Model<T>; LANES]) -> Self {
        let at_rest = Motion::at_rest(nalgebra::SVector::zeros());
        Self {
            models,
            last: [at_rest; LANES],
            next: [at_rest; LANES],
        }
    }
}

impl<G, T, const N: usize, const LANES: usize, const CORRECTIONS: usize, const ORDER: usize>
    Engine<G, T, N, LANES> for Plain<G, T, N, LANES, CORRECTIONS, ORDER>
where
    G: Listing<N>,
    T: Real,
{
    fn attempt(
        &mut self,
        outputs: Outputs,
        drives: &[Signal<G::Drives<T>>; LANES],
        dt: T,
    ) -> [Evidence<T>; LANES] {
        std::array::from_fn(|lane| {
            let model = &self.models[lane];
            let prescribed = Prescribed::new(model, &Inputs::still(drives[lane]));
            let last = &self.last[lane];
            let step = Step::<_, Still, N, CORRECTIONS, ORDER>::new(model, &prescribed, last, dt);
            let (next, evidence) = step.in_fixed_order(outputs);
            self.next[lane] = next;
            evidence
        })
    }

    fn accept(&mut self) {
        self.last = self.next;
    }

    fn motion(&self, lane: usize) -> Motion<T, N> {
        self.last[lane]
    }

    fn next(&self, lane: usize) -> Motion<T, N> {
        self.next[lane]
    }

    fn set_motion(&mut self, lane: usize, motion: &Motion<T, N>) {
        self.last[lane] = *motion;
    }

    fn set_models(&mut self, models: [&G::Model<T>; LANES]) {
        self.models = models.map(|model| *model);
    }
}
