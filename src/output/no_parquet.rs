//! What stands in for Parquet in a program that is built without it.

use crate::failure::Failure;
use crate::output::heading::{Header, Heading};
use crate::output::target::Target;

/// Refuses Parquet.
///
/// # Errors
///
/// Always: [`Failure::Input`].
pub(super) fn available() -> Result<(), Failure> {
    Err(refusal())
}

fn refusal() -> Failure {
    let message = "this program is built without Parquet; build it with: cargo build --release --features parquet";
    Failure::Input(message.to_owned())
}

/// There is none.
pub(super) enum ParquetFile {}

impl ParquetFile {
    pub(super) fn create(_: &Target, _: &Header, _: &[Heading]) -> Result<Self, Failure> {
        Err(refusal())
    }

    pub(super) fn row(&mut self, _: &[f64]) -> Result<(), Failure> {
        match *self {}
    }

    pub(super) fn finish(self) -> Result<(), Failure> {
        match self {}
    }
}
