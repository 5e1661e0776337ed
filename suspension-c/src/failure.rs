//! Conversion of failures to C.

use suspension_core::Real;
use suspension_core::error::{Explain, Facts};

use crate::names::{Naming, Text};
use crate::pointer::Out;
use crate::shared::Failure;
use crate::status::Status;

/// The reason for which a call fails.
#[derive(Clone, Copy, Debug)]
pub enum Trouble {
    /// A wrong argument.
    Argument(Status),
    /// The geometry, the equations or a proof.
    Solver(Facts),
}

impl From<Status> for Trouble {
    fn from(status: Status) -> Self {
        Self::Argument(status)
    }
}

impl<E: Explain> From<E> for Trouble {
    fn from(error: E) -> Self {
        Self::Solver(error.facts())
    }
}

/// Runs the work of a call and writes its failure if C asks for it.
#[inline(always)]
pub fn respond<T: Real>(
    failure: Out<'_, Failure<T>>,
    names: &impl Naming,
    work: impl FnOnce() -> Result<(), Trouble>,
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

/// Runs the work of a call that can only fail because of its arguments.
#[inline(always)]
pub fn answer(work: impl FnOnce() -> Result<(), Status>) -> Status {
    match work() {
        Ok(()) => Status::Ok,
        Err(status) => status,
    }
}

#[cold]
#[inline(never)]
fn tell<T: Real>(trouble: Trouble, names: &impl Naming) -> Failure<T> {
    let facts = match trouble {
        Trouble::Argument(status) => return Failure::of(status),
        Trouble::Solver(facts) => facts,
    };
    let [value, bound] = facts
        .compared
        .map_or([0.0; 2], |compared| [compared.value, compared.bound])
        .map(T::constant);
    Failure {
        status: facts.cause.into(),
        culprit: facts.part.map_or(Text::NONE, |part| names.name(part)),
        value,
        bound,
        reached: T::constant(facts.reached.unwrap_or_default()),
    }
}
