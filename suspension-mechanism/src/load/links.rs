//! The lengths of links.

use suspension_runtime::Listing;

use crate::mechanism::Names;

/// The links of a listing, each with the number of its length.
pub(super) struct Links<'l>(pub(super) Vec<(&'l str, usize)>);

impl<'l> Links<'l> {
    pub(super) fn of(listing: &'l Listing, names: &Names) -> Self {
        let statements = listing.statements().into_iter();
        let links = statements.filter(|statement| statement.kind == "link");
        let number = |link: &str| names.lengths.iter().position(|length| length == link);
        Self(
            links
                .filter_map(|link| Some((link.name, number(link.name)?)))
                .collect(),
        )
    }

    pub(super) fn names(&self) -> impl Iterator<Item = &'l str> {
        self.0.iter().map(|(name, _)| *name)
    }

    /// The number of a link's length.
    pub(super) fn length(&self, name: &str) -> Option<usize> {
        let mut links = self.0.iter();
        links
            .find(|(link, _)| *link == name)
            .map(|(_, length)| *length)
    }
}
