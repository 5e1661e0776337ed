//! The columns of a measured table: what each one states, with its numbers.

use std::collections::BTreeSet;
use std::f64::consts::PI;

use suspension_core::listing::DriveKind;

use super::doubts::{doubt, doubt_of_travel};
use super::heading::Stated;
use super::rig_names::{is_of_other_axle, is_of_other_side};
use crate::characteristics::{Effect, usual_change};
use crate::failure::Failure;
use crate::file::Dimension;
use crate::kinematics::Kinematics;
use crate::measured_table::MeasuredTable;
use crate::mechanism::{CountedFrom, Description, ends};
use crate::number::without_rounding;
use crate::output::notes::print_notes_on;
use crate::quantities::{Column, STEERING_WHEEL_ANGLE, WHEEL_TRAVEL};

/// A column that the model knows.
pub(super) struct KnownColumn {
    /// Its index in the table.
    pub(super) column: usize,
    pub(super) stated: Stated,
    /// Those of a drive count from the design position; those of a quantity are NaN where a field is empty.
    pub(super) numbers: Vec<f64>,
    /// For a drive or wheel travel: a sentence if its numbers seem to be in another unit, or counted otherwise.
    doubt: Option<String>,
}

impl KnownColumn {
    /// Reads the columns of a table whose drives count `from` the design position or from zero; prints a note on the columns
    /// that are left out.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] at a heading, and at a field without a number.
    pub(super) fn all(
        table: &mut MeasuredTable,
        mechanism: &dyn Kinematics,
        from: CountedFrom,
    ) -> Result<Vec<Self>, Failure> {
        let units = table.take_units();
        let (mut known, mut left_out) = (Vec::new(), Vec::new());
        let headings = table.headings().into_iter().enumerate();
        for (column, heading) in headings.filter(|(_, heading)| !heading.is_empty()) {
            let below = units.get(column).map_or("", String::as_str);
            let stated = Stated::read(mechanism, heading, below);
            match stated.map_err(|message| table.refuse_heading(column, message))? {
                Some(stated) => known.push((column, stated)),
                None => left_out.push((why_left_out(mechanism, heading), heading)),
            }
        }
        check_once(table, &known)?;
        for why in [OTHER_AXLE, OTHER_SIDE, UNKNOWN] {
            let headings = left_out.iter().filter(|(reason, _)| *reason == why);
            let headings: Vec<&str> = headings.map(|(_, heading)| *heading).collect();
            tell_left_out(table.name(), why, &headings);
        }
        let known = known.into_iter();
        known
            .map(|(column, stated)| Self::read(table, mechanism, (column, stated), from))
            .collect()
    }

    fn read(
        table: &MeasuredTable,
        mechanism: &dyn Kinematics,
        (column, stated): (usize, Stated),
        from: CountedFrom,
    ) -> Result<Self, Failure> {
        if let Some(quantity) = &stated.named.quantity {
            let numbers = table.numbers_or_nan(column)?;
            let is_of_wheel =
                quantity.dimension == Dimension::Angle && !quantity.is(&STEERING_WHEEL_ANGLE);
            let mut angles = numbers.iter().map(|number| number / stated.scale);
            if let Some(line) = angles.position(|angle| is_of_wheel && angle.abs() > PI) {
                let message = format!(
                    "{} {} is more than half a turn; write all decimals of the table behind the same sign, a comma or a point",
                    numbers[line], stated.symbol
                );
                return Err(table.refuse_number(line, column, message));
            }
            return Ok(Self {
                column,
                doubt: doubt_of_travel(mechanism, &stated, &numbers),
                stated,
                numbers,
            });
        }
        let zero = match from {
            CountedFrom::Zero => at_design(mechanism, &stated),
            CountedFrom::Start => Ok(0.0),
        };
        let zero = zero.map_err(|message| table.refuse_heading(column, message))?;
        let numbers = table.numbers(column)?;
        Ok(Self {
            column,
            doubt: doubt(mechanism, &stated, &numbers, from),
            numbers: numbers.into_iter().map(|number| number - zero).collect(),
            stated,
        })
    }

    /// Whether it is one drive, or several that move together.
    pub(super) fn is_drive(&self) -> bool {
        self.stated.named.quantity.is_none()
    }

    pub(super) fn changes(&self) -> bool {
        ends(self.numbers.iter().copied()).is_some_and(|[least, greatest]| least < greatest)
    }

    /// Whether it takes the model away from the design position.
    pub(super) fn departs(&self) -> bool {
        let mut numbers = self.numbers.iter();
        numbers.any(|number| without_rounding(*number) != 0.0)
    }

    /// The wheel travel that it states.
    pub(super) fn travel(&self) -> Option<&Column> {
        let quantity = self.stated.named.quantity.as_ref();
        quantity.filter(|quantity| quantity.is(&WHEEL_TRAVEL))
    }

    /// The numbers of a column that leads as parts of the usual range, so that lengths and angles can be compared.
    pub(super) fn shares(&self, mechanism: &Description) -> Vec<f64> {
        let Description { names, unit, .. } = mechanism;
        let (drive, per) = self.stated.named.drives[0];
        let effect = match names.vehicle.steer.contains(&drive) {
            true => Effect::Steer,
            false => Effect::Travel,
        };
        let usual = match self.travel() {
            Some(_) => usual_change(Effect::Travel, DriveKind::Coordinate, *unit),
            None => usual_change(effect, names.drives[drive].kind, *unit) / per.abs(),
        };
        let numbers = self.numbers.iter();
        numbers.map(|at| at / self.stated.scale / usual).collect()
    }

    /// What its numbers count, with their unit: changes of drives, or of the steering wheel, or wheel travel.
    pub(super) fn label(&self) -> String {
        let Stated { named, symbol, .. } = &self.stated;
        let wheel = self.travel().map(|travel| travel.wheel.as_deref());
        match wheel {
            None => format!("change of {} ({symbol})", named.title),
            Some(None | Some("")) => format!("{} ({symbol})", named.title),
            Some(Some(wheel)) => {
                let wheel = wheel.replace('_', " ");
                format!("travel of the {wheel} wheel ({symbol})")
            }
        }
    }
}

/// Prints the doubts on columns that lead, but not on the noise of one that a rig holds while another one changes.
pub(super) fn tell_doubts(table: &MeasuredTable, mechanism: &Description, leads: &[KnownColumn]) {
    /// The most that is noise, as a part of the largest change.
    const NOISE: f64 = 0.1;
    let largest = |lead: &KnownColumn| {
        let shares = lead.shares(mechanism).into_iter();
        shares.map(f64::abs).fold(0.0, f64::max)
    };
    let of_all = leads.iter().map(largest).fold(0.0, f64::max);
    let leads = leads.iter().filter(|lead| largest(lead) >= NOISE * of_all);
    print_notes_on(table.name(), leads.filter_map(|lead| lead.doubt.as_ref()));
}

/// Refuses a quantity that is in two columns.
fn check_once(table: &MeasuredTable, known: &[(usize, Stated)]) -> Result<(), Failure> {
    let mut quantities = BTreeSet::new();
    let again = known.iter().find(|(_, stated)| {
        let quantity = stated.named.quantity.as_ref();
        quantity.is_some_and(|quantity| !quantities.insert(quantity.title()))
    });
    again.map_or(Ok(()), |(column, stated)| {
        let title = &stated.named.title;
        let message = format!("`{title}` is in two columns; empty the heading of one");
        Err(table.refuse_heading(*column, message))
    })
}

/// Why a column is left out, and what to do.
const UNKNOWN: [&str; 2] = [
    "as the model knows no such names",
    "suspension motion --help says what each quantity needs",
];
const OTHER_AXLE: [&str; 2] = [
    "as the model is of the other axle",
    "[vehicle] of the motion file states which one",
];

const OTHER_SIDE: [&str; 2] = [
    "as the model has only the wheel on the other side",
    "import with --side or --axle makes a model that has this wheel",
];

fn why_left_out(mechanism: &Description, heading: &str) -> [&'static str; 2] {
    if is_of_other_axle(mechanism, heading) {
        OTHER_AXLE
    } else if is_of_other_side(mechanism, heading) {
        OTHER_SIDE
    } else {
        UNKNOWN
    }
}

/// Names the columns that are left out.
fn tell_left_out(table: &str, [why, remedy]: [&str; 2], headings: &[&str]) {
    /// A table of sweep with derivatives has hundreds.
    const MOST: usize = 20;
    let named = headings.iter().take(MOST);
    let named = named.map(|heading| format!("`{heading}`"));
    let named = named.collect::<Vec<_>>().join(", ");
    let more = match headings.len().saturating_sub(MOST) {
        0 => String::new(),
        more => format!(" and {more} more"),
    };
    if !named.is_empty() {
        let note = format!("left out, {why}: {named}{more}; {remedy}");
        print_notes_on(table, [note]);
    }
}

/// Returns the drive's own value at the design position, in the unit of its column.
fn at_design(mechanism: &Description, stated: &Stated) -> Result<f64, String> {
    match stated.named.drives[..] {
        [(drive, _)] => Ok(mechanism.design[drive] * stated.scale),
        _ => Err(format!(
            "the drives `{}` move together from the design position; state their changes, and leave out --absolute, or give \
             each drive a column of its own",
            stated.named.title
        )),
    }
}
