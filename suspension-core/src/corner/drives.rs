//! Wrong drives that the equations would not detect.

use crate::arithmetic::scalar::Real;
use crate::error::SolveError;
use crate::linkage::Linkage;
use crate::listing::{Kind, Part};
use crate::signal::Signal;
use crate::step::substeps::Stopped;
use crate::values::Values;

/// Refuses drives that are NaN or infinite: a drive that moves a point which only measures read affects no residual.
/// Also refuses angles beyond their range, where the equations have the sine or cosine of another angle.
pub(super) fn check<T: Real, L: Linkage<N, Scalar = T>, const N: usize>(
    model: &L,
    drives: &Signal<L::Drives>,
    [from, to]: [T; 2],
) -> Result<(), Stopped<T>> {
    let rates = drives.rate.values().zip(drives.second_rate.values());
    let each = drives.value.values().zip(rates).enumerate();
    let each = each.take(model.count(Kind::Drive));
    for (drive, (value, (rate, second_rate))) in each {
        let part = Part::Drive(drive);
        let is_finite = value.is_finite() && rate.is_finite() && second_rate.is_finite();
        let refused = if is_finite {
            let end = model.drive_kind(drive).end_exceeded(value);
            end.map(|end| SolveError::OutOfRange {
                part,
                asked: value,
                end,
            })
        } else {
            Some(SolveError::NotFinite { part })
        };
        if let Some(error) = refused {
            return Err(Stopped {
                reached: from,
                refused: Some((to - from, error.of_step(to - from))),
            });
        }
    }
    Ok(())
}

/// Refuses a change of drives that is NaN or infinite.
pub(super) fn check_change<T: Real, L: Linkage<N, Scalar = T>, const N: usize>(
    model: &L,
    change: &L::Drives,
) -> Result<(), SolveError<T>> {
    let mut each = change.values().take(model.count(Kind::Drive));
    let not_finite = each.position(|change| !change.is_finite());
    not_finite.map_or(Ok(()), |drive| {
        let part = Part::Drive(drive);
        Err(SolveError::NotFinite { part })
    })
}
