//! The scatter of quantities due to that of hardpoints.

use crate::characteristics::DesignNumber;
use crate::number::{rounded, without_rounding};
use crate::tolerances::{Deviations, Sampled};

/// Digits of a sensitivity.
pub(super) const DIGITS: usize = 4;

/// The scatter of quantities.
pub(super) struct Scatter {
    pub(super) first_order: Deviations,
    /// The sample; `None` if fewer than two suspensions can be built.
    pub(super) sampled: Option<Sampled>,
    /// The requested number of suspensions, and the seed.
    pub(super) drawn: (usize, u64),
}

impl Scatter {
    /// Returns the deviations with their names in tables.
    pub(super) fn rows(&self) -> impl Iterator<Item = (&'static str, &Deviations)> {
        let sampled = self.sampled.iter();
        let sampled = sampled.map(|sampled| ("standard_deviation_of_samples", &sampled.deviations));
        [("standard_deviation", &self.first_order)]
            .into_iter()
            .chain(sampled)
    }

    /// Returns whether a number deviates by more than rounding.
    pub(super) fn changes(&self, at: &DesignNumber) -> bool {
        let mut rows = self.rows();
        rows.any(|(_, deviations)| {
            without_rounding(deviations[at.column][at.number] * at.scale) != 0.0
        })
    }

    pub(super) fn in_words(&self, at: &DesignNumber) -> String {
        let of = |deviations: &Deviations| {
            let deviation = deviations[at.column][at.number] * at.scale.abs();
            rounded(without_rounding(deviation), DIGITS)
        };
        let (count, seed) = self.drawn;
        let sampled = match &self.sampled {
            None => "no two samples can be built".to_owned(),
            Some(sampled) => {
                let built = match count - sampled.built {
                    0 => String::new(),
                    failed => format!(", {failed} of which cannot be built"),
                };
                let deviation = of(&sampled.deviations);
                format!("of {count} samples (seed {seed}{built}) {deviation}")
            }
        };
        let (first, symbol) = (of(&self.first_order), &at.symbol);
        format!("standard deviation {first} {symbol}; {sampled}")
    }
}
