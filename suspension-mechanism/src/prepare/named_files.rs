//! Files that a motion file names.

use toml::Spanned;

use crate::failure::Failure;
use crate::file::Source;

/// Reads a file whose path counts from the folder of the motion file.
///
/// # Errors
///
/// [`Failure::Input`] at the path if there is no such text.
pub(super) fn read_beside(source: &Source, path: &Spanned<String>) -> Result<Source, Failure> {
    Source::read(&source.beside(path.get_ref())).map_err(|failure| match failure {
        Failure::Input(message) => source.refuse(&path.span(), message),
        other => other,
    })
}
