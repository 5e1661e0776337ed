//! What a mistyped option may have been meant to be, where clap has no answer: it takes letters in another order for
//! others, so that `--cvs` is not near `--csv`.

use std::ffi::OsString;

use clap::Command;
use clap::error::{ContextKind, ContextValue, ErrorKind};
use suspension_listing::did_you_mean::nearest;

/// The mistake in the arguments of `program`, with the option that was meant where one is near.
pub(crate) fn with_suggestion(
    mut mistake: clap::Error,
    program: &Command,
    arguments: &[OsString],
) -> clap::Error {
    let has_one = mistake.get(ContextKind::SuggestedArg).is_some();
    if mistake.kind() != ErrorKind::UnknownArgument || has_one {
        return mistake;
    }
    if let Some(ContextValue::String(wanted)) = mistake.get(ContextKind::InvalidArg)
        && let Some(meant) = meant(wanted, program, arguments)
    {
        mistake.remove(ContextKind::Suggested);
        mistake.insert(ContextKind::SuggestedArg, ContextValue::String(meant));
    }
    mistake
}

/// The nearest long option of the command that the arguments name.
fn meant(wanted: &str, program: &Command, arguments: &[OsString]) -> Option<String> {
    let wanted = wanted.strip_prefix("--")?;
    let named = arguments.get(1)?.to_str()?;
    let command = program.find_subcommand(named)?;
    let options = command.get_arguments().filter_map(clap::Arg::get_long);
    Some(format!("--{}", nearest(wanted, options)?))
}
