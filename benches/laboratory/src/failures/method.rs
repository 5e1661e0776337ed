//! The methods that step from one configuration to another, or start from a rough guess.

use nalgebra::SVector;
use suspension_core::solve::motion::Prescribed;
use suspension_core::{Build, Inputs, Motion, Newton, Real, Still, Tracker, assemble};

use super::integration::runge_kutta;
use super::marquardt::{Number, end_of_descent};

/// A method of the failure map.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// Newton's method from the last configuration, without safeguards.
    Plain,
    /// Newton's method, corrections halved until the residual falls.
    Damped,
    /// Least squares, by another library.
    Marquardt,
    /// The core's assembly from a rough guess.
    Assembled,
    /// The core's tracker, in as many steps as its guard asks for.
    Tracked,
    /// The core's tracker in a single step.
    Stepped,
    /// The tracker without bounds on corrections and on the change of the Jacobian, and without memory of the determinant's
    /// sign; mirrored bodies are still refused.
    Unguarded,
    /// Velocities integrated by the method of Runge and Kutta.
    Integrated,
    /// Integration with each step projected onto the constraints by Newton's method.
    Projected,
}

/// The step from an instant to another: the inputs as a function of time, and the two times.
pub struct Step<'a, T, D> {
    /// The prescribed quantities at a time.
    pub inputs: &'a dyn Fn(T) -> Inputs<Still, D>,
    /// Start and end, s.
    pub times: [T; 2],
}

impl Method {
    /// All methods in the order of tables and figures.
    pub const ALL: [Self; 9] = [
        Self::Plain,
        Self::Damped,
        Self::Marquardt,
        Self::Assembled,
        Self::Integrated,
        Self::Projected,
        Self::Unguarded,
        Self::Stepped,
        Self::Tracked,
    ];

    /// Returns the name in tables and figures.
    pub fn name(self) -> &'static str {
        match self {
            Self::Plain => "plain Newton",
            Self::Damped => "damped Newton",
            Self::Marquardt => "Levenberg-Marquardt",
            Self::Assembled => "assemble",
            Self::Tracked => "tracker, own steps",
            Self::Stepped => "tracker, one step",
            Self::Unguarded => "tracker, no guard",
            Self::Integrated => "RK4",
            Self::Projected => "RK4 and projection",
        }
    }

    /// Returns whether the method can start near the motion; the others continue from their last result.
    pub fn takes_guesses(self) -> bool {
        !matches!(self, Self::Tracked | Self::Integrated | Self::Projected)
    }

    /// Returns the configuration at the end of a step that begins at `start`; `None` if the method reports that it finds
    /// none.
    pub fn step<T, L, const N: usize>(
        self,
        linkage: &L,
        step: &Step<'_, T, L::Drives>,
        start: &Motion<T, N>,
    ) -> Option<Motion<T, N>>
    where
        T: Number,
        L: Build<N, Scalar = T>,
    {
        let Step { inputs, times } = step;
        let [from, to] = *times;
        match self {
            Self::Plain => solved(plain(), linkage, &inputs(to), start.position),
            Self::Damped => solved(Newton::from_afar(), linkage, &inputs(to), start.position),
            Self::Marquardt => descended(linkage, &inputs(to), &start.position),
            Self::Assembled => {
                let mut q = start.position;
                let found = assemble(&Newton::from_afar(), linkage, &inputs(to), &mut q);
                found.ok().map(|_| Motion::at_rest(q))
            }
            Self::Tracked => {
                let mut motion = *start;
                let advanced = Tracker::default().advance(linkage, inputs, from, to, &mut motion);
                advanced.ok().map(|_| motion)
            }
            Self::Stepped => tracked(&Tracker::default(), linkage, step, *start),
            Self::Unguarded => {
                let forgetful = Motion {
                    positive_determinant: None,
                    ..*start
                };
                tracked(&unguarded(), linkage, step, forgetful)
            }
            Self::Integrated => runge_kutta(linkage, inputs, *times, &start.position)
                .ok()
                .map(Motion::at_rest),
            Self::Projected => {
                let q = runge_kutta(linkage, inputs, *times, &start.position).ok()?;
                solved(plain(), linkage, &inputs(to), q)
            }
        }
    }
}

fn plain<T: Real>() -> Newton<T> {
    Newton {
        max_halvings: 0,
        ..Newton::from_afar()
    }
}

fn unguarded<T: Real>() -> Tracker<T> {
    // Finite in every number type: infinity times a move of zero would not be a number.
    let boundless = T::constant(f64::from(f32::MAX));
    Tracker {
        newton: plain(),
        correction_of_move: boundless,
        correction_of_size: boundless,
        change_of_jacobian: boundless,
        ..Tracker::default()
    }
}

fn solved<T: Real, L: Build<N, Scalar = T>, const N: usize>(
    newton: Newton<T>,
    linkage: &L,
    inputs: &Inputs<Still, L::Drives>,
    mut q: SVector<T, N>,
) -> Option<Motion<T, N>> {
    let converged = newton.solve(linkage, inputs, &mut q);
    converged.ok().map(|_| Motion::at_rest(q))
}

fn tracked<T: Real, L: Build<N, Scalar = T>, const N: usize>(
    tracker: &Tracker<T>,
    linkage: &L,
    step: &Step<'_, T, L::Drives>,
    mut motion: Motion<T, N>,
) -> Option<Motion<T, N>> {
    let [from, to] = step.times;
    let converged = tracker.step(linkage, &(step.inputs)(to), to - from, &mut motion);
    converged.ok().map(|_| motion)
}

/// Returns the result of the least-squares solver, if it is a root by the measure of the other methods.
fn descended<T: Number, L: Build<N, Scalar = T>, const N: usize>(
    linkage: &L,
    inputs: &Inputs<Still, L::Drives>,
    start: &SVector<T, N>,
) -> Option<Motion<T, N>> {
    let prescribed = Prescribed::new(linkage, inputs);
    let q = end_of_descent(linkage, &prescribed, start);
    let is_root = Newton::from_afar().is_root(linkage, inputs, &q);
    is_root.then(|| Motion::at_rest(q))
}
