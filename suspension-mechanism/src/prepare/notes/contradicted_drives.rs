//! Statements of a file about drives that the mechanism at its design contradicts.

use suspension_core::Values;
use toml::Spanned;

use crate::file::StatedLaw;
use crate::mechanism::{
    CountedFrom, DriveAtDesign, DriveLaws, Instants, Suspension, ends, evenly_spaced, extent,
};
use crate::number::rounded;
use crate::prepare::design::Design;
use crate::prepare::task::Task;

/// The number of instants at which drives are checked.
const LOOKS: usize = 101;

/// Doubts about the laws of drives, over the instants.
pub(in crate::prepare) fn doubts<L: Suspension<N>, const N: usize>(
    task: &Task<'_>,
    design: &Design<L, N>,
    laws: &DriveLaws,
    instants: &Instants,
) -> Vec<String> {
    let [first, last] = instants.ends();
    let looks = evenly_spaced([first, last], LOOKS).into_iter();
    let values = looks.map(|t| design.drives_in_file(&laws.inputs::<L::Drives>(t).drives.value));
    let values: Vec<Vec<f64>> = values.collect();
    let designed = design.drives_in_file(&design.drives);
    let size = extent(design.points.values()).norm();
    let stated = task.file.drives.get_ref();
    let drives = task.names.drives.iter().enumerate();
    let drives = drives.filter(|(_, drive)| stated.has(drive.name.as_str()));
    let unit = task.file.unit();
    let doubts = drives.filter_map(|(index, drive)| {
        let ends = ends(values.iter().map(|values| values[index]))?;
        let (name, design) = (&drive.name, designed[index]);
        let in_file = design * unit.file_factor(drive.kind);
        let in_file = rounded(in_file, 6);
        let way = match stated.get(name.as_str()).map(Spanned::get_ref) {
            Some(StatedLaw::Sine(_)) => format!("; write mean = {in_file}"),
            Some(StatedLaw::Recorded(_)) => format!("; write offset = {in_file}"),
            _ => format!("; write {name} = [{in_file}, ...]"),
        };
        let at_design = DriveAtDesign {
            drive,
            design,
            size,
            unit,
            seconds: (last - first).abs(),
        };
        at_design.doubt(ends, CountedFrom::Zero, &way)
    });
    doubts.map(|doubt| format!("[drives]: {doubt}")).collect()
}
