//! Parts that bear no load.

use crate::commands::loads::case_results::{CaseResults, Extreme};
use crate::commands::loads::report_lines::Line;

/// The names of links and joints without load at any place, whose rows would be zeros.
pub(super) struct Unloaded {
    names: Vec<String>,
    /// Forces up to this one are rounding.
    rounding: f64,
}

impl Unloaded {
    pub(super) fn new(found: &CaseResults<'_>) -> Self {
        /// A part of the largest of all forces.
        const ROUNDING: f64 = 1e-9;
        let sizes = found.ranges.iter().map(Extreme::largest);
        Self {
            names: Vec::new(),
            rounding: ROUNDING * sizes.fold(0.0, f64::max),
        }
    }

    /// Returns the lines that bear a load and keeps the names of the others.
    pub(super) fn remove_from(&mut self, lines: Vec<Line>) -> Vec<Line> {
        let (loaded, others): (Vec<Line>, Vec<Line>) =
            lines.into_iter().partition(|line| self.is_loaded(line));
        self.names.extend(others.into_iter().map(|line| line.name));
        loaded
    }

    pub(super) fn is_loaded(&self, line: &Line) -> bool {
        line.largest > self.rounding
    }

    pub(super) fn in_words(&self) -> String {
        match self.names.as_slice() {
            [] => String::new(),
            names => format!("no load in: {}\n\n", names.join(", ")),
        }
    }
}
