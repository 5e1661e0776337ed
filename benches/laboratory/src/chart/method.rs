//! The interface of a method for the chart.

use nalgebra::SVector;

pub use suspension_core::step::bounded::Outputs;

use super::course::Given;

/// The outputs of a step, from the fewest to the most.
pub const ALL_OUTPUTS: [Outputs; 3] = [Outputs::Position, Outputs::Velocity, Outputs::Acceleration];

/// Returns the name of the last output of a step, in tables.
pub fn name_of(outputs: Outputs) -> &'static str {
    match outputs {
        Outputs::Position => "position",
        Outputs::Velocity => "velocity",
        Outputs::Acceleration => "acceleration",
    }
}

/// Returns the unit of its error.
pub fn unit_of(outputs: Outputs) -> &'static str {
    match outputs {
        Outputs::Position => "m",
        Outputs::Velocity => "m/s",
        Outputs::Acceleration => "m/s²",
    }
}

/// Position, velocity and acceleration of the free points' coordinates.
pub type Coordinates<const N: usize> = [SVector<f64, N>; 3];

/// A method that steps from one motion of a linkage to the next, with drives `D`.
pub trait Method<D, const N: usize> {
    /// The input of a step, in the method's own number type.
    type Input: Copy;
    /// A motion in the method's own coordinates.
    type State: Copy;

    /// Returns the input of a step between two instants.
    fn input(&self, from: &Given<D>, to: &Given<D>) -> Self::Input;

    /// A rest near the positions of the first instant.
    fn rest(&self, position: &SVector<f64, N>) -> Self::State;

    /// Makes one step of `dt` seconds from `from` with `input`; `None` if the method finds no configuration. Rates that
    /// `outputs` omit do not matter in the result.
    fn step(
        &self,
        outputs: Outputs,
        input: &Self::Input,
        dt: f64,
        from: &Self::State,
    ) -> Option<Self::State>;

    /// Returns the outputs that the method computes on a course whose errors are those of `outputs`: all of them, except for
    /// methods that continue from their own estimates of the omitted ones.
    fn on_the_way(&self, _outputs: Outputs) -> Outputs {
        Outputs::Acceleration
    }

    /// The coordinates of the free points.
    fn coordinates(&self, state: &Self::State) -> Coordinates<N>;
}
