//! Messages on standard error, separate from results.

use std::fmt::Display;
use std::io::{Write, stderr};

/// Writes a line to standard error. Where it cannot be written, on a full disk or to a reader that has gone, it is lost: results
/// and exit codes are worth more.
pub fn tell(line: impl Display) {
    let _ = writeln!(stderr(), "{line}");
}
