//! The pipeline: parse, check and lower, order, emit.

use std::sync::{Mutex, PoisonError};

use proc_macro2::TokenStream;
use quote::quote;
use syn::{Error, LitStr};

use suspension_listing::include::IncludeSource;
use suspension_listing::name::Name;
use suspension_listing::system::System;
use suspension_listing::text::{self, Mistake, Read};
use suspension_listing::{Kind, checked, order};

use crate::listing_files::ListingFiles;
use crate::module::{Module, Source};
use crate::{emit, module};

/// Expands one module at a time, because the choice of lexer in `proc-macro2` is shared by the whole process.
static ALONE: Mutex<()> = Mutex::new(());

/// Expands `[path of the core] listing`. If it has mistakes, all of them are reported, and the types are still
/// emitted so that code which uses them raises no further errors.
pub(crate) fn expand(input: TokenStream) -> TokenStream {
    let _alone = ALONE.lock().unwrap_or_else(PoisonError::into_inner);
    let (module, errors) = match module::parse(input) {
        Ok(parsed) => parsed,
        Err(error) => return error.into_compile_error(),
    };
    match &module.source {
        Source::Braces(listing, files) => {
            let (system, found) = checked(listing, errors);
            let expansion = emitted(&module, &system, &listing.names(), found.err());
            let watched = files.watched();
            quote!(#watched #expansion)
        }
        Source::File(path) => {
            let files = ListingFiles::new(path.span(), &path.value());
            match files.listing() {
                Ok(text) => {
                    let expansion = expand_text(&module, path, &text, &files);
                    let watched = files.watched();
                    quote!(#watched #expansion)
                }
                Err(message) => Error::new(path.span(), message).into_compile_error(),
            }
        }
    }
}

/// The expansion of a module whose statements are the text of a file.
pub(crate) fn expand_text(
    module: &Module,
    path: &LitStr,
    text: &str,
    includes: &dyn IncludeSource,
) -> TokenStream {
    let Read {
        system,
        names,
        mistakes,
    } = text::read(text, includes);
    let errors = mistakes.iter().map(|mistake| error_in_file(path, mistake));
    let error = errors.reduce(|mut all, error| {
        all.combine(error);
        all
    });
    match (system, error) {
        (Some(system), error) => emitted(module, &system, &names, error),
        (None, error) => error.map(Error::into_compile_error).unwrap_or_default(),
    }
}

fn error_in_file(path: &LitStr, mistake: &Mistake) -> Error {
    let Mistake {
        message,
        line,
        column,
        ..
    } = mistake;
    let message = format!("{}:{line}:{column}: {message}", path.value());
    Error::new(path.span(), message)
}

fn emitted(
    module: &Module,
    system: &System,
    names: &[(Name, Kind)],
    error: Option<Error>,
) -> TokenStream {
    match error {
        None => emit::module(module, system, &order(system)),
        Some(error) => emit::stub(module, system, names, &error),
    }
}
