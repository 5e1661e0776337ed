//! How long a search may take, and how much it may find.

/// Watches a search that may take long. It is called before each root is followed, by several threads, with the number of
/// assemblies that are known of a part of general lengths; `false` gives the search up.
pub type Watch<'a> = dyn Fn(usize) -> bool + Sync + 'a;

/// How many real assemblies are listed. Those of its parts multiply.
pub(super) const MOST: usize = 10_000;
