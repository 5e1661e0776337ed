//! The numbers of the model at the places of a measured table.

use std::sync::atomic::AtomicBool;

use nalgebra::{DMatrix, DVector};

use super::columns::KnownColumn;
use crate::failure::Failure;
use crate::kinematics::Kinematics;
use crate::mechanism::{CountedFrom, DerivativeOrder, Grid, GridAxis, Place};
use crate::quantities::{Column, Reader};

/// What moves the model to places, which count from the design position.
pub(super) struct MovedModel<'a> {
    pub(super) file: &'a str,
    pub(super) mechanism: &'a dyn Kinematics,
    /// The columns that say where the model is.
    pub(super) leads: &'a [KnownColumn],
    pub(super) interrupted: &'a AtomicBool,
}

/// What a place is for the columns of wheel travel.
enum Arrival {
    /// All wheels are where they should be; the quantities there.
    There(Vec<f64>),
    /// The step of the columns that leads there by Newton's method; `None` if the mechanism locks.
    Off(Option<DVector<f64>>),
}

impl MovedModel<'_> {
    /// Reads quantities where the columns that lead have these numbers; `None` if the model does not reach the place.
    ///
    /// # Errors
    ///
    /// [`Failure::Interrupted`].
    pub(super) fn read(
        &self,
        numbers: &[f64],
        quantities: &[&Column],
    ) -> Result<Option<Vec<f64>>, Failure> {
        const STEPS: usize = 20;
        let each = self.leads.iter().zip(numbers);
        let wanted = each.clone().map(|(lead, at)| at / lead.stated.scale);
        let wanted = DVector::from_iterator(numbers.len(), wanted);
        // The drive of wheel travel is unknown, and begins at the design position.
        let known = each.zip(&wanted);
        let known = known.map(|((lead, _), at)| lead.travel().map_or(*at, |_| 0.0));
        let mut changes = DVector::from_iterator(numbers.len(), known);
        let mut step = DVector::zeros(numbers.len());
        for _ in 0..STEPS {
            let next = &changes + &step;
            match self.visit(&next, &mut |place| self.arrival(place, &wanted, quantities))? {
                Some(Arrival::There(found)) => return Ok(Some(found)),
                Some(Arrival::Off(Some(further))) => (changes, step) = (next, further),
                // Half the way may be within reach.
                Some(Arrival::Off(None)) | None => step /= 2.0,
            }
            if step.amax() == 0.0 {
                break;
            }
        }
        Ok(None)
    }

    fn arrival(&self, place: &dyn Place, wanted: &DVector<f64>, quantities: &[&Column]) -> Arrival {
        let rounding = 1e-12 * self.mechanism.unit.metre();
        let state = place.state();
        let off = self.leads.iter().zip(wanted).map(|(lead, wanted)| {
            let travel = lead.travel();
            travel.map_or(0.0, |travel| wanted - travel.along(&state).value)
        });
        let off = DVector::from_iterator(wanted.len(), off);
        if off.amax() <= rounding {
            let reader = Reader::new(&state);
            let each = quantities.iter();
            return Arrival::There(each.map(|column| column.read(&reader).value).collect());
        }
        Arrival::Off(self.step(place, &off))
    }

    /// Returns the change of the drives of wheel travel that takes the wheels to where they should be, to first order.
    fn step(&self, place: &dyn Place, off: &DVector<f64>) -> Option<DVector<f64>> {
        let count = self.leads.len();
        let mut rates = DMatrix::identity(count, count);
        for (index, lead) in self.leads.iter().enumerate() {
            if lead.travel().is_none() {
                continue;
            }
            let (drive, _) = lead.stated.named.drives[0];
            let state = place.per(drive)?;
            for (other, row) in self.leads.iter().enumerate() {
                if let Some(travel) = row.travel() {
                    rates[(other, index)] = travel.along(&state).rate;
                }
            }
        }
        let step = rates.lu().solve(off)?;
        step.iter().all(|it| it.is_finite()).then_some(step)
    }

    /// Moves the model straight from the design position to a change of each column, and reads there.
    fn visit<R>(
        &self,
        changes: &DVector<f64>,
        read: &mut dyn FnMut(&dyn Place) -> R,
    ) -> Result<Option<R>, Failure> {
        let each = self.leads.iter().zip(changes);
        let drives = each.flat_map(|(lead, change)| {
            let drives = lead.stated.named.drives.iter();
            drives.map(move |(drive, per)| (*drive, per * change))
        });
        let there = GridAxis {
            drives: drives.collect(),
            values: vec![1.0],
        };
        let grid = Grid::new(self.mechanism, vec![there], CountedFrom::Start);
        let grid = grid.map_err(|message| Failure::input(self.file, message))?;
        let order = DerivativeOrder::First;
        let visited = self.mechanism.visit(&grid, order, self.interrupted, read);
        match visited.failure(self.file) {
            Some(failure @ Failure::Interrupted(_)) => Err(failure),
            _ => Ok(visited.places.into_iter().flatten().next()),
        }
    }
}
