//! The quantities of a table beside those of the model.

use super::columns::KnownColumn;
use super::course::{Course, numbers};
use super::measured_quantity::MeasuredQuantity;
use super::model_at_places::MovedModel;
use super::out_of_reach::out_of_reach;
use crate::commands::compare::differences::Place;
use crate::failure::Failure;
use crate::file::Dimension;
use crate::measured_table::MeasuredTable;
use crate::mechanism::Unit;
use crate::quantities::Column;

/// Reads the quantities of the model at the places of a table, beside the table's.
///
/// # Errors
///
/// [`Failure::Input`] at a place out of reach, and [`Failure::Interrupted`].
pub(super) fn quantities(
    table: &MeasuredTable,
    model: &MovedModel<'_>,
    course: &Course,
    compared: Vec<KnownColumn>,
) -> Result<Vec<MeasuredQuantity>, Failure> {
    let columns = compared.iter();
    let columns = columns.filter_map(|known| known.stated.named.quantity.as_ref());
    let columns: Vec<&Column> = columns.collect();
    let lines = visited(table, model, &columns)?;
    let reached: Vec<bool> = lines.iter().map(Option::is_some).collect();
    if let Some(failure) = out_of_reach(table, model.file, model.leads, &reached) {
        return Err(failure);
    }
    let curve = course.curve.iter();
    let curve = curve.map(|(_, numbers)| model.read(numbers, &columns));
    let curve = curve.collect::<Result<Vec<_>, _>>()?;
    let unit = model.mechanism.unit;
    let each = compared.into_iter().enumerate();
    let each = each.map(|(index, known)| {
        let read = |place: &Option<Vec<f64>>| {
            let number = place.as_ref().map_or(f64::NAN, |numbers| numbers[index]);
            number * known.stated.scale
        };
        let model = [&lines, &curve].map(|places| places.iter().map(read).collect());
        quantity(course, known, model, unit)
    });
    Ok(each.collect())
}

/// Reads the model's quantities in each line, none in lines out of reach, up to as many of these as are enough to refuse
/// the table: the search for a way to such a line takes long.
fn visited(
    table: &MeasuredTable,
    model: &MovedModel<'_>,
    columns: &[&Column],
) -> Result<Vec<Option<Vec<f64>>>, Failure> {
    const ENOUGH: usize = 20;
    let mut lines = Vec::new();
    let mut missing = 0;
    for line in 0..table.lines() {
        let found = model.read(&numbers(model.leads, line), columns);
        let found = found.map_err(|failure| of_table(failure, table, line))?;
        missing += usize::from(found.is_none());
        lines.push(found);
        if missing == ENOUGH {
            break;
        }
    }
    Ok(lines)
}

/// Says of an interruption how far the model has come in a table.
fn of_table(failure: Failure, table: &MeasuredTable, line: usize) -> Failure {
    match failure {
        Failure::Interrupted(_) => Failure::Interrupted(format!(
            "{}: interrupted; the model was moved to {line} of {} measured places, nothing was written",
            table.name(),
            table.lines()
        )),
        other => other,
    }
}

/// Returns the least change that is well above what rigs resolve, in the model's unit.
fn least_change(dimension: Dimension, unit: Unit) -> f64 {
    match dimension {
        Dimension::Angle => 0.1_f64.to_radians(),
        Dimension::Length => 0.5e-3 * unit.metre(),
        _ => 0.0,
    }
}

/// Sets a column beside the model's numbers in the lines of the table and along the curve.
fn quantity(
    course: &Course,
    measured: KnownColumn,
    [lines, curve]: [Vec<f64>; 2],
    unit: Unit,
) -> MeasuredQuantity {
    let at = course.at.iter().zip(&course.from_design);
    let both = lines.into_iter().zip(measured.numbers);
    let places = at.zip(both).map(|((at, from_design), both)| Place {
        at: *at,
        from_design: *from_design,
        values: both.into(),
    });
    let is_known = |place: &Place| place.values.iter().all(|value| value.is_finite());
    let along = course.curve.iter().map(|(at, _)| *at);
    let column = measured.stated.named.quantity.as_ref();
    MeasuredQuantity {
        kind: column.map_or("", |column| column.quantity.name),
        least_change: column.map_or(0.0, |column| least_change(column.dimension, unit))
            * measured.stated.scale,
        title: measured.stated.named.title,
        symbol: measured.stated.symbol,
        places: places.filter(is_known).collect(),
        around: course.around,
        stride: course.stride,
        curve: along.zip(curve).collect(),
    }
}
