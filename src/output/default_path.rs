//! Where results of a motion file go if no option says it.

use std::borrow::Cow;
use std::path::{Path, PathBuf};

use crate::output::target::Target;

/// Returns the name of a file without its ending: `corner.v2` for `files/corner.v2.toml`.
pub fn name_of(file: &Path) -> Cow<'_, str> {
    file.file_stem().unwrap_or_default().to_string_lossy()
}

/// Returns `out/NAME` with an ending, NAME being the motion file's name.
pub fn in_out(file: &Path, ending: &str) -> PathBuf {
    Path::new("out").join(format!("{}{ending}", name_of(file)))
}

/// Returns the place that `--out` names, or else [`in_out`].
pub fn target(out: Option<&Path>, file: &Path, ending: &str) -> Target {
    Target::from(out.map_or_else(|| in_out(file, ending), Path::to_owned))
}
