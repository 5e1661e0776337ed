//! The table of a sweep: quantities, then their derivatives with respect to each drive.

use crate::failure::Failure;
use crate::mechanism::{Description, Names, State};
use crate::output::heading::{Header, Heading};
use crate::output::rows::{Forms, Rows};
use crate::quantities::{self, Column, DRIVES, Reader, Shown, catalogue};

/// The numbers of a place.
pub(super) type Row = Vec<f64>;

/// What is read off a place.
pub(super) struct Columns {
    quantities: Vec<Column>,
    drives: usize,
    derivatives: u8,
}

/// All quantities that positions determine, with derivatives up to an order.
pub(super) fn columns(names: &Names, derivatives: u8) -> Columns {
    let all = quantities::columns(catalogue(), names).into_iter();
    let of_positions = all.filter(|column| {
        column.kind.is_of_positions() && column.quantity.shown != Shown::InSummaries
    });
    Columns {
        quantities: of_positions.collect(),
        drives: names.drives.len(),
        derivatives,
    }
}

impl Columns {
    /// The numbers of a state; `per` is the state with derivatives with respect to a drive, `None` where the mechanism locks.
    pub(super) fn row(&self, state: &State, per: impl Fn(usize) -> Option<State>) -> Row {
        let reader = Reader::of(state);
        let quantities = self.quantities.iter();
        let mut row: Row = quantities
            .map(|column| column.read(&reader).value)
            .collect();
        if self.derivatives == 0 {
            return row;
        }
        let per: Vec<Option<State>> = (0..self.drives).map(per).collect();
        let readers = per.iter().map(|state| state.as_ref().map(Reader::of));
        let readers: Vec<Option<Reader<'_>>> = readers.collect();
        for column in self.with_derivatives() {
            for reader in &readers {
                let along = reader.as_ref().map(|reader| column.read(reader));
                let [first, second] =
                    along.map_or([f64::NAN; 2], |along| [along.rate, along.second_rate]);
                row.extend([first, second].iter().take(self.derivatives.into()));
            }
        }
        row
    }

    fn with_derivatives(&self) -> impl Iterator<Item = &Column> {
        let columns = self.quantities.iter();
        columns.filter(|column| column.has_derivatives && !column.is(&DRIVES))
    }
}

/// Writes the rows of all places that have a configuration.
pub(super) fn write(
    mechanism: &Description,
    columns: &Columns,
    rows: &[Option<Row>],
    forms: &Forms,
) -> Result<(), Failure> {
    let Description { names, unit, .. } = mechanism;
    let values = columns
        .quantities
        .iter()
        .map(|column| column.csv_name(*unit));
    let derivatives = columns.with_derivatives().flat_map(|column| {
        let name = column.csv_name(*unit);
        let drives = names.drives.iter();
        drives.flat_map(move |drive| {
            let first = format!("{name}_per_{}", drive.name);
            let second = format!("{first}2");
            [first, second].into_iter().take(columns.derivatives.into())
        })
    });
    let heading = |name| Heading {
        name,
        counts: false,
    };
    let headings: Vec<Heading> = values.chain(derivatives).map(heading).collect();
    let mut file = Rows::create(forms, &Header::of(mechanism), &headings)?;
    for row in rows.iter().flatten() {
        file.add(row)?;
    }
    file.finish()
}
