//! All curves of a design: along the drives, and over the travel of the wheel.

use crate::characteristics::curves::{Curves, curves};
use crate::characteristics::mode_states::ModeStates;
use crate::characteristics::span::through_design;
use crate::characteristics::wheel_rise::Rise;
use crate::kinematics::Kinematics;
use crate::mechanism::Unit;

/// The curves along all drives of travel and steering, and over the travel of the wheel if the drives of travel are not heights
/// of wheels.
pub fn all_curves(
    mechanism: &dyn Kinematics,
    modes: &[ModeStates],
    rises: &[Option<Rise>],
) -> Vec<Curves> {
    let unit = mechanism.unit;
    let is_no_height = |(drive, _): &(usize, f64)| {
        let mut rises = rises.iter().flatten();
        rises.any(|rise| rise.drive == *drive && !rise.is_height)
    };
    let each = modes.iter().flat_map(|mode| {
        let curves = curves(mechanism, mode, unit);
        let is_over_wheel = mode.drives.iter().any(is_no_height);
        let over_wheel = is_over_wheel.then(|| over_wheel(&curves, unit)).flatten();
        [Some(curves), over_wheel].into_iter().flatten()
    });
    each.collect()
}

/// The curves over the travel of the first wheel that rises everywhere.
fn over_wheel(curves: &Curves, unit: Unit) -> Option<Curves> {
    let mut wheels = curves.lines.iter().filter(|line| line.is_wheel_travel());
    let wheel = wheels.find(|line| line.is_rising())?;
    let travels = through_design(wheel.ends()?, curves.changes.len());
    let over = curves.over_travel_of(wheel, travels, unit);
    let title = format!("{} ({})", over.title, curves.title);
    Some(Curves { title, ..over })
}
