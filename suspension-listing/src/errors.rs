//! Every message of the macro: the fact, and what to write instead.

mod names;
mod syntax;
mod system;

use std::fmt::Display;

use syn::{Error, Ident};

pub use names::*;
pub use syntax::*;
pub use system::*;

/// Errors gathered so that all of them are reported at once.
#[derive(Default)]
pub struct Errors(Option<Error>);

impl Errors {
    pub fn push(&mut self, error: Error) {
        match &mut self.0 {
            Some(first) => first.combine(error),
            None => self.0 = Some(error),
        }
    }

    pub fn append(&mut self, others: Self) {
        if let Some(error) = others.0 {
            self.push(error);
        }
    }

    pub fn is_empty(&self) -> bool {
        self.0.is_none()
    }

    pub fn into_result(self) -> Result<(), Error> {
        self.0.map_or(Ok(()), Err)
    }
}

fn at(ident: &Ident, message: impl Display) -> Error {
    Error::new(ident.span(), message)
}
