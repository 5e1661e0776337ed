//! The derivatives on the page.

use crate::characteristics::{Derivative, Parameter, Rise, Way};
use crate::mechanism::{Description, Unit};

/// The derivatives of all quantities with respect to a drive, or to the height of the wheel that it moves.
pub(super) struct Derivatives {
    /// The drive or the height, in words.
    pub(super) heading: String,
    way: usize,
    /// For derivatives with respect to the height of the wheel: the rise of the wheel per drive.
    rise: Option<Rise>,
}

impl Derivatives {
    /// Returns the derivatives with respect to the drives of travel and steering. If a drive of travel is not the height of
    /// its wheel, those with respect to this height follow.
    pub(super) fn collect(mechanism: &Description, rises: &[Option<Rise>]) -> Vec<Self> {
        let ways = Way::of_drives(&mechanism.names).into_iter().enumerate();
        let both = ways.zip(rises).flat_map(|((way, (_, drive)), rise)| {
            let name = &mechanism.names.drives[drive].name;
            let per_drive = Self {
                heading: format!("per {name}"),
                way,
                rise: None,
            };
            let rise = rise.as_ref().filter(|rise| !rise.is_height);
            let per_rise = rise.map(|rise| Self {
                heading: format!("per wheel travel ({name})"),
                way,
                rise: Some(rise.clone()),
            });
            [Some(per_drive), per_rise].into_iter().flatten()
        });
        both.collect()
    }

    /// Returns the derivative of a quantity, with lengths in `unit`.
    pub(super) fn derivative(&self, parameter: &Parameter, unit: Unit) -> Option<Derivative> {
        match &self.rise {
            Some(rise) => parameter.per_rise(self.way, rise, unit),
            None => parameter.per[self.way].clone(),
        }
    }
}
