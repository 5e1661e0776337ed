//! Measured places that the model does not reach.

use super::columns::KnownColumn;
use super::course::numbers;
use crate::failure::Failure;
use crate::measured_table::MeasuredTable;
use crate::mechanism::{ends, listed};
use crate::number::number;

/// Returns the failure at the first line out of reach, if there is one; `reached` has the lines that were tried.
pub(super) fn out_of_reach(
    table: &MeasuredTable,
    file: &str,
    leads: &[KnownColumn],
    reached: &[bool],
) -> Option<Failure> {
    let line = reached.iter().position(|reached| !reached)?;
    let away: Vec<&KnownColumn> = leads.iter().filter(|lead| lead.departs()).collect();
    let (column, message) = match away[..] {
        [] | [_] => {
            let lead = away.first().map_or(&leads[0], |lead| *lead);
            (lead.column, of_one(lead, line, reached))
        }
        [first, ..] => (first.column, of_several(leads, line, reached)),
    };
    let message = format!("{message}. suspension range {file} says what stops the model");
    Some(table.refuse_number(line, column, message))
}

fn of_one(lead: &KnownColumn, line: usize, reached: &[bool]) -> String {
    let symbol = &lead.stated.symbol;
    let others = lead.numbers.iter().zip(reached);
    let others = ends(others.filter(|(_, reached)| **reached).map(|(at, _)| *at));
    let others = others.map(|ends| ends.map(number)).map_or_else(
        || "none".to_owned(),
        |[least, greatest]| format!("those from {least} to {greatest} {symbol}"),
    );
    format!(
        "{} {symbol} from the design position is out of the model's reach; of the measured places {others} are in reach; leave out \
         the lines beyond",
        number(lead.numbers[line])
    )
}

fn of_several(leads: &[KnownColumn], line: usize, reached: &[bool]) -> String {
    let each = leads.iter().zip(numbers(leads, line));
    let each = each.map(|(lead, at)| {
        let stated = &lead.stated;
        format!("`{}` {} {}", stated.named.title, number(at), stated.symbol)
    });
    let missing = reached.iter().filter(|reached| !**reached).count();
    let first = match reached.len() < leads[0].numbers.len() {
        true => "the first ",
        false => "",
    };
    format!(
        "{} from the design position are together out of the model's reach; leave out the line ({missing} of {first}{} are out of \
         reach)",
        listed(each),
        reached.len()
    )
}
