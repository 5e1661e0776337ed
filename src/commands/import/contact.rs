//! The contact point of the wheel, which no layout has: it gives the wheel's radius.

use nalgebra::Vector3;

use super::hardpoints::Hardpoint;
use super::imported_corner::ImportedCorner;
use super::spelling::is_contact;
use super::stand_in::number;
use crate::number::rounded;

/// The least part of the distance from the wheel centre that is vertical: others are no contact points.
const UPRIGHT: f64 = 0.9;

/// A contact point, and the radius of the wheel that reaches it.
pub(super) struct Contact<'a> {
    pub(super) point: &'a Hardpoint,
    /// As the motion file states it.
    pub(super) radius: String,
    /// Says where the radius comes from.
    pub(super) why: String,
}

impl<'a> ImportedCorner<'a> {
    /// Returns the contact point of a corner whose wheel's radius the file does not state.
    pub(super) fn contact(&self) -> Option<Contact<'a>> {
        let Self { stated, names, .. } = self;
        let centre = self.choice.point("wheel_centre")?;
        if number(stated, names, "wheel_radius", self.corner.stated_side).is_some() {
            return None;
        }
        let mut points = self.points.iter().filter(|point| is_contact(&point.key));
        points.find_map(|point| {
            let [at, from] = [point.at, centre.at].map(Vector3::from);
            let down = self.orientation.axes.turned(from - at);
            let is_below = down.z > UPRIGHT * down.norm();
            is_below.then(|| Contact {
                point,
                radius: rounded(down.norm(), 9),
                why: format!(
                    "the distance of `{}` from {}",
                    centre.name,
                    stated.quoted(point)
                ),
            })
        })
    }
}
