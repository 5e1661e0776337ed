//! Steps in lanes: four corners of a car for about the price of one, or eight variants for one and a half (with AVX-512).
//!
//! The code that `linkage!` generates runs on vectors of numbers. [`Lanes`] find out which instructions the processor
//! has when they are made, so a default build is fast on any processor.

mod engine;
mod instructions;
mod lane;
mod model_and_motion;
mod number;
mod plain;

use engine::Engine;
pub use instructions::Instructions;
pub use lane::Lane;
use suspension_core::solve::report::Report;
use suspension_core::step::bounded::Outputs;
use suspension_core::{Bounded, Inputs, Linkage, Listing, Motion, Signal, SolveError};

/// `LANES` models of the listing `G`, each with its motion, on still chassis.
///
/// All lanes are of one listing, on either side: a car whose axles have different layouts takes one `Lanes` for each.
/// Lanes that remain may hold copies, at no cost.
///
/// A lane that fails keeps its motion and returns the reason, which names the part if it is printed with the
/// [`model`](Self::model): `error.named(lanes.model(lane))`. The other lanes are not affected. A lane that has failed
/// must catch up before the next step, whose length is the same for all: see [`set_motion`](Self::set_motion).
///
/// Motions start from a configuration. Where the points of a corner do not satisfy the listing, for example where one is a
/// tenth of a millimetre off the line of its `slide`, take the motion of [`Corner::assembled`](suspension_core::Corner::assembled).
///
/// `N` is the number of unknowns of the listing, `Listing::PARTS.unknowns.len()`, or `_` if the models determine it.
/// See [`Bounded`] for `CORRECTIONS` and `ORDER`. One correction, the default, suits drives that are smooth functions
/// of time; in `f64` a wheel that a vehicle's equations of motion move on a road takes three:
/// `Lanes::<Listing, f64, _, 4, 3>`. Numbers in vectors round a product and a sum together, so results differ from
/// those of [`Bounded::step`] by rounding.
///
/// ```
/// use suspension_core::step::bounded::Outputs;
/// use suspension_core::linkages::double_wishbone::{Corner, Drives, Listing};
/// use suspension_core::{Inputs, Signal};
/// use suspension_lanes::Lanes;
///
/// let corner: Corner = Corner::design()?;
/// let (start, rate) = (corner.drives(), Drives { bump: 0.5, steer: 0.0 });
/// // Of a car these would be four models.
/// let mut lanes = Lanes::<Listing, f64, _, 4>::new([*corner.model(); 4], &[*corner.motion(); 4]);
/// // A first step without length finds the rates.
/// let first = lanes.step(Outputs::Acceleration, &[Signal::line(start, rate, 0.0); 4], 0.0);
/// assert!(first.iter().all(Result::is_ok));
/// for tick in 1..=20 {
///     let drives = [Signal::line(start, rate, 1e-3 * f64::from(tick)); 4];
///     for result in lanes.step(Outputs::Acceleration, &drives, 1e-3) {
///         result?;
///     }
/// }
/// let inputs = Inputs::still(Signal::line(start, rate, 0.02));
/// let points = lanes.motion(2).points(lanes.model(2), &inputs);
/// assert!((points.value.wheel_centre.z - start.bump - 0.01).abs() < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Lanes<
    G: Listing<N>,
    T: Lane,
    const N: usize,
    const LANES: usize,
    const CORRECTIONS: usize = 1,
    const ORDER: usize = 2,
> {
    /// The conditions under which a step is accepted.
    pub settings: Bounded<T, CORRECTIONS, ORDER>,
    models: [G::Model<T>; LANES],
    signs: [Option<bool>; LANES],
    engine: Box<dyn Engine<G, T, N, LANES>>,
}

impl<G, T, const N: usize, const LANES: usize, const CORRECTIONS: usize, const ORDER: usize>
    Lanes<G, T, N, LANES, CORRECTIONS, ORDER>
where
    G: Listing<N>,
    T: Lane,
{
    fn from_engine(
        mut engine: Box<dyn Engine<G, T, N, LANES>>,
        models: [G::Model<T>; LANES],
        motions: &[Motion<T, N>; LANES],
    ) -> Self {
        for (lane, motion) in motions.iter().enumerate() {
            engine.set_motion(lane, motion);
        }
        Self {
            settings: Bounded::new(),
            models,
            signs: motions.map(|motion| motion.positive_determinant),
            engine,
        }
    }

    /// Makes one step of length `dt` in every lane, solving only for the requested outputs.
    ///
    /// # Errors
    ///
    /// For each lane as [`Bounded::step`]; the motion of that lane is then unchanged.
    pub fn step(
        &mut self,
        outputs: Outputs,
        drives: &[Signal<G::Drives<T>>; LANES],
        dt: T,
    ) -> [Result<Report<T>, SolveError<T>>; LANES] {
        let evidence = self.engine.attempt(outputs, drives, dt);
        let judged: [_; LANES] = std::array::from_fn(|lane| {
            let (evidence, before) = (&evidence[lane], self.signs[lane]);
            let size = self.models[lane].size();
            let judged = self.settings.judge(size, evidence, before, T::zero);
            judged.ok().filter(|_| evidence.is_healthy())
        });
        if judged.iter().all(Option::is_some) {
            self.engine.accept();
            self.signs = evidence.map(|evidence| Some(evidence.determinant_sign > T::zero()));
            // All are present: no lane has to step alone.
            return judged.map(Option::unwrap_or_default).map(Ok);
        }
        std::array::from_fn(|lane| match judged[lane] {
            Some(settled) => {
                let next = evidence[lane].signed(self.engine.next(lane));
                self.set_motion(lane, &next);
                Ok(settled)
            }
            None => self.step_alone(lane, outputs, &drives[lane], dt),
        })
    }

    /// Steps a lane alone, in every available way, if its pivots are unhealthy or its step is refused.
    #[cold]
    fn step_alone(
        &mut self,
        lane: usize,
        outputs: Outputs,
        drives: &Signal<G::Drives<T>>,
        dt: T,
    ) -> Result<Report<T>, SolveError<T>> {
        let mut motion = self.motion(lane);
        let inputs = Inputs::still(*drives);
        let model = &self.models[lane];
        let settled = self
            .settings
            .step_to(outputs, model, &inputs, dt, &mut motion)?;
        self.set_motion(lane, &motion);
        Ok(settled)
    }
}
