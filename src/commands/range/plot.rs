//! The plot of a drive's whole curve.

use crate::file::Dimension;
use crate::mechanism::{Description, ends};
use crate::output::capitalised::capitalised;
use crate::output::motion::plots::upwards;
use crate::output::plot::{Chart, Curve};
use crate::quantities::{Axis, CAMBER, CENTRE, Column, TOE, columns};
use crate::reach::{DriveRange, Station};

/// Plots a quantity of a wheel over the drive: the whole curve, and over it the part through which the drive leads, its ends
/// marked. The wheel is the one that the drive moves, or else the first; `None` without a wheel, or if no quantity varies.
pub(super) fn chart(mechanism: &Description, range: &DriveRange) -> Option<Chart> {
    let (scale, symbol) = Dimension::from(range.kind).display_scale(mechanism.unit);
    let shown = shown(mechanism, range)?;
    let line = |stations: &[Station]| -> Vec<(f64, f64)> {
        let points = stations.iter();
        let point = |station: &Station| {
            let value = shown.column.value(&station.state);
            (station.value() * scale, value * shown.scale)
        };
        points.map(point).collect()
    };
    let usable = line(&range.usable);
    let marks = [usable.first(), usable.last()];
    Some(Chart {
        title: format!("{} over the whole curve of {}", shown.title, range.name),
        across: format!("{} ({symbol})", range.name),
        quantity: shown.axis,
        curves: vec![
            Curve {
                name: "out of the drive's reach".to_owned(),
                line: line(&range.curve),
                ..Curve::default()
            },
            Curve {
                name: "led by the drive, ends marked".to_owned(),
                marks: marks.into_iter().flatten().copied().collect(),
                line: usable,
                ..Curve::default()
            },
        ],
    })
}

struct Drawn {
    title: String,
    /// The label of the axis.
    axis: String,
    column: Column,
    scale: f64,
}

/// The height of the wheel centre; where that is the drive itself, or stays, the toe angle or the camber angle.
fn shown(mechanism: &Description, range: &DriveRange) -> Option<Drawn> {
    let names = &mechanism.names;
    let moved = names.wheels.iter().position(|wheel| {
        let drive = wheel.travel.and_then(|drive| names.drives.get(drive));
        drive.is_some_and(|drive| drive.name == range.name)
    });
    let number = moved.unwrap_or_default();
    let wheel = names.wheels.get(number)?;
    let (up, axis) = upwards(mechanism);
    let is_height = |column: &Column| column.axis == Some(Axis::Z);
    let height = columns([&CENTRE], names).into_iter().filter(is_height);
    let mut height = height.map(|column| Drawn {
        title: format!("Height of the {}", wheel.title(CENTRE.title)),
        axis: axis.clone(),
        column,
        scale: up,
    });
    let angle = |quantity| {
        let each = columns([quantity], names).into_iter();
        let mut angle = each.map(|column| Drawn {
            title: capitalised(&wheel.title(quantity.title)),
            axis: format!("{} (deg)", quantity.title),
            column,
            scale: 1_f64.to_degrees(),
        });
        angle.nth(number)
    };
    let candidates = [height.nth(number), angle(&TOE), angle(&CAMBER)];
    let mut candidates = candidates.into_iter().flatten();
    candidates.find(|drawn| says_something(&drawn.column, range))
}

/// Whether a quantity is neither constant along the curve nor the drive itself.
fn says_something(column: &Column, range: &DriveRange) -> bool {
    const ROUNDING: f64 = 1e-9;
    let varies = |value: &dyn Fn(&Station) -> f64| {
        let [low, high] = ends(range.curve.iter().map(value)).unwrap_or_default();
        high - low > ROUNDING * high.abs().max(low.abs()).max(1.0)
    };
    let of = |station: &Station| column.value(&station.state);
    varies(&of) && varies(&|station| of(station) - station.value())
}
