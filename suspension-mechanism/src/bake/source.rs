//! A baked motion as a file that people read and compilers take.

mod about;
mod c;
mod curve;
mod rust;
mod surface;

use std::path::Path;

use crate::bake::driven::Output;
use crate::bake::fit::Baked;
use crate::bake::surface::BakedSurface;
use crate::number::{counted, rounded};

pub use about::{About, Ranged};

/// The language of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Language {
    /// A `static` of `suspension_core::baked::Curve` or `Surface`.
    Rust,
    /// A header in C99 with a function that evaluates.
    C,
    /// The numbers alone.
    Toml,
}

impl Language {
    /// The ending of a file's name.
    pub fn extension(self) -> &'static str {
        match self {
            Self::Rust => "rs",
            Self::C => "h",
            Self::Toml => "toml",
        }
    }
}

/// A baked motion and what its numbers mean.
#[derive(Clone, Debug)]
pub struct Sheet {
    /// What the numbers mean.
    pub about: About,
    /// The numbers.
    pub baked: Table,
}

/// The numbers of a baked motion.
#[derive(Clone, Debug)]
pub enum Table {
    /// Of one drive.
    Curve(Baked),
    /// Of two drives.
    Surface(BakedSurface),
}

impl Table {
    fn outputs(&self) -> &[Output] {
        match self {
            Self::Curve(baked) => &baked.outputs,
            Self::Surface(baked) => &baked.outputs,
        }
    }

    /// How many polynomials there are, in words.
    pub fn count_in_words(&self) -> String {
        match self {
            Self::Curve(baked) => counted(baked.segments.len(), "segment"),
            Self::Surface(BakedSurface { counts, .. }) => {
                format!("{} x {} patches", counts[0], counts[1])
            }
        }
    }
}

impl Sheet {
    /// What by which drives.
    pub fn subject(&self) -> String {
        self.about.subject(self.baked.outputs())
    }

    /// The text of a file at a path.
    pub fn text(&self, language: Language, path: &Path) -> String {
        let Self { about, baked } = self;
        let titled = Titled {
            about,
            name: about.name(baked.outputs(), path),
            outputs: about::output_names(baked.outputs()),
        };
        match baked {
            Table::Curve(baked) => curve::text(titled, baked, language),
            Table::Surface(baked) => surface::text(titled, baked, language),
        }
    }
}

/// What a file has of a table of either kind.
struct Titled<'a> {
    about: &'a About,
    /// The table's name.
    name: String,
    /// The numbers' names, in order.
    outputs: Vec<String>,
}

/// A bound, rounded up to two digits: still a bound.
fn bound(bound: f64) -> String {
    // Rounding to two digits takes off at most one part in twenty.
    let digits = rounded(bound, 2);
    match digits.parse::<f64>() {
        Ok(below) if below < bound => rounded(bound * 1.05, 2),
        _ => digits,
    }
}
