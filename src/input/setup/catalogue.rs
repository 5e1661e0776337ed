//! The linkages that motion files know, and how such a file is loaded.

use nalgebra::{Const, DimMin};
use suspension_core::linkages::{attia2003, five_link};

use super::{Task, prepare};
use crate::failure::Failure;
use crate::input::check;
use crate::input::file::MotionFile;
use crate::input::instants::Instants;
use crate::input::source::Source;
use crate::study::{Study, Suspension};

type Prepare = fn(&Task<'_>) -> Result<Box<dyn Study>, Failure>;

/// The catalogue: each linkage under the name that files use.
const CATALOGUE: [(&str, Prepare); 2] = [
    ("attia2003", prepare::<attia2003::Model<f64>, 15>),
    ("five_link", prepare::<five_link::Model<f64>, 15>),
];

/// Reads a motion file and brings its mechanism to the first instant.
///
/// # Errors
///
/// [`Failure::Input`] with a place where the file is wrong, [`Failure::Solver`] where the
/// mechanism does not assemble or does not reach the first instant.
pub fn load(source: &Source) -> Result<(Box<dyn Study>, Instants), Failure> {
    load_one_of(&CATALOGUE, source)
}

/// Reads a motion file for a linkage of one's own, under the name that the file must give; see
/// [`load`]. The listing states a `wheel` and a `kingpin`; the file all points and drives, as
/// `suspension motion --help` explains. Such a program depends on `suspension` and `suspension-core`.
///
/// ```no_run
/// use std::ops::ControlFlow;
/// use std::path::Path;
///
/// use suspension::input::{setup::load_own, source::Source};
///
/// suspension_core::linkage! {
///     mod double_wishbone {
///         fixed: lower_front, lower_rear, upper_front, upper_rear, rack;
///         free: lower_ball, upper_ball, tie_ball, axle_inner, axle_outer;
///         link lower_fore: lower_front -> lower_ball;
///         link lower_aft: lower_rear -> lower_ball;
///         link upper_fore: upper_front -> upper_ball;
///         link upper_aft: upper_rear -> upper_ball;
///         link tie_rod: rack -> tie_ball;
///         body upright: lower_ball, upper_ball, tie_ball, axle_inner, axle_outer;
///         drive bump: axle_outer.z;
///         drive steer: rack.y;
///         wheel: axle_inner -> axle_outer;
///         kingpin: lower_ball -> upper_ball;
///     }
/// }
///
/// # fn main() -> Result<(), suspension::failure::Failure> {
/// let source = Source::read(Path::new("my.toml"))?; // linkage = "double_wishbone"
/// let (study, instants) =
///     load_own::<double_wishbone::Model<f64>, _>("double_wishbone", &source)?;
/// println!("{}", study.columns().join(","));
/// let end = study.sweep(&instants, &mut |row| {
///     println!("{row:?}");
///     Ok(ControlFlow::Continue(()))
/// })?;
/// println!("{end:?}"); // whether the motion went through
/// # Ok(())
/// # }
/// ```
///
/// # Errors
///
/// Those of [`load`].
pub fn load_own<L: Suspension<N>, const N: usize>(
    linkage: &'static str,
    source: &Source,
) -> Result<(Box<dyn Study>, Instants), Failure>
where
    Const<N>: DimMin<Const<N>, Output = Const<N>>,
{
    load_one_of(&[(linkage, prepare::<L, N>)], source)
}

fn load_one_of(
    known: &[(&'static str, Prepare)],
    source: &Source,
) -> Result<(Box<dyn Study>, Instants), Failure> {
    let file = MotionFile::parse(source)?;
    let wanted = file.linkage.get_ref();
    let Some((linkage, prepare)) = known.iter().find(|(name, _)| name == wanted) else {
        let names: Vec<_> = known.iter().map(|(name, _)| *name).collect();
        let message = format!("unknown linkage `{wanted}`; known are {}", names.join(", "));
        return Err(source.refuse(&file.linkage.span(), message));
    };
    let instants = check::instants(source, &file.time)?;
    let study = prepare(&Task {
        source,
        file: &file,
        linkage,
        first: instants.ends()[0],
    })?;
    Ok((study, instants))
}

/// Reads a motion file for a command that all drives must lead; see [`load`].
///
/// # Errors
///
/// Those of [`load`], and [`Failure::Input`] where a measure stands in for a drive.
pub fn load_driven(source: &Source, command: &str) -> Result<(Box<dyn Study>, Instants), Failure> {
    let (study, instants) = load(source)?;
    match study.leader() {
        None => Ok((study, instants)),
        Some(key) => {
            let message = format!(
                "`{}` is a measure; suspension {command} needs a motion that drives lead",
                key.get_ref()
            );
            Err(source.refuse(&key.span(), message))
        }
    }
}
