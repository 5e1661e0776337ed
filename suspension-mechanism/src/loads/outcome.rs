//! The result of a load case.

use nalgebra::Vector3;

/// What a case does at a place.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// What each drive bears: N, or N m about an angle.
    pub on_drives: Vec<f64>,
    /// All that acts in each measure that bears the load of a drive, as in [`Case::along`](crate::loads::Case::along): what it bears, and what
    /// the case states there.
    pub in_measures: Vec<(usize, f64)>,
    /// The force in each link, N, positive in tension, by the number of its statement; of a link with a mass at its middle,
    /// but for what spinning adds.
    pub links: Vec<(usize, f64)>,
    /// The force, N, that each other statement, each link with a mass, and each measure in which something acts exerts on each of
    /// its points, by number; of a body also on those of its markers on which measures act.
    pub joints: Vec<(By, usize, Vector3<f64>)>,
    /// The moment, N m, that what drives, holds or measures each angle exerts on each part, by number, that carries a line of it or
    /// its axis.
    pub moments: Vec<(By, usize, Vector3<f64>)>,
    /// The force, N, that links, joints, measures and drives of lengths exert together on each chassis point that one of them
    /// has, by number.
    pub on_chassis: Vec<(usize, Vector3<f64>)>,
    /// The largest force that acts at a point, N: of the loads, of what bears drives' loads, of weight and inertia.
    pub largest_load: f64,
}

/// What exerts a force at a joint, or a moment on a part.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum By {
    /// The part of this number, of [`Structure::statements`](crate::loads::Structure::statements).
    Part(usize),
    /// What acts in the measure of this number, a spring's force say.
    Measure(usize),
    /// The drive of this number, of an angle.
    Drive(usize),
}

impl Outcome {
    /// How many times the largest force that acts the largest one inside is: without bound where the mechanism locks.
    pub fn amplification(&self) -> f64 {
        let links = self.links.iter().map(|(_, tension)| tension.abs());
        let joints = self.joints.iter().map(|(.., force)| force.norm());
        let largest = links.chain(joints).fold(0.0, f64::max);
        if largest == 0.0 {
            0.0
        } else {
            largest / self.largest_load
        }
    }
}
