//! A linkage, assembled and with its drives.

use std::sync::atomic::AtomicBool;

use nalgebra::{Const, DimMin};
use suspension_core::{Advanced, Kind, LocalOrigin, Motion, Stopped, Tracker, Values};
use toml::Spanned;

use crate::assemblies::{self, OnListed, Wish};
use crate::bake::order::{Order, Ordered};
use crate::bake::source::Sheet;
use crate::failure::Failure;
use crate::input::drives::{DriveLaws, given};
use crate::input::file::Unit;
use crate::input::instants::Instants;
use crate::range::course::DriveRange;
use crate::range::meeting::meeting;
use crate::range::station;
use crate::study::columns::{self, PointNames};
use crate::study::led::Lead;
use crate::study::timing::{self, Timing};
use crate::study::{End, MAX_STEPS, OnRow, Study, Suspension};

/// A linkage in the configuration of the first instant, with its drives over time.
#[derive(Clone, Debug)]
pub struct Assembled<L, const N: usize> {
    /// The linkage's name in motion files.
    pub linkage: &'static str,
    /// The unit of its lengths.
    pub unit: Unit,
    /// Where the file's coordinates have the origin of all below.
    pub origin: LocalOrigin<f64>,
    /// The geometry.
    pub model: L,
    /// The first instant, s.
    pub first: f64,
    /// The configuration there.
    pub start: Motion<f64, N>,
    /// The drives; one for which a measure leads stays as it is there.
    pub drives: DriveLaws,
    /// The measure that leads in place of a drive.
    pub lead: Option<Lead<N>>,
}

impl<L: Suspension<N>, const N: usize> Assembled<L, N> {
    /// The drives' values in the file's coordinates.
    pub(crate) fn given(&self, local: &L::Drives) -> L::Drives {
        given(&self.origin, &self.model, local)
    }

    /// What a drive has more in the file's coordinates.
    pub(crate) fn drive_offset(&self, drive: usize) -> f64 {
        let offsets = self.origin.of_drives(&self.model);
        offsets.values().nth(drive).unwrap_or_default()
    }
}

impl<L: Suspension<N>, const N: usize> Study for Assembled<L, N>
where
    Const<N>: DimMin<Const<N>, Output = Const<N>>,
{
    fn linkage(&self) -> &'static str {
        self.linkage
    }

    fn unit(&self) -> Unit {
        self.unit
    }

    fn columns(&self) -> Vec<String> {
        columns::names::<L, N>(self.unit)
    }

    fn measures(&self) -> Vec<String> {
        columns::measures::<L, N>(self.unit)
    }

    fn leader(&self) -> Option<&Spanned<String>> {
        self.lead.as_ref().map(|lead| &lead.stand_in.key)
    }

    fn points(&self) -> PointNames {
        PointNames::of::<L, N>()
    }

    fn sweep(&self, instants: &Instants, on_row: &mut OnRow<'_>) -> Result<End, Failure> {
        let mut moving = self.moving();
        let [mut last, _] = instants.ends();
        for t in instants.iter() {
            match self.follow([last, t], &mut moving) {
                Ok(advanced) => {
                    let inputs = self.inputs(t, &moving);
                    let row = columns::row(self, t, &inputs, &moving.motion(), &advanced);
                    if on_row(&row)?.is_break() {
                        return Ok(End::Cut);
                    }
                }
                Err(stopped) => {
                    return Ok(End::Stopped(self.stop(t, &stopped, &moving)));
                }
            }
            last = t;
        }
        Ok(End::Complete)
    }

    fn time_a_step(&self, ends: [f64; 2]) -> Option<Timing> {
        timing::time_a_step(self, ends)
    }

    fn bake(&self, file: &str, instants: &Instants, order: &Order) -> Result<Sheet, Failure> {
        let ordered = Ordered {
            file,
            assembled: self,
            instants,
            order,
        };
        ordered.sheet()
    }

    fn assemblies(
        &self,
        file: &str,
        wish: &Wish,
        interrupted: &AtomicBool,
        on_listed: &mut OnListed<'_>,
    ) -> Result<(), Failure> {
        assemblies::list(self, file, wish, interrupted, on_listed)
    }

    fn range_columns(&self) -> Vec<String> {
        station::names::<L, N>(self.unit)
    }

    fn ranges(
        &self,
        instants: &Instants,
        interrupted: &AtomicBool,
    ) -> Result<Vec<DriveRange>, Failure> {
        let [first, _] = instants.ends();
        let drives = 0..self.model.count(Kind::Drive);
        drives
            .map(|index| self.range(first, index, interrupted))
            .collect()
    }

    fn meeting(&self, drive: usize, ends: [f64; 2], instants: &Instants) -> Option<(f64, usize)> {
        let driven = self.lead.is_none();
        let ends = ends.map(|end| end - self.drive_offset(drive));
        driven.then(|| meeting::<L, N>(&self.drives, drive, ends, instants))?
    }
}

/// Follows the motion from one time to another, in as many steps as it takes.
///
/// # Errors
///
/// [`Stopped`] where the mechanism goes no further.
pub fn follow<L: Suspension<N>, const N: usize>(
    model: &L,
    drives: &DriveLaws,
    [from, to]: [f64; 2],
    motion: &mut Motion<f64, N>,
) -> Result<Advanced<f64>, Stopped<f64>> {
    let tracker = Tracker {
        max_steps: MAX_STEPS,
        ..Tracker::default()
    };
    tracker.advance(model, |t| drives.inputs(t), from, to, motion)
}
