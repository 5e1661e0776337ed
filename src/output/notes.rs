//! Notes on standard error.

use std::fmt::Display;

use crate::characteristics::{ModeStates, unmet_range};
use crate::failure::Failure;
use crate::file::tell;
use crate::kinematics::Kinematics;

/// Prints notes.
pub fn print_notes(notes: impl IntoIterator<Item = impl Display>) {
    for note in notes {
        tell(format_args!("note: {note}"));
    }
}

/// Prints notes on a file, with its name.
pub fn print_notes_on(file: &str, notes: impl IntoIterator<Item = impl Display>) {
    let notes = notes.into_iter();
    print_notes(notes.map(|note| format!("{file}: {note}")));
}

/// Prints the notes on the file of a mechanism, and returns the mechanism.
pub fn with_notes_printed<'a>(mechanism: Box<dyn Kinematics + 'a>) -> Box<dyn Kinematics + 'a> {
    print_notes(&mechanism.notes);
    mechanism
}

/// Returns the failure of [`unmet_range`], and prints its notes.
pub fn print_unmet_range(modes: &[ModeStates], file: &str) -> Option<Failure> {
    let (notes, failure) = unmet_range(modes, file);
    print_notes(notes);
    failure
}
