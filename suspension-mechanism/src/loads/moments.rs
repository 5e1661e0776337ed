//! Moments about angles, which act on the parts that carry the lines.

use nalgebra::Vector3;
use suspension_runtime::Statement;

use crate::loads::forces::Here;
use crate::loads::outcome::By;
use crate::mechanism::Names;

/// A moment, N m, on a part, by number.
type Moment = (By, usize, Vector3<f64>);

/// The moments of angles that statements, by name, drive or hold.
pub(super) fn moments_of_angles(
    on_parts: Vec<(usize, String, Vector3<f64>)>,
    parts: &[Statement<'_>],
    names: &Names,
) -> Vec<Moment> {
    let by = |angle: &str| {
        let held = parts.iter().position(|part| part.name == angle);
        held.map(By::Part)
            .or_else(|| names.drive(angle).map(By::Drive))
    };
    let each = on_parts.into_iter();
    each.filter_map(|(part, angle, moment)| Some((by(&angle)?, part, moment)))
        .collect()
}

/// The moments of loads in measures, by number, that are angles.
pub(super) fn moments_in_measures(here: &Here<'_>, acting: &[(usize, f64)]) -> Vec<Moment> {
    let moments = acting.iter().flat_map(|(measure, along)| {
        let on_parts = here.moments_in(*measure, *along).into_iter();
        on_parts.map(|(part, moment)| (By::Measure(*measure), part, moment))
    });
    moments.collect()
}
