//! The columns that say where the model is.

use super::columns::KnownColumn;
use crate::characteristics::{Title, columns_of_positions};
use crate::failure::Failure;
use crate::kinematics::Kinematics;
use crate::measured_table::MeasuredTable;
use crate::mechanism::listed;
use crate::quantities::{Column, WHEEL_TRAVEL};

/// Divides columns into those that say where the model is, and those of quantities that are compared. Drives lead; so do the
/// travel of a wheel and the angle of the steering wheel, unless a column of a drive moves the same.
///
/// # Errors
///
/// [`Failure::Input`] if no column leads, at one that asks for what another one does, at wheel travel that no other drive can
/// follow, and at a missing number.
pub(super) fn divide(
    table: &MeasuredTable,
    mechanism: &dyn Kinematics,
    known: Vec<KnownColumn>,
) -> Result<[Vec<KnownColumn>; 2], Failure> {
    let (mut leads, others): (Vec<KnownColumn>, Vec<KnownColumn>) =
        known.into_iter().partition(KnownColumn::is_drive);
    for (index, lead) in leads.iter().enumerate() {
        check_alone(table, mechanism, &leads[..index], lead)?;
    }
    let mut compared = Vec::new();
    let mut undecided = others.iter().filter(|known| is_undecided(known)).count();
    for mut known in others {
        let drive = match known.stated.named.drives.first() {
            Some(own) => own_or_free_drive(mechanism, &leads, (&known, *own)),
            None if is_undecided(&known) => {
                undecided -= 1;
                lifting_drive(mechanism, &leads, (&known, undecided))
            }
            None => Ok(None),
        };
        match drive.map_err(|message| table.refuse_heading(known.column, message))? {
            Some(drive) => {
                // A quantity that is compared may lack numbers.
                table.numbers(known.column)?;
                known.stated.named.drives = vec![drive];
                leads.push(known);
            }
            None => compared.push(known),
        }
    }
    leads.sort_by_key(|known| known.column);
    if leads.is_empty() {
        table.check_no_point()?;
        return Err(table.refuse_heading(0, no_position_column(mechanism)));
    }
    Ok([leads, compared])
}

/// Refuses a column that moves a drive of another column.
fn check_alone(
    table: &MeasuredTable,
    mechanism: &dyn Kinematics,
    others: &[KnownColumn],
    lead: &KnownColumn,
) -> Result<(), Failure> {
    let mut drives = lead.stated.named.drives.iter().map(|(drive, _)| *drive);
    let both = drives.find_map(|drive| Some((drive, column_moving(others, drive)?)));
    both.map_or(Ok(()), |(drive, other)| {
        let message = format!(
            "`{}` and `{}` both say where `{}` is; empty the heading of one",
            other.stated.named.title, lead.stated.named.title, mechanism.names.drives[drive].name
        );
        Err(table.refuse_heading(lead.column, message))
    })
}

fn column_moving(leads: &[KnownColumn], drive: usize) -> Option<&KnownColumn> {
    let mut leads = leads.iter();
    leads.find(|lead| {
        lead.stated
            .named
            .drives
            .iter()
            .any(|(own, _)| *own == drive)
    })
}

/// A drive, with its change per unit of a column.
type Share = (usize, f64);

/// Returns the own drive of wheel travel or of the steering wheel; `None` if a column of a drive moves it, and another drive
/// if the travel of another wheel does.
fn own_or_free_drive(
    mechanism: &dyn Kinematics,
    leads: &[KnownColumn],
    (known, own): (&KnownColumn, Share),
) -> Result<Option<Share>, String> {
    let other = column_moving(leads, own.0);
    match (other, known.travel()) {
        (None, _) => Ok(Some(own)),
        (Some(other), Some(travel)) if !other.is_drive() => {
            let free = other_drive(mechanism, leads, travel).ok_or_else(|| {
                format!(
                    "the drive `{}` follows `{}`, and no other drive is left that could follow `{}`; empty the heading of one",
                    mechanism.names.drives[own.0].name,
                    other.stated.named.title,
                    known.stated.named.title
                )
            })?;
            Ok(Some((free, 1.0)))
        }
        _ => Ok(None),
    }
}

/// Whether it is the travel of a wheel for which no drive is known.
fn is_undecided(known: &KnownColumn) -> bool {
    known.travel().is_some() && known.stated.named.drives.is_empty()
}

/// Returns one of the drives that lift a wheel, such as heave and roll, if there are as many as columns for them: this one
/// and those still `to_come`; `None` if columns of drives move all.
fn lifting_drive(
    mechanism: &dyn Kinematics,
    leads: &[KnownColumn],
    (known, to_come): (&KnownColumn, usize),
) -> Result<Option<Share>, String> {
    let wheel = known.travel().and_then(|travel| travel.wheel.as_deref());
    let mut wheels = mechanism.names.wheels.iter();
    let Some(wheel) = wheels.find(|own| wheel.unwrap_or_default() == own.name) else {
        return Ok(None);
    };
    let drives = wheel.lifted_by.iter().copied();
    let free: Vec<usize> = drives
        .filter(|drive| column_moving(leads, *drive).is_none())
        .collect();
    match free[..] {
        [] => Ok(None),
        [first, ..] if free.len() == 1 + to_come => Ok(Some((first, 1.0))),
        _ => Err(format!(
            "which drive follows `{}`? Write travel = {} under [vehicle] of the motion file, or empty the heading",
            known.stated.named.title,
            mechanism.names.travel_in_file([wheel])
        )),
    }
}

/// Returns a drive that no column moves and that lifts the wheel without steering one, such as roll beside heave.
fn other_drive(
    mechanism: &dyn Kinematics,
    leads: &[KnownColumn],
    travel: &Column,
) -> Option<usize> {
    /// The least travel per change of a drive that rounding does not make, relative to lengths of the mechanism.
    const LIFTS: f64 = 1e-6;
    let names = &mechanism.names;
    let mut drives = (0..names.drives.len()).filter(|drive| {
        !names.vehicle.steer.contains(drive) && column_moving(leads, *drive).is_none()
    });
    drives.find(|drive| {
        let rate = mechanism.at_start(&mut |place| Some(travel.along(&place.per(*drive)?).rate));
        rate.flatten().is_some_and(|rate| rate.abs() > LIFTS)
    })
}

fn no_position_column(mechanism: &dyn Kinematics) -> String {
    let names = &mechanism.names;
    let drives = names.drive_names().join(", ");
    let columns = columns_of_positions(mechanism);
    let travels = columns.filter(|column: &Column| column.is(&WHEEL_TRAVEL));
    let travels = travels.map(|travel| format!("`{} [mm]`", Title::new(&travel, &names.wheels)));
    let travels = listed(travels);
    let travels = (!travels.is_empty()).then(|| {
        format!(
            "wheel travel, as {travels}, for which [vehicle] may have to state travel = \"DRIVE\""
        )
    });
    let steering = "steering_wheel_angle, for which [vehicle] states rack_per_turn".to_owned();
    let steering = (!names.vehicle.steer.is_empty()).then_some(steering);
    let drives = format!("a drive and its unit (the drives are {drives})");
    let ways: Vec<String> = [Some(drives), travels, steering]
        .into_iter()
        .flatten()
        .collect();
    format!(
        "no column says where the model is; head one with {}. The headings are the first line of several fields that does not begin with #",
        ways.join(", or with ")
    )
}
