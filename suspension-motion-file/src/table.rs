//! Tables of a motion file.

use std::collections::BTreeMap;

use toml::Spanned;

/// Values by name, each with its place in the file.
pub type Table<V> = Spanned<BTreeMap<Spanned<String>, Spanned<V>>>;

/// Its entries, in the order of the file.
pub fn in_order<V>(table: &Table<V>) -> impl Iterator<Item = (&Spanned<String>, &Spanned<V>)> {
    let mut stated: Vec<_> = table.get_ref().iter().collect();
    stated.sort_by_key(|(name, _)| name.span().start);
    stated.into_iter()
}
