//! The derivatives on the page.

use crate::characteristics::{Derivative, Movement, Parameter, Rises};
use crate::mechanism::{Description, Unit};

/// The derivatives of all quantities with respect to a drive, or to the height of the wheel that it moves.
pub(super) struct Derivatives<'a> {
    /// The drive or the height, in words.
    pub(super) heading: String,
    movement: usize,
    /// For derivatives with respect to the height of the wheel: the rises of the wheels per drive.
    rises: Option<&'a Rises>,
}

impl<'a> Derivatives<'a> {
    /// Returns the derivatives with respect to the drives of travel and steering. If a drive of travel is not the height of
    /// its wheel, counted upwards, with the other wheels held, those with respect to this height follow.
    pub(super) fn collect(mechanism: &Description, rises: Option<&'a Rises>) -> Vec<Self> {
        let movements = Movement::of_drives(&mechanism.names)
            .into_iter()
            .enumerate();
        let both = movements.flat_map(|(movement, (_, drive))| {
            let name = &mechanism.names.drives[drive].name;
            let per_drive = Self {
                heading: format!("per {name}"),
                movement,
                rises: None,
            };
            let is_other = |rises: &&Rises| {
                movement < rises.count() && !rises.is_height(movement, mechanism.unit)
            };
            let per_wheel = rises.filter(is_other).map(|rises| Self {
                heading: format!("per wheel travel ({name})"),
                movement,
                rises: Some(rises),
            });
            [Some(per_drive), per_wheel].into_iter().flatten()
        });
        both.collect()
    }

    /// Returns the derivative of a quantity, with lengths in `unit`.
    pub(super) fn derivative(&self, parameter: &Parameter, unit: Unit) -> Option<Derivative> {
        match self.rises {
            Some(rises) => parameter.per_wheel(self.movement, rises, unit),
            None => parameter.per[self.movement].clone(),
        }
    }
}
