//! Names and values in messages.

use std::fmt::Display;

use suspension_core::SolveError;

use crate::file::{Dimension, Unit};
use crate::mechanism::parts::names::{Drive, Names};
use crate::mechanism::parts::vehicle::Wheel;
use crate::number::{number, without_rounding};

/// The remedy for a lock in the motion of a file.
pub fn advice(file: &str) -> String {
    format!("`suspension range {file}` shows how far each drive reaches and what limits it")
}

/// Words as `a, b and c`.
pub fn listed(words: impl IntoIterator<Item = String>) -> String {
    let words: Vec<String> = words.into_iter().collect();
    match words.as_slice() {
        [before @ .., last] if !before.is_empty() => format!("{} and {last}", before.join(", ")),
        _ => words.concat(),
    }
}

/// Names in quotes, as `a`, `b` and `c`.
pub fn quoted<T: Display>(names: impl IntoIterator<Item = T>) -> String {
    listed(names.into_iter().map(|name| format!("`{name}`")))
}

/// A length or an angle in the unit of a file, such as `0.7 rad`.
pub(crate) fn value_in_words(value: f64, dimension: impl Into<Dimension>, unit: Unit) -> String {
    let dimension = dimension.into();
    let value = number(without_rounding(value * unit.file_factor(dimension)));
    format!("{value} {}", dimension.symbol(unit))
}

impl Names {
    /// A drive's value, in the file's coordinates, in words, such as `theta = 0.7 rad`.
    pub fn drive_in_words(&self, drive: usize, value: f64, unit: Unit) -> String {
        let Drive { name, kind } = &self.drives[drive];
        format!("{name} = {}", value_in_words(value, *kind, unit))
    }

    /// All drives' values in words, with `instead` in place of one of them.
    pub fn drives_in_words(
        &self,
        values: &[f64],
        unit: Unit,
        instead: Option<(usize, &str)>,
    ) -> String {
        let each = values
            .iter()
            .enumerate()
            .map(|(drive, value)| match instead {
                Some((other, words)) if other == drive => words.to_owned(),
                _ => self.drive_in_words(drive, *value, unit),
            });
        each.collect::<Vec<_>>().join(", ")
    }

    /// The value of `travel` under `[vehicle]` for some of the wheels: the drives that alone lift them, or `NAME` for
    /// a wheel without one.
    pub fn travel_in_file<'a>(&self, wheels: impl IntoIterator<Item = &'a Wheel>) -> String {
        let quoted = |wheel: &Wheel| {
            let drive = match *wheel.lifted_by {
                [only] => &self.drives[only].name,
                _ => "NAME",
            };
            format!("{drive:?}")
        };
        let each: Vec<(&str, String)> = wheels
            .into_iter()
            .map(|wheel| (wheel.name.as_str(), quoted(wheel)))
            .collect();
        match each.as_slice() {
            [] => "\"NAME\"".to_owned(),
            [("", drive)] => drive.clone(),
            each => {
                let each: Vec<_> = each
                    .iter()
                    .map(|(wheel, drive)| format!("{wheel} = {drive}"))
                    .collect();
                format!("{{ {} }}", each.join(", "))
            }
        }
    }

    /// The reason why a step was refused.
    pub fn cause(&self, error: &SolveError<f64>) -> String {
        format!("{:#}", error.named(self))
    }
}

#[cfg(test)]
mod tests {
    use super::listed;

    #[test]
    fn listed_words_are_joined_by_commas_and_a_final_and() {
        let listed = |words: &[&str]| listed(words.iter().map(ToString::to_string));
        assert_eq!(listed(&["a"]), "a");
        assert_eq!(listed(&["a", "b"]), "a and b");
        assert_eq!(listed(&["a", "b", "c"]), "a, b and c");
    }
}
