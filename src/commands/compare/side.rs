//! One of the two suspensions.

use std::sync::atomic::AtomicBool;

use crate::characteristics::{Curves, Parameter, Span, Way, curves, parameters, ways};
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
    /// The names of the drives by which the parameters have derivatives.
    pub(super) ways: Vec<String>,
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
        Ok(Self {
            file: file.to_owned(),
            linkage: mechanism.linkage.clone(),
            converted,
            unit,
            missing: missing.collect(),
            ways: Way::all(&mechanism.names)
                .into_iter()
                .map(|way| way.name)
                .collect(),
            parameters: parameters(mechanism, unit, interrupted),
            curves: curves.collect(),
        })
    }
}
