//! Drives that wheels have by their names, where the file does not say which ones move and steer them.

use nalgebra::Vector3;
use suspension_core::Values;
use toml::Spanned;

use crate::load::design::Design;
use crate::load::task::Task;
use crate::mechanism::{Names, Suspension, Wheel};

/// The least that a wheel moves up or down, or is turned times the suspension's size, against the fastest point.
const MOVES: f64 = 1e-6;

/// The names without such drives as do not move the wheel up or down, or do not turn it; of the first, notes.
pub(super) fn in_effect<L: Suspension<N>, const N: usize>(
    task: &Task<'_>,
    design: &Design<L, N>,
) -> (Names, Vec<String>) {
    let vehicle = task.file.vehicle.as_ref().map(Spanned::get_ref);
    let is_stated = [
        vehicle.is_some_and(|vehicle| vehicle.travel.is_some()),
        vehicle.is_some_and(|vehicle| vehicle.steer.is_some()),
    ];
    let points: Vec<_> = design.points.values().collect();
    let size = design.model.size();
    let mut names = task.names.clone();
    let mut notes = Vec::new();
    for wheel in &mut names.wheels {
        let rates = |drive: Option<usize>| design.per(drive?);
        if let (false, Some(rates)) = (is_stated[0], rates(wheel.travel))
            && !rises(wheel, &rates)
        {
            notes.extend(unmoved(task, wheel));
            wheel.travel = None;
        }
        if let (false, Some(rates)) = (is_stated[1], rates(wheel.steer))
            && !turns(wheel, (&points, &rates), size)
        {
            wheel.steer = None;
        }
    }
    let Names {
        wheels, vehicle, ..
    } = &mut names;
    // A listing without a wheel has drives all the same.
    if !wheels.is_empty() {
        let has = |of: fn(&Wheel) -> Option<usize>, drive: &usize| {
            wheels.iter().any(|wheel| of(wheel) == Some(*drive))
        };
        vehicle
            .travel
            .retain(|drive| has(|wheel| wheel.travel, drive));
        vehicle
            .steer
            .retain(|drive| has(|wheel| wheel.steer, drive));
    }
    (names, notes)
}

fn fastest(rates: &[Vector3<f64>]) -> f64 {
    rates.iter().map(|rate| rate.norm()).fold(0.0, f64::max)
}

fn rises(wheel: &Wheel, rates: &[Vector3<f64>]) -> bool {
    let [_, centre] = wheel.points.axis;
    rates[centre].z.abs() > MOVES * fastest(rates)
}

/// Whether a drive turns a wheel about the vertical.
pub(super) fn turns(
    wheel: &Wheel,
    (points, rates): (&[Vector3<f64>], &[Vector3<f64>]),
    size: f64,
) -> bool {
    let [inner, centre] = wheel.points.axis;
    let along = (points[centre] - points[inner]).xy();
    let rate = (rates[centre] - rates[inner]).xy();
    let turn = along.perp(&rate) / along.norm_squared();
    turn.abs() * size > MOVES * fastest(rates)
}

fn unmoved(task: &Task<'_>, wheel: &Wheel) -> Option<String> {
    let drive = &task.names.drives[wheel.travel?].name;
    let of_wheel = match wheel.name.as_str() {
        "" => "\"NAME\"".to_owned(),
        name => format!("{{ {name} = \"NAME\", ... }}"),
    };
    Some(format!(
        "{}: the drive `{drive}` does not move the {} up or down; write travel = {of_wheel} under [vehicle] where another does",
        task.source.name(),
        wheel.title("wheel"),
    ))
}
