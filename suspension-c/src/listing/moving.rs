//! A moving suspension with a model of any size, for arrays of numbers.

use std::boxed::Box;

use suspension_core::error::{Explain, Facts};
use suspension_core::listing::Parts;
use suspension_core::nalgebra::{SVector, Vector3};
use suspension_core::solve::report::Report;
use suspension_core::{Corner, Motion, Signal, Values};
use suspension_runtime::{Model, Room, Size};

use super::loads::{self, Structure, Wanted};
use super::parsed::Counts;
use super::row::{Row, write};
use crate::shared::Masses;
use crate::status::Status;

/// The operations of C on a suspension. Rows have the counts of the listing; rows of drives, points and
/// measures with rates contain all values, then all rates, then all second rates.
pub(super) trait Moving: Send + Sync {
    /// Returns a copy.
    fn copied<'a>(&self) -> Box<dyn Moving + 'a>
    where
        Self: 'a;

    /// The count of numbers in a state.
    fn state_count(&self) -> usize;

    /// Reads the state: time, sign of the determinant or zero if it is unknown, drives, and unknowns.
    fn read_state(&self, state: Row<'_>);

    /// See [`Corner::resumed`].
    fn set_state(&mut self, state: &[f64]);

    /// See [`Corner::step`].
    fn step(&mut self, dt: f64, drives: &[f64]) -> Result<Report<f64>, Facts>;

    /// See [`Corner::step_towards`].
    fn step_towards(&mut self, dt: f64, drives: &[f64]) -> Result<Report<f64>, Facts>;

    fn read_drives(&self, drives: Row<'_>);

    fn time(&self) -> f64;

    fn read_points(&self, points: Row<'_>);

    fn read_measures(&self, measures: Row<'_>);

    /// See [`Corner::per`].
    fn read_per(&self, change: &[f64], points: Row<'_>, measures: Row<'_>) -> Result<(), Facts>;

    /// Computes the effects of forces at the points: see [`loads::read`].
    fn read_loads(
        &self,
        structure: &Structure,
        forces: &[f64],
        wanted: Wanted<'_>,
    ) -> Result<(), Facts>;

    /// Adds weight and inertia of masses, stated at the points `design`, to forces at the points.
    fn add_masses(
        &self,
        masses: &Masses<f64>,
        design: &[f64],
        forces: &mut [f64],
    ) -> Result<(), Status>;

    /// Returns the spin axis of a wheel by its number, with its time derivatives.
    fn wheel_axis(&self, wheel: usize) -> Option<Signal<[Vector3<f64>; 2]>>;

    /// The same with its derivatives for a change of the drives: see [`Corner::per`].
    fn wheel_axis_per(
        &self,
        wheel: usize,
        change: &[f64],
    ) -> Result<Option<Signal<[Vector3<f64>; 2]>>, Facts>;

    fn wheel_carrier(&self, wheel: usize) -> Option<Signal<[Vector3<f64>; 3]>>;

    fn kingpin(&self, wheel: usize) -> Option<[Vector3<f64>; 2]>;
}

/// A corner of a listing with its numbers of points, drives and measures.
pub(super) struct Counted<'l, const N: usize>
where
    Room<N>: Size,
{
    pub(super) corner: Corner<Model<'l, f64, N>, N>,
    pub(super) counts: Counts,
}

impl<const N: usize> Counted<'_, N>
where
    Room<N>: Size,
{
    fn write_points<P: Values<Vector3<f64>>>(&self, points: &Signal<P>, row: Row<'_>) {
        let parts = [&points.value, &points.rate, &points.second_rate].into_iter();
        let each = parts.flat_map(|points| points.values().take(self.counts.points));
        write(each.flat_map(<[f64; 3]>::from), row);
    }

    fn write_measures<M: Values<f64>>(&self, measures: &Signal<M>, row: Row<'_>) {
        let parts = [&measures.value, &measures.rate, &measures.second_rate].into_iter();
        write(
            parts.flat_map(|measures| measures.values().take(self.counts.measures)),
            row,
        );
    }
}

impl<const N: usize> Moving for Counted<'_, N>
where
    Room<N>: Size,
{
    fn copied<'a>(&self) -> Box<dyn Moving + 'a>
    where
        Self: 'a,
    {
        Box::new(Self {
            corner: self.corner,
            counts: self.counts,
        })
    }

    fn state_count(&self) -> usize {
        2 + 3 * (self.counts.drives + N)
    }

    fn read_state(&self, state: Row<'_>) {
        let (motion, drives) = (self.corner.motion(), self.corner.drive_signal());
        let sign = match motion.positive_determinant {
            None => 0.0,
            Some(true) => 1.0,
            Some(false) => -1.0,
        };
        let drives = [&drives.value, &drives.rate, &drives.second_rate].into_iter();
        let drives = drives.flat_map(|part| part.values().take(self.counts.drives));
        let unknowns = [&motion.position, &motion.velocity, &motion.acceleration].into_iter();
        let unknowns = unknowns.flat_map(|part| part.iter().copied());
        write(
            [self.corner.time(), sign]
                .into_iter()
                .chain(drives)
                .chain(unknowns),
            state,
        );
    }

    fn set_state(&mut self, state: &[f64]) {
        let number = |place: usize| state.get(place).copied().unwrap_or_default();
        let drives = signal(state.get(2..).unwrap_or_default(), self.counts.drives);
        let first = 2 + 3 * self.counts.drives;
        let unknowns = |part| SVector::from_fn(|row, _| number(first + part * N + row));
        let motion = Motion {
            position: unknowns(0),
            velocity: unknowns(1),
            acceleration: unknowns(2),
            positive_determinant: (number(1) != 0.0).then_some(number(1) > 0.0),
        };
        self.corner = Corner::resumed(*self.corner.model(), motion, drives, number(0));
    }

    fn step(&mut self, dt: f64, drives: &[f64]) -> Result<Report<f64>, Facts> {
        let drives = signal(drives, self.counts.drives);
        let start = self.corner.time();
        let stepped = self.corner.step(dt, drives);
        stepped.map_err(|failure| from_start(start, failure.error.facts()))
    }

    fn step_towards(&mut self, dt: f64, drives: &[f64]) -> Result<Report<f64>, Facts> {
        let drives = signal(drives, self.counts.drives);
        let start = self.corner.time();
        let advanced = self.corner.step_towards(dt, drives);
        advanced.map_err(|failure| from_start(start, failure.error.facts()))
    }

    fn read_drives(&self, drives: Row<'_>) {
        write(self.corner.drives().values(), drives);
    }

    fn time(&self) -> f64 {
        self.corner.time()
    }

    fn read_points(&self, points: Row<'_>) {
        self.write_points(&self.corner.points(), points);
    }

    fn read_measures(&self, measures: Row<'_>) {
        self.write_measures(&self.corner.measures(), measures);
    }

    fn read_per(&self, change: &[f64], points: Row<'_>, measures: Row<'_>) -> Result<(), Facts> {
        let derived = self.corner.per(Values::from_values(change.iter().copied()));
        let derived = derived.map_err(|failure| failure.error.facts())?;
        self.write_points(&derived.points, points);
        self.write_measures(&derived.measures, measures);
        Ok(())
    }

    fn read_loads(
        &self,
        structure: &Structure,
        forces: &[f64],
        wanted: Wanted<'_>,
    ) -> Result<(), Facts> {
        loads::read(&self.corner, structure, forces, wanted)
    }

    fn add_masses(
        &self,
        masses: &Masses<f64>,
        design: &[f64],
        forces: &mut [f64],
    ) -> Result<(), Status> {
        loads::add_masses(&self.corner, masses, design, forces)
    }

    fn wheel_axis(&self, wheel: usize) -> Option<Signal<[Vector3<f64>; 2]>> {
        let places = self.corner.model().wheel(wheel)?.axis;
        Some(self.corner.points().map(|points| points.at(places)))
    }

    fn wheel_axis_per(
        &self,
        wheel: usize,
        change: &[f64],
    ) -> Result<Option<Signal<[Vector3<f64>; 2]>>, Facts> {
        let derived = self.corner.per(Values::from_values(change.iter().copied()));
        let points = derived.map_err(|failure| failure.error.facts())?.points;
        let wheel = self.corner.model().wheel(wheel);
        Ok(wheel.map(|wheel| points.map(|points| points.at(wheel.axis))))
    }

    fn wheel_carrier(&self, wheel: usize) -> Option<Signal<[Vector3<f64>; 3]>> {
        let places = self.corner.model().wheel(wheel)?.carrier;
        Some(self.corner.points().map(|points| points.at(places)))
    }

    fn kingpin(&self, wheel: usize) -> Option<[Vector3<f64>; 2]> {
        let places = self.corner.model().wheel(wheel)?.kingpin?;
        Some(self.corner.points().value.at(places))
    }
}

/// Converts a row to the signal of the drives.
fn signal<D: Values<f64>>(row: &[f64], count: usize) -> Signal<D> {
    let part = |place| D::from_values(row.iter().copied().skip(place * count).take(count));
    Signal {
        value: part(0),
        rate: part(1),
        second_rate: part(2),
    }
}

/// The facts of a step that began at a time on the clock, with the time that it has reached from its start.
fn from_start(start: f64, facts: Facts) -> Facts {
    let reached = facts.reached.map(|reached| reached - start);
    Facts { reached, ..facts }
}
