//! The tolerances of a motion file, by hardpoint and length.

use suspension_listing::did_you_mean::unknown;

use crate::failure::Failure;
use crate::file::{MotionFile, Source};
use crate::mechanism::Description;
use crate::sensitivities::{Change, coordinates, length};
use crate::tolerances::Tolerance;

/// The tolerances that a file states: of a point's three coordinates, and of a link's length.
///
/// # Errors
///
/// [`Failure::Input`] at a name that is neither a point nor a link, and at a number that is not a standard deviation.
pub(crate) fn tolerances(
    source: &Source,
    file: &MotionFile,
    mechanism: &Description,
) -> Result<Vec<Tolerance>, Failure> {
    let Some(table) = &file.tolerances else {
        return Ok(Vec::new());
    };
    let names = &mechanism.names;
    let followers = file.followers(&names.points);
    let changes = |name: &str| -> Option<Vec<Change>> {
        match names.points.iter().position(|point| point == name) {
            Some(point) => Some(coordinates(mechanism, point, &followers).collect()),
            None => Some(vec![length(mechanism, names.link(name)?)]),
        }
    };
    let mut found = Vec::new();
    for (name, deviation) in table.get_ref().iter() {
        let changes = changes(name.get_ref()).ok_or_else(|| {
            let known = names.points.iter().map(String::as_str);
            let known: Vec<&str> = known.chain(names.links().map(|(link, _)| link)).collect();
            let message = unknown("point or link", name.get_ref(), &known);
            source.refuse(&name.span(), message)
        })?;
        let value = *deviation.get_ref();
        if !(value.is_finite() && value >= 0.0) {
            let message = "a tolerance must be zero or a positive number: the standard deviation in the unit of lengths";
            return Err(source.refuse(&deviation.span(), message));
        }
        found.extend(changes.into_iter().map(|change| Tolerance {
            change,
            deviation: value,
        }));
    }
    Ok(found)
}
