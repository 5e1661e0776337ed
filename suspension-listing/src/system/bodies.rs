//! Which body has which points.

use super::{Body, System};
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
}
