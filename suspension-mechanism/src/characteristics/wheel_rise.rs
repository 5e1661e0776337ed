//! Drives of travel that are heights of wheels, and others.

use crate::characteristics::movement::Movement;
use crate::characteristics::parameters::{Derivative, Parameter, is_height_per_height};
use crate::mechanism::{Description, Unit};
use crate::quantities::{Axis, CENTRE};

/// The rise of the wheel of a drive of travel, at the design position.
#[derive(Clone, Copy, Debug)]
pub struct Rise {
    /// The number of the drive.
    pub drive: usize,
    /// Whether the drive is itself a height of the wheel, upwards or downwards.
    pub is_height: bool,
}

impl Rise {
    /// The rise for each of the drives of [`Movement::of_drives`], from parameters with lengths in `unit`; `None` for
    /// drives that move no wheel up and down.
    pub fn of_drives(
        mechanism: &Description,
        parameters: &[Parameter],
        unit: Unit,
    ) -> Vec<Option<Self>> {
        const ROUNDING: f64 = 1e-9;
        let movements = Movement::of_drives(&mechanism.names)
            .into_iter()
            .enumerate();
        let rise = |(movement, (_, drive)): (usize, (Movement, usize))| {
            let height = height_of(mechanism, parameters, drive)?;
            let Derivative { value, symbol } = height.per[movement].as_ref()?;
            let is_height =
                is_height_per_height(symbol, unit) && (value.abs() - 1.0).abs() < ROUNDING;
            Some(Self { drive, is_height })
        };
        movements.map(rise).collect()
    }
}

/// The height of the wheel that a drive moves up and down.
pub(super) fn height_of<'a>(
    mechanism: &Description,
    parameters: &'a [Parameter],
    drive: usize,
) -> Option<&'a Parameter> {
    let mut wheels = mechanism.names.wheels.iter();
    let wheel = wheels.find(|wheel| wheel.travel == Some(drive))?;
    let is_height = |parameter: &&Parameter| {
        let wheel_name = parameter.title.wheel.as_deref().unwrap_or_default();
        parameter.is(&CENTRE, Axis::Z) && wheel_name == wheel.name
    };
    parameters.iter().find(is_height)
}
