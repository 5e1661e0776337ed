//! The whole curve of a drive as a plot.

use crate::file::Dimension;
use crate::mechanism::Description;
use crate::output::figures::upwards;
use crate::output::plot::{Chart, Curve};
use crate::quantities::{Axis, CENTRE, columns};
use crate::reach::{DriveRange, Station};

/// The height of the centre of the wheel that the drive moves, else of the first, against the drive: the whole curve, and over it the part to
/// which the drive leads, its ends marked. `None` where there is no wheel.
pub(super) fn chart(mechanism: &Description, range: &DriveRange) -> Option<Chart> {
    let names = &mechanism.names;
    let (scale, symbol) = Dimension::from(range.kind).for_people(mechanism.unit);
    let (up, quantity) = upwards(mechanism);
    let moved = names.wheels.iter().position(|wheel| {
        let drive = wheel.travel.and_then(|drive| names.drives.get(drive));
        drive.is_some_and(|drive| drive.name == range.name)
    });
    let number = moved.unwrap_or_default();
    let wheel = names.wheels.get(number)?;
    let centre = columns([&CENTRE], names).into_iter();
    let mut heights = centre.filter(|column| column.axis == Some(Axis::Z));
    let height = heights.nth(number)?;
    let line = |stations: &[Station]| -> Vec<(f64, f64)> {
        let points = stations.iter();
        let point =
            |station: &Station| (station.value() * scale, up * height.value(&station.state));
        points.map(point).collect()
    };
    let usable = line(&range.usable);
    let marks = [usable.first(), usable.last()];
    Some(Chart {
        title: format!(
            "Height of the {} over the whole curve of {}",
            wheel.title(CENTRE.title),
            range.name
        ),
        across: format!("{} ({symbol})", range.name),
        quantity,
        curves: vec![
            Curve {
                name: "out of the drive's reach".to_owned(),
                line: line(&range.curve),
                marks: Vec::new(),
            },
            Curve {
                name: "led by the drive, ends marked".to_owned(),
                marks: marks.into_iter().flatten().copied().collect(),
                line: usable,
            },
        ],
    })
}
