//! The text of an input file and places in it.

use std::ops::Range;
use std::path::Path;

use crate::failure::Failure;

/// An input file: its name as the user gave it, and its text.
#[derive(Clone, Debug)]
pub struct Source {
    name: String,
    text: String,
}

impl Source {
    /// Text under a name that messages use.
    pub fn new(name: impl Into<String>, text: impl Into<String>) -> Self {
        Self {
            name: name.into(),
            text: text.into(),
        }
    }

    /// Reads a file.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] where it cannot be read or is not UTF-8.
    pub fn read(path: &Path) -> Result<Self, Failure> {
        let name = path.display().to_string();
        match std::fs::read_to_string(path) {
            Ok(text) => Ok(Self { name, text }),
            Err(error) => Err(Failure::Input(format!("{name}: cannot be read: {error}"))),
        }
    }

    /// The file's name.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The text.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// `name:line:column` of a place, both counted from one, columns in characters.
    pub fn place(&self, span: &Range<usize>) -> String {
        let before = self.text.get(..span.start).unwrap_or(&self.text);
        let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
        let line = before.matches('\n').count() + 1;
        let column = before[line_start..].chars().count() + 1;
        format!("{}:{line}:{column}", self.name)
    }

    /// The failure that names a place and what is wrong there.
    pub fn refuse(&self, span: &Range<usize>, message: impl std::fmt::Display) -> Failure {
        Failure::Input(format!("{}: {message}", self.place(span)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_counted_from_one_in_characters() {
        let source = Source::new("a.toml", "x = 1\n# é y\nz");
        assert_eq!(source.place(&(0..1)), "a.toml:1:1");
        let y = source.text().find('y').unwrap();
        assert_eq!(source.place(&(y..y)), "a.toml:2:5");
        let end = source.text().len();
        assert_eq!(source.place(&(end..end)), "a.toml:3:2");
    }
}
