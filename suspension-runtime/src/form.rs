//! The kinds of equation, each in one place: where its points and its derivatives are. What is computed of them
//! is in [`suspension_core::constraint`].

mod body;
mod coordinate;
mod distance;
mod moving;

pub(crate) use body::Body;
pub(crate) use coordinate::Coordinate;
pub(crate) use distance::Distance;
pub(crate) use moving::Moving;

use crate::site::CHASSIS;

/// The three columns of a free site; none of a chassis point.
fn columns(site: u16) -> Option<[usize; 3]> {
    let first = usize::from(site);
    (site & CHASSIS == 0).then_some([first, first + 1, first + 2])
}
