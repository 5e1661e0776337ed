//! Limits of the time and the results of a search.

/// What work that may take long is at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// It looks for the assemblies of a part of general dimensions.
    Search,
    /// It follows those that it knows to the mechanism's own lengths.
    Follow,
}

/// Watches work that may take long. It is called before each root is followed, by several threads, with the number of
/// assemblies that are known of a part of general dimensions. `false` ends the search of this part, and what it knows is followed
/// to the mechanism; at the other stage it gives all up.
pub type Watch<'a> = dyn Fn(Stage, usize) -> bool + Sync + 'a;

/// How many real assemblies are listed. Those of its parts multiply.
pub(super) const MOST: usize = 10_000;

/// How many paths the search of a part follows at most. A steered beam axle, of 42 unknowns that are one part, takes 10,000.
pub(super) const MOST_PATHS: usize = 20_000;
