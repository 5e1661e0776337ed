//! Wheels without a drive of travel, where the file states what needs one.

use toml::Spanned;

use crate::load::task::Task;
use crate::mechanism::{Names, Wheel};

/// A note with what to write, where each such wheel is lifted by one drive alone; `names` are those in effect, and wheels whose
/// drive of travel has the usual name but does not lift them are noted elsewhere.
pub(super) fn note(task: &Task<'_>, names: &Names) -> Option<String> {
    let vehicle = task.file.vehicle.as_ref().map(Spanned::get_ref);
    let shares = vehicle.is_some_and(|vehicle| {
        vehicle.cg_height.is_some()
            || vehicle.brake_share.is_some()
            || vehicle.drive_share.is_some()
    });
    let needed_by = match (&task.file.springs, shares) {
        (Some(_), _) => "[springs]",
        (None, true) => "[vehicle]",
        (None, false) => return None,
    };
    let in_effect = names.wheels.iter().zip(&task.names.wheels);
    let without = in_effect.filter(|(_, stated)| stated.travel.is_none());
    let without: Vec<&Wheel> = without.map(|(wheel, _)| wheel).collect();
    if without.is_empty() || without.iter().any(|wheel| wheel.only_lifted_by.is_none()) {
        return None;
    }
    let titles: Vec<String> = without.iter().map(|wheel| wheel.title("wheel")).collect();
    let stated = names.travel_in_file(without);
    Some(format!(
        "{}: no drive is named as the travel of the {}, and quantities of {needed_by} that need it are left out; write travel = {stated} \
         under [vehicle]",
        task.source.name(),
        titles.join(" and the ")
    ))
}
