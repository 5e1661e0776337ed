//! Where rows go.

use std::io::{self, BufWriter, Stdout, Write};
use std::path::PathBuf;

use crate::files::Pending;
use suspension_mechanism::failure::Failure;

/// Where rows go.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Target {
    /// Standard output.
    Stdout,
    /// A file.
    File(PathBuf),
}

impl From<PathBuf> for Target {
    /// Standard output for `-` and its other names, else a file.
    fn from(path: PathBuf) -> Self {
        const STDOUT: [&str; 4] = ["-", "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"];
        if STDOUT.iter().any(|name| path.as_os_str() == *name) {
            Self::Stdout
        } else {
            Self::File(path)
        }
    }
}

/// A target being written.
pub(crate) struct Sink {
    /// What messages call it.
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

    /// Ends it; a file takes its name.
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
