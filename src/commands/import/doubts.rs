//! Doubts about the places of hardpoints, one sentence each.

use super::imported_corner::ImportedCorner;
use crate::prepare::only_on_wrong_side;

impl ImportedCorner<'_> {
    /// Notes inner ends of links and wishbones that are outboard of their outer ends.
    pub(super) fn exchanged_ends(&self) -> impl Iterator<Item = String> {
        let pairs = self.names.arrangement.outboard.iter();
        pairs.filter_map(|[outer, inner]| {
            let ends = [self.choice.point(outer)?, self.choice.point(inner)?];
            let [out, inward] = ends.map(|end| end.at[1].abs());
            let [outer, inner] =
                ends.map(|end| format!("`{}` ({})", end.name, self.stated.line(&end.place)));
            (out < inward).then(|| {
                format!(
                    "{inner} is further from the middle of the vehicle than {outer}: have they each other's names?"
                )
            })
        })
    }

    /// Notes a free point of a corner that is on the other side of the vehicle than its wheel.
    pub(super) fn point_across(&self) -> Option<String> {
        let choice = &self.choice;
        let y = self.corner.at.iter().map(|[_, y, _]| *y);
        let points = choice.found.iter().zip(y);
        let (_, centre) = points
            .clone()
            .find(|((name, _), _)| name == "wheel_centre")?;
        let points = points.map(|(point, y)| (point, y, choice.layout.is_on_chassis(&point.0)));
        let (_, point) = only_on_wrong_side(points, centre)?;
        let point = self.stated.quoted(point);
        Some(format!(
            "{point} is on the other side of the vehicle than the wheel centre: is the sign of its y right?"
        ))
    }
}
