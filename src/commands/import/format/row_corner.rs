//! The corner that a row of a table states: in a field of its own, or by a code at an end of its name.

use super::heading::end_of_heading;
use super::row::Row;
use crate::commands::import::spelling::spelled;
use crate::vehicle_corner::{End, Sides, corner_of, sides_of};

impl Row<'_> {
    /// Returns whether the line is a title with a number in it, such as `FS 2024 - rear suspension`.
    pub(super) fn is_title(&self) -> bool {
        let words = self.spelled();
        let mut words_of_title = ["suspension", "hardpoints", "geometry"].iter();
        let is_named = words_of_title.any(|title| words.split('_').any(|word| word == *title));
        self.separator == ' ' && self.places().is_empty() && is_named
    }

    /// Returns the sides that the row states.
    pub(super) fn sides(&self) -> Sides {
        let said = self.fields.iter().find_map(|field| sides_of(field));
        said.unwrap_or(Sides::Unsaid)
    }

    /// Returns the end of the vehicle that the row states: by a code such as `RL`, in a field of its own or at an end of the
    /// name, or by a field such as `Rear` beside the name.
    pub(super) fn end(&self) -> Option<End> {
        let words = self.fields.iter().flat_map(|field| {
            let is_apart = |c: char| !c.is_alphanumeric();
            let (first, last) = (field.split(is_apart).next(), field.rsplit(is_apart).next());
            [first, last].into_iter().flatten()
        });
        let mut codes = words.filter_map(|word| corner_of(&word.to_ascii_lowercase()));
        let by_code = codes.next().map(|(end, _)| end);
        by_code.or_else(|| self.end_beside_name())
    }

    fn end_beside_name(&self) -> Option<End> {
        let (first, _) = self.found().filter(|_| self.separator != ' ')?;
        let name = self.name();
        let mut others = self.fields[..first].iter().filter(|field| **field != name);
        others.find_map(|field| end_of_heading(&spelled(field)))
    }
}
