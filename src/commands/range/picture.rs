//! The whole curve of a drive as a plot.

use crate::mechanism::{Names, Unit};
use crate::output::plot::{Chart, Curve};
use crate::quantities::{Axis, CENTRE, Kind, columns};
use crate::reach::{DriveRange, Station};

/// The height of the wheel centre against the drive: the whole curve, and over it the part to
/// which the drive leads, its ends marked. `None` where there is no wheel.
pub(super) fn chart(names: &Names, unit: Unit, range: &DriveRange) -> Option<Chart> {
    let (scale, symbol) = Kind::from(range.kind).for_people(unit);
    let mut centre = columns([&CENTRE], names).into_iter();
    let height = centre.find(|column| column.axis == Some(Axis::Z))?;
    let line = |stations: &[Station]| -> Vec<(f64, f64)> {
        let points = stations.iter();
        let point = |station: &Station| (station.value() * scale, height.value(&station.state));
        points.map(point).collect()
    };
    let usable = line(&range.usable);
    let marks = [usable.first(), usable.last()];
    Some(Chart {
        title: format!(
            "Height of the {} over the whole curve of {}",
            CENTRE.title, range.name
        ),
        across: format!("{} ({symbol})", range.name),
        quantity: format!("height z ({})", unit.symbol()),
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
