//! Kinematics from the linkage's equations, to rounding or at a fixed cost: the stepper and its numbers decide.

use suspension_core::directions::Directions;
use suspension_core::error::{Cause, Explain};
use suspension_core::linkage::{Designed, Values};
use suspension_core::{
    Bounded, Build, GeometryError, Inputs, Linkage, Listing, Motion, Real, Signal, Stepper, Tracker,
};

use super::{Drives, Hub, Kinematics, Refused, Why};

/// A linkage that is solved in each tick.
#[derive(Clone, Copy)]
pub struct Solved<S, L: Linkage<N>, const N: usize> {
    stepper: S,
    model: L,
    design: [f64; 2],
    motion: Motion<L::Scalar, N>,
}

/// To rounding, in f64: as exact as the geometry.
///
/// # Errors
///
/// Where the listing's positions are not those of a linkage.
pub fn exact<L, const N: usize>() -> Result<Solved<Tracker<f64>, L, N>, GeometryError>
where
    L: Designed<N, Scalar = f64, Listing: Default>,
{
    let points = L::design();
    let model = L::new(&points)?;
    Ok(Solved {
        stepper: Tracker::default(),
        design: design_of(&model, &points),
        motion: Motion::at_rest(model.unknowns(&points)),
        model,
    })
}

/// At a fixed cost, in f32.
///
/// # Errors
///
/// As [`exact`].
pub fn bounded<G, const N: usize>() -> Result<Solved<Bounded<f32>, G::Model<f32>, N>, GeometryError>
where
    G: Listing<N> + Default,
    G::Model<f64>: Designed<N, Listing = G>,
{
    let points = <G::Model<f64> as Designed<N>>::design();
    let model = <G::Model<f64> as Build<N>>::new(&points)?;
    Ok(Solved {
        stepper: Bounded::default(),
        design: design_of(&model, &points),
        motion: Motion::at_rest(model.unknowns(&points).map(|x| x as f32)),
        model: G::rounded(&model),
    })
}

/// Bump and, where there is one, the rack's place in the design.
fn design_of<L: Build<N, Scalar = f64>, const N: usize>(model: &L, points: &L::Points) -> [f64; 2] {
    let mut values = [0.0; 2];
    for (value, drive) in values.iter_mut().zip(model.drives_at(points).values()) {
        *value = drive;
    }
    values
}

impl<T, S, L, const N: usize> Kinematics for Solved<S, L, N>
where
    T: Real + Into<f64>,
    S: Stepper<T> + Send,
    L: Linkage<N, Scalar = T> + Send,
{
    fn step(&mut self, dt: f64, drives: &Signal<Drives>) -> Result<Hub, Refused> {
        let refused = |cause| Refused {
            drives: drives.value,
            why: Why::Solver(cause),
        };
        let [travel, rack] = self.design;
        let of = |[travel, rack]: [f64; 2]| L::Drives::from_values([travel, rack].map(T::constant));
        let inputs = Inputs::still(Signal {
            value: of([travel + drives.value.travel, rack + drives.value.rack]),
            rate: of([drives.rate.travel, drives.rate.rack]),
            second_rate: of([drives.second_rate.travel, drives.second_rate.rack]),
        });
        self.stepper
            .step(&self.model, &inputs, T::constant(dt), &mut self.motion)
            .map_err(|error| refused(error.facts().cause))?;
        let points = self.motion.points(&self.model, &inputs);
        let per_travel = Directions::new(&self.model, inputs.drives.value, &self.motion.position)
            .and_then(|directions| directions.points(of([1.0, 0.0])))
            .map_err(|error| refused(error.facts().cause))?;
        Hub::of(&self.model, &points, &per_travel).ok_or(refused(Cause::Overflow))
    }
}
