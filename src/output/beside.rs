//! Default names of the files written for a motion file.

use std::borrow::Cow;
use std::path::{Path, PathBuf};

/// Returns the name of a file without its ending: `corner.v2` for `files/corner.v2.toml`.
pub fn name_of(file: &Path) -> Cow<'_, str> {
    file.file_stem().unwrap_or_default().to_string_lossy()
}

/// Returns `out/NAME` with an ending, NAME being the motion file's name.
pub fn in_out(file: &Path, ending: &str) -> PathBuf {
    Path::new("out").join(format!("{}{ending}", name_of(file)))
}
