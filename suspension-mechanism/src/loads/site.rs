//! The place at which a load acts.

use crate::mechanism::Wheel;

/// The point where a wheel touches the ground, in the names of loads.
const CONTACT: &str = "contact";

/// The site of a load.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Site {
    /// A free point, which passes the load to whatever it joins.
    Point(usize),
    /// A point of a body that these three points determine.
    Body(usize, [usize; 3]),
    /// The point where the wheel with this number touches the ground, with the wheel held by its carrier.
    Contact(usize),
}

/// The name of the point where a wheel touches the ground: `contact`, or `left_contact` for a named wheel.
pub fn contact_of(wheel: &Wheel) -> String {
    match wheel.name.as_str() {
        "" => CONTACT.to_owned(),
        name => format!("{name}_{CONTACT}"),
    }
}
