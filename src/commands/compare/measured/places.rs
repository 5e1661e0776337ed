//! The places of a measured table, and the numbers of the model there.

use std::sync::atomic::AtomicBool;

use super::heading::Stated;
use crate::failure::Failure;
use crate::kinematics::Kinematics;
use crate::mechanism::{Axis, CountedFrom, DerivativeOrder, Grid, Place};
use crate::number::number;
use crate::quantities::{Column, Reader, WHEEL_TRAVEL};

/// What moves the model to places, which count from the design position.
pub(super) struct Places<'a> {
    pub(super) file: &'a str,
    pub(super) mechanism: &'a dyn Kinematics,
    /// The heading of the places.
    pub(super) stated: Stated,
    /// The drives that stay at one value each, perhaps not that of the design position.
    pub(super) held: Vec<Axis>,
    pub(super) interrupted: &'a AtomicBool,
}

/// What is read at each place; `None` where it is out of reach.
type Found<R> = Result<Vec<Option<R>>, Failure>;

impl Places<'_> {
    /// Returns the wheel travel that the places count; `None` if they count changes of drives, or of the steering wheel.
    fn travel(&self) -> Option<&Column> {
        let quantity = self.stated.named.quantity.as_ref();
        quantity.filter(|quantity| quantity.is(&WHEEL_TRAVEL))
    }

    /// Returns what the places count, with their unit.
    pub(super) fn label(&self) -> String {
        let Stated { named, symbol, .. } = &self.stated;
        let change = self.travel().map_or("change of ", |_| "");
        format!("{change}{} ({symbol})", named.title)
    }

    /// Says that a place is out of reach, and which others are not.
    pub(super) fn out_of_reach(&self, at: f64, reached: Option<[f64; 2]>) -> String {
        let symbol = &self.stated.symbol;
        let reached = reached.map(|ends| ends.map(number));
        let reached = reached.map_or_else(
            || "none of the places".to_owned(),
            |[least, greatest]| format!("those from {least} to {greatest} {symbol}"),
        );
        format!(
            "{} {symbol} from the design position is out of the model's reach, which has {reached}; leave out the lines beyond. \
             suspension range {} says what stops the model",
            number(at),
            self.file
        )
    }

    /// Reads quantities at places.
    ///
    /// # Errors
    ///
    /// [`Failure::Interrupted`].
    pub(super) fn read(&self, places: &[f64], quantities: &[&Column]) -> Found<Vec<f64>> {
        let wanted: Vec<f64> = places.iter().map(|at| at / self.stated.scale).collect();
        let mut read = |place: &dyn Place| -> Vec<f64> {
            let state = place.state();
            let reader = Reader::new(&state);
            let each = quantities.iter();
            each.map(|column| column.read(&reader).value).collect()
        };
        let drives = self.stated.named.drives.clone();
        let Some(travel) = self.travel() else {
            let values = wanted;
            return self.visit(Axis { drives, values }, &mut read);
        };
        let (values, is_there) = self.changes_for(travel, drives[0].0, &wanted)?;
        let found = self.visit(Axis { drives, values }, &mut read)?;
        let found = found.into_iter().zip(is_there);
        Ok(found
            .map(|(found, is_there)| found.filter(|_| is_there))
            .collect())
    }

    /// Finds the changes of a drive for wheel travel by Newton's method, each with whether it leads there.
    fn changes_for(
        &self,
        travel: &Column,
        drive: usize,
        wanted: &[f64],
    ) -> Result<(Vec<f64>, Vec<bool>), Failure> {
        const STEPS: usize = 20;
        let rounding = 1e-12 * self.mechanism.unit.metre();
        let mut changes = vec![0.0; wanted.len()];
        let mut is_there = vec![false; wanted.len()];
        for _ in 0..STEPS {
            let axis = Axis::for_drive(drive, changes.clone());
            let found = self.visit(axis, &mut |place| {
                place.per(drive).map(|state| travel.along(&state))
            })?;
            for (index, found) in found.into_iter().enumerate() {
                // Half the way may be within reach.
                let back = -changes[index] / 2.0;
                let step = found
                    .flatten()
                    .map_or(back, |at| (wanted[index] - at.value) / at.rate);
                changes[index] += step;
                is_there[index] = step.abs() <= rounding;
            }
            if is_there.iter().all(|is_there| *is_there) {
                break;
            }
        }
        Ok((changes, is_there))
    }

    fn visit<R>(&self, axis: Axis, read: &mut dyn FnMut(&dyn Place) -> R) -> Found<R> {
        let axes = self.held.iter().cloned().chain([axis]).collect();
        let grid = Grid::new(self.mechanism, axes, CountedFrom::Start);
        let grid = grid.map_err(Failure::Input)?;
        let order = DerivativeOrder::First;
        let visited = self.mechanism.visit(&grid, order, self.interrupted, read);
        match visited.failure(self.file) {
            Some(failure @ Failure::Interrupted(_)) => Err(failure),
            _ => Ok(visited.places),
        }
    }
}
