//! The names that hardpoint files use for points and numbers: `names.toml`.

mod words;

use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet, HashMap};

use serde::Deserialize;
use suspension_listing::did_you_mean::nearest;

use super::layout::Layout;
use super::spelling::is_on_ground;
use crate::failure::Failure;
use crate::vehicle_corner::{Section, Side};
use words::Words;

/// The contents of `names.toml`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Table {
    words: BTreeMap<String, Vec<String>>,
    unsaid: Vec<String>,
    points: BTreeMap<String, Vec<String>>,
    numbers: BTreeMap<String, Vec<String>>,
    advice: BTreeMap<String, Vec<String>>,
    headings: BTreeMap<String, Vec<String>>,
    arrangement: Arrangement,
}

/// The usual order of points along the axes.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Arrangement {
    /// The first is ahead of the second.
    pub(super) ahead: Vec<[String; 2]>,
    /// The first is above the second.
    pub(super) above: Vec<[String; 2]>,
    /// The first is further from the middle of the vehicle than the second.
    pub(super) outboard: Vec<[String; 2]>,
    /// The layouts with another order of points.
    pub(super) otherwise: Vec<String>,
}

/// The known names of points and numbers.
#[derive(Debug)]
pub(super) struct Names {
    /// The layouts of the catalogue.
    pub(super) layouts: Vec<Layout>,
    /// The other names of each point of the catalogue.
    pub(super) points: BTreeMap<String, Vec<String>>,
    /// The other names of each number.
    pub(super) numbers: BTreeMap<String, Vec<String>>,
    /// The names of numbers that are not read, by what to do about them.
    advice: BTreeMap<String, Vec<String>>,
    /// The words that mean the same, by their meaning.
    pub(super) synonyms: BTreeMap<String, Vec<String>>,
    /// The words of headings that mean the same as English ones, by these.
    pub(super) headings: BTreeMap<String, Vec<String>>,
    /// The words without a meaning.
    pub(super) unsaid: Vec<String>,
    pub(super) arrangement: Arrangement,
    words: Words,
    /// The normal forms that have been asked for.
    normal: RefCell<HashMap<String, String>>,
    /// The normal forms of the names of each point.
    forms: BTreeMap<String, Vec<String>>,
    /// The normal forms of the names of all points, and of all numbers.
    known_points: BTreeSet<String>,
    known_numbers: BTreeSet<String>,
}

impl Names {
    /// Reads the table.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] if the table or a listing of the catalogue is damaged.
    pub(super) fn read() -> Result<Self, Failure> {
        let table = toml::from_str(include_str!("names.toml"));
        let mut table: Table =
            table.map_err(|error| Failure::Input(format!("names.toml: {}", error.message())))?;
        let layouts = Layout::read_all();
        let layouts = layouts.map_err(|mistakes| Failure::Input(mistakes.to_string()))?;
        for point in layouts.iter().flat_map(|layout| &layout.points) {
            table.points.entry(point.clone()).or_default();
        }
        let names = all(&table.points).chain(all(&table.numbers));
        let words = Words::new(names, &table.words, &table.unsaid);
        let forms: BTreeMap<String, Vec<String>> = table
            .points
            .keys()
            .map(|point| {
                let names = spellings(&table.points, point);
                (
                    point.clone(),
                    names.map(|name| words.normal(name)).collect(),
                )
            })
            .collect();
        Ok(Self {
            layouts,
            known_points: forms.values().flatten().cloned().collect(),
            forms,
            known_numbers: all(&table.numbers).map(|name| words.normal(name)).collect(),
            points: table.points,
            numbers: table.numbers,
            advice: table.advice,
            synonyms: table.words,
            headings: table.headings,
            unsaid: table.unsaid,
            arrangement: table.arrangement,
            words,
            normal: RefCell::default(),
        })
    }

    /// Returns the names of a point of a listing, its own name first.
    pub(super) fn of_point<'a>(&'a self, point: &'a str) -> impl Iterator<Item = &'a str> {
        spellings(&self.points, point)
    }

    /// Returns the forms of the names of a point of a listing, that of its own name first.
    pub(super) fn forms_of(&self, point: &str) -> &[String] {
        self.forms.get(point).map_or(&[], Vec::as_slice)
    }

    /// Returns the form that all spellings of a name have.
    pub(super) fn normal(&self, name: &str) -> String {
        let found = self.normal.borrow().get(name).cloned();
        found.unwrap_or_else(|| {
            let form = self.words.normal(name);
            self.normal
                .borrow_mut()
                .insert(name.to_owned(), form.clone());
            form
        })
    }

    /// Returns the spelled words of a heading in English. A word that English has too is translated beside another foreign one.
    pub(super) fn heading_in_english(&self, words: &str) -> String {
        let row = |word: &str| self.heading_row(word);
        let is_english = |word: &str| ENGLISH_TOO.contains(&word);
        let is_foreign = |word: &str| row(word).is_some() && !is_english(word);
        let has_foreign = words.split('_').any(is_foreign);
        let english = |word| match row(word) {
            Some((english, _)) if has_foreign || !is_english(word) => english,
            _ => word,
        };
        let words = words.split('_').map(english);
        words.collect::<Vec<&str>>().join("_")
    }

    /// Returns what a spelled word in any language says of a corner.
    pub(super) fn corner_of_word(&self, word: &str) -> Option<Section> {
        Section::of_word(self.heading_row(word).map_or(word, |(english, _)| english))
    }

    /// Returns the row of a word of headings in another language.
    fn heading_row(&self, word: &str) -> Option<(&String, &Vec<String>)> {
        let mut rows = self.headings.iter();
        rows.find(|(_, others)| others.iter().any(|other| other == word))
    }

    /// Returns the known name that has a side before a name, or before the point that this names.
    pub(super) fn point_of_side(&self, side: Side, name: &str) -> Option<String> {
        let form = self.normal(name);
        let named = self.forms.iter().filter(|(_, forms)| forms.contains(&form));
        let own = [name]
            .into_iter()
            .chain(named.map(|(point, _)| point.as_str()));
        let mut of_side = own.map(|own| format!("{}_{own}", side.name()));
        of_side.find(|name| self.is_point(name))
    }

    /// Returns whether the name is that of a point.
    pub(super) fn is_point(&self, name: &str) -> bool {
        self.known_points.contains(&self.normal(name))
    }

    /// Returns whether a name is one of those of a point of a listing.
    pub(super) fn is_of_point(&self, point: &str, name: &str) -> bool {
        self.forms_of(point).contains(&self.normal(name))
    }

    /// Returns whether the name is that of a number.
    pub(super) fn is_number(&self, name: &str) -> bool {
        self.known_numbers.contains(&self.normal(name))
    }

    /// Returns whether a name is one of those of a number.
    pub(super) fn is_of_number(&self, number: &str, name: &str) -> bool {
        let name = self.normal(name);
        spellings(&self.numbers, number).any(|other| self.normal(other) == name)
    }

    /// Returns the name of a point that may have been meant by an unknown one.
    pub(super) fn point_meant(&self, name: &str) -> Option<String> {
        self.meant(name, all(&self.points).collect())
    }

    /// Returns the code of a corner within an unknown name, and the word that would make the name known: `FR` for front.
    pub(super) fn code_meant(&self, name: &str) -> Option<[&'static str; 2]> {
        CODES_AND_ENDS.into_iter().find(|[code, end]| {
            let words = name.split('_');
            let words = words.map(|word| if word == *code { end } else { word });
            let meant = words.collect::<Vec<_>>().join("_");
            meant != name && self.is_point(&meant)
        })
    }

    /// Returns what to do about an unknown name of a number, for example the name that may have been meant.
    pub(super) fn number_advice(&self, name: &str) -> Option<String> {
        let form = self.normal(name);
        let is_of = |others: &[String]| others.iter().any(|other| self.normal(other) == form);
        let mut rows = self.advice.iter();
        let advice = rows.find(|(_, others)| is_of(others));
        advice.map(|(advice, _)| advice.clone()).or_else(|| {
            let meant = self.meant(name, all(&self.numbers).collect())?;
            Some(format!("did you mean {meant}?"))
        })
    }

    /// Returns which of some names may have been meant by an unknown one, in its own words if only letters are wrong.
    pub(super) fn meant(&self, name: &str, known: Vec<&str>) -> Option<String> {
        if is_on_ground(name) {
            return None;
        }
        let corrected = self.words.corrected(name);
        let form = self.normal(&corrected);
        match known.iter().any(|other| self.normal(other) == form) {
            true => Some(corrected),
            false => nearest(name, known).map(str::to_owned),
        }
    }
}

/// Returns all names of a table, also of rows without other names.
fn all(rows: &BTreeMap<String, Vec<String>>) -> impl Iterator<Item = &str> {
    rows.keys().flat_map(|own| spellings(rows, own))
}

fn spellings<'a>(
    table: &'a BTreeMap<String, Vec<String>>,
    own: &'a str,
) -> impl Iterator<Item = &'a str> {
    let others = table.get(own).into_iter().flatten().map(String::as_str);
    [own].into_iter().chain(others)
}

/// Codes of corners that are also short for an end.
const CODES_AND_ENDS: [[&str; 2]; 2] = [["fr", "front"], ["rr", "rear"]];

/// Words of headings in other languages that English has too: `Rear links` and `drive train` say nothing of sides and axles.
const ENGLISH_TOO: [&str; 6] = ["links", "train", "as", "ad", "re", "post"];
