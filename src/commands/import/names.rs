//! The names by which hardpoint files call points and numbers: `names.toml`.

use std::collections::BTreeMap;

use serde::Deserialize;
use suspension_listing::did_you_mean::nearest;

use crate::failure::Failure;

/// What `names.toml` says.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Names {
    pub(super) points: BTreeMap<String, Vec<String>>,
    numbers: BTreeMap<String, Vec<String>>,
    pub(super) arrangement: Arrangement,
}

/// How points lie to one another.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Arrangement {
    /// The first is ahead of the second.
    pub(super) ahead: Vec<[String; 2]>,
    /// The first is above the second.
    pub(super) above: Vec<[String; 2]>,
    /// The first is on the part of the second, and so nearer to it than to the third.
    pub(super) near: Vec<[String; 3]>,
    /// The layouts whose points lie otherwise.
    pub(super) otherwise: Vec<String>,
}

impl Names {
    /// Reads the table.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] where the table is damaged.
    pub(super) fn read() -> Result<Self, Failure> {
        let names = toml::from_str(include_str!("names.toml"));
        names.map_err(|error| Failure::Input(format!("names.toml: {}", error.message())))
    }

    /// The names that stand for a point of a listing, its own first.
    pub(super) fn of_point<'a>(&'a self, point: &'a str) -> impl Iterator<Item = &'a str> {
        spellings(&self.points, point)
    }

    /// The names that stand for a number, its own first.
    pub(super) fn of_number<'a>(&'a self, number: &'a str) -> impl Iterator<Item = &'a str> {
        spellings(&self.numbers, number)
    }

    /// The names of all points.
    pub(super) fn all_of_points(&self) -> impl Iterator<Item = &str> {
        self.points.keys().flat_map(|point| self.of_point(point))
    }

    /// Whether any point goes by the name.
    pub(super) fn is_point(&self, name: &str) -> bool {
        self.all_of_points().any(|other| other == name)
    }

    /// The known name of a number that a mistyped one may stand for.
    pub(super) fn number_meant(&self, name: &str) -> Option<&str> {
        let numbers = self.numbers.keys();
        nearest(name, numbers.flat_map(|number| self.of_number(number)))
    }

    /// Whether any number goes by the name.
    pub(super) fn is_number(&self, name: &str) -> bool {
        let mut numbers = self.numbers.keys();
        numbers.any(|number| self.of_number(number).any(|other| other == name))
    }
}

fn spellings<'a>(
    table: &'a BTreeMap<String, Vec<String>>,
    own: &'a str,
) -> impl Iterator<Item = &'a str> {
    let others = table.get(own).into_iter().flatten().map(String::as_str);
    [own].into_iter().chain(others)
}

/// The most points that are told by name.
pub(super) const MOST_NAMES: usize = 40;

/// How many others there are, where there are any.
pub(super) fn and_more(others: usize) -> Option<String> {
    (others > 0).then(|| format!("and {others} more"))
}

/// A name in small letters, `_` between words.
pub(super) fn spelled(name: &str) -> String {
    let words = name.split(|c: char| !c.is_alphanumeric());
    let words = words.filter(|word| !word.is_empty());
    words.collect::<Vec<_>>().join("_").to_lowercase()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_apart_by_one_line() {
        assert_eq!(
            spelled(" Lower  Wishbone-front.pivot "),
            "lower_wishbone_front_pivot"
        );
    }
}
