//! Quantities at the places of a grid, with their derivatives with respect to each drive, in the file's units.

use suspension_core::Signal;

use crate::mechanism::{Description, Place, State};
use crate::quantities::{self, Column, DRIVES, Reader, Shown, catalogue};

/// What is read off each place of a grid: all quantities that positions determine, with derivatives up to an order.
pub struct GridTable {
    /// Each with what its number inside is multiplied with.
    quantities: Vec<(Column, f64)>,
    /// The same of each drive that there are derivatives with respect to.
    drives: Vec<f64>,
    /// Up to which order.
    derivatives: usize,
}

impl GridTable {
    /// Of a mechanism; without derivatives, with the first, or with the second too.
    pub fn of(mechanism: &Description, derivatives: usize) -> Self {
        let Description { names, unit, .. } = mechanism;
        let all = quantities::columns(catalogue(), names).into_iter();
        let of_positions = all.filter(|column| {
            column.kind.is_of_positions() && column.quantity.shown != Shown::InSummaries
        });
        let of_drives = names.drives.iter().filter(|_| derivatives > 0);
        Self {
            quantities: of_positions
                .map(|column| {
                    let scale = column.kind.in_file(*unit);
                    (column, scale)
                })
                .collect(),
            drives: of_drives.map(|drive| unit.per_drive(drive.kind)).collect(),
            derivatives,
        }
    }

    /// The columns' names, in the order of a row.
    pub fn names(&self, mechanism: &Description) -> Vec<String> {
        let Description { names, unit, .. } = mechanism;
        let values = self
            .quantities
            .iter()
            .map(|(column, _)| column.csv_name(*unit));
        let derivatives = self.with_derivatives().flat_map(|(_, column)| {
            let name = column.csv_name(*unit);
            let drives = names.drives.iter();
            drives.flat_map(move |drive| {
                let first = format!("{name}_per_{}", drive.name);
                let second = format!("{first}2");
                [first, second].into_iter().take(self.derivatives)
            })
        });
        values.chain(derivatives).collect()
    }

    /// The numbers of a place; derivatives are NaN where the mechanism locks.
    pub fn row(&self, place: &dyn Place) -> Vec<f64> {
        let read = |state: State| -> Vec<Signal<f64>> {
            let reader = Reader::of(&state);
            let quantities = self.quantities.iter();
            let numbers = quantities.map(|(column, scale)| (column.read(&reader), scale));
            let scaled = |(number, scale): (Signal<f64>, &f64)| number.map(|number| number * scale);
            numbers.map(scaled).collect()
        };
        let per = (0..self.drives.len()).map(|drive| place.per(drive).map(read));
        let per: Vec<Option<Vec<Signal<f64>>>> = per.collect();
        // A state with derivatives has the same values as one without.
        let alone = per.iter().all(Option::is_none).then(|| read(place.state()));
        let values = per.iter().chain([&alone]).flatten().next();
        let values = values.into_iter().flatten().map(|number| number.value);
        let mut row =
            Vec::with_capacity(self.quantities.len() * (1 + per.len() * self.derivatives));
        row.extend(values);
        for (index, _) in self.with_derivatives() {
            for (numbers, scale) in per.iter().zip(&self.drives) {
                let number = numbers.as_ref().map(|numbers| numbers[index]);
                let both = number.map_or([f64::NAN; 2], |number| {
                    [number.rate / scale, number.second_rate / (scale * scale)]
                });
                row.extend_from_slice(&both[..self.derivatives]);
            }
        }
        row
    }

    /// The columns with derivatives, by number.
    fn with_derivatives(&self) -> impl Iterator<Item = (usize, &Column)> {
        let columns = self.quantities.iter().map(|(column, _)| column).enumerate();
        columns.filter(|(_, column)| column.has_derivatives && !column.is(&DRIVES))
    }
}
