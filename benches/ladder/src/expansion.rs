//! The expansion of a listing by the macro's own code: its time, and the figures in the header of the generated module.

use std::time::Instant;
use suspension_listing::include::NoIncludes;

use proc_macro2::TokenStream;
use suspension_listing::{order, text};

use crate::median::median;
use crate::{expand, listing};

/// The time and the results of an expansion.
pub(crate) struct Expansion {
    pub(crate) unknowns: usize,
    pub(crate) non_zeros: usize,
    pub(crate) factor_non_zeros: usize,
    pub(crate) factor_chain: usize,
    /// Operations of residual, factorisation and solution.
    pub(crate) operations: [usize; 3],
    pub(crate) expansion_s: f64,
    pub(crate) order_s: f64,
}

impl Expansion {
    /// The median of three expansions of the ladder of `bodies` bodies.
    pub(crate) fn of(bodies: usize) -> Result<Self, String> {
        let statements = listing::statements(bodies);
        let module = format!("[::suspension_core] pub mod ladder {{ {statements} }}");
        let tokens: TokenStream = module.parse().map_err(|error| format!("{error}"))?;
        let expansion = expand::expand(tokens.clone()).to_string();
        let header = Header(&expansion);
        let expansion_s = seconds(|| drop(expand::expand(tokens.clone())));
        let system = text::read(&statements, &NoIncludes).system;
        let system = system.ok_or("the ladder's statements cannot be read")?;
        let order_s = seconds(|| drop(order(&system)));
        Ok(Self {
            unknowns: system.size(),
            non_zeros: header.number_before("non-zeros of")?,
            factor_non_zeros: header.number_before("are stored of its factors")?,
            factor_chain: header.number_after("in the factorisation is")?,
            operations: [
                header.operations("residual")?,
                header.operations("factor")?,
                header.operations("solve")?,
            ],
            expansion_s,
            order_s,
        })
    }
}

fn seconds(work: impl Fn()) -> f64 {
    median([(); 3].map(|()| {
        let start = Instant::now();
        work();
        start.elapsed().as_secs_f64()
    }))
}

/// The text of an expansion, of which the docs are read.
struct Header<'a>(&'a str);

impl Header<'_> {
    fn number_before(&self, words: &str) -> Result<usize, String> {
        let before = self.0.split_once(words).map(|(before, _)| before);
        number(
            before.and_then(|text| text.split_whitespace().next_back()),
            words,
        )
    }

    fn number_after(&self, words: &str) -> Result<usize, String> {
        let after = self.0.split_once(words).map(|(_, after)| after);
        let digits = |text: &'_ str| text.trim_start().find(|c: char| !c.is_ascii_digit());
        let after = after.map(str::trim_start);
        number(after.and_then(|text| text.get(..digits(text)?)), words)
    }

    /// The sum of a row of the table of operations.
    fn operations(&self, what: &str) -> Result<usize, String> {
        let row = format!("| {what} |");
        let row = self
            .0
            .split_once(&row)
            .and_then(|(_, after)| after.split_once('"'));
        let (cells, _) = row.ok_or_else(|| format!("the header does not count `{what}`"))?;
        Ok(cells
            .split('|')
            .filter_map(|cell| cell.trim().parse::<usize>().ok())
            .sum())
    }
}

fn number(text: Option<&str>, words: &str) -> Result<usize, String> {
    text.and_then(|text| text.parse().ok())
        .ok_or_else(|| format!("the header has no number at `{words}`"))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A run of the program takes minutes, because it calls cargo; this is the part that depends on the words of a header.
    #[test]
    fn the_figures_of_an_expansion_are_read_from_its_header() {
        let expansion = Expansion::of(1).expect("figures");
        assert_eq!(expansion.unknowns, 9, "three points of a body");
        let counts = [
            expansion.non_zeros,
            expansion.factor_non_zeros,
            expansion.factor_chain,
        ];
        assert!(
            counts
                .iter()
                .chain(&expansion.operations)
                .all(|count| *count > 0)
        );
    }
}
