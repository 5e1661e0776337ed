//! The description of a mechanism without its equations.

use nalgebra::Vector3;

use crate::file::{Axes, Instants, Unit};
use crate::mechanism::lock::Lock;
use crate::mechanism::lock::end_of_angle::EndOfAngle;
use crate::mechanism::measure::nearest;
use crate::mechanism::motion::drive_laws::DriveLaws;
use crate::mechanism::parts::names::Names;

/// The data of a mechanism without its equations: names, unit, and what leads it.
#[derive(Clone, Debug)]
pub struct Description {
    /// The linkage's name in motion files.
    pub linkage: String,
    /// The names of its parts.
    pub names: Names,
    /// The unit of its lengths.
    pub unit: Unit,
    /// The axes of its coordinates.
    pub axes: Axes,
    /// The vector to be added to a local position to get the file's coordinates.
    pub origin: Vector3<f64>,
    /// The instants of its motion.
    pub instants: Instants,
    /// The drives; a drive that a measure replaces keeps its value of the first instant.
    pub drives: DriveLaws,
    /// The difference of each drive's value in the file's coordinates from its local value.
    pub drive_offsets: Vec<f64>,
    /// The same difference for each measure.
    pub measure_offsets: Vec<f64>,
    /// The drives at the design position, in the file's coordinates.
    pub design: Vec<f64>,
    /// The measures at the design position.
    pub design_measures: Vec<f64>,
    /// The reason why the motion begins out of reach, in which case it stays at the design position; `None` if it
    /// does not.
    pub out_of_reach: Option<String>,
    /// The number of the measure that leads instead of a drive.
    pub led_by: Option<usize>,
    /// Remarks on what the author of the file may not have meant, one sentence each.
    pub notes: Vec<String>,
}

impl Description {
    /// The drives' values in the file's coordinates, from local ones.
    pub fn drives_in_file(&self, local: impl IntoIterator<Item = f64>) -> Vec<f64> {
        let each = local.into_iter().zip(&self.drive_offsets);
        each.map(|(local, offset)| local + offset).collect()
    }

    /// The measures' values in the file's coordinates, from local ones: each is as near as possible to that at the
    /// design position.
    pub(crate) fn measures_in_file(&self, local: &[f64]) -> Vec<f64> {
        let design = self.names.measures.iter().zip(&self.design_measures);
        let each = local.iter().zip(&self.measure_offsets).zip(design);
        let each = each.map(|((local, offset), (measure, design))| {
            nearest(measure.kind, local + offset, *design)
        });
        each.collect()
    }

    /// The drives at time `t`, in local coordinates.
    pub fn drives_at(&self, t: f64) -> Vec<f64> {
        self.drives.at(t).map(|drive| drive.value).collect()
    }

    /// The drives at the first instant, in local coordinates.
    pub fn first_drives(&self) -> Vec<f64> {
        let [first, _] = self.instants.ends();
        self.drives_at(first)
    }

    /// A description of where the mechanism locks.
    pub fn lock_in_words(&self, lock: &Lock) -> String {
        lock.in_words(&self.names, self.unit, &self.design)
    }

    /// The message that a driven angle is at the end of its range, with the remedy, if it is so at these values of
    /// the drives in the file's coordinates.
    pub fn end_of_angle(&self, drives: &[f64]) -> Option<String> {
        let end = EndOfAngle::find(&self.names, None, drives);
        end.map(|end| end.in_words(&self.names, self.unit))
    }
}
