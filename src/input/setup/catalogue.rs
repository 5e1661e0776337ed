//! The linkages that motion files know, and how such a file is loaded.

use nalgebra::{Const, DimMin};
use suspension_core::linkages::{attia2003, five_link};
use toml::Spanned;

use super::{Task, prepare};
use crate::failure::Failure;
use crate::input::check;
use crate::input::file::MotionFile;
use crate::input::instants::Instants;
use crate::input::source::Source;
use crate::study::{Study, Suspension, Work};

type Prepare = fn(&Task<'_>) -> Result<Box<dyn Study>, Failure>;

fn boxed<L: Suspension<N>, const N: usize>(task: &Task<'_>) -> Result<Box<dyn Study>, Failure>
where
    Const<N>: DimMin<Const<N>, Output = Const<N>>,
{
    Ok(Box::new(prepare::<L, N>(task)?))
}

/// The catalogue: each linkage under the name that files use.
const CATALOGUE: [(&str, Prepare); 2] = [
    ("attia2003", boxed::<attia2003::Model<f64>, 15>),
    ("five_link", boxed::<five_link::Model<f64>, 15>),
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
    load_one_of(&[(linkage, boxed::<L, N>)], source)
}

fn load_one_of(
    known: &[(&'static str, Prepare)],
    source: &Source,
) -> Result<(Box<dyn Study>, Instants), Failure> {
    let file = MotionFile::parse(source)?;
    let wanted = file.linkage.get_ref();
    let Some((linkage, prepare)) = known.iter().find(|(name, _)| name == wanted) else {
        let names = known.iter().map(|(name, _)| *name);
        return Err(unknown(source, &file, names));
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

fn unknown<'a>(
    source: &Source,
    file: &MotionFile,
    known: impl Iterator<Item = &'a str>,
) -> Failure {
    let wanted = file.linkage.get_ref();
    let known: Vec<_> = known.collect();
    let message = format!("unknown linkage `{wanted}`; known are {}", known.join(", "));
    source.refuse(&file.linkage.span(), message)
}

/// A motion file that was read, its mechanism still to be built.
#[derive(Clone, Debug)]
pub struct Loaded<'a> {
    source: &'a Source,
    file: MotionFile,
    instants: Instants,
}

impl<'a> Loaded<'a> {
    /// Reads a motion file of the catalogue.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] with a place where the file is wrong.
    pub fn read(source: &'a Source) -> Result<Self, Failure> {
        let file = MotionFile::parse(source)?;
        if CATALOGUE
            .iter()
            .all(|(name, _)| name != file.linkage.get_ref())
        {
            return Err(unknown(
                source,
                &file,
                CATALOGUE.iter().map(|(name, _)| *name),
            ));
        }
        let instants = check::instants(source, &file.time)?;
        Ok(Self {
            source,
            file,
            instants,
        })
    }

    /// The linkage's name.
    pub fn linkage(&self) -> &str {
        self.file.linkage.get_ref()
    }

    /// The instants.
    pub fn instants(&self) -> &Instants {
        &self.instants
    }

    /// Brings the mechanism to the first instant and does the work of a command, whose motion
    /// drives must lead.
    ///
    /// # Errors
    ///
    /// Those of [`load_driven`] and of the work.
    pub fn run_driven<W: Work>(&self, command: &str, work: W) -> Result<W::Answer, Failure> {
        let [(attia2003, _), (five_link, _)] = CATALOGUE;
        match self.linkage() {
            name if name == attia2003 => {
                self.run::<attia2003::Model<f64>, 15, W>(attia2003, command, work)
            }
            _ => self.run::<five_link::Model<f64>, 15, W>(five_link, command, work),
        }
    }

    fn run<L: Suspension<N>, const N: usize, W: Work>(
        &self,
        linkage: &'static str,
        command: &str,
        work: W,
    ) -> Result<W::Answer, Failure> {
        let mechanism = prepare::<L, N>(&Task {
            source: self.source,
            file: &self.file,
            linkage,
            first: self.instants.ends()[0],
        })?;
        driven(
            self.source,
            mechanism.lead.as_ref().map(|lead| &lead.stand_in.key),
            command,
        )?;
        work.on(&mechanism)
    }
}

/// Reads a motion file for a command that all drives must lead; see [`load`].
///
/// # Errors
///
/// Those of [`load`], and [`Failure::Input`] where a measure stands in for a drive.
pub fn load_driven(source: &Source, command: &str) -> Result<(Box<dyn Study>, Instants), Failure> {
    let (study, instants) = load(source)?;
    driven(source, study.leader(), command)?;
    Ok((study, instants))
}

fn driven(source: &Source, leader: Option<&Spanned<String>>, command: &str) -> Result<(), Failure> {
    leader.map_or(Ok(()), |key| {
        let message = format!(
            "`{}` is a measure; {command} needs a motion that drives lead",
            key.get_ref()
        );
        Err(source.refuse(&key.span(), message))
    })
}
