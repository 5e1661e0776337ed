//! Which quantities of a motion file lead: its drives, or a measure in place of one of them.

use toml::Spanned;

use crate::failure::Failure;
use crate::input::check;
use crate::input::file::Table;
use crate::input::source::Source;

/// A measure that stands in for a drive.
#[derive(Clone, Debug, PartialEq)]
pub struct StandIn {
    /// Its name, with its place in the file.
    pub key: Spanned<String>,
    /// Its index among the measures.
    pub measure: usize,
    /// The index of the drive that it sets free.
    pub drive: usize,
}

/// The measure that stands in for a drive; `None` where all drives lead themselves.
///
/// # Errors
///
/// [`Failure::Input`] at a name that is neither, at a measure too many, or where a drive is missing
/// for which nothing stands in.
pub fn stand_in<V>(
    source: &Source,
    table: &Table<V>,
    drives: &[&str],
    measures: &[&str],
) -> Result<Option<StandIn>, Failure> {
    check::known_names(source, table, "drive", &[drives, measures].concat())?;
    let entries = table.get_ref();
    let missing: Vec<usize> = (0..drives.len())
        .filter(|index| !entries.contains_key(drives[*index]))
        .collect();
    let index = |key: &Spanned<String>| measures.iter().position(|name| name == key.get_ref());
    let mut leading: Vec<_> = entries
        .keys()
        .filter_map(|key| Some((key, index(key)?)))
        .collect();
    leading.sort_by_key(|(key, _)| key.span().start);
    match (leading.as_slice(), missing.as_slice()) {
        ([], []) => Ok(None),
        ([(key, measure)], [drive]) => Ok(Some(StandIn {
            key: (*key).clone(),
            measure: *measure,
            drive: *drive,
        })),
        ([], [drive, ..]) => {
            let message = format!("drive `{}` is missing", drives[*drive]);
            Err(source.refuse(&table.span(), message))
        }
        ([(key, _)], []) => {
            let message = format!(
                "measure `{}` can lead only in place of a drive; leave out one of {}",
                key.get_ref(),
                drives.join(", ")
            );
            Err(source.refuse(&key.span(), message))
        }
        ([(key, _)], [_, drive, ..]) => {
            let message = format!(
                "drive `{}` is missing; measure `{}` stands in for one drive only",
                drives[*drive],
                key.get_ref()
            );
            Err(source.refuse(&table.span(), message))
        }
        ([(first, _), (second, _), ..], _) => {
            let message = format!(
                "measure `{}` cannot lead beside measure `{}`: one may stand in for a drive",
                second.get_ref(),
                first.get_ref()
            );
            Err(source.refuse(&second.span(), message))
        }
    }
}
