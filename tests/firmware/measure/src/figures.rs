//! The costs of a mode on a target.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

/// The budgeted figures of a mode.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Eq, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Figures {
    /// The most instructions of a step.
    pub instructions: u64,
    /// The deepest stack of a call, bytes, whatever way the call takes.
    pub stack: u64,
    /// Code and constants that a call reaches, bytes.
    pub size: u64,
}

impl Figures {
    /// The figures with their names.
    pub(crate) fn named(&self) -> [(&'static str, u64); 3] {
        [
            ("instructions", self.instructions),
            ("bytes of stack", self.stack),
            ("bytes of code and constants", self.size),
        ]
    }
}

/// The measurements of a mode.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Measured {
    /// The figures to compare with the budget.
    pub figures: Figures,
    /// The fewest instructions of a step.
    pub least: u64,
    /// The deepest stack that the motion has used, bytes.
    pub used_stack: u64,
    /// Whether the states equal those of the host to the last bit.
    pub is_hosts: bool,
    /// The largest residual, m.
    pub residual: f64,
}

/// Figures by target and mode.
pub(crate) type Table<T> = BTreeMap<String, BTreeMap<String, T>>;
