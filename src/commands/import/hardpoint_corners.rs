//! The ends of the vehicle to which the points of a file belong.

use std::ops::Range;
use std::path::Path;

use super::hardpoints::{Hardpoint, Hardpoints};
use super::names::Names;
use super::spelling::{spelled, without_end};
use crate::failure::Failure;
use crate::vehicle_corner::{End, Section, Side, end_of};

impl Hardpoints<'_> {
    /// Notes that a line names an end of the vehicle.
    pub(super) fn add_end(&mut self, end: Option<End>, place: Range<usize>) {
        self.ends.extend(end.map(|end| (end, place)));
    }

    /// Removes the ends that lines below the last point name: headings are above their points.
    pub(super) fn forget_ends_behind_points(&mut self) {
        if let Some(last) = self.points.last() {
            self.ends
                .retain(|(_, place)| place.start <= last.place.start);
        }
    }

    /// Returns the end of the vehicle to which the suspension belongs, and the reason; `None` if the file does not say or names
    /// both. The option `--end` comes first, then the lines of the file, then its name.
    pub(super) fn end(&self) -> Option<(End, String)> {
        let in_words = |end: End, at: &str| format!("{at} says {}", end.name());
        if let Some(wanted) = self.wanted {
            return Some((wanted, in_words(wanted, "--end")));
        }
        let Some((end, place)) = self.ends.first() else {
            let name = Path::new(self.source.name()).file_stem()?;
            let end = end_of(&spelled(&name.to_string_lossy()))?;
            return Some((end, in_words(end, "the name of the file")));
        };
        let is_same = self.ends.iter().all(|(other, _)| other == end);
        is_same.then(|| (*end, in_words(*end, &self.line(place))))
    }

    /// Returns the contents with the words that name a corner apart from the names that are known without them, as in `Rear
    /// lower wishbone front` and `Left wheel centre`. In layouts with both sides these words are part of the names.
    pub(super) fn with_corners_apart(&self, names: &Names) -> Self {
        let mut apart = self.clone();
        let is_known = |key: &str| names.is_point(key);
        let is_known_of_side = |key: &str| {
            is_known(key) || without_end(key, |word| of_letter(word, false), is_known).is_some()
        };
        let is_f = |word: &str| (word == "f").then_some(());
        let mut points = self.points.iter();
        let has_f = points.any(|point| without_end(&point.key, is_f, is_known_of_side).is_some());
        let meaning = |word: &str| {
            names
                .corner_of_word(word)
                .or_else(|| of_letter(word, has_f))
        };
        let is_known_of_corner =
            |key: &str| is_known(key) || without_end(key, meaning, is_known).is_some();
        for point in &mut apart.points {
            // An end and a side, in any order.
            for _ in 0..2 {
                let found = without_end(&point.key, meaning, is_known_of_corner);
                // `Front axle` is no point of the spin axis.
                let found = found.filter(|(said, own)| said.end.is_none() || own != "axle");
                if let Some((said, own)) = found {
                    apart
                        .ends
                        .extend(said.end.map(|end| (end, point.place.clone())));
                    point.end = said.end.or(point.end);
                    point.side = said.side.or(point.side);
                    point.key = own;
                }
            }
        }
        apart
    }

    /// Returns the contents with the sides of points in their names, as layouts with both sides have them: `Damper top RH`, or
    /// `Damper top` of the right side, is `right_damper_upper`.
    pub(super) fn with_sides_in_names(&self, names: &Names) -> Self {
        let mut joined = self.clone();
        for point in &mut joined.points {
            if let Some(name) = name_with_side(point, names) {
                point.key = name;
                point.side = None;
            }
        }
        joined
    }

    /// Returns the contents without the points and numbers of the other end of the vehicle, if `wanted` names an end.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] if the file says that all its points are of the other end, or states two values of a number.
    pub(super) fn of_end(mut self, wanted: Option<End>) -> Result<Self, Failure> {
        if let Some(wanted) = wanted {
            let is_wanted = |end: Option<End>| end.is_none_or(|end| end == wanted);
            let other = self.points.iter().find(|point| !is_wanted(point.end));
            let is_named = self.points.iter().any(|point| point.end == Some(wanted));
            if let Some(other) = other.filter(|_| !is_named) {
                let message = format!(
                    "point `{}` is of the other axle, and no line says which points are of the {end} one: write a heading such \
                     as `{end} suspension` above them",
                    other.name,
                    end = wanted.name()
                );
                return Err(self.source.refuse(&other.place, message));
            }
            self.points.retain(|point| is_wanted(point.end));
            self.numbers.retain(|number| is_wanted(number.end));
            let unknown = &mut self.unknown_numbers;
            unknown.retain(|number| is_wanted(number.end));
        }
        self.wanted = wanted;
        self.check_numbers()?;
        Ok(self)
    }
}

/// Returns the known name that says the side of a point: the words of its own name in English, or one with the side of its name or
/// row before a known name.
fn name_with_side(point: &Hardpoint, names: &Names) -> Option<String> {
    let side_of = |word: &str| {
        let said = names
            .corner_of_word(word)
            .or_else(|| of_letter(word, false))?;
        said.side.filter(|_| said.end.is_none())
    };
    let words = point.key.split('_');
    let in_english = words.map(|word| side_of(word).map_or(word, |side| side.name()));
    let in_english = in_english.collect::<Vec<_>>().join("_");
    if in_english != point.key && names.is_point(&in_english) {
        return Some(in_english);
    }
    let by_name = without_end(&point.key, side_of, |own| names.is_point(own));
    let (side, own) = by_name.or_else(|| Some((point.side?, point.key.clone())))?;
    names.point_of_side(side, &own)
}

/// Returns what a letter at an end of a name says; `r` is rear where other names have an `f`.
fn of_letter(word: &str, has_f: bool) -> Option<Section> {
    let (end, side) = match word {
        "l" => (None, Some(Side::Left)),
        "r" if !has_f => (None, Some(Side::Right)),
        "r" => (Some(End::Rear), None),
        "f" => (Some(End::Front), None),
        _ => return None,
    };
    Some(Section { end, side })
}
