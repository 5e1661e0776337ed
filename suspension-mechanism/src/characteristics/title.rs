//! Titles of numbers for people.

use std::fmt;

use crate::quantities::{Column, Compiled};

/// What a number is called, and of which wheel.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Title {
    /// The wheel's name, where it has one.
    pub wheel: Option<String>,
    /// What it is of that wheel, the same of each.
    pub of_wheel: String,
}

impl Title {
    /// That of a column, with its axis.
    pub(super) fn of<N: Compiled>(column: &Column<N>) -> Self {
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
