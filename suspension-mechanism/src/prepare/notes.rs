//! Notes on statements of a file that its author may not have meant.

mod below_ground;
pub(super) mod contradicted_drives;
pub(super) mod contradicted_wheels;
pub(super) mod listed_points;
pub(super) mod missing_travel;
pub(super) mod neither_side;
mod numbers;
pub(super) mod of_neither_axle;
pub(super) mod one_sided_masses;
pub(super) mod unlikely_masses;
pub(super) mod untwisted_bars;
mod wheels;
pub(super) mod wrong_side;

use nalgebra::Vector3;
use suspension_core::Values;
use suspension_runtime::Listing;

use crate::mechanism::{Length, Suspension};
use crate::number::rounded;
use crate::prepare::design::Design;
use crate::prepare::design::unsatisfied::{Unsatisfied, largest};
use crate::prepare::task::Task;
pub(super) use numbers::{length, short_of_stop};
use numbers::{lengths, rates};
use wheels::{diameter, named_side, notes_on_wheel};

/// The limits of a suspension's size, in metres: the largest, and after it the smallest of a corner, of an axle, and of both axles.
const LARGEST: f64 = 10.0;
const SMALLEST: f64 = 0.03;
const SMALLEST_AXLE: f64 = 3.0 * SMALLEST;
const SMALLEST_CAR: f64 = 2.0 * SMALLEST_AXLE;

/// The distance of a guess from the assembled position, in metres, above which it looks like an intended change: the
/// coordinates that Attia 2003 prints beside its lengths are 23 mm off.
const ROUGH: f64 = 0.025;

/// The distance that assembling must move a point for a note, in metres.
const LEAST_NOTED: f64 = 1e-4;

/// Notes on points as given and as assembled; `off` is the equation that they did not satisfy.
pub(super) fn notes<P: Values<Vector3<f64>>>(
    task: &Task<'_>,
    given: &P,
    placed: &P,
    off: Option<Unsatisfied>,
    has_outlier: bool,
) -> Vec<String> {
    let placed_points: Vec<_> = placed.values().collect();
    let of_points = [
        size(task, given).filter(|_| !has_outlier),
        moved(task, given, placed),
        assembled(task, given, placed, off),
    ];
    // A point in the wrong place misplaces axes too.
    let wheels = task.names.wheels.iter().filter(|_| !has_outlier);
    let mut sides = wheels.clone();
    let of_side = sides.find_map(|wheel| named_side(task, wheel, &placed_points));
    let of_radius = wheels
        .clone()
        .find_map(|wheel| diameter(task, wheel, &placed_points));
    let of_ground = below_ground::note(task, &placed_points)
        .or_else(|| below_ground::wheel_below_all(task, &placed_points))
        .filter(|_| !has_outlier);
    let of_wheels = wheels.flat_map(|wheel| notes_on_wheel(task, wheel, &placed_points));
    let of_points = of_points.into_iter().flatten();
    let notes = of_points
        .chain(of_side)
        .chain(of_wheels)
        .chain(of_radius)
        .chain(of_ground);
    let of_numbers = lengths(task).chain(rates(task));
    notes.chain(of_numbers).collect()
}

/// Notes on markers that do not belong to a body.
pub(super) fn loose_markers<L: Suspension<N>, const N: usize>(
    task: &Task<'_>,
    design: &Design<L, N>,
    listing: &Listing,
) -> Vec<String> {
    let mut markers = listing.loose_markers();
    if markers.is_empty() {
        return Vec::new();
    }
    let points: Vec<_> = design.points.values().collect();
    let drives = 0..task.names.drives.len();
    let rates: Vec<_> = drives.filter_map(|drive| design.per(drive)).collect();
    // Several links together may keep the points apart.
    let is_loose = |[_, from, to]: &[&str; 3]| {
        let [from, to] = [from, to].map(|name| listing.point(name).unwrap_or_default());
        let line = points[to] - points[from];
        // The bound of how fast rounding alone changes a distance per unit of a drive.
        let grows = |rates: &Vec<Vector3<f64>>| {
            (rates[to] - rates[from]).dot(&line).abs() > 1e-9 * line.norm()
        };
        rates.iter().any(grows)
    };
    markers.retain(is_loose);
    markers.dedup_by_key(|[marker, ..]| *marker);
    let notes = markers.iter().map(|[marker, from, to]| {
        format!(
            "the distance of `{from}` and `{to}`, which carry `{marker}`, is not constant, so that its distances from them \
             change too; let a body carry it, or three points of one"
        )
    });
    notes.collect()
}

/// A note that the points seem to be in another unit.
fn size<P: Values<Vector3<f64>>>(task: &Task<'_>, given: &P) -> Option<String> {
    let points: Vec<_> = given.values().take(task.names.points.len()).collect();
    let first = points.first()?;
    let apart = |point: &Vector3<f64>| (point - first).norm();
    let apart = points.iter().map(apart).fold(0.0, f64::max);
    let unit = task.file.length;
    let other = Length::guess_from_size(apart);
    let smallest = match task.names.wheels.len() {
        0 | 1 => SMALLEST,
        2 => SMALLEST_AXLE,
        _ => SMALLEST_CAR,
    };
    if (smallest..LARGEST).contains(&(apart / unit.metre())) || other == unit {
        return None;
    }
    let (apart, unit) = (rounded(apart, 3), unit.symbol());
    let (other, symbol) = (other.in_words(), other.symbol());
    Some(format!(
        "the points are up to {apart} {unit} apart: is the file in {other}? (unit = \"{symbol}\")"
    ))
}

/// The point that assembling moves farthest, and how far, if that is more than some metres.
fn furthest<'a, P: Values<Vector3<f64>>>(
    task: &'a Task<'_>,
    [given, placed]: [&P; 2],
    metres: f64,
) -> Option<(&'a str, String)> {
    let names = &task.names.points;
    let free = names.len() - task.names.markers().len();
    let pairs = given.values().zip(placed.values()).take(free);
    let off = pairs.map(|(given, placed)| (given - placed).norm());
    let off: Vec<f64> = off.collect();
    let (point, off) = largest(&off)?;
    let unit = task.file.length;
    (off > metres * unit.metre()).then(|| {
        let off = format!("{} {}", rounded(off, 3), unit.symbol());
        (names[point].as_str(), off)
    })
}

/// A note that a free point was moved although lengths are stated, which changes nothing.
fn moved<P: Values<Vector3<f64>>>(task: &Task<'_>, given: &P, placed: &P) -> Option<String> {
    task.file.lengths.as_ref()?;
    let (point, off) = furthest(task, [given, placed], ROUGH)?;
    Some(format!(
        "with [lengths] the free points are only a guess: the lengths put `{point}` {off} from where the file has it; \
         to move it, change the lengths or leave [lengths] out"
    ))
}

/// A note on points that should lie on a line or in a plane and do not. If drives are stated for the design, they
/// move points too.
fn assembled<P: Values<Vector3<f64>>>(
    task: &Task<'_>,
    given: &P,
    placed: &P,
    off: Option<Unsatisfied>,
) -> Option<String> {
    let off = off?;
    let by = off.by;
    let off = task.unsatisfied_in_words(off);
    let note = format!("the points do not satisfy {off}; results are of the assembled mechanism");
    if task.file.design.is_some() {
        return (by > LEAST_NOTED * task.file.unit().metre()).then_some(note);
    }
    let (point, moved) = furthest(task, [given, placed], LEAST_NOTED)?;
    Some(format!("{note}, in which `{point}` has moved by {moved}"))
}
