//! How far the mechanisms came.

/// How far a case came.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Reached {
    /// Cases.
    pub(crate) tried: usize,
    /// Those whose geometry makes a linkage.
    pub(crate) built: usize,
    /// Those that found a configuration.
    pub(crate) assembled: usize,
    /// Steps that were made.
    pub(crate) stepped: usize,
    /// Steps that were refused.
    pub(crate) refused: usize,
}

impl Reached {
    /// Adds the counts of others.
    pub(crate) fn add(&mut self, other: Self) {
        self.tried += other.tried;
        self.built += other.built;
        self.assembled += other.assembled;
        self.stepped += other.stepped;
        self.refused += other.refused;
    }

    pub(super) fn not_built() -> Self {
        Self {
            tried: 1,
            ..Self::default()
        }
    }

    pub(super) fn count<T, E>(&mut self, step: &Result<T, E>) {
        match step {
            Ok(_) => self.stepped += 1,
            Err(_) => self.refused += 1,
        }
    }
}
