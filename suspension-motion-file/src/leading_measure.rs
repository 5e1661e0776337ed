//! The prescribed quantities of a motion file: its drives, or a measure in place of one of them.

use toml::Spanned;

use crate::check;
use crate::failure::Failure;
use crate::source::Source;
use crate::tables::entries::Table;

/// A measure that replaces a drive.
#[derive(Clone, Debug, PartialEq)]
pub struct LeadingMeasure {
    /// The measure's name, with its place in the file.
    pub key: Spanned<String>,
    /// The index of the measure.
    pub measure: usize,
    /// The index of the drive that becomes free.
    pub drive: usize,
}

/// Returns the measure that replaces a drive; `None` if the file prescribes all drives.
///
/// # Errors
///
/// [`Failure::Input`] at a name that is neither a drive nor a measure, at a second measure, or if a drive is missing and no
/// measure replaces it.
pub fn leading_measure<V>(
    source: &Source,
    table: &Table<V>,
    drives: &[&str],
    measures: &[&str],
) -> Result<Option<LeadingMeasure>, Failure> {
    let mut has = format!("the drives are {}", drives.join(", "));
    if !measures.is_empty() {
        has += &format!(
            ", and one of them may be replaced by {}",
            measures.join(", ")
        );
    }
    check::known_names(source, table, "drive", &[drives, measures].concat(), &has)?;
    let missing = (0..drives.len()).filter(|index| !table.get_ref().has(drives[*index]));
    let missing: Vec<usize> = missing.collect();
    let number = |key: &Spanned<String>| measures.iter().position(|name| name == key.get_ref());
    let leading = table
        .get_ref()
        .iter()
        .filter_map(|(key, _)| Some((key, number(key)?)));
    let leading: Vec<_> = leading.collect();
    let (place, message) = match (leading.as_slice(), missing.as_slice()) {
        ([], []) => return Ok(None),
        ([(key, measure)], [drive]) => {
            return Ok(Some(LeadingMeasure {
                key: (*key).clone(),
                measure: *measure,
                drive: *drive,
            }));
        }
        ([], [drive, ..]) => {
            let name = drives[*drive];
            let message = format!(
                "drive `{name}` is missing; write {name} = its value, or [value, rate, ...], under [drives]"
            );
            (table.span(), message)
        }
        ([(key, _)], []) => {
            let (name, drives) = (key.get_ref(), drives.join(", "));
            let message =
                format!("measure `{name}` can only replace a drive; leave out one of {drives}");
            (key.span(), message)
        }
        ([(key, _)], [_, drive, ..]) => {
            let (name, drive) = (key.get_ref(), drives[*drive]);
            let message =
                format!("drive `{drive}` is missing; measure `{name}` replaces only one drive");
            (table.span(), message)
        }
        ([(first, _), (second, _), ..], _) => {
            let [first, name] = [first, second].map(|key| key.get_ref());
            let message = format!(
                "measures `{first}` and `{name}` cannot both replace a drive; leave out one of them"
            );
            (second.span(), message)
        }
    };
    Err(source.refuse(&place, message))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read_leading(leading: &str) -> Result<Option<LeadingMeasure>, String> {
        let source = Source::new("a.toml", leading);
        let table: Table<f64> = toml::from_str(leading).expect("a table");
        let (drives, measures) = (["bump", "steer"], ["height", "spring"]);
        leading_measure(&source, &table, &drives, &measures).map_err(|failure| failure.to_string())
    }

    #[test]
    fn one_measure_replaces_the_drive_that_is_left_out() {
        assert_eq!(read_leading("bump = 1\nsteer = 2"), Ok(None));
        let found = read_leading("spring = 1\nbump = 2")
            .expect("good")
            .expect("led");
        assert_eq!((found.measure, found.drive), (1, 1));
        assert_eq!(
            (found.key.get_ref().as_str(), found.key.span()),
            ("spring", 0..6)
        );
    }

    #[test]
    fn another_set_of_drives_and_measures_is_refused_at_its_place() {
        let cases = [
            ("", "a.toml:1:1: drive `bump` is missing; write bump = "),
            ("steer = 1", "a.toml:1:1: drive `bump` is missing"),
            (
                "steer = 1\ncamber = 2",
                "a.toml:2:1: unknown drive `camber`; the drives are bump, steer, and one of them may be replaced by height, spring",
            ),
            (
                "height = 1",
                "a.toml:1:1: drive `steer` is missing; measure `height` replaces only one drive",
            ),
            (
                "bump = 1\nsteer = 1\nspring = 1",
                "a.toml:3:1: measure `spring` can only replace a drive",
            ),
            (
                "steer = 1\nspring = 1\nheight = 1",
                "a.toml:3:1: measures `spring` and `height` cannot both replace a drive",
            ),
        ];
        for (leading, expected) in cases {
            let message = read_leading(leading).expect_err(leading);
            assert!(message.starts_with(expected), "{expected}: {message}");
        }
    }
}
