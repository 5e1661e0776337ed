//! Wheels without a drive of travel, if the file states something that needs one.

use crate::mechanism::{Names, Wheel, quoted};
use crate::prepare::task::Task;

/// A note with what to write. `names` are those in effect; wheels whose drive of travel has the usual name but does
/// not lift them are noted elsewhere.
pub(in crate::prepare) fn note(task: &Task<'_>, names: &Names) -> Option<String> {
    let in_effect = names.wheels.iter().zip(&task.names.wheels);
    let without = in_effect.filter(|(_, stated)| stated.travel.is_none());
    let without: Vec<&Wheel> = without.map(|(wheel, _)| wheel).collect();
    let [first, ..] = without.as_slice() else {
        return None;
    };
    let all = |has: fn(usize) -> bool| without.iter().all(|wheel| has(wheel.lifted_by.len()));
    let has_several = all(|drives| drives > 1);
    let needed_by = needed_by(task, has_several || names.wheels.len() > 1)?;
    let titles: Vec<String> = without.iter().map(|wheel| wheel.title("wheel")).collect();
    let titles = titles.join(" and the ");
    if has_several {
        let drives = first.lifted_by.iter();
        let drives = quoted(drives.map(|drive| &names.drives[*drive].name));
        let centre = &names.points[first.points.axis[1]];
        return Some(format!(
            "{drives} together move the {titles} up and down, and quantities of {needed_by} that need a drive of travel for each wheel are \
             left out; in place of these write one for each, as `drive NAME: {centre}.z;`"
        ));
    }
    all(|drives| drives == 1).then(|| {
        format!(
            "no drive is named as the travel of the {titles}, and quantities of {needed_by} that need it are left out; write \
             travel = {} under [vehicle]",
            names.travel_in_file(without.iter().copied())
        )
    })
}

/// The table of the file that needs the travel of wheels. The ground under a wheel needs it if the wheel has more
/// than one drive, or rolls together with another wheel.
fn needed_by(task: &Task<'_>, needs_each: bool) -> Option<&'static str> {
    let vehicle = task.file.vehicle.get_ref();
    let is_car = vehicle.cg_height.is_some()
        || vehicle.brake_share.is_some()
        || vehicle.drive_share.is_some()
        || needs_each && vehicle.wheel_radius.is_some();
    if task.file.springs.is_some() {
        Some("[springs]")
    } else {
        is_car.then_some("[vehicle]")
    }
}
