//! Derivatives with respect to the height of a wheel with the other wheels held, for any drives.

use nalgebra::DMatrix;

use crate::characteristics::parameters::{Derivative, Parameter, is_height_per_height, symbol_per};
use crate::characteristics::wheel_rise::height_of;
use crate::file::Dimension;
use crate::mechanism::{Description, Unit};

/// The rise of the wheels per drive of travel at the design position; the drives are the first ones of
/// [`Movement::of_drives`](crate::characteristics::Movement::of_drives).
#[derive(Clone, Debug)]
pub struct Rises {
    /// The rise of the wheel of each drive (a row) per unit of each drive, upwards.
    heights: DMatrix<f64>,
    /// The change of each drive (a row) per rise of the wheel of each drive, with the other wheels held.
    drives: DMatrix<f64>,
    /// The unit of the heights per unit of each drive.
    symbols: Vec<String>,
}

impl Rises {
    /// Computes the rises from parameters; `None` if the drives do not move the wheels independently, for example if
    /// two are alike, or if derivatives are missing.
    pub fn compute(mechanism: &Description, parameters: &[Parameter]) -> Option<Self> {
        let [.., up] = mechanism.axes.signs();
        let travel = &mechanism.names.vehicle.travel;
        let mut heights = DMatrix::zeros(travel.len(), travel.len());
        let mut symbols = vec![String::new(); travel.len()];
        for (wheel, drive) in travel.iter().enumerate() {
            let height = height_of(mechanism, parameters, *drive)?;
            for (movement, symbol) in symbols.iter_mut().enumerate() {
                let per = height.per[movement].as_ref()?;
                heights[(wheel, movement)] = up * per.value;
                symbol.clone_from(&per.symbol);
            }
        }
        let drives = heights.clone().try_inverse()?;
        Some(Self {
            heights,
            drives,
            symbols,
        })
    }

    /// The number of drives, and of wheels.
    pub fn count(&self) -> usize {
        self.symbols.len()
    }

    /// The rise of the wheel of one drive per unit of another drive.
    pub fn rise(&self, wheel: usize, movement: usize) -> f64 {
        self.heights[(wheel, movement)]
    }

    /// Whether a drive is itself the height of its wheel, counted upwards, and no other drive has to change for the other
    /// wheels to be held.
    pub fn is_height(&self, movement: usize, unit: Unit) -> bool {
        const ROUNDING: f64 = 1e-9;
        let changes = self.drives.column(movement);
        let mut changes = changes.iter().enumerate();
        is_height_per_height(&self.symbols[movement], unit)
            && changes.all(|(drive, change)| {
                let wanted = f64::from(u8::from(drive == movement));
                (change - wanted).abs() < ROUNDING
            })
    }

    /// The unit of rises per unit of a drive.
    pub fn symbol(&self, movement: usize) -> &str {
        &self.symbols[movement]
    }
}

impl Parameter {
    /// The derivative with respect to the height of the wheel of a drive, with the other wheels held at theirs.
    pub fn per_wheel(&self, wheel: usize, rises: &Rises, unit: Unit) -> Option<Derivative> {
        let by_drives = self.per.iter().zip(rises.drives.column(wheel));
        let parts = by_drives.map(|(per, drive)| Some(per.as_ref()?.value * drive));
        Some(Derivative {
            value: parts.sum::<Option<f64>>()?,
            symbol: symbol_per(&self.symbol, Dimension::Length, unit),
        })
    }
}
