//! The ends of the vehicle to which the points of a file belong.

use std::ops::Range;
use std::path::Path;

use super::hardpoints::Hardpoints;
use super::names::{Names, spelled};
use super::side::{End, end_of};
use crate::failure::Failure;

impl Hardpoints<'_> {
    /// Notes that a line names an end of the vehicle.
    pub(super) fn add_end(&mut self, end: Option<End>, place: Range<usize>) {
        self.ends.extend(end.map(|end| (end, place)));
    }

    /// Returns the end of the vehicle to which the suspension belongs, and the reason; `None` if the file does not say or
    /// names both. A name of the file counts only if its lines say nothing.
    pub(super) fn end(&self) -> Option<(End, String)> {
        let in_words = |end: End, at: &str| format!("{at} says {}", end.name());
        let Some((end, place)) = self.ends.first() else {
            let name = Path::new(self.source.name()).file_stem()?;
            let end = end_of(&spelled(&name.to_string_lossy()))?;
            return Some((end, in_words(end, "the name of the file")));
        };
        let is_same = self.ends.iter().all(|(other, _)| other == end);
        is_same.then(|| (*end, in_words(*end, &self.line(place))))
    }

    /// Takes the first word of a name, as in `Rear lower wishbone front`, as the end of the vehicle where the name is only
    /// known without it.
    pub(super) fn split_ends_off(&mut self, names: &Names) {
        let mut ends = Vec::new();
        for point in self
            .points
            .iter_mut()
            .filter(|point| !names.is_point(&point.key))
        {
            let split = point.key.split_once('_');
            let split = split.and_then(|(first, own)| Some((end_of(first)?, own.to_owned())));
            if let Some((end, own)) = split.filter(|(_, own)| names.is_point(own)) {
                ends.push((end, point.place.clone()));
                point.end = Some(end);
                point.key = own;
            }
        }
        self.ends.extend(ends);
    }

    /// Returns the contents without the points and numbers of the other end of the vehicle, if `wanted` names an end.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] if the file does not say which points are of that end, or states two values of a number.
    pub(super) fn of_end(mut self, wanted: Option<End>) -> Result<Self, Failure> {
        if let Some(wanted) = wanted {
            if !self.points.iter().any(|point| point.end == Some(wanted)) {
                let end = wanted.name();
                let message = format!(
                    "no line says which points are of the {end} axle: write a heading such as `{end} suspension` above them"
                );
                return Err(self.source.refuse(&(0..0), message));
            }
            let is_wanted = |end: Option<End>| end.is_none_or(|end| end == wanted);
            self.points.retain(|point| is_wanted(point.end));
            self.numbers.retain(|number| is_wanted(number.end));
            self.ends.retain(|(end, _)| *end == wanted);
        }
        self.check_numbers()?;
        Ok(self)
    }
}
