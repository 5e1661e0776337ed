//! The names that hardpoint files use for points and numbers: `names.toml`.

use std::collections::BTreeMap;

use serde::Deserialize;
use suspension_listing::did_you_mean::nearest;

use super::side::{Side, Sides, corner_of};
use crate::failure::Failure;

/// The contents of `names.toml`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Names {
    pub(super) points: BTreeMap<String, Vec<String>>,
    numbers: BTreeMap<String, Vec<String>>,
    pub(super) arrangement: Arrangement,
}

/// The usual order of points along the axes.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Arrangement {
    /// The first is ahead of the second.
    pub(super) ahead: Vec<[String; 2]>,
    /// The first is above the second.
    pub(super) above: Vec<[String; 2]>,
    /// The layouts with another order of points.
    pub(super) otherwise: Vec<String>,
}

impl Names {
    /// Reads the table.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] if the table is damaged.
    pub(super) fn read() -> Result<Self, Failure> {
        let names = toml::from_str(include_str!("names.toml"));
        names.map_err(|error| Failure::Input(format!("names.toml: {}", error.message())))
    }

    /// Returns the names of a point of a listing, its own name first.
    pub(super) fn of_point<'a>(&'a self, point: &'a str) -> impl Iterator<Item = &'a str> {
        spellings(&self.points, point)
    }

    /// Returns the names of a number, its own name first.
    pub(super) fn of_number<'a>(&'a self, number: &'a str) -> impl Iterator<Item = &'a str> {
        spellings(&self.numbers, number)
    }

    pub(super) fn all_of_points(&self) -> impl Iterator<Item = &str> {
        self.points.keys().flat_map(|point| self.of_point(point))
    }

    /// Returns whether the name is that of a point.
    pub(super) fn is_point(&self, name: &str) -> bool {
        self.all_of_points().any(|other| is_same(other, name))
    }

    /// Returns the known name of a number that may have been meant by a mistyped one.
    pub(super) fn number_meant(&self, name: &str) -> Option<&str> {
        let numbers = self.numbers.keys();
        nearest(name, numbers.flat_map(|number| self.of_number(number)))
    }

    /// Returns whether the name is that of a number.
    pub(super) fn is_number(&self, name: &str) -> bool {
        let mut numbers = self.numbers.keys();
        numbers.any(|number| self.of_number(number).any(|other| is_same(other, name)))
    }
}

fn spellings<'a>(
    table: &'a BTreeMap<String, Vec<String>>,
    own: &'a str,
) -> impl Iterator<Item = &'a str> {
    let others = table.get(own).into_iter().flatten().map(String::as_str);
    [own].into_iter().chain(others)
}

/// The most points that a message names.
pub(super) const MOST_NAMES: usize = 40;

/// Returns the words on `others` that a message does not name; `None` if there are none.
pub(super) fn and_more(others: usize) -> Option<String> {
    (others > 0).then(|| format!("and {others} more"))
}

/// Returns whether two spelled names are the same where their words may be joined or apart: `push_rod_outer` is
/// `pushrod_outer`.
pub(super) fn is_same(a: &str, b: &str) -> bool {
    let [a, b] = [a, b].map(|name| name.bytes().filter(|byte| *byte != b'_'));
    a.eq(b)
}

/// Returns a name in lower-case letters with `_` between words.
pub(super) fn spelled(name: &str) -> String {
    let words = name.split(|c: char| !c.is_alphanumeric());
    let words = words.filter(|word| !word.is_empty());
    words.collect::<Vec<_>>().join("_").to_lowercase()
}

/// Removes the code of a corner at either end of a spelled name.
fn without_corner(key: &str) -> Option<(String, Sides)> {
    let ends = [
        key.split_once('_'),
        key.rsplit_once('_').map(|(own, code)| (code, own)),
    ];
    let mut ends = ends.into_iter().flatten();
    ends.find_map(|(code, own)| Some((own.to_owned(), Sides::One(corner_of(code)?.1))))
}

/// Words that are no name without the part before them, as in `lca.front` of a structure.
const OF_PART: [&str; 8] = [
    "front", "rear", "fore", "aft", "inner", "outer", "centre", "center",
];

/// Returns a name as it is compared, and the side that it states. It omits the prefixes of Adams/Car, the model, and hpl_,
/// hpr_ or hps_ for left, right and single; the path of a structure in a program; and the code of a corner such as RL.
pub(super) fn key_of(name: &str) -> (String, Sides) {
    let mut path = name.rsplit('.');
    let own = path.next().unwrap_or(name);
    let key = match path.next() {
        Some(part) if OF_PART.contains(&spelled(own).as_str()) => spelled(&format!("{part} {own}")),
        _ => spelled(own),
    };
    let prefixes = [
        ("hpl_", Sides::One(Side::Left)),
        ("hpr_", Sides::One(Side::Right)),
        ("pvl_", Sides::One(Side::Left)),
        ("pvr_", Sides::One(Side::Right)),
        ("hps_", Sides::Unsaid),
        ("pvs_", Sides::Unsaid),
    ];
    let mut found = prefixes.into_iter();
    let found = found.find_map(|(prefix, side)| Some((key.strip_prefix(prefix)?.to_owned(), side)));
    let found = found.or_else(|| without_corner(&key));
    found.unwrap_or((key, Sides::Unsaid))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spelled_names_join_words_by_one_underscore() {
        assert_eq!(
            spelled(" Lower  Wishbone-front.pivot "),
            "lower_wishbone_front_pivot"
        );
    }
}
