//! Notes on the points of a wheel that their author may not have meant.

use std::ops::Range;

use nalgebra::Vector3;

use crate::mechanism::{Wheel, side_of};
use crate::number::rounded;
use crate::prepare::task::Task;

/// The angle, in degrees, by which no wheel is toed or cambered at its design position.
const OFF_AXIS: f64 = 30.0;

/// The angle, in degrees, by which no kingpin leans at its design position: that of a chopper leans by less.
const OFF_VERTICAL: f64 = 50.0;

/// Notes on a wheel, from all points at the design position.
pub(super) fn notes_on_wheel(
    task: &Task<'_>,
    wheel: &Wheel,
    placed: &[Vector3<f64>],
) -> impl Iterator<Item = String> {
    let notes = [
        kingpin(task, wheel, placed),
        lying_kingpin(task, wheel, placed),
        across_the_wheel(task, wheel, placed),
        spin_axis(task, wheel, placed),
    ];
    notes.into_iter().flatten()
}

/// A note that the kingpin is stated from top to bottom.
fn kingpin(task: &Task<'_>, wheel: &Wheel, placed: &[Vector3<f64>]) -> Option<String> {
    let names = &task.names;
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

/// A note that the kingpin is far off the vertical at the design position: one of its two points is probably wrong.
fn lying_kingpin(task: &Task<'_>, wheel: &Wheel, placed: &[Vector3<f64>]) -> Option<String> {
    let ends = wheel.points.kingpin?;
    let axis = placed[ends[1]] - placed[ends[0]];
    let off = axis.xy().norm().atan2(axis.z.abs()).to_degrees();
    (off > OFF_VERTICAL).then(|| {
        let line = format!("kingpin of the {}", wheel.title("wheel"));
        far_off(task, (&line, ends), (off, "vertical"))
    })
}

/// The note that a line between two points is that many degrees off its usual direction.
fn far_off(
    task: &Task<'_>,
    (line, ends): (&str, [usize; 2]),
    (degrees, usual): (f64, &str),
) -> String {
    let [from, to] = ends.map(|point| &task.names.points[point]);
    let off = rounded(degrees, 3);
    format!(
        "the {line}, from `{from}` to `{to}`, is {off} deg off the {usual} at the design position: are these the two points that are \
         meant, and their coordinates right?"
    )
}

/// A note that the spin axis is far off the y direction at the design position: one of its two points is probably
/// wrong.
fn across_the_wheel(task: &Task<'_>, wheel: &Wheel, placed: &[Vector3<f64>]) -> Option<String> {
    let ends = wheel.points.axis;
    let axis = placed[ends[1]] - placed[ends[0]];
    let off = axis.xz().norm().atan2(axis.y.abs()).to_degrees();
    (off > OFF_AXIS).then(|| {
        let line = format!("spin axis of the {}", wheel.title("wheel"));
        far_off(task, (&line, ends), (off, "y direction"))
    })
}

/// A note that the spin axis of a wheel on one side points to the other side.
fn spin_axis(task: &Task<'_>, wheel: &Wheel, placed: &[Vector3<f64>]) -> Option<String> {
    let names = &task.names;
    let [inner, centre] = wheel.points.axis;
    let [from, to] = [inner, centre].map(|point| &names.points[point]);
    let outboard = placed[centre].y - placed[inner].y;
    let side = task.y_in_file(&placed[centre]);
    (outboard * side < 0.0).then(|| {
        let wheel = wheel.stated("wheel");
        format!("the spin axis points inboard; write `{wheel}: {to} -> {from};` if `{from}` is the wheel centre")
    })
}

/// A note that the radius is large beside the distance of the wheel centre from the middle of the vehicle, and beside its height above
/// the origin, which is often on the ground: it is probably the diameter. The wheel of a motorcycle is in the middle.
pub(super) fn diameter(task: &Task<'_>, wheel: &Wheel, placed: &[Vector3<f64>]) -> Option<String> {
    /// As a part of the distance of the wheel centre from the middle. Radii are about half of it, 0.71 in one of the published suspensions.
    const LARGE: f64 = 0.75;
    /// A smaller part of the distance counts if the radius is about twice the height.
    const WITH_TWICE_THE_HEIGHT: f64 = 0.55;
    /// Longer than any diameter; beyond the end the wheel is in the middle.
    const LONGER: Range<f64> = 1.5..10.0;
    let radius = wheel.radius?;
    let [_, centre] = wheel.points.axis;
    let at = placed[centre] + task.origin.position();
    let [of_distance, of_height] = [at.y, at.z].map(|place| radius / place.abs());
    let is_twice = of_distance > WITH_TWICE_THE_HEIGHT && (1.8..2.2).contains(&of_height);
    let is_large = is_twice || of_distance > LARGE && of_height > 1.5;
    let is_diameter = of_distance < LONGER.start;
    let is_doubtful = is_large && of_distance < LONGER.end;
    is_doubtful.then(|| {
        let centre = &task.names.points[centre];
        let [radius, y, z] = [radius, at.y, at.z].map(|length| rounded(length, 4));
        let unit = task.file.length.symbol();
        let doubt = match is_diameter {
            true => "is it the diameter?",
            false => "are its decimal point and unit right?",
        };
        format!(
            "wheel_radius is {radius} {unit}, and `{centre}` is at y = {y} and z = {z}: {doubt}"
        )
    })
}

/// A note that a wheel is named for one side of the vehicle and stands on the other: the axes are probably others than stated.
pub(super) fn named_side(
    task: &Task<'_>,
    wheel: &Wheel,
    placed: &[Vector3<f64>],
) -> Option<String> {
    let axes = task.file.axes;
    let named = side_of(&wheel.name)?;
    let [_, centre] = wheel.points.axis;
    let [_, left, _] = axes.signs();
    let is = match task.y_in_file(&placed[centre]) * left {
        to_left if to_left > 0.0 => "left",
        to_left if to_left < 0.0 => "right",
        _ => return None,
    };
    (named != is).then(|| {
        format!(
            "the wheel `{}` is on the {named} by its name, and on the {is} by the y of `{}` in axes of {}: are the axes right?",
            wheel.name,
            task.names.points[centre],
            axes.in_words()
        )
    })
}
