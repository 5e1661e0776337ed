//! The whole curve of a drive as a plot.

use suspension_core::DriveKind;

use crate::output::plot::{Chart, Curve};
use crate::range::course::DriveRange;
use crate::range::station::Station;
use crate::study::Study;

/// The height of the wheel centre against the drive: the whole curve, and over it the part to
/// which the drive leads, its ends marked.
pub(super) fn chart(study: &dyn Study, range: &DriveRange) -> Chart {
    let (scale, unit) = match range.kind {
        DriveKind::Angle => (1_f64.to_degrees(), "deg"),
        DriveKind::Coordinate => (1.0, study.unit().symbol()),
    };
    let line = |stations: &[Station]| -> Vec<(f64, f64)> {
        let points = stations.iter();
        points.map(|s| (s.value * scale, s.height)).collect()
    };
    let usable = line(&range.usable);
    let marks = [usable.first(), usable.last()];
    Chart {
        title: format!(
            "Height of the wheel centre over the whole curve of {}",
            range.name
        ),
        across: format!("{} ({unit})", range.name),
        quantity: format!("height z ({})", study.unit().symbol()),
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
    }
}
