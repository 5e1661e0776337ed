//! Files that appear complete or not at all, and standard output that may close early.

use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use tempfile::NamedTempFile;

use crate::failure::Failure;

/// A file being written. It takes its name only when it is finished; until then what had the
/// name before stays.
#[derive(Debug)]
pub struct Pending {
    path: PathBuf,
    sink: Sink,
}

#[derive(Debug)]
enum Sink {
    Replacing(BufWriter<NamedTempFile>),
    /// Devices and pipes cannot be replaced.
    Direct(BufWriter<File>),
}

impl Pending {
    /// Starts a file; missing folders are made.
    ///
    /// # Errors
    ///
    /// [`Failure::Output`] where the place cannot be written to.
    pub fn create(path: &Path) -> Result<Self, Failure> {
        // A symbolic link is kept, and what it points to replaced.
        let target = path.canonicalize().unwrap_or_else(|_| path.to_owned());
        open(&target)
            .map(|sink| Self { path: target, sink })
            .map_err(|error| Failure::writing(path.display(), &error))
    }

    /// Gives the file its name.
    ///
    /// # Errors
    ///
    /// [`Failure::Output`] where the rest cannot be written or the name not be taken.
    pub fn finish(self) -> Result<(), Failure> {
        let Self { path, sink } = self;
        let finished = match sink {
            Sink::Direct(file) => file.into_inner().map(drop).map_err(|e| e.into_error()),
            Sink::Replacing(file) => file
                .into_inner()
                .map_err(|error| error.into_error())
                .and_then(|file| file.persist(&path).map(drop).map_err(|e| e.error)),
        };
        finished.map_err(|error| Failure::writing(path.display(), &error))
    }
}

impl Write for Pending {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match &mut self.sink {
            Sink::Replacing(file) => file.write(bytes),
            Sink::Direct(file) => file.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match &mut self.sink {
            Sink::Replacing(file) => file.flush(),
            Sink::Direct(file) => file.flush(),
        }
    }
}

fn open(path: &Path) -> io::Result<Sink> {
    match path.metadata() {
        Ok(found) if found.is_dir() => Err(io::ErrorKind::IsADirectory.into()),
        Ok(found) if !found.is_file() => {
            let file = File::options().write(true).open(path)?;
            Ok(Sink::Direct(BufWriter::new(file)))
        }
        _ => {
            let folder = match path.parent() {
                Some(folder) if folder != Path::new("") => folder,
                _ => Path::new("."),
            };
            std::fs::create_dir_all(folder)?;
            Ok(Sink::Replacing(BufWriter::new(beside(folder)?)))
        }
    }
}

/// A temporary file in the folder of the final one, readable like any new file.
fn beside(folder: &Path) -> io::Result<NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".suspension-").suffix(".part");
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        builder.permissions(std::fs::Permissions::from_mode(0o666));
    }
    builder.tempfile_in(folder)
}

/// Writes a whole file.
///
/// # Errors
///
/// [`Failure::Output`].
pub fn write_file(path: &Path, text: &str) -> Result<(), Failure> {
    let mut file = Pending::create(path)?;
    file.write_all(text.as_bytes())
        .map_err(|error| Failure::writing(path.display(), &error))?;
    file.finish()
}

/// Writes to standard output.
///
/// # Errors
///
/// [`Failure::ReaderGone`] where it was closed, else [`Failure::Output`].
pub fn print(text: &str) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    out.write_all(text.as_bytes())
        .and_then(|()| out.flush())
        .map_err(|error| Failure::writing("standard output", &error))
}
