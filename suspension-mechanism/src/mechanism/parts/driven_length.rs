//! A driven length at zero, where its points meet.

use suspension_runtime::Listing;

/// A length that a drive prescribes, such as that of an actuator.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DrivenLength {
    /// The number of the drive.
    pub drive: usize,
    /// The points that it is between.
    pub ends: [String; 2],
}

impl DrivenLength {
    /// All driven lengths of a listing with this number of drives.
    pub(crate) fn all(listing: &Listing, drives: usize) -> Vec<Self> {
        let lengths = (0..drives).filter_map(|drive| {
            let ends = listing.driven_length(drive)?.map(str::to_owned);
            Some(Self { drive, ends })
        });
        lengths.collect()
    }

    /// The length that is zero to rounding, in a mechanism of this size with these values of its drives, in the
    /// file's coordinates.
    pub(crate) fn at_zero<'a>(all: &'a [Self], drives: &[f64], size: f64) -> Option<&'a Self> {
        /// The fraction of the size below which rounding leaves no direction of the line between the points.
        const NEAR: f64 = 1e-6;
        let mut lengths = all.iter();
        lengths.find(|length| drives[length.drive].abs() < NEAR * size)
    }

    /// The message that `value` of a drive is less than zero, if that is one of these lengths: only the square of a length
    /// enters the equations.
    pub fn below_zero(all: &[Self], drive: usize, value: f64) -> Option<String> {
        let length = all.iter().find(|length| length.drive == drive)?;
        let [from, to] = &length.ends;
        (value < 0.0)
            .then(|| format!("the length from `{from}` to `{to}` cannot be less than zero"))
    }

    /// The message that it is zero.
    pub(crate) fn fault(&self) -> String {
        let [from, to] = &self.ends;
        format!("the length is zero, where `{from}` and `{to}` meet, and cannot be less")
    }
}
