//! Tables of a motion file.

use std::collections::BTreeMap;

use toml::Spanned;

/// Values by name, each with its place in the file.
pub type Table<V> = Spanned<BTreeMap<Spanned<String>, Spanned<V>>>;
