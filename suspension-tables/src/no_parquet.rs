//! The replacement for Parquet in a program built without it.

use crate::heading::{Header, Heading};
use crate::target::Target;
use suspension_mechanism::failure::Failure;

/// Refuses to write Parquet.
///
/// # Errors
///
/// Always: [`Failure::Input`].
pub(crate) fn available() -> Result<(), Failure> {
    Err(refusal())
}

fn refusal() -> Failure {
    let message = "this program is built without Parquet; build it with: cargo build --release --features parquet";
    Failure::Input(message.to_owned())
}

/// Cannot be made.
pub(crate) enum ParquetFile {}

impl ParquetFile {
    pub(crate) fn create(_: &Target, _: &Header, _: &[Heading]) -> Result<Self, Failure> {
        Err(refusal())
    }

    pub(crate) fn row(&mut self, _: &[f64]) -> Result<(), Failure> {
        match *self {}
    }

    pub(crate) fn finish(self) -> Result<(), Failure> {
        match self {}
    }
}
