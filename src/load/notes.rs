//! What a file says that its author may not have meant.

use nalgebra::Vector3;
use suspension_core::Values;

use crate::load::task::Task;
use crate::mechanism::Unit;
use crate::number::rounded;

/// No suspension is so large, in metres, nor so small.
const LARGEST: f64 = 30.0;
const SMALLEST: f64 = 0.03;

/// How far a guess may be off the assembled position before it looks like a change that was meant, in metres: the
/// coordinates that Attia 2003 prints beside its lengths are 23 mm off.
const ROUGH: f64 = 0.025;

/// Notes on points that were given, and then assembled.
pub(super) fn notes<P: Values<Vector3<f64>>>(
    task: &Task<'_>,
    given: &P,
    placed: &P,
) -> Vec<String> {
    let notes = [size(task, given), moved(task, given, placed)];
    let name = task.source.name();
    let notes = notes.into_iter().flatten();
    notes.map(|note| format!("{name}: {note}")).collect()
}

/// The points are in another unit, as it seems.
fn size<P: Values<Vector3<f64>>>(task: &Task<'_>, given: &P) -> Option<String> {
    let points: Vec<_> = given.values().take(task.names.points.len()).collect();
    let first = points.first()?;
    let apart = |point: &Vector3<f64>| (point - first).norm();
    let apart = points.iter().map(apart).fold(0.0, f64::max);
    let (unit, metres) = (task.file.unit, apart / task.file.unit.metre());
    let other = match unit {
        Unit::Metre if metres > LARGEST => Unit::Millimetre,
        Unit::Millimetre if metres < SMALLEST => Unit::Metre,
        _ => return None,
    };
    let (apart, unit, other) = (rounded(apart, 3), unit.symbol(), other.symbol());
    Some(format!(
        "the points are up to {apart} {unit} apart: is the file in {other}? (unit = \"{other}\")"
    ))
}

/// A free point was moved where lengths are stated, which changes nothing.
fn moved<P: Values<Vector3<f64>>>(task: &Task<'_>, given: &P, placed: &P) -> Option<String> {
    task.file.lengths.as_ref()?;
    let names = &task.names.points;
    let free = names.len() - task.names.markers().len();
    let pairs = given.values().zip(placed.values()).take(free);
    let off = pairs.map(|(given, placed)| (given - placed).norm());
    let (point, off) = off.enumerate().max_by(|a, b| a.1.total_cmp(&b.1))?;
    let unit = task.file.unit;
    (off > ROUGH * unit.metre()).then(|| {
        format!(
            "with [lengths] free points are but a guess: the lengths put `{}` {} {} from where the file has it; \
             to move it, change the lengths or leave [lengths] out",
            names[point],
            rounded(off, 3),
            unit.symbol()
        )
    })
}
