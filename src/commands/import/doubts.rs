//! Doubts about the places of hardpoints, one sentence each.

use super::imported_corner::ImportedCorner;

impl ImportedCorner<'_> {
    /// Notes inner ends of links and wishbones that are outboard of their outer ends.
    pub(super) fn exchanged_ends(&self) -> impl Iterator<Item = String> {
        let pairs = self.names.arrangement.outboard.iter();
        pairs.filter_map(|[outer, inner]| {
            let ends = [self.choice.point(outer)?, self.choice.point(inner)?];
            let [out, inward] = ends.map(|end| end.at[1].abs());
            let [outer, inner] = ends.map(|end| self.stated.quoted(end));
            (out < inward).then(|| {
                format!(
                    "{inner} is further from the middle of the vehicle than {outer}: have they each other's names?"
                )
            })
        })
    }
}
