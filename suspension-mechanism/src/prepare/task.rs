//! A file that is being prepared, and what is to be made of it.

use std::ops::Range;

use nalgebra::Vector3;
use suspension_core::GeometryError;
use suspension_core::listing::{Part, Parts};
use suspension_core::model::local::LocalOrigin;
use suspension_runtime::{Listing, Statement};
use toml::Spanned;

use crate::failure::Failure;
use crate::file::{Dimension, MotionFile, Source, Table};
use crate::mechanism::{DrivenLength, Instants, Names};
use crate::number::{number, rounded};
use crate::prepare::design::unsatisfied::Unsatisfied;

/// The mechanism to be prepared.
#[derive(Clone, Copy)]
pub(super) struct Request<'a> {
    pub(super) source: &'a Source,
    pub(super) file: &'a MotionFile,
    /// Its listing, if that was read at run time.
    pub(super) listing: Option<&'a Listing>,
    pub(super) instants: &'a Instants,
    pub(super) to: Start,
}

/// The place of a mechanism when work on it starts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Start {
    /// The first instant of its motion.
    FirstInstant,
    /// The first instant or, if that is out of reach, the design position, with a note.
    WithinReach,
    /// The design position, held by drives and not by a measure.
    Design,
}

/// A file whose mechanism is being prepared.
pub(super) struct Task<'a> {
    pub(super) source: &'a Source,
    /// The file as it was read: in its own coordinates and units.
    pub(super) file: &'a MotionFile,
    /// Its listing, if that was read at run time.
    pub(super) listing: Option<&'a Listing>,
    /// The first instant, s.
    pub(super) first: f64,
    /// The last instant, s.
    pub(super) last: f64,
    pub(super) names: Names,
    /// The origin of the local coordinates, in which the mechanism is computed.
    pub(super) origin: LocalOrigin<f64>,
}

impl<'a> Task<'a> {
    /// A file with the names of all parts.
    pub(super) fn new(request: &Request<'a>, names: Names, origin: LocalOrigin<f64>) -> Self {
        let [first, last] = request.instants.ends();
        Self {
            source: request.source,
            file: request.file,
            listing: request.listing,
            first,
            last,
            names,
            origin,
        }
    }

    /// Points out, in the file, the cause why a linkage cannot be built.
    pub(super) fn refuse_geometry(&self, error: &GeometryError) -> Failure {
        let Self {
            source,
            file,
            names,
            ..
        } = self;
        let points = file.points.get_ref();
        let lengths = file.lengths.as_ref();
        let name = names.name(error.part());
        let span = match error {
            GeometryError::NotFinite { .. }
            | GeometryError::Collinear { .. }
            | GeometryError::Flat { .. }
            | GeometryError::NoLine { .. } => points.get(name).map(Spanned::span),
            GeometryError::BadLength { .. } => lengths
                .and_then(|lengths| lengths.get_ref().get(name))
                .map(Spanned::span),
            GeometryError::NotClosed { .. } => lengths.map(Spanned::span),
            GeometryError::SmallPivot { .. } | GeometryError::Singular { .. } => None,
        };
        source.refuse(
            &span.unwrap_or_else(|| file.points.span()),
            error.named(names),
        )
    }

    /// A description of an equation that points do not satisfy, with the error.
    pub(super) fn unsatisfied_in_words(&self, Unsatisfied { equation, by }: Unsatisfied) -> String {
        const DIGITS: usize = 3;
        let (by, unit) = (rounded(by, DIGITS), self.file.unit().symbol());
        let name = self.names.name(Part::Equation(equation));
        let statement = self.statement_of(equation);
        let of = statement.map(|statement| format!(" of {} `{}`", statement.kind, statement.name));
        format!(
            "equation `{name}`{}, by {by} {unit}",
            of.unwrap_or_default()
        )
    }

    /// The place of the first point of the statement that has an equation.
    pub(super) fn place_of_equation(&self, equation: usize) -> Range<usize> {
        let stated = self.file.points.get_ref();
        let points = self
            .statement_of(equation)
            .map(|statement| statement.points);
        let mut points = points.into_iter().flatten();
        let point = points.find_map(|point| stated.get(self.names.points[point].as_str()));
        point.map_or_else(|| self.file.points.span(), Spanned::span)
    }

    fn statement_of(&self, equation: usize) -> Option<Statement<'a>> {
        let mut statements = self.listing?.statements().into_iter();
        statements.find(|statement| {
            statement
                .equations
                .iter()
                .any(|rows| rows.contains(&equation))
        })
    }

    /// Notes with the name of the file before them.
    pub(super) fn of_file(
        &self,
        notes: impl IntoIterator<Item = String>,
    ) -> impl Iterator<Item = String> {
        let name = self.source.name();
        notes.into_iter().map(move |note| format!("{name}: {note}"))
    }

    /// The y of a local point in the file, where the middle of the vehicle is at zero.
    pub(super) fn y_in_file(&self, point: &Vector3<f64>) -> f64 {
        point.y + self.origin.position().y
    }

    /// A number of the file, in radians if it is an angle.
    pub(super) fn in_radians(&self, stated: f64, dimension: impl Into<Dimension>) -> f64 {
        stated / self.file.unit().file_factor(dimension)
    }

    /// Checks that driving angles are in their ranges. `table` has the drives' places.
    pub(super) fn check_angles<V>(
        &self,
        values: impl Iterator<Item = f64>,
        table: &Table<V>,
    ) -> Result<(), Failure> {
        for (drive, value) in self.names.drives.iter().zip(values) {
            let (name, angle) = (&drive.name, self.file.angle);
            if let Some(bounds) = angle.bounds_exceeded(drive.kind, value) {
                let place = table.get_ref().get(name.as_str()).map(Spanned::span);
                let message = format!(
                    "drive `{name}` begins at {} {}; {bounds}",
                    number(value * angle.radian()),
                    angle.symbol(),
                );
                return Err(self
                    .source
                    .refuse(&place.unwrap_or_else(|| table.span()), message));
            }
        }
        Ok(())
    }

    /// Checks that no driven length is less than zero.
    pub(super) fn check_lengths<V>(
        &self,
        values: impl Iterator<Item = f64>,
        table: &Table<V>,
    ) -> Result<(), Failure> {
        for ((drive, value), named) in values.enumerate().zip(&self.names.drives) {
            let fault = DrivenLength::below_zero(&self.names.driven_lengths, drive, value);
            if let Some(fault) = fault {
                let place = table.get_ref().get(named.name.as_str()).map(Spanned::span);
                let place = place.unwrap_or_else(|| table.span());
                return Err(self.source.refuse(&place, fault));
            }
        }
        Ok(())
    }
}
