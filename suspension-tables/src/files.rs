//! Files that appear complete or not at all, and standard output that may close early.

use std::fs::{File, Permissions};
use std::io::{self, BufWriter, Write};
use std::path::{Component, Path, PathBuf};

use tempfile::{NamedTempFile, TempPath};

use suspension_mechanism::failure::Failure;
use suspension_mechanism::file::{inputs, tell};
use suspension_mechanism::interrupt;

/// A file that is being written. It gets its name only when it is finished; until then a file of that name stays.
#[derive(Debug)]
pub struct Pending {
    /// The path as the user gave it.
    path: PathBuf,
    /// The path with symbolic links resolved, so that links stay.
    target: PathBuf,
    file: BufWriter<File>,
    /// `None` for devices and pipes, which cannot be replaced.
    temporary: Option<TempPath>,
}

impl Pending {
    /// Starts a file and creates missing folders.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] if the file was read, [`Failure::Output`] if the place cannot be written to.
    pub fn create(path: &Path) -> Result<Self, Failure> {
        refuse_input(path, "the result")?;
        let target = path.canonicalize().or_else(|_| followed(path));
        let target = target.map_err(|error| Failure::writing(path.display(), &error))?;
        match open(&target) {
            Ok((file, temporary)) => Ok(Self {
                path: path.to_owned(),
                target,
                file: BufWriter::new(file),
                temporary,
            }),
            Err(error) => Err(Failure::writing(path.display(), &error)),
        }
    }

    /// Gives the file its name.
    ///
    /// # Errors
    ///
    /// [`Failure::Output`] if the rest cannot be written or the file cannot be renamed.
    pub fn finish(self) -> Result<(), Failure> {
        let Self {
            path,
            target,
            file,
            temporary,
        } = self;
        let written = file.into_inner().map_err(io::IntoInnerError::into_error);
        let finished = written.and_then(|_| match temporary {
            Some(temporary) => temporary.persist(&target).map_err(|error| error.error),
            None => Ok(()),
        });
        finished.map_err(|error| Failure::writing(path.display(), &error))
    }
}

impl Write for Pending {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.file.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

/// Resolves a path that may be a link to a file that does not exist.
fn followed(path: &Path) -> io::Result<PathBuf> {
    /// More links are a cycle, as for the system.
    const MOST_LINKS: usize = 40;
    let mut path = path.to_owned();
    for _ in 0..MOST_LINKS {
        let Ok(to) = path.read_link() else {
            return Ok(path);
        };
        path = path.parent().unwrap_or(Path::new("")).join(to);
    }
    Err(io::ErrorKind::TooManyLinks.into())
}

fn open(path: &Path) -> io::Result<(File, Option<TempPath>)> {
    let replaced = match path.metadata() {
        Ok(found) if found.is_dir() => return Err(io::ErrorKind::IsADirectory.into()),
        Ok(found) if !found.is_file() => {
            let path = path.to_owned();
            let file = interrupt::waiting(|| File::options().write(true).open(path))?;
            return Ok((file, None));
        }
        Ok(found) => Some(found.permissions()),
        Err(_) => None,
    };
    let folder = match path.parent() {
        Some(folder) if folder != Path::new("") => folder,
        _ => Path::new("."),
    };
    std::fs::create_dir_all(folder).map_err(|error| match error.kind() {
        io::ErrorKind::AlreadyExists => io::ErrorKind::NotADirectory.into(),
        _ => error,
    })?;
    let (file, temporary) = create_temporary(folder, replaced)?.into_parts();
    Ok((file, Some(temporary)))
}

/// Creates a temporary file in the folder of the final one, with the permissions of the file that it replaces or else those
/// of any new file. Errors do not contain its name: the user did not give it.
fn create_temporary(folder: &Path, replaced: Option<Permissions>) -> io::Result<NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".suspension-").suffix(".part");
    let made = builder.make_in(folder, |path| File::create_new(path))?;
    if let Some(permissions) = replaced {
        made.as_file().set_permissions(permissions)?;
    }
    Ok(made)
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

/// Writes to standard output. Where its reader has gone the program goes on: there may be files to write.
///
/// # Errors
///
/// [`Failure::Output`].
pub fn print(text: &str) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    let written = out.write_all(text.as_bytes()).and_then(|()| out.flush());
    unless_reader_gone(written.map_err(|error| Failure::writing("standard output", &error)))
}

/// Ignores that a reader has gone: it is no failure.
pub(crate) fn unless_reader_gone(written: Result<(), Failure>) -> Result<(), Failure> {
    match written {
        Err(Failure::ReaderGone) => Ok(()),
        written => written,
    }
}

/// Prints the names of the written files.
pub fn announce(written: impl IntoIterator<Item = impl AsRef<Path>>) {
    for path in written {
        tell(format_args!("wrote {}", path.as_ref().display()));
    }
}

/// Refuses to write a table to the path of a plot. `option` is the option that names the table.
///
/// # Errors
///
/// [`Failure::Input`].
pub fn refuse_plot(table: &Path, option: &str, plots: &[PathBuf]) -> Result<(), Failure> {
    let place = resolved(table);
    if !plots.iter().any(|plot| resolved(plot) == place) {
        return Ok(());
    }
    Err(Failure::Input(format!(
        "{}: --plots draws to this file, which {option} names too",
        table.display()
    )))
}

/// Resolves a path, whether the file exists or not.
pub(crate) fn resolved(path: &Path) -> PathBuf {
    let path = followed(path).unwrap_or_else(|_| path.to_owned());
    let path = std::path::absolute(&path).unwrap_or(path);
    let mut found = PathBuf::new();
    for component in path.components() {
        match component {
            Component::ParentDir => drop(found.pop()),
            other => found.push(other),
        }
        found = found.canonicalize().unwrap_or(found);
    }
    found
}

/// Refuses to overwrite an input file ([`inputs::note`]) with a result. `option` is the option that names the result.
///
/// # Errors
///
/// [`Failure::Input`].
pub fn refuse_input(result: &Path, option: &str) -> Result<(), Failure> {
    if !inputs::has(result) {
        return Ok(());
    }
    let result = result.display();
    let message =
        format!("{result}: this is the file that is read, which {option} would overwrite");
    Err(Failure::Input(message))
}

/// Refuses to overwrite an existing file with a result that the user has not named with `--out`; the message proposes `out`.
///
/// # Errors
///
/// [`Failure::Input`].
pub fn refuse_existing(result: &Path, out: &Path) -> Result<(), Failure> {
    if !result.exists() {
        return Ok(());
    }
    let (result, out) = (result.display(), out.display());
    let message = format!("{result}: exists already; --out {out} replaces it");
    Err(Failure::Input(message))
}
