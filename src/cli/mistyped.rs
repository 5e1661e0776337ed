//! Suggestions for mistyped options. clap has none for exchanged letters: it counts them as different, so that `--cvs` is
//! not near `--csv` for it. Also the command to use with a file that is given without one.

use std::ffi::OsString;
use std::path::Path;

use clap::Command;
use clap::error::{ContextKind, ContextValue, ErrorKind};
use suspension_listing::did_you_mean::nearest;

/// Returns the mistake in the arguments of `program`, with the nearest option, or the command to use with a file.
pub(crate) fn with_suggestion(
    mut mistake: clap::Error,
    program: &Command,
    arguments: &[OsString],
) -> clap::Error {
    if let Some(ContextValue::String(command)) = mistake.get(ContextKind::InvalidSubcommand)
        && let Some(advice) = advice_for_file(command)
    {
        mistake.remove(ContextKind::SuggestedSubcommand);
        let advice = ContextValue::StyledStrs(vec![advice.into()]);
        mistake.insert(ContextKind::Suggested, advice);
        return mistake;
    }
    let has_one = mistake.get(ContextKind::SuggestedArg).is_some();
    if mistake.kind() != ErrorKind::UnknownArgument || has_one {
        return mistake;
    }
    if let Some(ContextValue::String(wanted)) = mistake.get(ContextKind::InvalidArg)
        && let Some(meant) = nearest_option(wanted, program, arguments)
    {
        mistake.remove(ContextKind::Suggested);
        mistake.insert(ContextKind::SuggestedArg, ContextValue::String(meant));
    }
    mistake
}

/// Returns the advice for a file in place of a command.
fn advice_for_file(name: &str) -> Option<String> {
    match Path::new(name).extension()?.to_str()? {
        "toml" => Some(format!(
            "for the motion of a file write suspension motion {name}"
        )),
        "csv" | "sub" | "shk" => Some(format!(
            "for a motion file of hardpoints write suspension import {name}"
        )),
        "linkage" => Some(format!(
            "a motion file names a listing: listing = \"{name}\""
        )),
        _ => None,
    }
}

/// Returns the nearest long option of the command that the arguments name.
fn nearest_option(wanted: &str, program: &Command, arguments: &[OsString]) -> Option<String> {
    let wanted = wanted.strip_prefix("--")?;
    let named = arguments.get(1)?.to_str()?;
    let command = program.find_subcommand(named)?;
    let options = command.get_arguments().filter_map(clap::Arg::get_long);
    Some(format!("--{}", nearest(wanted, options)?))
}
