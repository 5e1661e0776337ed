//! The interface of a method for the chart.

use nalgebra::SVector;

pub use suspension_core::step::bounded::Outputs;

use super::course::Given;

/// What a step can compute, from the least to the most.
pub const ALL_OUTPUTS: [Outputs; 3] = [Outputs::Position, Outputs::Velocity, Outputs::Acceleration];

/// The name of what a step computes last, in tables.
pub fn name_of(outputs: Outputs) -> &'static str {
    match outputs {
        Outputs::Position => "position",
        Outputs::Velocity => "velocity",
        Outputs::Acceleration => "acceleration",
    }
}

/// The unit of its error.
pub fn unit_of(outputs: Outputs) -> &'static str {
    match outputs {
        Outputs::Position => "m",
        Outputs::Velocity => "m/s",
        Outputs::Acceleration => "m/s²",
    }
}

/// Position, velocity and acceleration of the free points' coordinates.
pub type Coordinates<const N: usize> = [SVector<f64, N>; 3];

/// A way to step from one motion of a linkage to the next, with drives `D`.
pub trait Method<D, const N: usize> {
    /// What a step is given, in the method's own number type.
    type Input: Copy;
    /// A motion in the method's own coordinates.
    type State: Copy;

    /// What a step between two instants is given.
    fn input(&self, from: &Given<D>, to: &Given<D>) -> Self::Input;

    /// A rest near the positions of the first instant.
    fn rest(&self, position: &SVector<f64, N>) -> Self::State;

    /// One step of `dt` seconds from `from` by `input`; `None` where the method finds no
    /// configuration. What `outputs` leave out is of no account in the result.
    fn step(
        &self,
        outputs: Outputs,
        input: &Self::Input,
        dt: f64,
        from: &Self::State,
    ) -> Option<Self::State>;

    /// What is computed on the way through a course whose errors are those of `outputs`: everything,
    /// but by methods that go on from their own estimates of what they leave out.
    fn on_the_way(&self, _outputs: Outputs) -> Outputs {
        Outputs::Acceleration
    }

    /// The coordinates of the free points.
    fn coordinates(&self, state: &Self::State) -> Coordinates<N>;
}
