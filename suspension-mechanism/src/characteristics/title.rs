//! Titles of numbers for people.

use std::fmt;

use crate::quantities::{Column, Compiled};

/// The name of a number, and the wheel to which it belongs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Title {
    /// The wheel's name, if it has one.
    pub wheel: Option<String>,
    /// The name of the number for this wheel, the same for each wheel.
    pub of_wheel: String,
}

impl Title {
    /// The title of a column, with its axis.
    pub(super) fn new<N: Compiled>(column: &Column<N>) -> Self {
        let axis = column
            .axis
            .map_or_else(String::new, |axis| format!(" {axis}"));
        let title = if column.quantity.name.is_empty() {
            &column.name
        } else {
            column.quantity.title
        };
        Self {
            wheel: column.wheel.clone(),
            of_wheel: format!("{title}{axis}"),
        }
    }
}

impl fmt::Display for Title {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.wheel {
            Some(wheel) => write!(f, "{wheel} {}", self.of_wheel),
            None => f.write_str(&self.of_wheel),
        }
    }
}
