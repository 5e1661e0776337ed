//! The assemblies of a file's mechanism.

use std::f64::consts::PI;
use std::sync::atomic::{AtomicBool, Ordering};

use nalgebra::{Const, DimMin, SVector};
use suspension_core::lu::Lu;
use suspension_core::wheel::Wheel;
use suspension_core::{DriveKind, HasWheel, Inputs, Motion, Named, Parts, Signal, Still, Values};

use crate::assemblies::{Assemblies, Census, Tally};
use crate::failure::Failure;
use crate::input::drives::in_words;
use crate::study::{Assembled, Suspension};

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
    /// The drives, in rad or the file's unit.
    pub drives: Vec<f64>,
    /// The same in words.
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
    /// The smallest pivot of the Jacobian with partial pivoting; zero where it is singular.
    pub smallest_pivot: f64,
    /// The points that stand on the wrong side of those that links join them to: a mirror image that
    /// has all lengths and cannot be built.
    pub mirrored: Vec<&'static str>,
    /// The wheel.
    pub wheel: Option<Wheel<f64>>,
    /// The coordinates of free points and markers.
    pub coordinates: Vec<f64>,
}

/// Takes the assemblies at one value of the drives.
pub type OnListed<'a> = dyn FnMut(&Listed) -> Result<(), Failure> + 'a;

/// Lists all assemblies of the file's mechanism, value by value.
///
/// # Errors
///
/// [`Failure::Input`] where the wish makes no sense, [`Failure::Interrupted`] between two values, and
/// what `on_listed` fails with.
pub fn list<L: Suspension<N>, const N: usize>(
    assembled: &Assembled<L, N>,
    file: &str,
    wish: &Wish,
    interrupted: &AtomicBool,
    on_listed: &mut OnListed<'_>,
) -> Result<(), Failure>
where
    Const<N>: DimMin<Const<N>, Output = Const<N>>,
{
    let first = assembled.drives.inputs::<L::Drives>(assembled.first);
    let inputs = match wish.at.as_slice() {
        [] => vec![first],
        values => {
            let drive = drive::<L, N>(file, wish)?;
            let each = values.iter();
            let offset = assembled.drive_offset(drive);
            each.map(|value| with::<L, N>(file, &first, drive, *value, offset))
                .collect::<Result<_, _>>()?
        }
    };
    let mut search = Assemblies::new(&assembled.model, &assembled.start.position, &first);
    for (done, inputs) in inputs.iter().enumerate() {
        if interrupted.load(Ordering::Relaxed) {
            return Err(Failure::Interrupted(format!(
                "{file}: interrupted after {done} of the drive's values"
            )));
        }
        on_listed(&listed(assembled, inputs, search.at(inputs)))?;
    }
    Ok(())
}

fn drive<L: Suspension<N>, const N: usize>(file: &str, wish: &Wish) -> Result<usize, Failure> {
    let names = <L::Drives as Named<f64>>::NAMES;
    let all = names.join(", ");
    match (&wish.drive, names) {
        (None, [_]) => Ok(0),
        (None, _) => Err(Failure::Input(format!(
            "{file}: --drive must say which: {all}"
        ))),
        (Some(wanted), _) => {
            let found = names.iter().position(|name| name == wanted);
            let unknown = || format!("{file}: unknown drive `{wanted}`; known are {all}");
            found.ok_or_else(|| Failure::Input(unknown()))
        }
    }
}

/// The inputs with another value of one drive, `offset` less in local coordinates.
fn with<L: Suspension<N>, const N: usize>(
    file: &str,
    inputs: &Inputs<Still, L::Drives>,
    drive: usize,
    value: f64,
    offset: f64,
) -> Result<Inputs<Still, L::Drives>, Failure> {
    let angle = L::Listing::default().drive_kind(drive) == DriveKind::Angle;
    if !value.is_finite() || angle && !(0.0..=PI).contains(&value) {
        let bound = if angle {
            "the angle of a link from an axis lies between 0 and pi"
        } else {
            "a drive has a finite value"
        };
        return Err(Failure::Input(format!("{file}: --at {value}: {bound}")));
    }
    Ok(Inputs::still(Signal {
        value: inputs.drives.value.with(drive, value - offset),
        ..Signal::default()
    }))
}

fn listed<L: Suspension<N>, const N: usize>(
    assembled: &Assembled<L, N>,
    inputs: &Inputs<Still, L::Drives>,
    census: Census<N>,
) -> Listed {
    let mut assemblies: Vec<_> = census
        .real
        .iter()
        .map(|q| assembly(assembled, inputs, q))
        .collect();
    assemblies.sort_by(|a, b| a.distance.total_cmp(&b.distance));
    let drives = assembled.given(&inputs.drives.value);
    Listed {
        drives: drives.values().collect(),
        drives_in_words: in_words::<L, N>(&drives, assembled.unit),
        assemblies,
        tally: census.tally,
    }
}

fn assembly<L: Suspension<N>, const N: usize>(
    assembled: &Assembled<L, N>,
    inputs: &Inputs<Still, L::Drives>,
    q: &SVector<f64, N>,
) -> Assembly {
    let model = &assembled.model;
    let moved = q - assembled.start.position;
    let shifts = moved.as_slice().chunks(3);
    let farthest = shifts
        .map(|shift| shift.iter().map(|x| x * x).sum::<f64>().sqrt())
        .fold(0.0, f64::max);
    let points = Motion::at_rest(*q).points(model, inputs).value;
    let fixed = model.drive_anchors(*model.fixed(), &model.coordinates(&inputs.drives).value);
    let factored = Lu::factor(&model.jacobian(q, &fixed));
    let sides = model.linked().zip(model.mirrored(q, &fixed));
    let mirrored = sides.filter(|(_, mirrored)| *mirrored > 0.5);
    let chassis = model.fixed().values().count();
    Assembly {
        distance: moved.norm(),
        farthest,
        smallest_pivot: factored.map_or(0.0, |lu| lu.smallest_pivot().1),
        mirrored: mirrored
            .map(|(point, _)| <L::Points as Named<nalgebra::Vector3<f64>>>::NAMES[point])
            .collect(),
        wheel: Wheel::of(points.wheel()).map(|wheel| Wheel {
            centre: wheel.centre + assembled.origin.position(),
            ..wheel
        }),
        coordinates: points
            .values()
            .skip(chassis)
            .map(|point| point + assembled.origin.position())
            .flat_map(|point| [point.x, point.y, point.z])
            .collect(),
    }
}
