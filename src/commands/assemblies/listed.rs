//! The assemblies of a file's mechanism.

use std::f64::consts::PI;
use std::sync::atomic::{AtomicBool, Ordering};

use nalgebra::SVector;
use suspension_core::lu::Lu;
use suspension_core::{DriveKind, Inputs, Motion, Signal, Still, Values};

use crate::assemblies::{Assemblies, Census, Tally};
use crate::failure::Failure;
use crate::mechanism::{Drive, Mechanism, State, Suspension};

/// Where assemblies are wanted.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Wish {
    /// The drive; `None` where there is only one.
    pub drive: Option<String>,
    /// Its values; none for those of the file's first instant.
    pub at: Vec<f64>,
}

/// All assemblies at one value of the drives.
#[derive(Clone, Debug, PartialEq)]
pub struct Listed {
    /// The drives in words.
    pub drives_in_words: String,
    /// The real ones, nearest to the file's configuration first.
    pub assemblies: Vec<Assembly>,
    /// These and the others, by number.
    pub tally: Tally,
}

/// A real assembly.
#[derive(Clone, Debug, PartialEq)]
pub struct Assembly {
    /// From the configuration of the file's first instant: the norm over all coordinates, in the
    /// file's unit.
    pub distance: f64,
    /// How far the point moved that moved farthest.
    pub farthest: f64,
    /// Its number in the list, from 1.
    pub number: usize,
    /// The smallest pivot of the Jacobian with partial pivoting; zero where it is singular.
    pub smallest_pivot: f64,
    /// The points that stand on the wrong side of those that links join them to: a mirror image that
    /// has all lengths and cannot be built.
    pub mirrored: Vec<String>,
    /// The mechanism at rest.
    pub state: State,
}

/// Takes the assemblies at one value of the drives.
pub type OnListed<'a> = dyn FnMut(&Listed) -> Result<(), Failure> + 'a;

/// Lists all assemblies of the file's mechanism, value by value.
///
/// # Errors
///
/// [`Failure::Input`] where the wish makes no sense, [`Failure::Solver`] where there is no assembly at a value,
/// [`Failure::Interrupted`] between two values, and what `on_listed` fails with.
pub fn list<L: Suspension<N>, const N: usize>(
    mechanism: &Mechanism<L, N>,
    file: &str,
    wish: &Wish,
    interrupted: &AtomicBool,
    on_listed: &mut OnListed<'_>,
) -> Result<(), Failure> {
    let [first, _] = mechanism.instants.ends();
    let first = mechanism.drives.inputs::<L::Drives>(first);
    let refuse = |message: String| Failure::Input(format!("{file}: {message}"));
    let inputs = match wish.at.as_slice() {
        [] => vec![first],
        values => {
            let drive = mechanism.names.chosen_drive(wish.drive.as_deref());
            let drive = drive.map_err(refuse)?;
            let offset = mechanism.drive_offset(drive);
            let with = |value: &f64| {
                check(&mechanism.names.drives[drive], *value).map_err(refuse)?;
                Ok(Inputs::still(Signal {
                    value: first.drives.value.with(drive, value - offset),
                    ..Signal::default()
                }))
            };
            values.iter().map(with).collect::<Result<_, _>>()?
        }
    };
    let mut nowhere = Vec::new();
    let mut search = Assemblies::new(&mechanism.model, &mechanism.start.position, &first);
    for (done, inputs) in inputs.iter().enumerate() {
        if interrupted.load(Ordering::Relaxed) {
            return Err(Failure::Interrupted(format!(
                "{file}: interrupted after {done} of the drive's values"
            )));
        }
        let listed = listed(mechanism, inputs, search.at(inputs));
        on_listed(&listed)?;
        if listed.assemblies.is_empty() {
            nowhere.push(listed.drives_in_words);
        }
    }
    if nowhere.is_empty() {
        return Ok(());
    }
    let design = &mechanism.design;
    let design = mechanism
        .names
        .drives_in_words(design, mechanism.unit, None);
    Err(Failure::Solver(format!(
        "{file}: no assembly was found at {}; --at has the drive's own values, the design is at {design}",
        nowhere.join(", nor at ")
    )))
}

/// Whether a drive can have a value.
fn check(drive: &Drive, value: f64) -> Result<(), String> {
    let is_angle = drive.kind == DriveKind::Angle;
    if value.is_finite() && (!is_angle || (0.0..=PI).contains(&value)) {
        return Ok(());
    }
    let bound = if is_angle {
        "the angle of a link from an axis lies between 0 and pi"
    } else {
        "a drive has a finite value"
    };
    Err(format!("--at {value}: {bound}"))
}

fn listed<L: Suspension<N>, const N: usize>(
    mechanism: &Mechanism<L, N>,
    inputs: &Inputs<Still, L::Drives>,
    census: Census<N>,
) -> Listed {
    let mut assemblies: Vec<_> = census
        .real
        .iter()
        .map(|q| assembly(mechanism, inputs, q))
        .collect();
    assemblies.sort_by(|a, b| a.distance.total_cmp(&b.distance));
    for (number, assembly) in (1..).zip(&mut assemblies) {
        assembly.number = number;
    }
    let drives = mechanism.given(&inputs.drives.value);
    Listed {
        drives_in_words: mechanism
            .names
            .drives_in_words(&drives, mechanism.unit, None),
        assemblies,
        tally: census.tally,
    }
}

fn assembly<L: Suspension<N>, const N: usize>(
    mechanism: &Mechanism<L, N>,
    inputs: &Inputs<Still, L::Drives>,
    q: &SVector<f64, N>,
) -> Assembly {
    let Mechanism { model, names, .. } = mechanism;
    let moved = q - mechanism.start.position;
    let shifts = moved.as_slice().chunks(3);
    let farthest = shifts
        .map(|shift| shift.iter().map(|x| x * x).sum::<f64>().sqrt())
        .fold(0.0, f64::max);
    let points = Motion::at_rest(*q).points(model, inputs).value;
    let fixed = model.drive_anchors(*model.fixed(), &model.coordinates(&inputs.drives).value);
    let factored = Lu::factor(&model.jacobian(q, &fixed));
    let sides = model.linked().zip(model.mirrored(q, &fixed));
    let mirrored = sides.filter(|(_, mirrored)| *mirrored > 0.5);
    let [first, _] = mechanism.instants.ends();
    Assembly {
        distance: moved.norm(),
        farthest,
        number: 0,
        smallest_pivot: factored.map_or(0.0, |lu| lu.smallest_pivot().1),
        mirrored: mirrored
            .map(|(point, _)| names.points[point].clone())
            .collect(),
        state: mechanism.at_rest(first, &inputs.drives.value, points),
    }
}
