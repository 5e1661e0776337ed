//! Notes on numbers of a file, other than points, that its author may not have meant.

use std::ops::Range;

use suspension_core::listing::MeasureKind;

use crate::mechanism::{Instants, Length};
use crate::number::{number, rounded};
use crate::prepare::task::Task;

/// A note that the motion ends before its stop, because this is not a whole number of steps from the start.
pub(in crate::prepare) fn short_of_stop(task: &Task<'_>, instants: &Instants) -> Option<String> {
    let time = task.file.time.get_ref();
    let (stop, step) = (time.stop.as_ref()?, time.step.as_ref()?);
    let [_, last] = instants.ends();
    let (stop, step) = (*stop.get_ref(), *step.get_ref());
    (last != stop).then(|| {
        let [last, stop, step] = [last, stop, step].map(|seconds| rounded(seconds, 9));
        format!("the motion ends at t = {last} s: its stop at {stop} s is not a whole number of steps of {step} s")
    })
}

/// Notes on lengths of the vehicle that seem to be in another unit.
pub(super) fn lengths(task: &Task<'_>) -> impl Iterator<Item = String> {
    let names = &task.names;
    let radii = names.wheels.iter().filter_map(|wheel| wheel.radius);
    let radius = radii.map(|radius| length(task.file.length, "wheel_radius", radius, 0.05..5.0));
    let rack_per_turn = task.file.vehicle.get_ref().rack_per_turn.as_ref();
    let rack_per_turn = rack_per_turn.map(|travel| *travel.get_ref());
    let of_car = [
        ("rack_per_turn", rack_per_turn, 0.01..0.5),
        ("wheelbase", names.vehicle.wheelbase, 0.5..20.0),
        ("cg_height", names.vehicle.cg_height, 0.05..5.0),
    ];
    let of_car = of_car
        .into_iter()
        .filter_map(|(name, stated, usual)| length(task.file.length, name, stated?, usual));
    radius.flatten().take(1).chain(of_car)
}

/// The usual rates of springs, from models in a tenth of the size to lorries, N/m.
const RATES: Range<f64> = 500.0..5e6;

/// The usual rates of bars about an angle, N m/rad.
const RATES_OF_BARS: Range<f64> = 5.0..2e5;

/// Notes on rates of springs and bars that seem to be in another unit.
pub(super) fn rates(task: &Task<'_>) -> impl Iterator<Item = String> {
    let unit = task.file.unit();
    let springs = task
        .file
        .springs
        .iter()
        .flat_map(|table| table.get_ref().iter());
    springs.filter_map(move |(name, stated)| {
        let along = stated.get_ref().along.get_ref();
        let measure = &task.names.measures[task.names.measure(along)?];
        let rate = *stated.get_ref().rate.get_ref();
        let (usual, per, what, symbol) = match measure.kind {
            MeasureKind::Length => (RATES, unit.length.metre(), "N", unit.length.symbol()),
            MeasureKind::Angle => (RATES_OF_BARS, unit.angle.radian(), "N m", unit.angle.symbol()),
        };
        if rate == 0.0 || usual.contains(&(rate * per)) {
            return None;
        }
        let [from, to] = [usual.start, usual.end].map(|end| rounded(end / per, 4));
        let (name, rate) = (name.get_ref(), number(rate));
        Some(format!(
            "the rate of spring `{name}` is {rate} {what} per {symbol}; it is usually from {from} to {to} {what} per {symbol}: rates \
             are per unit of lengths or angles of the file"
        ))
    })
}

/// A note on a length that is outside the usual range, in metres.
pub(in crate::prepare) fn length(
    unit: Length,
    name: &str,
    stated: f64,
    usual: Range<f64>,
) -> Option<String> {
    if usual.contains(&(stated / unit.metre())) {
        return None;
    }
    let (length, symbol) = (number(stated), unit.symbol());
    // A usual length divided by this is about a metre.
    let middle = (usual.start * usual.end).sqrt();
    let doubt = match Length::guess_from_size(stated / middle) {
        other if other == unit => {
            let [from, to] = [usual.start, usual.end].map(|end| rounded(end * unit.metre(), 5));
            format!("it is usually from {from} {symbol} to {to} {symbol}; is the number right?")
        }
        other => format!(
            "is it in {}? The file is in {}",
            other.in_words(),
            unit.in_words()
        ),
    };
    Some(format!("{name} is {length} {symbol}: {doubt}"))
}
