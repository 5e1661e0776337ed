//! A corner in the design, at rest: its height on the tyre, and the force in its spring.

use nalgebra::Vector3;

use crate::contact::Contact;
use crate::kinematics::Hub;
use crate::saloon::{Axle, GRAVITY};
use crate::strut::Strut;
use crate::tyre::Tyre;

/// Returns the height of the origin of the hub's axes above the ground at which the tyre bears a load along the normal, m.
pub fn clearance(hub: &Hub, tyre: &Tyre, load: f64) -> f64 {
    let upright = Contact::new(0.0, Vector3::z(), hub.axis, tyre.radius).upright;
    let deflection = load * upright / tyre.stiffness;
    (tyre.radius - deflection) * upright - hub.centre.value.z
}

/// The strut whose spring holds the wheel under that load: its work, the tyre's and the weight's sum to nothing along the travel.
pub fn strut(hub: &Hub, axle: &Axle, tyre: &Tyre, clearance: f64) -> Strut {
    let height = clearance + hub.centre.value.z;
    let contact = Contact::new(height, Vector3::z(), hub.axis, tyre.radius);
    let ground = contact.along_normal(tyre.load(contact.deflection, 0.0));
    let per_travel = hub.per_travel;
    let at_contact = per_travel.centre + per_travel.turn.cross(&contact.arm);
    let weight = axle.unsprung_mass * GRAVITY * per_travel.centre.z;
    let force = (weight - at_contact.dot(&ground)) / per_travel.strut;
    axle.strut(force, hub.strut[0])
}
