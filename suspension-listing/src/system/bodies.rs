//! The points of each body, and the points that are rigid to each other.

use super::{Body, Site, SiteMotion, System, distance_between};
use crate::name::Name;

impl System {
    /// The body that has all of some points.
    pub(crate) fn body_of(&self, points: impl IntoIterator<Item: Into<Name>>) -> Option<&Body> {
        let points: Vec<Name> = points.into_iter().map(Into::into).collect();
        let has = |body: &&Body| {
            points
                .iter()
                .all(|name| body.points().any(|site| site.name == *name))
        };
        self.bodies.iter().find(has)
    }

    /// The pairs of points of a frame whose distance neither an equation, nor a body, nor the chassis keeps. Several
    /// links together still may keep it.
    pub fn loose_pairs<'f>(&self, [a, b, c]: &'f [Site; 3]) -> Vec<[&'f Name; 2]> {
        let is_loose = |[a, b]: &[&'f Site; 2]| {
            distance_between(&self.equations, &a.name, &b.name).is_none()
                && self.body_of([a.name.clone(), b.name.clone()]).is_none()
                && [a, b]
                    .into_iter()
                    .any(|site| site.motion != SiteMotion::Anchor)
        };
        let pairs = [[a, b], [a, c], [b, c]].into_iter().filter(is_loose);
        pairs.map(|pair| pair.map(|site| &site.name)).collect()
    }
}
