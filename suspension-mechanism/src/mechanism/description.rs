//! The description of a mechanism without its equations.

use nalgebra::Vector3;

use crate::mechanism::drives::DriveLaws;
use crate::mechanism::end_of_angle::EndOfAngle;
use crate::mechanism::locking::Lock;
use crate::mechanism::measure::nearest;
use crate::mechanism::names::Names;
use suspension_motion_file::Axes;
use suspension_motion_file::Instants;
use suspension_motion_file::Unit;

/// What is known of a mechanism without its equations: names, unit, and what leads it.
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
    /// What to add to a local position for the file's coordinates.
    pub origin: Vector3<f64>,
    /// The instants of its motion.
    pub instants: Instants,
    /// The drives; one for which a measure leads stays as it is at the first instant.
    pub drives: DriveLaws,
    /// What each drive has more in the file's coordinates than in local ones.
    pub drive_offsets: Vec<f64>,
    /// The same of each measure.
    pub measure_offsets: Vec<f64>,
    /// The drives at the design position, in the file's coordinates.
    pub design: Vec<f64>,
    /// The measures there.
    pub design_measures: Vec<f64>,
    /// Why its motion begins out of reach, for which it stays at the design position; `None` where it does not.
    pub out_of_reach: Option<String>,
    /// The number of the measure that leads in place of a drive.
    pub led_by: Option<usize>,
    /// What the file says that its author may not have meant, a sentence each.
    pub notes: Vec<String>,
}

impl Description {
    /// The drives' values in the file's coordinates, from local ones.
    pub fn given(&self, local: &[f64]) -> Vec<f64> {
        let each = local.iter().zip(&self.drive_offsets);
        each.map(|(local, offset)| local + offset).collect()
    }

    /// The measures' values in the file's coordinates, from local ones: each as near to that at the design position as it can be.
    pub fn given_measures(&self, local: &[f64]) -> Vec<f64> {
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

    /// Where the mechanism locks, in words.
    pub fn lock_in_words(&self, lock: &Lock) -> String {
        lock.in_words(&self.names, self.unit, &self.design)
    }

    /// That a driven angle is at the end of its range where the drives have values, in the file's coordinates, and what to do, in words.
    pub fn end_of_angle(&self, drives: &[f64]) -> Option<String> {
        let end = EndOfAngle::of(&self.names, None, drives);
        end.map(|end| end.in_words(&self.names, self.unit))
    }
}
