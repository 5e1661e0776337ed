//! What a file says that its author may not have meant.

use std::ops::Range;

use nalgebra::Vector3;
use suspension_core::Values;
use suspension_runtime::Listing;
use toml::Spanned;

use crate::load::design::Design;
use crate::load::outlier::Outlier;
use crate::load::task::Task;
use crate::load::unsatisfied::{Unsatisfied, largest};
use crate::mechanism::{Instants, Length, Suspension, Wheel};
use crate::number::{number, rounded};

/// No suspension is so large, in metres, nor so small.
const LARGEST: f64 = 10.0;
const SMALLEST: f64 = 0.03;

/// How far a guess may be off the assembled position before it looks like a change that was meant, in metres: the
/// coordinates that Attia 2003 prints beside its lengths are 23 mm off.
const ROUGH: f64 = 0.025;

/// No wheel is toed or cambered by so much at its design position, in degrees.
const OFF_AXIS: f64 = 30.0;

/// How far assembling must move a point to be told, in metres.
const TOLD: f64 = 1e-4;

/// Notes on points that were given, and then assembled; `off` is what they did not satisfy.
pub(super) fn notes<P: Values<Vector3<f64>>>(
    task: &Task<'_>,
    given: &P,
    placed: &P,
    off: Option<Unsatisfied>,
    outlier: Option<&Outlier>,
) -> Vec<String> {
    let placed_points: Vec<_> = placed.values().collect();
    let of_points = [
        size(task, given).filter(|_| outlier.is_none()),
        moved(task, given, placed),
        assembled(task, given, placed, off),
    ];
    // A point that is in the wrong place takes axes with it.
    let wheels = task.names.wheels.iter().filter(|_| outlier.is_none());
    let of_wheels = wheels.flat_map(|wheel| {
        [
            kingpin(task, wheel, &placed_points),
            across_the_wheel(task, wheel, &placed_points),
            spin_axis(task, wheel, &placed_points),
        ]
    });
    let name = task.source.name();
    let notes = of_points.into_iter().chain(of_wheels).flatten();
    let notes = notes.chain(lengths(task));
    let of_outlier = outlier.map(|outlier| outlier.note(task.source));
    let notes = notes.map(|note| format!("{name}: {note}"));
    of_outlier.into_iter().chain(notes).collect()
}

/// Notes on markers that are no points of a body.
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
    // Several links together may keep them apart.
    let is_loose = |[_, from, to]: &[&str; 3]| {
        let [from, to] = [from, to].map(|name| listing.point(name).unwrap_or_default());
        let line = points[to] - points[from];
        // How fast a distance changes that rounding alone changes, for a unit of a drive.
        let grows = |rates: &Vec<Vector3<f64>>| {
            (rates[to] - rates[from]).dot(&line).abs() > 1e-9 * line.norm()
        };
        rates.iter().any(grows)
    };
    markers.retain(is_loose);
    markers.dedup_by_key(|[marker, ..]| *marker);
    let name = task.source.name();
    let notes = markers.iter().map(|[marker, from, to]| {
        format!(
            "{name}: nothing keeps `{from}` and `{to}` apart, which carry `{marker}`: its distances from them change as they move; \
             let a body carry it, or three points of one"
        )
    });
    notes.collect()
}

/// The points are in another unit, as it seems.
fn size<P: Values<Vector3<f64>>>(task: &Task<'_>, given: &P) -> Option<String> {
    let points: Vec<_> = given.values().take(task.names.points.len()).collect();
    let first = points.first()?;
    let apart = |point: &Vector3<f64>| (point - first).norm();
    let apart = points.iter().map(apart).fold(0.0, f64::max);
    let unit = task.file.length;
    let other = Length::of_size(apart);
    if (SMALLEST..LARGEST).contains(&(apart / unit.metre())) || other == unit {
        return None;
    }
    let (apart, unit) = (rounded(apart, 3), unit.symbol());
    let (other, symbol) = (other.in_words(), other.symbol());
    Some(format!(
        "the points are up to {apart} {unit} apart: is the file in {other}? (unit = \"{symbol}\")"
    ))
}

/// The point that assembling moves furthest, and how far, where that is more than some metres.
fn furthest<'a, P: Values<Vector3<f64>>>(
    task: &Task<'a>,
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

/// A free point was moved where lengths are stated, which changes nothing.
fn moved<P: Values<Vector3<f64>>>(task: &Task<'_>, given: &P, placed: &P) -> Option<String> {
    task.file.lengths.as_ref()?;
    let (point, off) = furthest(task, [given, placed], ROUGH)?;
    Some(format!(
        "with [lengths] free points are but a guess: the lengths put `{point}` {off} from where the file has it; \
         to move it, change the lengths or leave [lengths] out"
    ))
}

/// Points that should lie on a line, or in a plane, and do not. Where drives are stated for the design, they move points too.
fn assembled<P: Values<Vector3<f64>>>(
    task: &Task<'_>,
    given: &P,
    placed: &P,
    off: Option<Unsatisfied>,
) -> Option<String> {
    let off = off?;
    let by = off.by;
    let off = task.unsatisfied_in_words(off);
    let told = format!("the points do not satisfy {off}; results are of the assembled mechanism");
    if task.file.design.is_some() {
        return (by > TOLD * task.file.unit().metre()).then_some(told);
    }
    let (point, moved) = furthest(task, [given, placed], TOLD)?;
    Some(format!("{told}, in which `{point}` has moved by {moved}"))
}

/// The kingpin is stated from top to bottom.
fn kingpin(task: &Task<'_>, wheel: &Wheel, placed: &[Vector3<f64>]) -> Option<String> {
    let names = task.names;
    let [lower, upper] = wheel.points.kingpin?;
    let [from, to] = [lower, upper].map(|point| &names.points[point]);
    let upwards = task.file.axes.turned(placed[upper] - placed[lower]);
    (upwards.z < 0.0).then(|| {
        let kingpin = wheel.stated("kingpin");
        format!(
            "the kingpin points downwards; write `{kingpin}: {to} -> {from};` for caster and kingpin angle, or look at the \
             axes and the signs of z if `{to}` is to be the upper end"
        )
    })
}

/// At the design position the spin axis is far off the y direction: one of its two points is likely to be a wrong one.
fn across_the_wheel(task: &Task<'_>, wheel: &Wheel, placed: &[Vector3<f64>]) -> Option<String> {
    let names = task.names;
    let [inner, centre] = wheel.points.axis;
    let [from, to] = [inner, centre].map(|point| &names.points[point]);
    let axis = placed[centre] - placed[inner];
    let off = axis.xz().norm().atan2(axis.y.abs()).to_degrees();
    (off > OFF_AXIS).then(|| {
        let (wheel, off) = (wheel.title("wheel"), rounded(off, 3));
        format!(
            "the spin axis of the {wheel}, from `{from}` to `{to}`, is {off} deg off the y direction at the design position: are these \
             the two points that are meant, and their coordinates right?"
        )
    })
}

/// The spin axis of a wheel that is on one side points to the other.
fn spin_axis(task: &Task<'_>, wheel: &Wheel, placed: &[Vector3<f64>]) -> Option<String> {
    let names = task.names;
    let [inner, centre] = wheel.points.axis;
    let [from, to] = [inner, centre].map(|point| &names.points[point]);
    let outboard = placed[centre].y - placed[inner].y;
    // Points are in local coordinates; the middle of the vehicle is at y = 0 of the file.
    let side = placed[centre].y + task.middle;
    (outboard * side < 0.0).then(|| {
        let wheel = wheel.stated("wheel");
        format!("the spin axis points inboard; write `{wheel}: {to} -> {from};` if `{from}` is the wheel centre")
    })
}

/// The motion ends before its stop, which is no whole number of steps from the start.
pub(super) fn short_of_stop(task: &Task<'_>, instants: &Instants) -> Option<String> {
    let time = task.file.time.get_ref();
    let (stop, step) = (time.stop.as_ref()?, time.step.as_ref()?);
    let [_, last] = instants.ends();
    let (name, stop, step) = (task.source.name(), *stop.get_ref(), *step.get_ref());
    (last != stop).then(|| {
        let [last, stop, step] = [last, stop, step].map(|seconds| rounded(seconds, 9));
        format!("{name}: the motion ends at t = {last} s: its stop at {stop} s is no whole number of steps of {step} s")
    })
}

/// Lengths of the vehicle that are in another unit, as it seems.
fn lengths(task: &Task<'_>) -> impl Iterator<Item = String> {
    let names = task.names;
    let radii = names.wheels.iter().filter_map(|wheel| wheel.radius);
    let radius = radii.map(|radius| length(task.file.length, "wheel_radius", radius, 0.05..5.0));
    let vehicle = task.file.vehicle.as_ref().map(Spanned::get_ref);
    let rack_per_turn = vehicle.and_then(|vehicle| vehicle.rack_per_turn.as_ref());
    let of_car = [
        (
            "rack_per_turn",
            rack_per_turn.map(|travel| *travel.get_ref()),
            0.01..0.5,
        ),
        ("wheelbase", names.vehicle.wheelbase, 0.5..20.0),
        ("cg_height", names.vehicle.cg_height, 0.05..5.0),
    ];
    let of_car = of_car
        .into_iter()
        .filter_map(|(name, stated, usual)| length(task.file.length, name, stated?, usual));
    radius.flatten().take(1).chain(of_car)
}

/// A length that is outside what is usual, in metres.
pub(super) fn length(unit: Length, name: &str, stated: f64, usual: Range<f64>) -> Option<String> {
    if usual.contains(&(stated / unit.metre())) {
        return None;
    }
    let (length, symbol) = (number(stated), unit.symbol());
    // A length that is usual is about a metre long when divided by this.
    let middle = (usual.start * usual.end).sqrt();
    let doubt = match Length::of_size(stated / middle) {
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
