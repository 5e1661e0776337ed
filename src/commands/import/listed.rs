//! Lists in messages.

/// The most points that a message names.
pub(super) const MOST_NAMES: usize = 40;

/// Joins the descriptions of some items, no more than `most`, and counts the others; `None` if there are no items.
pub(super) fn listed<T>(
    mut items: impl Iterator<Item = T>,
    (most, between): (usize, &str),
    describe: impl Fn(T) -> String,
) -> Option<String> {
    let mut told: Vec<String> = items.by_ref().take(most).map(describe).collect();
    match items.count() {
        0 => {}
        others => told.push(format!("and {others} more")),
    }
    (!told.is_empty()).then(|| told.join(between))
}
