//! One of the two suspensions.

use std::sync::atomic::AtomicBool;

use crate::characteristics::{Curves, Does, Parameter, Span, Way, curves, parameters, ways};
use crate::failure::Failure;
use crate::file::Source;
use crate::kinematics::Kinematics;
use crate::mechanism::Unit;

/// What is compared of a suspension, with lengths in the unit of the first.
pub(super) struct Side {
    pub(super) file: String,
    pub(super) linkage: String,
    /// From what to what its numbers were converted, where they were.
    pub(super) converted: Option<String>,
    /// The unit of lengths here.
    pub(super) unit: Unit,
    /// What the drives do with respect to which the parameters have derivatives.
    pub(super) ways: Vec<Way>,
    /// The drive of travel of each wheel that has a name, by its place in these.
    pub(super) travel_of: Vec<(String, usize)>,
    pub(super) parameters: Vec<Parameter>,
    /// Over travel, and over steering where a drive steers.
    pub(super) curves: Vec<Curves>,
    /// What could not be solved.
    pub(super) missing: Vec<Failure>,
}

impl Side {
    /// Of a file's mechanism, with lengths in `unit`, and what else of it is converted in words.
    pub(super) fn of(
        mechanism: &dyn Kinematics,
        (source, converted): (&Source, Option<String>),
        spans: [Option<Span>; 2],
        unit: Unit,
        interrupted: &AtomicBool,
    ) -> Result<Self, Failure> {
        let file = source.name();
        let along = ways(mechanism, file, spans, unit, interrupted)?;
        let missing = along.iter().filter_map(|along| along.visited.failure(file));
        let curves = along.iter().map(|along| curves(mechanism, along, unit));
        let (does, drives): (Vec<Way>, Vec<usize>) =
            Way::of_drives(&mechanism.names).into_iter().unzip();
        let travel_of = mechanism.names.wheels.iter().filter_map(|wheel| {
            let place = drives
                .iter()
                .position(|drive| Some(*drive) == wheel.travel)?;
            Some((wheel.name.clone(), place))
        });
        Ok(Self {
            file: file.to_owned(),
            linkage: mechanism.linkage.clone(),
            converted,
            unit,
            missing: missing.collect(),
            travel_of: travel_of.collect(),
            ways: does,
            parameters: parameters(mechanism, unit, interrupted),
            curves: curves.collect(),
        })
    }

    /// Whether a drive steers.
    pub(super) fn steers(&self) -> bool {
        self.ways.iter().any(|way| way.does == Does::Steer)
    }
}
