//! A state in numbers that have first derivatives with respect to several drives.

use nalgebra::Vector3;

use crate::dual::Dual;
use crate::mechanism::derivatives::positions::Positions;
use crate::mechanism::points::Points;
use crate::mechanism::state::State;

/// The number of drives with respect to which a [`Gradient`] has derivatives: travel and steering.
pub const DRIVES_AT_ONCE: usize = 2;

/// A number with its first derivatives with respect to some consecutive drives; NaN if they are not known.
pub type Gradient = Dual<f64, DRIVES_AT_ONCE>;

/// A state with first derivatives with respect to some drives.
pub(crate) struct Graded<'a> {
    /// The state, with velocities and without rates.
    pub(crate) state: &'a State,
    /// The derivatives of the points, by drive.
    pub(crate) points: [Points; DRIVES_AT_ONCE],
    /// The derivatives of the measures.
    pub(crate) measures: [Vec<f64>; DRIVES_AT_ONCE],
    /// The derivatives of the state's velocities.
    pub(crate) velocities: Vec<Option<[Points; DRIVES_AT_ONCE]>>,
}

impl Positions<Gradient> for Graded<'_> {
    fn point(&self, point: usize) -> Vector3<Gradient> {
        gradient(&self.state.points.value, &self.points, point)
    }

    fn measure(&self, measure: usize) -> Gradient {
        Dual {
            value: self.state.measures.value[measure],
            rates: self.measures.each_ref().map(|rates| rates[measure]),
        }
    }

    fn velocity(&self, point: usize, drive: usize) -> Option<Vector3<Gradient>> {
        let velocities = &self.state.moved_by(drive)?.value;
        let rates = self.velocities.get(drive)?.as_ref()?;
        Some(gradient(velocities, rates, point))
    }
}

/// One of some vectors with its derivatives.
fn gradient(values: &Points, rates: &[Points; DRIVES_AT_ONCE], number: usize) -> Vector3<Gradient> {
    let rates = rates.each_ref().map(|rates| rates[number]);
    let component = |axis: usize| Dual {
        value: values[number][axis],
        rates: rates.map(|rate| rate[axis]),
    };
    Vector3::new(component(0), component(1), component(2))
}
