//! One mechanism through every entry of the core.

use nalgebra::{SVector, Vector3};
use suspension_core::linkage::{Build, Values};
use suspension_core::listing::Part;
use suspension_core::signal::ChassisMotion;
use suspension_core::step::series::{InputSeries, Jet};
use suspension_core::{
    GeometryError, Inputs, Motion, Newton, Real, Signal, SolveError, Still, Tangent, assemble,
};

use super::draw::Draw;
use super::reached::Reached;
use super::verdict::{demand_cause, demand_root, demand_same, rounding};

/// Draws a mechanism, builds it, assembles it and drives it in every way. Panics where an answer is
/// wrong.
pub(crate) fn everything<T, L, const N: usize>(draw: &mut Draw<'_>) -> Reached
where
    T: Real,
    L: Build<N, Scalar = T, Listing: Default>,
{
    begin::<T, L, N>(draw).map_or_else(Reached::not_built, |(mut trial, guess)| {
        let drives = trial.drives(draw);
        let motion = trial.assemble(guess, &Inputs::still(drives));
        trial.drive(motion, drives, draw);
        trial.reached
    })
}

/// Draws a mechanism, builds it, solves it once and steps twice. Panics where an answer is wrong.
pub(crate) fn briefly<T, L, const N: usize>(draw: &mut Draw<'_>) -> Reached
where
    T: Real,
    L: Build<N, Scalar = T, Listing: Default>,
{
    begin::<T, L, N>(draw).map_or_else(Reached::not_built, |(mut trial, guess)| {
        let inputs = Inputs::still(trial.drives(draw));
        let mut motion = Motion::at_rest(trial.solve(guess, &inputs));
        let dt = T::constant(draw.moderate());
        let next = course(inputs.drives).at::<T, L::Fixed>(dt);
        trial.tracked(&next, dt, &mut { motion });
        trial.bounded(&next, dt, &mut motion, draw);
        trial.reached
    })
}

fn begin<T, L, const N: usize>(draw: &mut Draw<'_>) -> Option<(Trial<L, N>, SVector<T, N>)>
where
    T: Real,
    L: Build<N, Scalar = T, Listing: Default>,
{
    let design = points::<T, L::Points>(draw);
    let model = build::<T, L, N>(&design, draw)?;
    let guess = model
        .unknowns(&design)
        .map(|x| x + T::constant(draw.distance()));
    let trial = Trial {
        at_design: model.drives_at(&design),
        model,
        reached: Reached {
            tried: 1,
            built: 1,
            ..Reached::default()
        },
    };
    Some((trial, guess))
}

/// The drives over time.
fn course<T: Real, D: Values<T>>(drives: Signal<D>) -> InputSeries<Still, D, 4> {
    let zero = drives.rate.map(|_| T::zero());
    let half = drives.second_rate.map(|x| x * T::constant(0.5));
    InputSeries::still(Jet {
        value: drives.value,
        terms: [drives.rate, half, zero, zero],
    })
}

fn points<T: Real, P: Values<Vector3<T>>>(draw: &mut Draw<'_>) -> P {
    let count = P::from_values([]).values().count();
    P::from_values(
        draw.points(count)
            .into_iter()
            .map(|point| point.map(T::constant)),
    )
}

/// The mechanism with the lengths of its points, or sometimes with others.
fn build<T, L, const N: usize>(design: &L::Points, draw: &mut Draw<'_>) -> Option<L>
where
    T: Real,
    L: Build<N, Scalar = T, Listing: Default>,
{
    let model = demand_linkage(L::of(L::Listing::default(), design))?;
    if draw.below(4) > 0 {
        return Some(model);
    }
    let lengths = L::Lengths::from_values(model.lengths().values().map(|length| {
        let change = T::one() + T::constant(draw.moderate() * 1e-2);
        length * change
    }));
    let model = demand_linkage(model.with_lengths(&lengths))?;
    demand_linkage(model.with_markers(design))
}

/// A linkage has finite lengths; an error names a point or a length of the listing.
fn demand_linkage<T, L, const N: usize>(model: Result<L, GeometryError>) -> Option<L>
where
    T: Real,
    L: Build<N, Scalar = T, Listing: Default>,
{
    match model {
        Ok(model) => {
            let usable = |length: T| length >= T::zero() && length.is_finite();
            assert!(model.lengths().values().all(usable) && model.size() > T::zero());
            Some(model)
        }
        Err(error) => {
            let room = match error.part() {
                Part::Unknown(_) | Part::Equation(_) => N,
                Part::Length(_) => L::Lengths::from_values([]).values().count(),
                _ => L::Points::from_values([]).values().count(),
            };
            assert!(error.part().index() < room, "{error:?}");
            None
        }
    }
}

pub(super) struct Trial<L: Build<N>, const N: usize> {
    pub(super) model: L,
    at_design: L::Drives,
    pub(super) reached: Reached,
}

impl<T, L, const N: usize> Trial<L, N>
where
    T: Real,
    L: Build<N, Scalar = T, Listing: Default>,
{
    /// Drives near those of the design, with rates.
    fn drives(&self, draw: &mut Draw<'_>) -> Signal<L::Drives> {
        let at_design = self.at_design.values().collect::<Vec<_>>();
        let mut near = |at: T| at + T::constant(draw.distance());
        Signal {
            value: L::Drives::from_values(at_design.into_iter().map(&mut near)),
            rate: L::Drives::from_values(std::iter::repeat_with(|| near(T::zero()))),
            second_rate: L::Drives::from_values(std::iter::repeat_with(|| near(T::zero()))),
        }
    }

    /// The configuration near by, or where there is none the guess itself.
    fn solve(&mut self, guess: SVector<T, N>, inputs: &Inputs<Still, L::Drives>) -> SVector<T, N> {
        let mut near = guess;
        match Newton::near_by().solve(&self.model, inputs, &mut near) {
            Ok(_) => {
                self.demand_root(inputs, &Motion::at_rest(near));
                self.reached.assembled = 1;
            }
            Err(error) => self.demand_refusal(&error, &guess, &near),
        }
        near
    }

    /// The start of the motion: a configuration, or where there is none the guess itself.
    fn assemble(
        &mut self,
        guess: SVector<T, N>,
        inputs: &Inputs<Still, L::Drives>,
    ) -> Motion<T, N> {
        self.solve(guess, inputs);
        let mut q = guess;
        match assemble(&Newton::from_afar(), &self.model, inputs, &mut q) {
            Ok(converged) => {
                assert!(converged.report.residual() <= converged.report.tolerance());
                self.demand_root(inputs, &Motion::at_rest(q));
                self.reached.assembled = 1;
                if let Ok(motion) =
                    Tangent::new(&self.model, inputs, &q).and_then(|tangent| tangent.motion())
                {
                    self.demand_root(inputs, &motion);
                }
            }
            Err(error) => self.demand_refusal(&error, &guess, &q),
        }
        Motion::at_rest(q)
    }

    /// Steps of every kind from the same motion; it goes on from the tracker's.
    fn drive(
        &mut self,
        mut motion: Motion<T, N>,
        mut drives: Signal<L::Drives>,
        draw: &mut Draw<'_>,
    ) {
        for _ in 0..3 {
            let dt = T::constant(draw.moderate());
            let course = course(drives);
            let start = motion;
            self.by_series(&course, dt, &mut { start });
            self.advanced(&course, dt, &mut { start });
            let next = course.at::<T, L::Fixed>(dt);
            let chassis = Signal {
                value: *self.model.fixed(),
                rate: L::Fixed::from_values(std::iter::repeat_with(|| {
                    Vector3::from_fn(|_, _| T::constant(draw.distance()))
                })),
                second_rate: L::Fixed::default(),
            };
            let moving = Inputs {
                chassis,
                drives: next.drives,
            };
            self.tracked(&moving, dt, &mut { start });
            self.bounded(&moving, dt, &mut { start }, draw);
            self.bounded(&next, dt, &mut { start }, draw);
            if self.tracked(&next, dt, &mut motion) {
                drives = next.drives;
            }
        }
    }

    pub(super) fn demand_root<C: ChassisMotion<L::Fixed>>(
        &self,
        inputs: &Inputs<C, L::Drives>,
        motion: &Motion<T, N>,
    ) {
        let allowed = rounding(&self.model, &motion.position);
        demand_root(&self.model, inputs, motion, allowed);
    }

    fn demand_refusal(&self, error: &SolveError<T>, before: &SVector<T, N>, after: &SVector<T, N>) {
        demand_cause(&self.model, error);
        demand_same(before, after);
    }
}
