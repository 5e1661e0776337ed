//! Which of the admissible entries an attempt prefers as the next pivot.

/// What an attempt goes by in its choice of pivots.
pub(super) struct Preference {
    random: Lcg,
    /// Whether entries that are ready early are preferred, for a short chain, or cheap ones alone.
    early: bool,
}

impl Preference {
    /// Attempts take turns: on a large matrix short chains may cost too many operations.
    pub(super) fn of(attempt: u64) -> Self {
        Self {
            random: Lcg(attempt),
            early: attempt % 2 == 1,
        }
    }

    /// The entry with the lowest rank is the next pivot.
    pub(super) fn rank(&mut self, markowitz: usize, ready: usize) -> (usize, u32) {
        // Near ties are worth trying too; 10 was found best on the catalogue.
        const NEAR: u32 = 10;
        let wait = if self.early {
            ready + (self.random.next() % NEAR) as usize
        } else {
            0
        };
        (markowitz + wait, self.random.next())
    }
}

/// A linear congruential generator (Knuth's MMIX constants): the same order at every expansion.
struct Lcg(u64);

impl Lcg {
    fn next(&mut self) -> u32 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 40) as u32
    }
}
