//! Counts of operations.

/// The operations of straight-line code. A change of sign does not count.
#[derive(Clone, Copy, Default)]
pub(super) struct Operations {
    pub(super) multiplications: usize,
    pub(super) additions: usize,
    pub(super) divisions: usize,
}

impl From<(usize, usize)> for Operations {
    /// Multiplications and additions.
    fn from((multiplications, additions): (usize, usize)) -> Self {
        Self {
            multiplications,
            additions,
            divisions: 0,
        }
    }
}

impl Operations {
    pub(super) fn add(&mut self, multiplications: usize, additions: usize) {
        self.multiplications += multiplications;
        self.additions += additions;
    }
}
