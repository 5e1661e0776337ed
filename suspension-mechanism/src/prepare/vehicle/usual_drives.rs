//! Drives of wheels found by name, if the file does not state which drives move and steer them.

use nalgebra::Vector3;
use suspension_core::Values;

use crate::mechanism::{Names, Suspension, Wheel};
use crate::prepare::design::Design;
use crate::prepare::task::Task;
use crate::prepare::vehicle::is_stated;

/// The smallest motion of a wheel up or down, or turn multiplied by the suspension's size, relative to the fastest
/// point.
const MOVES: f64 = 1e-6;

/// The names without drives of travel that do not move the wheel up or down, and without the usual drives of steering
/// that do not turn it; with notes on usual drives of travel.
pub(crate) fn effective_names<L: Suspension<N>, const N: usize>(
    task: &Task<'_>,
    design: &Design<L, N>,
) -> (Names, Vec<String>) {
    let stated = task.file.vehicle.get_ref();
    let points: Vec<_> = design.points.values().collect();
    let size = design.model.size();
    let mut names = task.names.clone();
    let mut unmoved: Vec<Vec<&Wheel>> = vec![Vec::new(); names.drives.len()];
    for (wheel, of_task) in names.wheels.iter_mut().zip(&task.names.wheels) {
        let rates = |drive: Option<usize>| design.per(drive?);
        if let (Some(drive), Some(rates)) = (wheel.travel, rates(wheel.travel))
            && !rises(wheel, &rates)
        {
            if !is_stated(&stated.travel, wheel) {
                unmoved[drive].push(of_task);
            }
            wheel.travel = None;
        }
        if let (false, Some(rates)) = (is_stated(&stated.steer, wheel), rates(wheel.steer))
            && !turns(wheel, (&points, &rates), size)
        {
            wheel.steer = None;
        }
    }
    let rates: Vec<_> = (0..names.drives.len())
        .map(|drive| design.per(drive))
        .collect();
    let wheels = names.wheels.iter_mut();
    for wheel in wheels.filter(|wheel| wheel.travel.is_none()) {
        wheel.lifted_by = lifting(wheel, &rates);
    }
    drop_idle(&mut names);
    let unmoved = unmoved.iter().enumerate();
    let notes = unmoved
        .filter(|(_, wheels)| !wheels.is_empty())
        .map(|(drive, wheels)| note(task, drive, wheels));
    (names, notes.collect())
}

/// Removes from the vehicle the drives of travel and steering that no wheel has.
fn drop_idle(names: &mut Names) {
    let (wheels, vehicle) = (&names.wheels, &mut names.vehicle);
    // A listing without a wheel has drives nevertheless.
    if wheels.is_empty() {
        return;
    }
    let has = |drive_of: fn(&Wheel) -> Option<usize>, drive: &usize| {
        wheels.iter().any(|wheel| drive_of(wheel) == Some(*drive))
    };
    vehicle
        .travel
        .retain(|drive| has(|wheel| wheel.travel, drive));
    vehicle
        .steer
        .retain(|drive| has(|wheel| wheel.steer, drive));
}

/// The drives that move a wheel up or down and do not steer it, from the rates of all points per drive.
fn lifting(wheel: &Wheel, rates: &[Option<Vec<Vector3<f64>>>]) -> Vec<usize> {
    let lifts = |rates: &Option<Vec<_>>| rates.as_ref().is_some_and(|rates| rises(wheel, rates));
    let drives = rates.iter().enumerate();
    let lifting = drives.filter(|(drive, rates)| wheel.steer != Some(*drive) && lifts(rates));
    lifting.map(|(drive, _)| drive).collect()
}

fn fastest(rates: &[Vector3<f64>]) -> f64 {
    rates.iter().map(|rate| rate.norm()).fold(0.0, f64::max)
}

/// Whether a drive moves a wheel up or down.
pub(crate) fn rises(wheel: &Wheel, rates: &[Vector3<f64>]) -> bool {
    let [_, centre] = wheel.points.axis;
    rates[centre].z.abs() > MOVES * fastest(rates)
}

/// Whether a drive turns a wheel about the vertical.
pub(crate) fn turns(
    wheel: &Wheel,
    (points, rates): (&[Vector3<f64>], &[Vector3<f64>]),
    size: f64,
) -> bool {
    turn_rate(wheel, points, rates).abs() * size > MOVES * fastest(rates)
}

/// The rate at which a wheel turns about the z axis of its points.
pub(crate) fn turn_rate(wheel: &Wheel, points: &[Vector3<f64>], rates: &[Vector3<f64>]) -> f64 {
    let [inner, centre] = wheel.points.axis;
    let along = (points[centre] - points[inner]).xy();
    let rate = (rates[centre] - rates[inner]).xy();
    along.perp(&rate) / along.norm_squared()
}

/// A note with what to write if other drives move the wheels up and down.
fn note(task: &Task<'_>, drive: usize, wheels: &[&Wheel]) -> String {
    let drive = &task.names.drives[drive].name;
    let titles: Vec<String> = wheels.iter().map(|wheel| wheel.title("wheel")).collect();
    let stated = task.names.travel_in_file(wheels.iter().copied());
    format!(
        "the drive `{drive}` does not move the {} up or down; write travel = {stated} under [vehicle] where another does",
        titles.join(" and the ")
    )
}
