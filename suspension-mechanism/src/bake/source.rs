//! A baked motion as a file for people and compilers.

mod about;
mod c;
mod curve;
mod rust;
mod surface;

use std::path::Path;

use crate::bake::baked::Baked;
use crate::bake::driven::Output;
use crate::bake::surface::BakedSurface;
use crate::number::{counted, rounded};

pub use about::{About, Ranged, Replaced};

/// The language of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Language {
    /// A `static` of `suspension_core::baked::Curve` or `Surface`.
    Rust,
    /// A header in C99 with a function that evaluates the polynomials.
    C,
    /// The numbers alone.
    Toml,
}

impl Language {
    /// The extension of a file's name.
    pub fn extension(self) -> &'static str {
        match self {
            Self::Rust => "rs",
            Self::C => "h",
            Self::Toml => "toml",
        }
    }
}

/// A baked motion and the meaning of its numbers.
#[derive(Clone, Debug)]
pub struct BakedFile {
    /// The meaning of the numbers.
    pub about: About,
    /// The numbers.
    pub baked: Table,
}

/// The numbers of a baked motion.
#[derive(Clone, Debug)]
pub enum Table {
    /// The numbers of a motion of one drive.
    Curve(Baked),
    /// The numbers of a motion of two drives.
    Surface(BakedSurface),
}

impl Table {
    fn outputs(&self) -> &[Output] {
        match self {
            Self::Curve(baked) => &baked.outputs,
            Self::Surface(baked) => &baked.outputs,
        }
    }

    /// The number of polynomials, in words.
    pub fn count_in_words(&self) -> String {
        match self {
            Self::Curve(baked) => counted(baked.segments.len(), "segment"),
            Self::Surface(BakedSurface { counts, .. }) => {
                format!("{} x {} patches", counts[0], counts[1])
            }
        }
    }
}

impl BakedFile {
    /// A description of the outputs and the drives.
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

/// The common parts of a file for a table of either kind.
struct Titled<'a> {
    about: &'a About,
    /// The table's name.
    name: String,
    /// The numbers' names, in order.
    outputs: Vec<String>,
}

/// The line of a header about a tolerance and the error reached, which is never shown as larger than the request
/// unless it is.
fn tolerance(asked: f64, reached: f64, unit: &str) -> String {
    let within = rounded(asked, 3);
    let digits = bound(reached);
    let seems_more = digits.parse::<f64>().is_ok_and(|shown| shown > asked);
    let shown = if reached <= asked && seems_more {
        &within
    } else {
        &digits
    };
    format!("Tolerance asked: {within} {unit}; reached: {shown} {unit}.")
}

/// A bound, rounded up to two digits: still a bound.
fn bound(bound: f64) -> String {
    let digits = rounded(bound, 2);
    let second_digit = 10_f64.powf(bound.log10().floor() - 1.0);
    match digits.parse::<f64>() {
        Ok(below) if below < bound => rounded(below + second_digit, 2),
        _ => digits,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// For an error of 2.44e-7 at a tolerance of 2.5e-7 the header once stated 2.6e-7.
    #[test]
    fn stated_bounds_are_rounded_up_by_less_than_a_digit() {
        for (value, expected) in [
            (2.44e-7, "2.5e-7"),
            (2.72e-7, "2.8e-7"),
            (2.401e-7, "2.5e-7"),
            (9.94e-7, "1e-6"),
            (3e-7, "3e-7"),
            (0.0, "0"),
        ] {
            assert_eq!(bound(value), expected, "{value}");
        }
    }

    /// A reached 2.44e-7 was shown as 2.5e-7 beside a tolerance of 2.45e-7.
    #[test]
    fn a_reached_tolerance_is_not_printed_above_the_requested_one() {
        for (requested, reached, expected) in [
            (2.45e-7, 2.44e-7, "asked: 2.45e-7 m; reached: 2.45e-7 m."),
            (2.45e-7, 2.32e-7, "asked: 2.45e-7 m; reached: 2.4e-7 m."),
            (2.45e-7, 2.46e-7, "asked: 2.45e-7 m; reached: 2.5e-7 m."),
            (1e-6, 9.94e-7, "asked: 1e-6 m; reached: 1e-6 m."),
        ] {
            let line = tolerance(requested, reached, "m");
            assert_eq!(line, format!("Tolerance {expected}"));
        }
    }
}
