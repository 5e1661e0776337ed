//! One of the two suspensions.

use std::sync::atomic::AtomicBool;

use crate::characteristics::{Curves, Does, Parameter, Span, Title, Way, curves, parameters, ways};
use crate::failure::Failure;
use crate::file::Source;
use crate::kinematics::Kinematics;
use crate::mechanism::Unit;
use crate::quantities::CENTRE;

/// What is compared of a suspension, with lengths in the unit of the first.
pub(super) struct Side {
    pub(super) file: String,
    pub(super) linkage: String,
    /// From what to what its numbers were converted, where they were.
    pub(super) converted: Option<String>,
    /// The unit of lengths here.
    pub(super) unit: Unit,
    /// 1 where the z axis points upwards, -1 where it points downwards.
    up: f64,
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
            up: mechanism.axes.signs()[2],
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

    /// How far the wheel of a drive of travel rises per unit of the drive at the design position, with the unit; `None` of other
    /// drives.
    pub(super) fn rise(&self, way: usize) -> Option<(f64, &str)> {
        let mut travel_of = self.travel_of.iter();
        let (wheel, _) = travel_of.find(|(_, own)| *own == way)?;
        let is_height = |parameter: &&Parameter| {
            let Title {
                wheel: of,
                of_wheel,
            } = &parameter.title;
            std::ptr::eq(parameter.quantity, &CENTRE)
                && of_wheel.ends_with(" z")
                && of.as_deref().unwrap_or_default() == wheel
        };
        let rise = self.parameters.iter().find(is_height)?.per[way].as_ref()?;
        Some((self.up * rise.value, &rise.symbol))
    }
}
