//! A point that is named for neither side of the vehicle but joined to both.

use nalgebra::Vector3;
use suspension_core::Values;
use suspension_runtime::{Listing, Statement};

use crate::mechanism::{name_on_other_side, side_of};
use crate::number::rounded;
use crate::prepare::task::Task;

/// The distance from the middle of the vehicle within which a point is in the middle, as a fraction of the farthest
/// point's distance.
const MIDDLE: f64 = 1e-6;

/// Notes on points off the middle of the vehicle that are joined both by a part and by its image on the other side:
/// one of the two reaches across the vehicle. A part that joins such points of both sides, as of a relay rod from the
/// pitman arm to the idler arm, is meant to.
pub(in crate::prepare) fn notes<P: Values<Vector3<f64>>>(
    task: &Task<'_>,
    listing: &Listing,
    given: &P,
) -> Vec<String> {
    let y: Vec<f64> = given.values().map(|point| task.y_in_file(&point)).collect();
    let off = y.iter().fold(0.0, |off: f64, y| off.max(y.abs())) * MIDDLE;
    let names = &task.names.points;
    let is_of_neither = |point: usize| side_of(&names[point]).is_none() && y[point].abs() > off;
    let spans = |part: &Statement<'_>| {
        let ends = part.points.iter().filter(|point| is_of_neither(**point));
        let (left, right): (Vec<usize>, Vec<usize>) = ends.partition(|point| y[**point] > 0.0);
        !left.is_empty() && !right.is_empty()
    };
    let parts: Vec<Statement<'_>> = listing.parts().filter(|part| !spans(part)).collect();
    let points = (0..names.len()).filter(|point| is_of_neither(*point));
    let notes = points.filter_map(|point| {
        let (name, y) = (&names[point], y[point]);
        let [part, other] = parts_on_both_sides(&parts, point)?;
        let side = side_of(part.name)?;
        let (part, other) = (part.name, other.name);
        let (unit, y) = (task.file.unit().symbol(), rounded(y.abs(), 4));
        Some(format!(
            "`{name}` is named for neither side and lies {y} {unit} off the middle of the vehicle: `{part}` and `{other}` both join it, \
             one of them across the vehicle; name it `{side}_{name}` where each side has its own"
        ))
    });
    notes.collect()
}

/// The parts that join a point and whose names differ only in their sides.
fn parts_on_both_sides<'a, 'l>(
    parts: &'a [Statement<'l>],
    point: usize,
) -> Option<[&'a Statement<'l>; 2]> {
    let joining = || parts.iter().filter(|part| part.points.contains(&point));
    joining().find_map(|part| {
        let image = name_on_other_side(part.name)?;
        let other = joining().find(|other| other.name == image)?;
        Some([part, other])
    })
}
