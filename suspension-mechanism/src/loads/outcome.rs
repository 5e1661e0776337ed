//! The result of a load case.

use nalgebra::Vector3;

/// The effect of a case at a place.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// The load that each drive bears: N, or N m about an angle.
    pub on_drives: Vec<f64>,
    /// The whole load in each measure that bears the load of a drive, and then in each in which springs act by their rates, as
    /// in [`Case::along`](crate::loads::Case::along): with what the case states there.
    pub in_measures: Vec<(usize, f64)>,
    /// The force in each link, N, positive in tension, by the number of its statement; for a link with a mass, the
    /// force at its middle without the contribution of spinning.
    pub links: Vec<(usize, f64)>,
    /// The force, N, that each other statement, each link with a mass, and each measure with a load exerts on each of
    /// its points, by number; a body also exerts forces on those of its markers on which measures act.
    pub joints: Vec<(By, usize, Vector3<f64>)>,
    /// The moment, N m, exerted by what drives, holds or measures each angle on each part, by number, that carries a
    /// line of the angle or its axis.
    pub moments: Vec<(By, usize, Vector3<f64>)>,
    /// The sum of the forces, N, that links, joints, measures and drives of lengths exert on each chassis point that
    /// one of them has, by number.
    pub on_chassis: Vec<(usize, Vector3<f64>)>,
    /// The largest force that acts at a point, N: from the loads, from what bears drives' loads, and from weight and
    /// inertia.
    pub largest_load: f64,
}

/// The source of a force at a joint, or of a moment on a part.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum By {
    /// The part with this number in [`Structure::statements`](crate::loads::Structure::statements).
    Part(usize),
    /// The load in the measure with this number, for example a spring's force.
    Measure(usize),
    /// The drive with this number, which drives an angle.
    Drive(usize),
}

impl Outcome {
    /// The largest internal force as a multiple of the largest applied force: unbounded where the mechanism locks.
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
