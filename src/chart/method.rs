//! What the chart asks of a method.

use nalgebra::SVector;

use super::course::Given;

/// What a step computes, each including the ones before.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Outputs {
    /// Positions.
    Position,
    /// And velocities.
    Velocity,
    /// And accelerations.
    Acceleration,
}

impl Outputs {
    /// All, from the least to the most.
    pub const ALL: [Self; 3] = [Self::Position, Self::Velocity, Self::Acceleration];

    /// The name in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Position => "position",
            Self::Velocity => "velocity",
            Self::Acceleration => "acceleration",
        }
    }

    /// The unit of its errors.
    pub fn unit(self) -> &'static str {
        match self {
            Self::Position => "m",
            Self::Velocity => "m/s",
            Self::Acceleration => "m/s²",
        }
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

    /// Suspensions that one step moves.
    const LANES: usize = 1;

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

    /// The coordinates of the free points; of lanes, those of the worst.
    fn coordinates(&self, state: &Self::State) -> Coordinates<N>;
}
