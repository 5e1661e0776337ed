//! The columns of a measured table: what each one states, with its numbers.

use super::heading::Stated;
use crate::failure::Failure;
use crate::file::tell;
use crate::grid::doubt_of_option;
use crate::kinematics::Kinematics;
use crate::measured_table::MeasuredTable;
use crate::mechanism::{Axis, Description, ends};

/// A column that the model knows.
pub(super) struct Known {
    /// Its index in the table.
    pub(super) column: usize,
    pub(super) stated: Stated,
    /// Those of a drive count from the design position; those of a quantity are NaN where a field is empty.
    pub(super) numbers: Vec<f64>,
}

impl Known {
    /// Reads the columns of a table whose drives have changes or, if `absolute`, their own values; prints notes on the columns
    /// that are left out, and on doubtful values.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] at a heading, and at a field without a number.
    pub(super) fn all(
        table: &mut MeasuredTable,
        mechanism: &dyn Kinematics,
        absolute: bool,
    ) -> Result<Vec<Self>, Failure> {
        let units = table.take_units();
        let (mut known, mut left_out) = (Vec::new(), Vec::new());
        let headings = table.headings().into_iter().enumerate();
        for (column, heading) in headings.filter(|(_, heading)| !heading.is_empty()) {
            let below = units.get(column).map_or("", String::as_str);
            let stated = Stated::read(mechanism, heading, below);
            match stated.map_err(|message| table.refuse_heading(column, message))? {
                Some(stated) => known.push((column, stated)),
                None => left_out.push(format!("`{heading}`")),
            }
        }
        tell_left_out(table.name(), &left_out);
        let known = known.into_iter();
        known
            .map(|(column, stated)| Self::read(table, mechanism, (column, stated), absolute))
            .collect()
    }

    fn read(
        table: &MeasuredTable,
        mechanism: &dyn Kinematics,
        (column, stated): (usize, Stated),
        absolute: bool,
    ) -> Result<Self, Failure> {
        let numbers = if stated.named.quantity.is_some() {
            table.numbers_or_nan(column)?
        } else {
            let zero = match absolute {
                true => at_design(mechanism, &stated),
                false => Ok(0.0),
            };
            let zero = zero.map_err(|message| table.refuse_heading(column, message))?;
            let numbers = table.numbers(column)?;
            if let Some(doubt) = doubt(mechanism, &stated, &numbers, absolute) {
                tell(format_args!("note: {}: {doubt}", table.name()));
            }
            numbers.into_iter().map(|number| number - zero).collect()
        };
        Ok(Self {
            column,
            stated,
            numbers,
        })
    }

    /// Whether it is one drive, or several that move together.
    pub(super) fn is_drive(&self) -> bool {
        self.stated.named.quantity.is_none()
    }

    /// Whether it says where the model is: a drive, wheel travel or the angle of the steering wheel.
    pub(super) fn leads(&self) -> bool {
        !self.stated.named.drives.is_empty()
    }

    pub(super) fn changes(&self) -> bool {
        ends(self.numbers.iter().copied()).is_some_and(|[least, greatest]| least < greatest)
    }

    /// The drives that stay at the first number.
    pub(super) fn held(&self) -> Axis {
        let first = self.numbers.first();
        Axis {
            drives: self.stated.named.drives.clone(),
            values: first.map(|at| at / self.stated.scale).into_iter().collect(),
        }
    }
}

/// Names the columns that are left out.
fn tell_left_out(table: &str, headings: &[String]) {
    /// A table of sweep with derivatives has hundreds.
    const MOST: usize = 20;
    let named = headings.iter().take(MOST).map(String::as_str);
    let named = named.collect::<Vec<_>>().join(", ");
    let more = match headings.len().saturating_sub(MOST) {
        0 => String::new(),
        more => format!(" and {more} more"),
    };
    if !named.is_empty() {
        tell(format_args!(
            "note: {table}: left out, as the model has no such quantities: {named}{more}; suspension motion --help says what each \
             quantity needs"
        ));
    }
}

/// Returns the drive's own value at the design position, in the unit of its column.
fn at_design(mechanism: &Description, stated: &Stated) -> Result<f64, String> {
    match stated.named.drives[..] {
        [(drive, _)] => Ok(mechanism.design[drive] * stated.scale),
        _ => Err(format!(
            "the drives `{}` move together from the design position; state their changes, and leave out --absolute",
            stated.named.title
        )),
    }
}

fn doubt(
    mechanism: &dyn Kinematics,
    stated: &Stated,
    numbers: &[f64],
    absolute: bool,
) -> Option<String> {
    let (drive, _) = *stated.named.drives.first()?;
    let ends = ends(numbers.iter().copied())?;
    doubt_of_option(mechanism, drive, (ends, stated.unit), absolute)
}
