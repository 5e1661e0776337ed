//! The same mechanism with two formulations of its knuckle.

use nalgebra::{SVector, Vector3};
use suspension_core::linkages::{attia2003, five_link};
use suspension_core::{Build, GeometryError, Linkage, Values};

use crate::chart::formulation::five_links::FiveLinks;
use suspension::mechanism::{Mechanism, Suspension};
use suspension_double_double::DoubleDouble;

/// The paper's list: nine distances between the points of the knuckle.
pub const NINE_DISTANCES: &str = "nine distances";

/// A body that keeps its handedness.
pub const RIGID_BODY: &str = "rigid body";

/// Both closures of a five-link suspension, and the configuration that they were built in.
pub struct Closures {
    /// The knuckle with nine distances.
    pub nine_distances: attia2003::Model<f64>,
    /// The knuckle as a rigid body.
    pub rigid_body: five_link::Model<f64>,
    /// The free points' coordinates at the start of the motion, in either formulation.
    pub start: SVector<f64, 15>,
}

impl Closures {
    /// Returns both formulations of a mechanism; `None` if it is not a five-link suspension whose knuckle has both.
    pub fn of<L: Suspension<N>, const N: usize>(mechanism: &Mechanism<L, N>) -> Option<Self> {
        let position = mechanism.start.position.map(DoubleDouble::from);
        let links = FiveLinks::<f64>::of(&mechanism.model, &position)?;
        Self::built(&links).ok()
    }

    fn built(links: &FiveLinks<f64>) -> Result<Self, GeometryError> {
        let points: attia2003::Points<f64> = points(links);
        let nine_distances = attia2003::Model::new(&points)?;
        Ok(Self {
            start: nine_distances.unknowns(&points),
            nine_distances,
            rigid_body: five_link::Model::new(&self::points(links))?,
        })
    }
}

/// Chassis ends, knuckle ends and the wheel centre, which both listings have in this order.
fn points<P: Values<Vector3<f64>>>(links: &FiveLinks<f64>) -> P {
    let knuckle = links.knuckle.map(|point| links.origin + point);
    // The wheel centre moves nothing.
    let wheel_centre = knuckle[2] + Vector3::y() * links.size();
    let chassis = links.chassis.into_iter();
    P::from_values(chassis.chain(knuckle).chain([wheel_centre]))
}
