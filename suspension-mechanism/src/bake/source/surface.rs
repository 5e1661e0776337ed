//! A surface of two drives as a file.

mod c;
mod rust;
mod toml;

use crate::bake::certify::SAMPLES;
use crate::bake::scheme::TERMS;
use crate::bake::source::about::row;
use crate::bake::source::{Language, Titled, bound, tolerance};
use crate::bake::surface::BakedSurface;

/// The data from which the text of a surface is written.
struct SurfaceFile<'a> {
    titled: Titled<'a>,
    baked: &'a BakedSurface,
}

pub(super) fn text(titled: Titled<'_>, baked: &BakedSurface, language: Language) -> String {
    let file = SurfaceFile { titled, baked };
    match language {
        Language::Rust => rust::text(&file),
        Language::C => c::text(&file),
        Language::Toml => toml::text(&file),
    }
}

impl SurfaceFile<'_> {
    /// The information for a reader, line by line.
    fn header(&self) -> Vec<String> {
        let Self { titled, baked } = self;
        let Titled { about, outputs, .. } = titled;
        let unit = about.unit.symbol();
        let joined = if baked.wanted.smooth {
            "position and first derivatives"
        } else {
            "position"
        };
        let [along, across] = baked.counts;
        let bytes = along * across * TERMS * TERMS * outputs.len() * size_of::<f64>();
        let degree = TERMS - 1;
        let drives = about.arguments.iter().zip(baked.reached.first);
        let slopes: Vec<_> = drives
            .map(|(drive, within)| {
                format!("{} {unit}/{} by {}", bound(within), drive.unit, drive.name)
            })
            .collect();
        let mut lines = about.header(&baked.outputs);
        lines.extend([
            format!("Continuous where patches join: {joined}."),
            tolerance(baked.wanted.tolerance, baked.reached.position, unit),
            format!("First derivative within {}.", slopes.join(", within ")),
            format!("Checked against the solver at {SAMPLES} x {SAMPLES} Chebyshev points a patch; a bound for smooth motions, not a proof."),
            format!("{along} x {across} patches of degree {degree} in each drive, {bytes} bytes."),
        ]);
        lines
    }

    /// The coefficients with those of one power of both drives per line, in the brackets of a language.
    fn coefficients(&self, brackets: [&str; 2]) -> String {
        let [open, close] = brackets;
        let patch = |patch: &Vec<[[[f64; 3]; TERMS]; TERMS]>| {
            let line = |first: usize, second: usize| {
                let numbers: Vec<f64> = patch.iter().flat_map(|of| of[first][second]).collect();
                format!("            {},\n", row(&numbers, brackets))
            };
            let of_first = |first: usize| {
                let lines: String = (0..TERMS).map(|second| line(first, second)).collect();
                format!("        {open}\n{lines}        {close},\n")
            };
            let rows: String = (0..TERMS).map(of_first).collect();
            format!("    {open}\n{rows}    {close},\n")
        };
        self.baked.patches.iter().map(patch).collect()
    }
}
