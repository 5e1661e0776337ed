//! What went wrong, in C's form.

use suspension_core::{GeometryError, Real, SolveError, Stopped, Unproved};

use crate::describe::Names;
use crate::names::Text;
use crate::pointer::Out;
use crate::shared::Failure;
use crate::status::Status;

/// Why a call does not do what it is asked.
#[derive(Clone, Copy, Debug)]
pub enum Trouble<T> {
    /// An argument.
    Argument(Status),
    /// The geometry.
    Geometry(GeometryError),
    /// The equations.
    Solve(SolveError<T>),
    /// A step in sub-steps.
    Stopped(Stopped<T>),
    /// A certificate.
    Unproved(Unproved<T>),
}

macro_rules! from {
    ($($cause:ty => $variant:ident),*) => {
        $(impl<T> From<$cause> for Trouble<T> {
            fn from(cause: $cause) -> Self {
                Self::$variant(cause)
            }
        })*
    };
}

from!(Status => Argument, GeometryError => Geometry, SolveError<T> => Solve, Stopped<T> => Stopped,
    Unproved<T> => Unproved);

/// Does the work of a call, and tells what went wrong where C asks for it.
#[inline(always)]
pub fn respond<T: Real>(
    failure: Out<'_, Failure<T>>,
    names: &Names,
    work: impl FnOnce() -> Result<(), Trouble<T>>,
) -> Status {
    let failure = match failure.optional() {
        Ok(failure) => failure,
        Err(status) => return status,
    };
    match work() {
        Ok(()) => Status::Ok,
        Err(trouble) => {
            let told = tell(trouble, names);
            if let Some(failure) = failure {
                failure.write(told);
            }
            told.status
        }
    }
}

/// Does the work of a call that fails by its arguments alone.
#[inline(always)]
pub fn answer(work: impl FnOnce() -> Result<(), Status>) -> Status {
    match work() {
        Ok(()) => Status::Ok,
        Err(status) => status,
    }
}

#[cold]
#[inline(never)]
fn tell<T: Real>(trouble: Trouble<T>, names: &Names) -> Failure<T> {
    match trouble {
        Trouble::Argument(status) => Failure::of(status),
        Trouble::Geometry(error) => geometry(error, names),
        Trouble::Solve(error) => solve(error, names),
        Trouble::Stopped(Stopped { reached, refused }) => Failure {
            reached,
            ..refused.map_or(Failure::of(Status::StepsUsedUp), |(_, error)| {
                solve(error, names)
            })
        },
        Trouble::Unproved(Unproved::NoBounds { cause }) => solve(cause, names),
        Trouble::Unproved(Unproved::NearSingular { defect }) => {
            Failure::compared(Status::UnprovedNearSingular, Text::NONE, defect, T::one())
        }
        Trouble::Unproved(Unproved::TooFar { correction, bound }) => {
            Failure::compared(Status::UnprovedTooFar, Text::NONE, correction, bound)
        }
    }
}

fn geometry<T: Real>(error: GeometryError, names: &Names) -> Failure<T> {
    let status = match error {
        GeometryError::NotFinite { .. } => Status::PointNotFinite,
        GeometryError::BadLength { .. } => Status::BadLength,
        GeometryError::Collinear { .. } => Status::Collinear,
        GeometryError::Flat { .. } => Status::Flat,
        GeometryError::NotClosed { .. } => Status::NotClosed,
        GeometryError::NoLine { .. } => Status::NoLine,
    };
    Failure {
        culprit: names.of(error.part()),
        ..Failure::of(status)
    }
}

fn solve<T: Real>(error: SolveError<T>, names: &Names) -> Failure<T> {
    let zero = T::zero();
    let (status, value, bound) = match error {
        SolveError::NotFinite { .. } => (Status::NotFinite, zero, zero),
        SolveError::Overflow { .. } => (Status::Overflow, zero, zero),
        SolveError::CrossedSingularity { .. } => (Status::CrossedSingularity, zero, zero),
        SolveError::Singular {
            pivot, threshold, ..
        } => (Status::Singular, pivot, threshold),
        SolveError::Mirrored { .. } => (Status::Mirrored, zero, zero),
        SolveError::Diverging { step, bound, .. } => (Status::Diverging, step, bound),
        SolveError::TooFar { change, bound, .. } => (Status::TooFar, change, bound),
        SolveError::StepTooLong { step, bound, .. } => (Status::StepTooLong, step, bound),
        SolveError::TurningPoint { asked, extreme, .. } => (Status::TurningPoint, asked, extreme),
        SolveError::NotConverged {
            residual,
            tolerance,
            ..
        } => (Status::NotConverged, residual, tolerance),
    };
    Failure::compared(status, names.of(error.part()), value, bound)
}
