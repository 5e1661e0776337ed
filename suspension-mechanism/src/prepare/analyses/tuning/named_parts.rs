//! The parts of a mechanism that a motion file names, by index.

use suspension_listing::did_you_mean::unknown;
use toml::Spanned;

use crate::failure::Failure;
use crate::file::Source;
use crate::mechanism::Description;
use crate::number::number;

/// A mechanism, and the file that names parts of it.
#[derive(Clone, Copy)]
pub(crate) struct Naming<'a> {
    pub(crate) source: &'a Source,
    pub(crate) mechanism: &'a Description,
}

impl Naming<'_> {
    pub(crate) fn point(&self, name: &Spanned<String>) -> Result<usize, Failure> {
        self.named("point", name, &self.mechanism.names.point_names())
    }

    pub(crate) fn drive(&self, name: &Spanned<String>) -> Result<usize, Failure> {
        self.named("drive", name, &self.mechanism.names.drive_names())
    }

    /// A range of lengths as an example of what to write: about so many metres either way, in the file's unit.
    pub(crate) fn example(&self, metres: f64) -> String {
        let unit = self.mechanism.unit;
        let end = metres * unit.metre();
        let digit = 10.0_f64.powf(end.log10().floor());
        let end = number((end / digit).round() * digit);
        format!("[-{end}, {end}] in {}", unit.length.in_words())
    }

    /// The index of a name among the known ones.
    pub(crate) fn named(
        &self,
        what: &str,
        name: &Spanned<String>,
        known: &[&str],
    ) -> Result<usize, Failure> {
        let wanted = name.get_ref().as_str();
        let found = known.iter().position(|each| *each == wanted);
        found.ok_or_else(|| {
            let message = unknown(what, wanted, known);
            self.source.refuse(&name.span(), message)
        })
    }
}
