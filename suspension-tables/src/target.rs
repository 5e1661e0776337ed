//! The destination of results.

use std::io::{self, BufWriter, Stdout, Write};
use std::path::{Path, PathBuf};

use crate::files::{Pending, print, refuse_input, resolved, write_file};
use suspension_mechanism::failure::Failure;

/// The destination of a result.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Target {
    /// Standard output.
    Stdout,
    /// A file.
    File(PathBuf),
}

impl From<PathBuf> for Target {
    /// Makes standard output of `-` and its other names, and a file of any other path.
    fn from(path: PathBuf) -> Self {
        const STDOUT: [&str; 4] = ["-", "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"];
        if STDOUT.iter().any(|name| path.as_os_str() == *name) {
            Self::Stdout
        } else {
            Self::File(path)
        }
    }
}

impl Target {
    /// Returns the path of a file.
    pub fn path(&self) -> Option<&Path> {
        match self {
            Self::Stdout => None,
            Self::File(path) => Some(path),
        }
    }

    /// Returns whether another result goes to the same place.
    fn is_same_place(&self, other: &Self) -> bool {
        match (self.path(), other.path()) {
            (Some(one), Some(other)) => resolved(one) == resolved(other),
            (one, other) => one == other,
        }
    }

    /// Refuses another result at the same place; `options` name the two.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`].
    pub(crate) fn refuse_same(
        &self,
        other: &Self,
        [one, another]: [&str; 2],
    ) -> Result<(), Failure> {
        if !self.is_same_place(other) {
            return Ok(());
        }
        let message = format!("{one} and {another} name the same place; give each its own");
        Err(Failure::Input(message))
    }

    /// Calls [`refuse_input`] for a file.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`].
    pub fn refuse_input(&self, option: &str) -> Result<(), Failure> {
        self.path()
            .map_or(Ok(()), |path| refuse_input(path, option))
    }

    /// Writes a whole text.
    ///
    /// # Errors
    ///
    /// See [`print()`] and [`write_file`].
    pub fn write(&self, text: &str) -> Result<(), Failure> {
        self.path()
            .map_or_else(|| print(text), |path| write_file(path, text))
    }
}

/// An open target.
pub(crate) struct Sink {
    /// The name in messages.
    pub(crate) name: String,
    writer: Writer,
}

enum Writer {
    Stdout(BufWriter<Stdout>),
    File(Pending),
}

impl Sink {
    pub(crate) fn create(target: &Target) -> Result<Self, Failure> {
        Ok(match target {
            Target::Stdout => Self {
                name: "standard output".to_owned(),
                writer: Writer::Stdout(BufWriter::new(io::stdout())),
            },
            Target::File(path) => Self {
                name: path.display().to_string(),
                writer: Writer::File(Pending::create(path)?),
            },
        })
    }

    /// Ends the target; a file gets its name.
    pub(crate) fn finish(self) -> Result<(), Failure> {
        match self.writer {
            Writer::Stdout(mut out) => out
                .flush()
                .map_err(|error| Failure::writing(&self.name, &error)),
            Writer::File(file) => file.finish(),
        }
    }
}

impl Write for Sink {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match &mut self.writer {
            Writer::Stdout(out) => out.write(bytes),
            Writer::File(file) => file.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match &mut self.writer {
            Writer::Stdout(out) => out.flush(),
            Writer::File(file) => file.flush(),
        }
    }
}
