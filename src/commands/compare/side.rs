//! One of the two suspensions.

use std::sync::atomic::AtomicBool;

use crate::characteristics::{Curves, Parameter, Span, curves, parameters, ways};
use crate::failure::Failure;
use crate::file::Source;
use crate::mechanism::{Mechanism, Suspension, Unit, Work};

/// What is compared of a suspension, with lengths in the unit of the first.
pub(super) struct Side {
    pub(super) file: String,
    pub(super) linkage: String,
    /// Its own unit.
    pub(super) own_unit: Unit,
    /// The unit of lengths here.
    pub(super) unit: Unit,
    pub(super) parameters: Vec<Parameter>,
    /// Over travel, and over steering where a drive steers.
    pub(super) curves: Vec<Curves>,
    /// What could not be solved.
    pub(super) missing: Vec<Failure>,
}

/// Reads a side off a mechanism.
pub(super) struct Sided<'a> {
    pub(super) source: &'a Source,
    pub(super) spans: [Option<Span>; 2],
    pub(super) unit: Unit,
    pub(super) interrupted: &'a AtomicBool,
}

impl Work for Sided<'_> {
    type Answer = Side;

    fn on<L: Suspension<N>, const N: usize>(
        self,
        mechanism: &Mechanism<L, N>,
    ) -> Result<Side, Failure> {
        let Self {
            unit, interrupted, ..
        } = self;
        let file = self.source.name();
        let ways = ways(mechanism, file, self.spans, unit, interrupted)?;
        let missing = ways.iter().filter_map(|along| along.visited.failure(file));
        Ok(Side {
            file: file.to_owned(),
            linkage: mechanism.linkage.clone(),
            own_unit: mechanism.unit,
            unit,
            missing: missing.collect(),
            parameters: parameters(mechanism, unit, interrupted),
            curves: ways
                .iter()
                .map(|along| curves(mechanism, along, unit))
                .collect(),
        })
    }
}
