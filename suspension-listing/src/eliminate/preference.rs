//! The choice of the next pivot among the admissible entries.

use crate::random::Lcg;

/// The criteria by which an attempt chooses its pivots.
pub(super) struct Preference {
    random: Lcg,
    /// Whether entries that are ready early are preferred, for a short chain, or only cheap ones.
    early: bool,
}

impl Preference {
    /// Attempts alternate: on a large matrix short chains may cost too many operations.
    pub(super) fn new(attempt: u64) -> Self {
        Self {
            random: Lcg::new(attempt),
            early: attempt % 2 == 1,
        }
    }

    /// The rank of an entry; the one with the lowest rank is the next pivot.
    pub(super) fn rank(&mut self, markowitz: usize, ready: usize) -> (usize, u32) {
        // Near ties are worth trying too; 10 was the best value for the catalogue.
        const NEAR: u32 = 10;
        let wait = if self.early {
            ready + (self.random.next() % NEAR) as usize
        } else {
            0
        };
        (markowitz + wait, self.random.next())
    }
}
