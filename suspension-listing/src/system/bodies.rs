//! Which body has which points, and which points are rigid to each other.

use super::{Body, Site, SiteMotion, System, distance_between};
use crate::name::Name;

impl System {
    /// The body that has all of some points.
    pub fn body_of(&self, points: &[Name]) -> Option<&Body> {
        let has = |body: &&Body| {
            points
                .iter()
                .all(|name| body.points().any(|site| site.name == *name))
        };
        self.bodies.iter().find(has)
    }

    /// Two points of a frame whose distance nothing keeps: no equation, no body, and not the chassis.
    pub fn loose_pair<'f>(&self, [a, b, c]: &'f [Site; 3]) -> Option<[&'f Name; 2]> {
        let is_loose = |[a, b]: &[&Site; 2]| {
            distance_between(&self.equations, &a.name, &b.name).is_none()
                && self.body_of(&[a.name.clone(), b.name.clone()]).is_none()
                && [a, b]
                    .into_iter()
                    .any(|site| site.motion != SiteMotion::Anchor)
        };
        let mut pairs = [[a, b], [a, c], [b, c]].into_iter();
        pairs.find(is_loose).map(|pair| pair.map(|site| &site.name))
    }
}
