//! Kinematics from the linkage's equations, to rounding or at a fixed cost, depending on the stepper and its numbers.

use suspension_core::directions::Directions;
use suspension_core::error::{Cause, Explain};
use suspension_core::linkage::{Designed, Values};
use suspension_core::{
    Bounded, Build, GeometryError, Inputs, Linkage, Listing, Motion, Real, Signal, Stepper, Still,
    Tracker,
};

use super::{Drives, Hub, Kinematics, Refused};

/// A linkage that is solved in each tick.
#[derive(Clone, Copy)]
pub struct Solved<S, L: Linkage<N>, const N: usize> {
    stepper: S,
    model: L,
    design: [f64; 2],
    start: Motion<L::Scalar, N>,
    motion: Motion<L::Scalar, N>,
}

/// Solves to rounding, in f64: as exact as the geometry.
///
/// # Errors
///
/// If the listing's positions do not suit its linkage.
pub fn exact<L, const N: usize>() -> Result<Solved<Tracker<f64>, L, N>, GeometryError>
where
    L: Designed<N, Scalar = f64, Listing: Default>,
{
    let points = L::design();
    let model = L::new(&points)?;
    let start = Motion::at_rest(model.unknowns(&points));
    let design = design_of(&model, &points);
    Ok(Solved::new(Tracker::default(), model, design, start))
}

/// Solves at a fixed cost, in f32.
///
/// # Errors
///
/// Those of [`exact`].
pub fn bounded<G, const N: usize>() -> Result<Solved<Bounded<f32>, G::Model<f32>, N>, GeometryError>
where
    G: Listing<N> + Default,
    G::Model<f64>: Designed<N, Listing = G>,
{
    let points = <G::Model<f64> as Designed<N>>::design();
    let model = <G::Model<f64> as Build<N>>::new(&points)?;
    let start = Motion::at_rest(model.unknowns(&points).map(|x| x as f32));
    let design = design_of(&model, &points);
    Ok(Solved::new(
        Bounded::default(),
        G::rounded(&model),
        design,
        start,
    ))
}

/// Returns bump and, if there is one, the rack's position at the design position.
fn design_of<L: Build<N, Scalar = f64>, const N: usize>(model: &L, points: &L::Points) -> [f64; 2] {
    let mut values = [0.0; 2];
    for (value, drive) in values.iter_mut().zip(model.drives_at(points).values()) {
        *value = drive;
    }
    values
}

impl<T, S, L, const N: usize> Solved<S, L, N>
where
    T: Real,
    L: Linkage<N, Scalar = T>,
{
    fn new(stepper: S, model: L, design: [f64; 2], start: Motion<T, N>) -> Self {
        Self {
            stepper,
            model,
            design,
            start,
            motion: start,
        }
    }

    fn inputs(&self, drives: &Signal<Drives>) -> Inputs<Still, L::Drives> {
        let [bump, steer] = self.design;
        let Signal {
            value,
            rate,
            second_rate,
        } = drives;
        Inputs::still(Signal {
            value: of([bump + value.travel, steer + value.rack]),
            rate: of([rate.travel, rate.rack]),
            second_rate: of([second_rate.travel, second_rate.rack]),
        })
    }
}

/// Returns the drives of a listing; without a rack the second value is dropped.
fn of<T: Real, D: Values<T>>(values: [f64; 2]) -> D {
    D::from_values(values.map(T::constant))
}

impl<T, S, L, const N: usize> Kinematics for Solved<S, L, N>
where
    T: Real + Into<f64>,
    S: Stepper<T> + Send,
    L: Linkage<N, Scalar = T> + Send,
{
    fn step(&mut self, dt: f64, drives: &Signal<Drives>) -> Result<Hub, Refused> {
        let refused = |cause| Refused::by_solver(drives.value, cause);
        let inputs = self.inputs(drives);
        self.stepper
            .step(&self.model, &inputs, T::constant(dt), &mut self.motion)
            .map_err(|error| refused(error.facts().cause))?;
        let points = self.motion.points(&self.model, &inputs);
        let drives = inputs.drives.value;
        let per_travel = Directions::at(&self.model, drives, &self.motion.position, |directions| {
            directions.points(of([1.0, 0.0]))
        });
        let per_travel = per_travel.map_err(|error| refused(error.facts().cause))?;
        Hub::of(&self.model, &points, &per_travel).ok_or(refused(Cause::Overflow))
    }

    fn enter(&mut self, drives: &Drives) -> Result<(), Refused> {
        let mut motion = self.start;
        let way = |part: T| {
            let part: f64 = part.into();
            let of = |part| Drives {
                travel: drives.travel * part,
                rack: drives.rack * part,
            };
            self.inputs(&Signal {
                value: of(part),
                rate: of(1.0),
                second_rate: of(0.0),
            })
        };
        let whole = [T::zero(), T::one()];
        self.stepper
            .advance(&self.model, way, whole, &mut motion)
            .map_err(|stopped| Refused::by_solver(*drives, stopped.facts().cause))?;
        self.motion = motion;
        Ok(())
    }
}
