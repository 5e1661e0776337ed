//! The rack of a layout: whether it steers, and the statements of the layout without a rack of its own.

use super::hardpoints::{Hardpoint, Hardpoints};
use crate::vehicle_corner::End;

/// The point of a layout at the inner end of its tie rod.
pub(super) const RACK: &str = "rack";

/// How the catalogue's listings state it and its drive.
const FIXED_RACK: &str = "fixed: rack at";
const FREE_RACK: &str = "free:  rack at";
const STEER: &str = "/// Lateral position of the rack.\ndrive steer: rack.y;\n";

/// Says why the inner end of a tie rod or toe link does not steer; `None` if it does. A point whose name has the word `rack`
/// always steers. Others do not in the table of a rear suspension, nor where the table does not say which axle it is of and the
/// name is that of a toe link.
pub(super) fn why_fixed(inner: &Hardpoint, stated: &Hardpoints<'_>) -> Option<String> {
    if inner.key.split('_').any(|word| word == RACK) {
        return None;
    }
    match stated.end() {
        Some((End::Rear, why)) => Some(why),
        Some((End::Front, _)) => None,
        None => {
            let is_toe_link = inner.key.starts_with("toe");
            is_toe_link.then(|| "front axles have a tie rod instead".to_owned())
        }
    }
}

/// Returns whether a layout has a rack that steers.
pub(super) fn steers(layout: &str) -> bool {
    layout.contains(STEER)
}

/// Returns a layout whose rack stays in its place.
pub(super) fn fixed(layout: &str) -> String {
    layout.replace(STEER, "")
}

/// Returns a layout whose rack is moved by the listing that includes it.
pub(super) fn shared(layout: &str) -> String {
    fixed(layout).replace(FIXED_RACK, FREE_RACK)
}

/// Returns the statements of a layout without their coordinates, which are in metres, and without the comment at their top.
pub(super) fn without_places(text: &str) -> String {
    let statements = text.lines().skip_while(|line| line.starts_with("//!"));
    let unplaced = statements.map(|line| {
        let mut line = line.to_owned();
        while let Some(at) = line.find(" at [") {
            let end = line[at..].find(']').map_or(line.len(), |end| at + end + 1);
            line.replace_range(line[..at].trim_end().len()..end, "");
        }
        line + "\n"
    });
    unplaced.collect()
}

#[cfg(test)]
mod tests {
    use suspension_core::linkages::LISTINGS;

    use super::*;

    /// A layout in other words would keep its drive.
    #[test]
    fn every_layout_with_a_rack_has_the_statements_that_are_replaced() {
        let with_rack = LISTINGS.iter().filter(|(_, text)| text.contains("rack at"));
        let mut count = 0;
        for (linkage, text) in with_rack {
            assert_ne!(fixed(text), *text, "{linkage}");
            assert_ne!(shared(text), fixed(text), "{linkage}");
            count += 1;
        }
        assert!(count > 5, "{count}");
    }
}
