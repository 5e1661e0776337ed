//! The place at which a load acts.

use crate::mechanism::Wheel;

/// Where a wheel touches the ground, in the names of loads.
const CONTACT: &str = "contact";

/// Where a load acts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Site {
    /// At a free point, which passes the load to whatever it joins.
    Point(usize),
    /// At a point of a body that these three points determine.
    Body(usize, [usize; 3]),
    /// Where a wheel by this number touches the ground, the wheel being held by its carrier.
    Contact(usize),
}

/// The name of the place where a wheel touches the ground: `contact`, or of a named wheel `left_contact`.
pub fn contact_of(wheel: &Wheel) -> String {
    match wheel.name.as_str() {
        "" => CONTACT.to_owned(),
        name => format!("{name}_{CONTACT}"),
    }
}
