//! The quantities of a design.

use crate::kinematics::Kinematics;
use crate::mechanism::Place;
use crate::quantities::{Column, Reader};

/// The value and derivatives of each column at the start of a mechanism.
pub fn design_values(mechanism: &dyn Kinematics, columns: &[Column]) -> Option<Vec<Vec<f64>>> {
    let mut of_place = |place: &dyn Place| {
        let state = place.state();
        let reader = Reader::new(&state);
        let drives = 0..mechanism.names.drives.len();
        let per: Vec<_> = drives.map(|drive| place.per(drive)).collect();
        let per: Vec<_> = per
            .iter()
            .map(|state| state.as_ref().map(Reader::new))
            .collect();
        let of_column = |column: &Column| {
            let rates = per.iter().map(|reader| {
                let reader = reader.as_ref().filter(|_| column.has_derivatives);
                reader.map_or(f64::NAN, |reader| column.read(reader).rate)
            });
            [column.read(&reader).value]
                .into_iter()
                .chain(rates)
                .collect()
        };
        columns.iter().map(of_column).collect()
    };
    mechanism.at_start(&mut of_place)
}
