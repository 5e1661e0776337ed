//! The text of an input file and places in it.

mod encoding;
mod fit_for_terminal;
mod marked_line;

use std::fmt;
use std::fs::File;
use std::io::{self, Read};
use std::ops::Range;
use std::path::{Path, PathBuf};

use toml::Spanned;

use crate::failure::{Failure, MOST_MISTAKES};
use crate::inputs;
use crate::interrupt;
use crate::number::counted;
use fit_for_terminal::fit_for_terminal;

/// The first bytes of workbooks of spreadsheet programs (`.xlsx` and `.ods`, `.xls`).
const WORKBOOKS: [&[u8]; 2] = [b"PK\x03\x04", b"\xd0\xcf\x11\xe0"];

/// The size limit of input files in bytes: a motion file has a few thousand, and the parser needs a hundred times the
/// memory.
const LARGEST: usize = 4 << 20;

/// That of tables of measurements: ten minutes of a dozen channels at 1 kHz are 60 MB.
const LARGEST_TABLE: usize = 64 << 20;

/// An input file: its name as the user gave it, and its text.
#[derive(Clone, Debug)]
pub struct Source {
    name: String,
    text: String,
}

impl Source {
    /// Makes a source with a name for messages.
    pub fn new(name: impl Into<String>, text: impl Into<String>) -> Self {
        Self {
            name: name.into(),
            text: text.into(),
        }
    }

    /// Reads a file in UTF-8, or in UTF-16 with a byte order mark; a table may be in Windows-1252 too.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] if the file cannot be read, is larger than 4 MiB, is a workbook, or is in another encoding.
    pub fn read(path: &Path) -> Result<Self, Failure> {
        Self::read_up_to(LARGEST, path)
    }

    /// Reads a table of measurements, which may be as large as 64 MiB.
    ///
    /// # Errors
    ///
    /// As [`read`](Self::read).
    pub fn read_table(path: &Path) -> Result<Self, Failure> {
        Self::read_up_to(LARGEST_TABLE, path)
    }

    fn read_up_to(largest: usize, path: &Path) -> Result<Self, Failure> {
        let name = fit_for_terminal(&path.display().to_string());
        let refuse = |why: String| Err(Failure::Input(format!("{name}: {why}")));
        inputs::note(path);
        let bytes = match read_at_most(path, largest + 1) {
            Ok(bytes) => bytes,
            Err(error) if error.kind() == io::ErrorKind::Interrupted => {
                let message = format!("{name}: interrupted before it was read");
                return Err(Failure::Interrupted(message));
            }
            Err(error) => return refuse(format!("cannot be read: {error}")),
        };
        // TOML is in UTF-8 by definition, and listings are read by the macro too.
        let mut extension = path.extension().into_iter();
        let is_table = !extension.any(|it| it == "toml" || it == "linkage");
        if bytes.len() > largest {
            let size = largest >> 20;
            let remedy = if is_table {
                "; leave out columns and lines that are not needed"
            } else {
                ""
            };
            return refuse(format!("is larger than {size} MiB{remedy}"));
        }
        if WORKBOOKS.iter().any(|start| bytes.starts_with(start)) {
            return refuse("is a workbook, not text; save the sheet as CSV in UTF-8".to_owned());
        }
        encoding::text(bytes, is_table).map_or_else(
            |error| {
                let valid = error.utf8_error().valid_up_to();
                let text = String::from_utf8_lossy(&error.as_bytes()[..valid]);
                let message = "is not text in UTF-8; save it in that encoding";
                Err(Self::new(&name, text).refuse(&(valid..valid), message))
            },
            |text| Ok(Self::new(&name, text)),
        )
    }

    /// The file's name.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The path of a file that this one names: it counts from the folder of this one.
    pub(crate) fn beside(&self, named: &str) -> PathBuf {
        Path::new(&self.name).with_file_name(named)
    }

    /// Reads a file that this one names, with its path from the folder of this one.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] at the path if there is no such text.
    pub fn read_beside(&self, path: &Spanned<String>) -> Result<Self, Failure> {
        let read = Self::read(&self.beside(path.get_ref()));
        read.map_err(|failure| self.located(failure, path))
    }

    /// Reads a [table of measurements](Self::read_table) that this file names, with its path from the folder of this one.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] at the path if there is no such text.
    pub fn read_table_beside(&self, path: &Spanned<String>) -> Result<Self, Failure> {
        let read = Self::read_table(&self.beside(path.get_ref()));
        read.map_err(|failure| self.located(failure, path))
    }

    /// Returns the failure to read a file with the place where this one names it.
    fn located(&self, failure: Failure, path: &Spanned<String>) -> Failure {
        match failure {
            Failure::Input(message) => self.refuse(&path.span(), message),
            other => other,
        }
    }

    /// The text.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Returns `name:line:column` of a place, both counted from one, columns in characters.
    pub fn place(&self, span: &Range<usize>) -> String {
        let before = self.text.get(..span.start).unwrap_or(&self.text);
        let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
        let line = before.matches('\n').count() + 1;
        let column = before[line_start..].chars().count() + 1;
        format!("{}:{line}:{column}", self.name)
    }

    /// Returns the failure with a place and the mistake there.
    pub fn refuse(&self, span: &Range<usize>, message: impl fmt::Display) -> Failure {
        Failure::Input(self.message(span, &fit_for_terminal(&message.to_string())))
    }

    /// Returns the message of a mistake: with the marked line on a terminal, one line elsewhere.
    fn message(&self, span: &Range<usize>, what: &str) -> String {
        marked_line::drawn(&self.name, &self.text, span, what)
            .unwrap_or_else(|| format!("{}: {what}", self.place(span)))
    }

    /// Returns one failure for several mistakes, of which at most twenty are reported. `described` returns the place and the message
    /// of one.
    pub fn refuse_all<M>(
        &self,
        mistakes: &[M],
        mut described: impl FnMut(&M) -> (Range<usize>, String),
    ) -> Failure {
        let first = mistakes.iter().take(MOST_MISTAKES).map(|mistake| {
            let (span, message) = described(mistake);
            self.message(&span, &fit_for_terminal(&message))
        });
        let mut messages: Vec<String> = first.collect();
        match mistakes.len() - messages.len() {
            0 => {}
            more => {
                let more = counted(more, "more mistake");
                messages.push(format!("{}: and {more}", self.name));
            }
        }
        Failure::Input(messages.join("\n"))
    }

    /// Returns the place of characters of a line, which are counted as in [`place`](Self::place); the end of the text if there
    /// is no such line.
    pub fn span(&self, line: usize, column: usize, length: usize) -> Range<usize> {
        let mut starts = self.text.split_inclusive('\n').scan(0, |next, line| {
            let start = *next;
            *next += line.len();
            Some((start, line))
        });
        let Some((start, line)) = starts.nth(line.saturating_sub(1)) else {
            return self.text.len()..self.text.len();
        };
        let at = |character: usize| {
            let mut places = line.char_indices().map(|(place, _)| place);
            start + places.nth(character).unwrap_or(line.len())
        };
        let first = column.saturating_sub(1);
        at(first)..at(first + length)
    }
}

fn read_at_most(path: &Path, limit: usize) -> io::Result<Vec<u8>> {
    let is_file = path.metadata()?.is_file();
    let path = path.to_owned();
    let read = move || {
        let mut bytes = Vec::new();
        File::open(path)?
            .take(limit as u64)
            .read_to_end(&mut bytes)?;
        Ok(bytes)
    };
    if is_file {
        read()
    } else {
        interrupt::waiting(read)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_20_mistakes_are_printed() {
        let source = Source::new("a.toml", "x = 1\n");
        for (count, end) in [
            (150, "\na.toml: and 130 more mistakes"),
            (21, "\na.toml: and 1 more mistake"),
        ] {
            let described = |message: &&str| (0..1, (*message).to_owned());
            let message = source
                .refuse_all(&vec!["wrong"; count], described)
                .to_string();
            assert_eq!(message.lines().count(), 21);
            assert!(message.ends_with(end), "{message}");
        }
    }

    #[test]
    fn line_and_column_are_counted_from_one_in_characters() {
        let source = Source::new("a.toml", "x = 1\n# é y\nz");
        assert_eq!(source.place(&(0..1)), "a.toml:1:1");
        let y = source.text().find('y').unwrap();
        assert_eq!(source.place(&(y..y)), "a.toml:2:5");
        let end = source.text().len();
        assert_eq!(source.place(&(end..end)), "a.toml:3:2");
    }
}
