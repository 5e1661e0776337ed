//! Sensitivities of quantities at the design position, and of their derivatives with respect to the drives, to each
//! hardpoint coordinate and each link's length.
//!
//! A change of a hardpoint moves the point; the suspension is built from its points and read at its new design position. A length
//! changes with the drives held. The derivatives are exact, except for the effects of springs and for a model that
//! `linkage!` has written: these are differences.

mod design_values;
mod difference;
mod exact;

use std::sync::atomic::{AtomicBool, Ordering};

use nalgebra::DMatrix;

use crate::characteristics::columns;
use crate::kinematics::{Changes, Kinematics};
use crate::mechanism::{CHANGES_AT_ONCE, Description, Names};
use crate::quantities::{Axis, Column};
pub use design_values::design_values;
use exact::Exact;

/// A change of the design.
#[derive(Clone, Debug, PartialEq)]
pub struct Change {
    /// Its name: `tie_ball.z`, `length tie_rod`, or the name of a move.
    pub name: String,
    /// The change for one unit of length.
    pub per_unit: Changes,
}

/// The effect of a change.
#[derive(Clone, Debug, PartialEq)]
pub struct Sensitivity {
    /// The change.
    pub change: Change,
    /// A row for each column: the derivatives of its value, then of its derivatives with respect to each drive, per
    /// unit of length; NaN if a neighbour has no such value.
    pub of: DMatrix<f64>,
}

/// The columns that are read, in the file's lengths and in radians: the value, then the derivative with respect to
/// each drive.
pub struct Sensitivities {
    /// The quantities.
    pub columns: Vec<Column>,
    /// Their values at the design position.
    pub values: Vec<Vec<f64>>,
    /// The effect of each change; changes with which no suspension can be built are left out.
    pub each: Vec<Sensitivity>,
}

/// Changes of the coordinates of a point, with which the points that follow it move: `followers` are pairs of a point
/// and the one that it follows. A point that slides on a line of the chassis takes the line with it.
pub fn coordinates(
    mechanism: &Description,
    point: usize,
    followers: &[[usize; 2]],
) -> impl Iterator<Item = Change> {
    let Names { points, guides, .. } = &mechanism.names;
    let name = &points[point];
    let following = followers.iter().filter(move |[_, from]| *from == point);
    let moved: Vec<usize> = following
        .map(|[marker, _]| *marker)
        .chain([point])
        .collect();
    Axis::ALL.into_iter().map(move |axis| {
        let by = axis.vector();
        let on_lines = guides.iter().flat_map(|guide| guide.moved_with(point, by));
        let moved = moved.iter().map(|point| (*point, by));
        Change {
            name: format!("{name}.{axis}"),
            per_unit: Changes {
                points: moved.chain(on_lines).collect(),
                ..Changes::default()
            },
        }
    })
}

/// The change of a length.
pub fn length(mechanism: &Description, length: usize) -> Change {
    Change {
        name: format!("length {}", mechanism.names.lengths[length]),
        per_unit: Changes {
            lengths: vec![(length, 1.0)],
            ..Changes::default()
        },
    }
}

/// The sensitivities of a mechanism at its design position; `None` if the user interrupts.
pub fn sensitivities(
    mechanism: &dyn Kinematics,
    changes: &[Change],
    interrupted: &AtomicBool,
    mut on_change: impl FnMut(),
) -> Option<Sensitivities> {
    let columns = columns(mechanism);
    let design = mechanism.design_derivatives();
    let state = mechanism.at_start(&mut |place| place.state());
    let exact = design.as_ref().zip(state);
    let exact = exact.map(|(design, state)| Exact::new(mechanism, &**design, state));
    let derivatives_of = |changes: &[Change]| match &exact {
        Some(exact) => exact.read(changes),
        None => {
            let each = changes.iter();
            each.map(|change| difference::derivatives(mechanism, change, &columns))
                .collect()
        }
    };
    let mut each = Vec::new();
    for changes in changes.chunks(CHANGES_AT_ONCE) {
        if interrupted.load(Ordering::Relaxed) {
            return None;
        }
        for (change, of) in changes.iter().zip(derivatives_of(changes)) {
            on_change();
            let Some(mut of) = of else {
                continue;
            };
            if exact.is_some() {
                difference::fill(mechanism, change, &columns, &mut of);
            }
            each.push(Sensitivity {
                change: change.clone(),
                of,
            });
        }
    }
    Some(Sensitivities {
        values: design_values(mechanism, &columns)?,
        columns,
        each,
    })
}
