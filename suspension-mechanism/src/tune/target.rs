//! A target of tuning.

use std::sync::atomic::AtomicBool;

use crate::failure::Failure;
use crate::kinematics::Kinematics;
use crate::mechanism::{
    CountedFrom, DerivativeOrder, Description, Drive, Grid, GridAxis, Place, Visited,
};
use crate::quantities::{Column, Reader};

/// A quantity, the places where it is read, and the values wanted there.
pub struct Target {
    /// Its name.
    pub name: String,
    /// The number that is read.
    pub reading: Reading,
    /// The drives that are moved, by distances from the design position; none to read it there.
    pub over: Vec<GridAxis>,
    /// The wanted values, in the file's lengths and in radians.
    pub wanted: Wanted,
    /// The largest permitted deviation.
    pub within: f64,
}

/// The number that is read at a place.
pub struct Reading {
    /// The quantity.
    pub column: Column,
    /// The drive, if the derivative with respect to it is meant.
    pub per: Option<usize>,
}

/// The wanted numbers: one for all places, or one for each in the order of the grid.
#[derive(Clone, Debug, PartialEq)]
pub enum Wanted {
    /// Values.
    Values(Vec<f64>),
    /// Differences from the value at the design position.
    Changes(Vec<f64>),
}

/// The deviation of a target at each of its places.
pub type Deviations = Vec<f64>;

impl Reading {
    /// Its name: `toe`, `toe per bump`.
    pub fn title(&self, mechanism: &Description) -> String {
        self.column.title_per(self.drive(mechanism))
    }

    /// The factor from a number to its value in the file.
    pub fn file_factor(&self, mechanism: &Description) -> f64 {
        let drive = self.drive(mechanism);
        self.column.file_factor_per(drive, mechanism.unit)
    }

    /// The factor to the value for people, and the symbol of its unit.
    pub fn display_scale(&self, mechanism: &Description) -> (f64, String) {
        let drive = self.drive(mechanism);
        self.column.display_scale_per(drive, mechanism.unit)
    }

    fn drive<'a>(&self, mechanism: &'a Description) -> Option<&'a Drive> {
        mechanism.names.drives.get(self.per?)
    }

    /// The number at a place; NaN if there is none.
    fn at(&self, place: &dyn Place) -> f64 {
        match self.per {
            None => self.column.read(&Reader::new(&place.state())).value,
            Some(drive) => place.per(drive).map_or(f64::NAN, |state| {
                self.column.read(&Reader::new(&state)).rate
            }),
        }
    }
}

impl Target {
    /// Whether it is met.
    pub fn is_met_by(&self, off: &Deviations) -> bool {
        off.iter().all(|off| off.abs() <= self.within)
    }

    /// The deviation at each place; `None` if the mechanism does not reach all of them, or if there is no such
    /// number.
    pub(super) fn deviations(&self, mechanism: &dyn Kinematics) -> Option<Deviations> {
        let values = self
            .visited(mechanism, self.over.clone())?
            .places
            .into_iter();
        let values = values.collect::<Option<Vec<f64>>>()?;
        let (from, wanted) = match &self.wanted {
            Wanted::Values(wanted) => (0.0, wanted),
            Wanted::Changes(wanted) => {
                let design = self.visited(mechanism, Vec::new())?.places;
                ((*design.first()?)?, wanted)
            }
        };
        let off = values.iter().zip(wanted.iter().cycle());
        let off: Vec<f64> = off.map(|(value, wanted)| value - from - wanted).collect();
        off.iter().all(|off| off.is_finite()).then_some(off)
    }

    /// As [`deviations`](Self::deviations), for a mechanism that must reach all places.
    ///
    /// # Errors
    ///
    /// [`Failure::Solver`] with the cause of the lock, or if there is no such number.
    pub(super) fn check(
        &self,
        source: &str,
        mechanism: &dyn Kinematics,
    ) -> Result<Deviations, Failure> {
        self.deviations(mechanism).ok_or_else(|| {
            let visited = self.visited(mechanism, self.over.clone());
            let out_of_reach = visited
                .as_ref()
                .and_then(|visited| visited.out_of_reach(source));
            let why =
                out_of_reach.unwrap_or_else(|| self.describe_missing_value(mechanism, visited));
            Failure::Solver(format!("{source}: target `{}`: {why}", self.name))
        })
    }

    /// The sentence about the first of the places where there is no such number, or about the design position, which changes count from.
    fn describe_missing_value(
        &self,
        mechanism: &dyn Kinematics,
        visited: Option<Visited<f64>>,
    ) -> String {
        let places = visited.map_or_else(Vec::new, |visited| visited.places);
        let without = places
            .iter()
            .position(|place| place.is_none_or(|value| !value.is_finite()));
        let grid = Grid::new(mechanism, self.over.clone(), CountedFrom::Start).ok();
        let place = match without.zip(grid) {
            Some((place, grid)) => {
                let drives = mechanism.drives_in_file(grid.drives_at(place));
                let drives = mechanism
                    .names
                    .drives_in_words(&drives, mechanism.unit, None);
                format!("at {drives}")
            }
            None => "at the design position, which `change` counts from".to_owned(),
        };
        let quantity = self.reading.title(mechanism);
        format!("`{quantity}` has no value {place}; suspension motion --help says where it has one")
    }

    fn visited(&self, mechanism: &dyn Kinematics, over: Vec<GridAxis>) -> Option<Visited<f64>> {
        let never = AtomicBool::new(false);
        let grid = Grid::new(mechanism, over, CountedFrom::Start).ok()?;
        let mut read = |place: &dyn Place| self.reading.at(place);
        Some(mechanism.visit(&grid, DerivativeOrder::First, &never, &mut read))
    }
}
