//! Default names of the files written for a motion file.

use std::borrow::Cow;
use std::path::{Path, PathBuf};

/// The name of a file without its ending: `corner.v2` of `files/corner.v2.toml`.
pub fn name_of(file: &Path) -> Cow<'_, str> {
    file.file_stem().unwrap_or_default().to_string_lossy()
}

/// `out/NAME` with an ending, NAME being that of the motion file.
pub fn in_out(file: &Path, ending: &str) -> PathBuf {
    Path::new("out").join(format!("{}{ending}", name_of(file)))
}
