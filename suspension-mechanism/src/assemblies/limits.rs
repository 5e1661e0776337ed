//! Limits of the time and the results of a search.

/// The stage of work that may take long.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// The search for the assemblies of a part with general dimensions.
    Search,
    /// The known assemblies are followed to the mechanism's own lengths.
    Follow,
}

/// Watches work that may take long. It is called before each root is followed, by several threads, with the number of
/// known assemblies of a part with general dimensions. In the search, `false` ends the search of this part, and the
/// assemblies known by then are followed to the mechanism; at the other stage, it gives everything up.
pub type Watch<'a> = dyn Fn(Stage, usize) -> bool + Sync + 'a;

/// The largest number of real assemblies that are listed. Those of the parts multiply.
pub(super) const MOST: usize = 10_000;

/// The largest number of paths in the search of a part. A steered beam axle, whose 42 unknowns are one part, takes
/// 10,000.
pub(super) const MOST_PATHS: usize = 20_000;
