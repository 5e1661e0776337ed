//! Messages on standard error, separate from results.

use std::fmt::Display;
use std::io::{Write, stderr};

/// Writes a line to standard error. A failure to write it, on a full disk or to a closed pipe, is ignored, because results
/// and exit codes matter more.
pub fn tell(line: impl Display) {
    let _ = writeln!(stderr(), "{line}");
}
