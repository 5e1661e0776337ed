//! The force on the chassis at each of its points, the sum of all parts that are joined there.

use nalgebra::Vector3;

use crate::loads::{By, Outcome, Structure};

impl Structure<'_> {
    /// The forces on chassis points of the links and joints of an outcome, and `by_actuators` on all points.
    pub(super) fn on_chassis(
        &self,
        outcome: &Outcome,
        by_actuators: &[Vec<Vector3<f64>>],
        at: &[Vector3<f64>],
    ) -> Vec<(usize, Vector3<f64>)> {
        let joints = outcome.joints.iter();
        let by_joints = joints.map(|(_, point, force)| (*point, *force));
        // A link that bears more than tension is one of the joints.
        let is_joint = |number: usize| {
            let mut joints = outcome.joints.iter();
            joints.any(|(by, ..)| *by == By::Part(number))
        };
        let links = outcome.links.iter();
        let pulling = links.filter(|(number, _)| !is_joint(*number));
        let by_links = pulling.flat_map(|(number, tension)| self.pull(*number, *tension, at));
        let actuators = self.actuators.iter().zip(by_actuators);
        let by_actuators = actuators.flat_map(|(actuator, by)| {
            let points = actuator.points.iter();
            points.map(|point| (*point, by[*point]))
        });
        let all = by_joints.chain(by_links).chain(by_actuators);
        let mut together = vec![None; self.chassis];
        for (point, force) in all.filter(|(point, _)| *point < self.chassis) {
            *together[point].get_or_insert_with(Vector3::zeros) += force;
        }
        let together = together.into_iter().enumerate();
        together
            .filter_map(|(point, force)| Some((point, force?)))
            .collect()
    }

    /// The forces of a link in tension on its ends.
    fn pull(
        &self,
        number: usize,
        tension: f64,
        at: &[Vector3<f64>],
    ) -> impl Iterator<Item = (usize, Vector3<f64>)> {
        let ends = self.statements[number].ends().into_iter();
        let forces = ends.map(move |[from, to]| {
            let force = (at[to] - at[from]).normalize() * tension;
            [(from, force), (to, -force)]
        });
        forces.flatten()
    }
}
