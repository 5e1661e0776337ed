//! The assemblies of a file's mechanism.

use std::sync::atomic::AtomicBool;

use crate::assemblies::Tally;
use crate::failure::Failure;
use crate::kinematics::{Assembly, Kinematics};
use crate::mechanism::DrivenLength;
use crate::output::progress::search::Search;

/// A request for assemblies.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Request {
    /// The drive; `None` if the linkage has only one.
    pub drive: Option<String>,
    /// Values of the drive; empty for the drives at the file's first instant.
    pub at: Vec<f64>,
}

/// All assemblies at one value of the drives.
#[derive(Clone, Debug, PartialEq)]
pub struct Listed {
    /// The drives in words.
    pub drives_in_words: String,
    /// The real assemblies, nearest to the file's configuration first.
    pub assemblies: Vec<Assembly>,
    /// The numbers of real and of other assemblies.
    pub tally: Tally,
}

/// Called with the assemblies at each value of the drives.
pub type OnListed<'a> = dyn FnMut(&Listed) -> Result<(), Failure> + 'a;

/// Lists all assemblies of the file's mechanism, value by value.
///
/// # Errors
///
/// [`Failure::Input`] if the request is wrong, [`Failure::Solver`] if there is no assembly at a value,
/// [`Failure::Interrupted`], and any failure of `on_listed`.
pub fn list(
    mechanism: &dyn Kinematics,
    file: &str,
    request: &Request,
    interrupted: &AtomicBool,
    on_listed: &mut OnListed<'_>,
) -> Result<(), Failure> {
    let places = places(mechanism, file, request)?;
    let progress = Search::new(file, interrupted);
    let watch = |stage, count| progress.goes_on(stage, count);
    let mut nowhere = Vec::new();
    let mut search = mechanism.assemblies(&watch);
    for (done, drives) in places.iter().enumerate() {
        let listed = search.at(drives);
        let given_up = || progress.given_up(&format!("after {done} of the drive's values"));
        let (assemblies, tally) = listed.ok_or_else(given_up)?;
        progress.clear();
        let given = mechanism.drives_in_file(drives.iter().copied());
        let listed = Listed {
            drives_in_words: mechanism
                .names
                .drives_in_words(&given, mechanism.unit, None),
            assemblies,
            tally,
        };
        on_listed(&listed)?;
        if listed.assemblies.is_empty() {
            nowhere.push(listed.drives_in_words);
        }
    }
    progress.ended()?;
    if nowhere.is_empty() {
        return Ok(());
    }
    let design = &mechanism.design;
    let design = mechanism
        .names
        .drives_in_words(design, mechanism.unit, None);
    Err(Failure::Solver(format!(
        "{file}: no assembly was found at {}; --at has the drive's own values, the design is at {design}",
        nowhere.join(", nor at ")
    )))
}

/// Returns the drives at each requested value, or at the first instant if none is requested, in local coordinates.
fn places(
    mechanism: &dyn Kinematics,
    file: &str,
    request: &Request,
) -> Result<Vec<Vec<f64>>, Failure> {
    let first = mechanism.first_drives();
    if request.at.is_empty() {
        return Ok(vec![first]);
    }
    let refuse = |message: String| Failure::input(file, message);
    let drive = mechanism.names.chosen_drive(request.drive.as_deref());
    let drive = drive.map_err(refuse)?;
    let (kind, unit) = (mechanism.names.drives[drive].kind, mechanism.unit);
    let with = |value: &f64| {
        let inside = value / unit.file_factor(kind);
        let finite = || (!value.is_finite()).then(|| "a drive has a finite value".to_owned());
        let below_zero = || {
            let length = DrivenLength::below_zero(&mechanism.names.driven_lengths, drive, inside)?;
            Some(format!("{length}; --at has the drive's own values"))
        };
        let bounds = unit.angle.bounds_exceeded(kind, inside);
        let bounds = bounds.or_else(below_zero).or_else(finite);
        if let Some(bounds) = bounds {
            return Err(refuse(format!("--at {value}: {bounds}")));
        }
        let mut drives = first.clone();
        drives[drive] = inside - mechanism.drive_offsets[drive];
        Ok(drives)
    };
    request.at.iter().map(with).collect()
}
