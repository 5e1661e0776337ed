//! A point below the ground, and a wheel below the suspension.

use std::ops::Range;

use nalgebra::Vector3;

use crate::number::rounded;
use crate::prepare::task::Task;

/// The depths that are noted, as parts of the wheel's radius. Less is possible; where it is more, the radius is probably wrong.
const NOTED: Range<f64> = 0.1..2.0;

/// A note on the lowest point, if it is far below the ground at every wheel: its z, or that of the wheel centre, is probably wrong.
pub(super) fn note(task: &Task<'_>, placed: &[Vector3<f64>]) -> Option<String> {
    let names = &task.names;
    let up = |from: usize, to: usize| task.file.axes.turned(placed[to] - placed[from]).z;
    let depth_at_wheels = |point: usize| {
        let depths = names.wheels.iter().filter_map(|wheel| {
            let ([_, centre], radius) = (wheel.points.axis, wheel.radius?);
            Some((-up(centre, point) - radius, radius, centre))
        });
        depths.min_by(|(one, ..), (other, ..)| one.total_cmp(other))
    };
    let points = 0..names.points.len();
    let depths = points.filter_map(|point| Some((point, depth_at_wheels(point)?)));
    let lowest = depths.max_by(|(_, (one, ..)), (_, (other, ..))| one.total_cmp(other));
    let (point, (depth, radius, centre)) = lowest?;
    NOTED.contains(&(depth / radius)).then(|| {
        let [point, centre] = [point, centre].map(|point| &names.points[point]);
        let (depth, unit) = (rounded(depth, 3), task.file.length.symbol());
        format!(
            "`{point}` lies {depth} {unit} below the ground, which is wheel_radius below `{centre}`: are the z of both right?"
        )
    })
}

/// A note on a wheel centre so far below the points of all parts that the whole tyre is: the sign of its z is probably wrong.
pub(super) fn wheel_below_all(task: &Task<'_>, placed: &[Vector3<f64>]) -> Option<String> {
    let names = &task.names;
    let is_of_axis = |point: &usize| {
        let mut wheels = names.wheels.iter();
        wheels.any(|wheel| wheel.points.axis.contains(point))
    };
    names.wheels.iter().find_map(|wheel| {
        let ([_, centre], radius) = (wheel.points.axis, wheel.radius?);
        let up = |point: usize| task.file.axes.turned(placed[point] - placed[centre]).z;
        let others = (0..names.points.len()).filter(|point| !is_of_axis(point));
        let above = others.map(up).min_by(f64::total_cmp)?;
        (above > radius).then(|| {
            let (centre, above) = (&names.points[centre], rounded(above, 3));
            let unit = task.file.length.symbol();
            format!(
                "`{centre}` lies {above} {unit} below all other points, which is more than wheel_radius: is its z right?"
            )
        })
    })
}
