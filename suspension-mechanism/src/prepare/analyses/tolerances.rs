//! The tolerances of a motion file, by hardpoint and length.

use std::ops::Range;

use suspension_listing::did_you_mean::unknown;

use crate::failure::Failure;
use crate::mechanism::Description;
use crate::prepare::loaded::Loaded;
use crate::prepare::notes;
use crate::sensitivities::{Change, coordinates, length};
use crate::tolerances::Tolerance;

/// The usual standard deviations of hardpoints, in metres.
const USUAL: Range<f64> = 1e-6..0.02;

impl Loaded<'_> {
    /// The tolerances that a file states: of a point's three coordinates, and of a link's length.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] at a name that is neither a point nor a link, and at a number that is not a standard deviation.
    pub fn tolerances(&self, mechanism: &Description) -> Result<Vec<Tolerance>, Failure> {
        let Some(table) = &self.file.tolerances else {
            return Ok(Vec::new());
        };
        let names = &mechanism.names;
        let followers = self.file.followers(&names.points);
        let changes = |name: &str| -> Option<Vec<Change>> {
            match names.point(name) {
                Some(point) => Some(coordinates(mechanism, point, &followers).collect()),
                None => Some(vec![length(mechanism, names.link(name)?)]),
            }
        };
        let each = table.get_ref().iter().map(|(name, deviation)| {
            let changes = changes(name.get_ref()).ok_or_else(|| {
                let mut known = names.point_names();
                known.extend(names.links().map(|(link, _)| link));
                let message = unknown("point or link", name.get_ref(), &known);
                self.source.refuse(&name.span(), message)
            })?;
            let value = *deviation.get_ref();
            if !(value.is_finite() && value >= 0.0) {
                let message = "a tolerance must be zero or a positive number: the standard deviation in the unit of lengths";
                return Err(self.source.refuse(&deviation.span(), message));
            }
            let tolerances = changes.into_iter().map(|change| Tolerance {
                change,
                deviation: value,
            });
            Ok(Vec::from_iter(tolerances))
        });
        Ok(Failure::all(each)?.concat())
    }

    /// A note on the first tolerance that seems to be in another unit.
    pub fn doubtful_tolerance(&self) -> Option<String> {
        let stated = self.file.tolerances.as_ref()?.get_ref();
        let note = stated.iter().find_map(|(name, deviation)| {
            let what = format!("the tolerance of `{}`", name.get_ref());
            let deviation = *deviation.get_ref();
            let stated = (deviation > 0.0).then_some(deviation)?;
            notes::length(self.file.length, &what, stated, USUAL)
        })?;
        Some(format!("{}: {note}", self.source.name()))
    }
}
