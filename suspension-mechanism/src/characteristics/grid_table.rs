//! Quantities at the places of a grid and their derivatives with respect to each drive, in the file's units.

use suspension_core::Signal;

use crate::mechanism::{Angle, DRIVES_AT_ONCE, Description, Gradient, Place, State};
use crate::quantities::{
    Column, Compiled, DRIVES, Reader, Shown, catalogue, columns_in, is_driven_angle,
};

/// The numbers read at each place of a grid: all quantities that positions determine, with derivatives up to an
/// order.
pub struct GridTable {
    /// Each quantity with the factor to its value in the file.
    quantities: Vec<(Column, f64)>,
    /// The same quantities with the first derivatives with respect to several drives at once, and the place in a row
    /// where these start; `None` for a quantity without derivatives.
    gradients: Vec<(Column<Gradient>, Option<usize>)>,
    /// The count of numbers in a row.
    width: usize,
    /// The columns of drives that are angles, which are stated in the unit `angle`.
    driven_angles: Vec<usize>,
    angle: Angle,
    /// For each drive with derivatives, the divisor of a number.
    drives: Vec<f64>,
    /// The highest order of derivatives.
    derivatives: usize,
}

impl GridTable {
    /// The table of a mechanism: without derivatives, with the first ones, or with the second ones too.
    pub fn new(mechanism: &Description, derivatives: usize) -> Self {
        let Description { names, unit, .. } = mechanism;
        let of_drives = names.drives.iter().filter(|_| derivatives > 0);
        let drives: Vec<f64> = of_drives
            .map(|drive| unit.file_factor(drive.kind))
            .collect();
        let scaled = |column: Column| {
            let scale = unit.file_factor(column.dimension);
            (column, scale)
        };
        let quantities: Vec<_> = columns_of_positions(mechanism).map(scaled).collect();
        let driven_angles = quantities.iter().enumerate();
        let driven_angles = driven_angles.filter(|(_, (column, _))| is_driven_angle(column));
        let driven_angles = driven_angles.map(|(index, _)| index).collect();
        let mut width = quantities.len();
        let behind = |column: Column<Gradient>| {
            let start = has_derivatives(&column).then_some(width);
            width += start.map_or(0, |_| drives.len() * derivatives);
            (column, start)
        };
        Self {
            gradients: columns_of_positions(mechanism).map(behind).collect(),
            quantities,
            width,
            driven_angles,
            angle: unit.angle,
            drives,
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
        let derivatives = self.columns_with_derivatives().flat_map(|(_, column)| {
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

    /// The numbers of a place; derivatives are NaN if the mechanism locks.
    pub fn row(&self, place: &dyn Place) -> Vec<f64> {
        let mut row = if self.derivatives == 1 {
            self.row_from_gradients(place)
        } else {
            self.row_from_signals(place)
        };
        for drive in &self.driven_angles {
            row[*drive] = self.angle.as_stated(row[*drive]);
        }
        row
    }

    fn row_from_gradients(&self, place: &dyn Place) -> Vec<f64> {
        let state = place.state();
        let mut row = vec![f64::NAN; self.width];
        for first in (0..self.drives.len()).step_by(DRIVES_AT_ONCE) {
            let at = place.gradient(&state, first);
            let reader = Reader::with_numbers(&state, &*at);
            let columns = self.gradients.iter().zip(&self.quantities).enumerate();
            for (index, ((column, derivatives), (_, scale))) in columns {
                let number = column.read(&reader);
                row[index] = number.value * scale;
                if let Some(start) = derivatives {
                    let places = row[start + first..].iter_mut();
                    let per = places.zip(&self.drives[first..]);
                    for ((place, per), rate) in per.zip(number.rates) {
                        *place = rate * scale / per;
                    }
                }
            }
        }
        row
    }

    fn row_from_signals(&self, place: &dyn Place) -> Vec<f64> {
        let read = |state: State| -> Vec<Signal<f64>> {
            let reader = Reader::new(&state);
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
        let mut row = Vec::with_capacity(self.width);
        row.extend(values);
        for (index, _) in self.columns_with_derivatives() {
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

    fn columns_with_derivatives(&self) -> impl Iterator<Item = (usize, &Column)> {
        let columns = self.quantities.iter().map(|(column, _)| column).enumerate();
        columns.filter(|(_, column)| has_derivatives(column))
    }
}

fn has_derivatives<N: Compiled>(column: &Column<N>) -> bool {
    column.has_derivatives && !column.is(&DRIVES)
}

/// The columns of all quantities that positions determine.
pub fn columns_of_positions<N: Compiled>(
    mechanism: &Description,
) -> impl Iterator<Item = Column<N>> {
    let all = columns_in(catalogue(), &mechanism.names).into_iter();
    all.filter(|column| {
        column.dimension.is_of_positions() && column.quantity.shown != Shown::InSummaries
    })
}
