//! Links to a wheel's carrier whose ends seem to have each other's places.

use nalgebra::Vector3;
use suspension_core::Values;
use suspension_runtime::Listing;

use crate::mechanism::Wheel;
use crate::prepare::task::Task;

/// Notes on lateral links from the chassis to the carrier of one wheel, such as tie rods, whose inner ends are further
/// from the middle of the vehicle than their outer ends. Links of a live axle may well be so.
pub(in crate::prepare) fn notes<P: Values<Vector3<f64>>>(
    task: &Task<'_>,
    listing: &Listing,
    given: &P,
) -> Vec<String> {
    let names = &task.names;
    let at: Vec<Vector3<f64>> = given.values().collect();
    let of_wheels = on_carriers(&names.wheels, listing);
    let links = listing.parts().filter_map(|part| {
        let [from, to] = part.ends()?;
        let ends = [from.min(to), from.max(to)]; // chassis points are the first of all points
        Some((part.name, ends))
    });
    let to_wheels =
        links.filter(|(_, [inner, outer])| *inner < names.chassis && of_wheels.contains(outer));
    let exchanged = to_wheels.filter(|(_, [inner, outer])| {
        let along = at[*outer] - at[*inner];
        let [inner, outer] = [inner, outer].map(|end| task.y_in_file(&at[*end]));
        let is_lateral = along.y.abs() > along.xz().norm();
        is_lateral && inner * outer > 0.0 && inner.abs() > outer.abs()
    });
    let notes = exchanged.map(|(link, ends)| {
        let [inner, outer] = ends.map(|end| &names.points[end]);
        format!(
            "`{inner}`, the inner end of `{link}`, is further from the middle of the vehicle than its outer end `{outer}`: have they each \
             other's coordinates?"
        )
    });
    notes.collect()
}

/// The points of bodies that carry one wheel.
fn on_carriers(wheels: &[Wheel], listing: &Listing) -> Vec<usize> {
    let carries_one = |body: &Vec<usize>| {
        let mut carried = (0..wheels.len()).filter(|wheel| {
            let mut carrier = wheels[*wheel].points.carrier.iter();
            carrier.all(|point| body.contains(point))
        });
        carried.next().is_some() && carried.next().is_none()
    };
    let bodies = listing.bodies().into_iter();
    bodies.filter(carries_one).flatten().collect()
}
