//! The listing of a motion file as one text that states the design position of each point.

use nalgebra::Vector3;
use suspension_listing::text;
use suspension_runtime::CatalogueAndFiles;

use crate::failure::Failure;
use crate::kinematics::Kinematics;
use crate::prepare::listing::points::stated_at;
use crate::prepare::listing::refused;
use crate::prepare::loaded::Loaded;

/// Numbers that differ by less than this, relative to the largest coordinate, differ by rounding.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

impl Loaded<'_> {
    /// The statements of its listing with includes and mirrors written out. Each point is stated at its place in a
    /// `mechanism` of this file at the design position, in the unit and the axes of the file; the numbers are those of the
    /// file unless the mechanism was assembled elsewhere.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] if a file that the listing includes can no longer be read.
    pub fn flat_listing(&self, mechanism: &dyn Kinematics) -> Result<String, Failure> {
        let stated = &self.file.points;
        let assembled = mechanism.points();
        let largest = assembled.iter().map(Vector3::amax).fold(0.0, f64::max);
        let places = mechanism.names.points.iter().zip(assembled);
        let places = places.map(|(name, assembled)| {
            let stated = stated_at(stated, name);
            let is_there = (stated - assembled).amax() <= ROUNDING * largest;
            (name.as_str(), if is_there { stated } else { assembled })
        });
        let places: Vec<(&str, Vector3<f64>)> = places.collect();
        let source = &self.listing.text;
        let includes = CatalogueAndFiles::beside(source.name());
        let at = |name: &str| {
            let (_, at) = places.iter().find(|(point, _)| *point == name)?;
            Some(<[f64; 3]>::from(*at))
        };
        text::flat(source.text(), source.name(), &includes, &at)
            .map_err(|mistakes| refused(source, &mistakes))
    }
}
