//! The text of a motion file, from which the mechanism has been built before the file is written.

use std::path::Path;
use std::sync::atomic::AtomicBool;

use super::draft::Draft;
use crate::failure::Failure;
use crate::file::{Source, tell};
use crate::output::notes::{print_notes, print_notes_on};
use crate::prepare::load;

/// Returns the text of the motion file at the path `out`.
pub(super) fn checked_text(draft: &Draft<'_>, out: &Path) -> Result<String, Failure> {
    print_notes_on(draft.source, &draft.remarks);
    let file = |text: &str| Source::new(out.display().to_string(), text.to_owned());
    // The drives' values at the design position come from the mechanism, so it is built first.
    let unmoved = file(&draft.text(&vec![0.0; draft.drives()]));
    let moved = load(&unmoved).and_then(|loaded| {
        let text = draft.text(&loaded.at_design()?.design);
        Ok((loaded, text))
    });
    let (loaded, text) = moved.map_err(|failure| with_line(failure, &unmoved))?;
    let written = file(&text);
    let loaded = loaded.with_drives_of(&written)?;
    let notes = &loaded.at_design()?.notes;
    print_notes(notes.iter().map(|note| draft.with_origins(note)));
    if let Some(why) = loaded.own_motion_ends(&AtomicBool::new(false))? {
        tell(format_args!(
            "note: {why}; state a shorter motion under [drives]"
        ));
    }
    Ok(text)
}

/// Quotes the line that a message names, because no file has it.
fn with_line(failure: Failure, unwritten: &Source) -> Failure {
    let Failure::Input(message) = failure else {
        return failure;
    };
    let name = unwritten.name();
    let place = message.strip_prefix(&format!("{name}:"));
    let number = place.and_then(|place| place.split(':').next()?.parse::<usize>().ok());
    let line = number.and_then(|number| Some((number, unwritten.text().lines().nth(number - 1)?)));
    Failure::Input(match line {
        Some((number, line)) => {
            format!("{message}\n{name} is not written; its line {number} would be: {line}")
        }
        None => message,
    })
}
