//! What a file says of drives that the mechanism at its design contradicts.

use suspension_core::Values;
use suspension_core::listing::DriveKind;

use crate::load::design::Design;
use crate::load::task::Task;
use crate::mechanism::{Coordinate, DriveLaws, From, Instants, Suspension, evenly_spaced};
use crate::number::rounded;

/// Instants at which drives are looked at.
const LOOKS: usize = 101;

/// Doubts about the laws of drives that are coordinates, over the instants.
pub(super) fn doubts<L: Suspension<N>, const N: usize>(
    task: &Task<'_>,
    design: &Design<L, N>,
    laws: &DriveLaws,
    instants: &Instants,
) -> Vec<String> {
    let looks = evenly_spaced(instants.ends(), LOOKS).into_iter();
    let values = looks.map(|t| design.given(&laws.inputs::<L::Drives>(t).drives.value));
    let values: Vec<Vec<f64>> = values.collect();
    let designed = design.given(&design.drives);
    let size = Coordinate::extent(design.points.values());
    let stated = task.file.drives.get_ref();
    let drives = task.names.drives.iter().enumerate();
    let coordinates = drives.filter(|(_, drive)| {
        drive.kind == DriveKind::Coordinate && stated.contains_key(drive.name.as_str())
    });
    let doubts = coordinates.filter_map(|(index, drive)| {
        let of_drive = values.iter().map(|values| values[index]);
        let ends = of_drive.fold(
            [f64::INFINITY, f64::NEG_INFINITY],
            |[least, most], value| [least.min(value), most.max(value)],
        );
        let (name, design) = (drive.name.as_str(), designed[index]);
        let way = format!("; write {name} = [{}, ...]", rounded(design, 6));
        let coordinate = Coordinate {
            name,
            design,
            size,
            unit: task.file.length,
        };
        coordinate.doubt(ends, From::Zero, &way)
    });
    let name = task.source.name();
    doubts
        .map(|doubt| format!("{name}: [drives]: {doubt}"))
        .collect()
}
