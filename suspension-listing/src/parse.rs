//! From tokens to the listing. A statement that cannot be read is reported and skipped.

mod include;
mod statement;

use std::cell::Cell;
use std::collections::BTreeSet;
use std::path::PathBuf;

use proc_macro2::{Span, TokenStream, TokenTree};
use syn::Attribute;
use syn::parse::{ParseStream, Parser};

use crate::errors::{Errors, lacks_semicolon};
use crate::include::IncludeSource;
use crate::listing::Listing;
use crate::statement::mirror::{MIRROR, Mirror};
use crate::statement::operands::lines;
use statement::{is_at_end, skip_statement, statement, tokens};

/// Reads the statements of a listing to the end of the input, and the errors of those that could not be read.
/// Messages about the listing as a whole point to `span`.
///
/// # Errors
///
/// If something cannot be read and cannot be skipped.
pub fn statements(
    input: ParseStream<'_>,
    span: Span,
    includes: &dyn IncludeSource,
) -> syn::Result<(Listing, Errors)> {
    let included = Cell::new(Some(0));
    let mut reading = Reading::new(span, includes, &included);
    reading.all(input)?;
    Ok((reading.listing, reading.errors))
}

/// The statements of a listing, those that declare points among them, in the order in which they are read; includes and
/// mirrors are written out.
///
/// # Errors
///
/// As [`statements`], and the first error of a statement that could not be read.
pub(crate) fn flat_statements(
    input: ParseStream<'_>,
    includes: &dyn IncludeSource,
) -> syn::Result<Vec<TokenStream>> {
    let included = Cell::new(Some(0));
    let mut reading = Reading::new(Span::call_site(), includes, &included);
    reading.all(input)?;
    reading.errors.into_result()?;
    let texts = reading.texts.into_iter();
    Ok(texts.map(TokenStream::from_iter).collect())
}

/// A listing being read.
struct Reading<'a> {
    listing: Listing,
    errors: Errors,
    /// The statements that were read, including those of included listings.
    texts: Vec<Vec<TokenTree>>,
    includes: &'a dyn IncludeSource,
    /// The names under which listings are included.
    includes_named: BTreeSet<String>,
    /// The path of an included listing, relative to the folder of the one that is read.
    file: PathBuf,
    /// The number of listings in which it is nested.
    depth: usize,
    /// The number of listings included in all; `None` after one too many.
    included: &'a Cell<Option<usize>>,
}

impl<'a> Reading<'a> {
    fn new(span: Span, includes: &'a dyn IncludeSource, included: &'a Cell<Option<usize>>) -> Self {
        Self {
            listing: Listing::empty(span),
            errors: Errors::default(),
            texts: Vec::new(),
            includes,
            includes_named: BTreeSet::new(),
            file: PathBuf::new(),
            depth: 0,
            included,
        }
    }

    fn all(&mut self, input: ParseStream<'_>) -> syn::Result<()> {
        match lines(&input.call(Attribute::parse_inner)?) {
            Ok(lines) => self.listing.docs = lines,
            Err(error) => self.errors.push(error),
        }
        while !input.is_empty() {
            let begin = input.cursor();
            match statement(input, &mut self.listing) {
                Ok(()) => {}
                // Nothing but the semicolon is missing.
                Err(error) if lacks_semicolon(&error.to_string()) && is_at_end(begin, input) => {
                    self.errors.push(error);
                }
                Err(error) => {
                    self.report(error);
                    skip_statement(input)?;
                    continue;
                }
            }
            match self.listing.include.take() {
                Some(include) => self.include(&include),
                None => self.texts.push(tokens(begin, input.cursor())),
            }
        }
        if let Some(sides) = self.listing.mirror.take()
            && let Err(error) = self.mirror(&Mirror::new(sides))
        {
            self.report(error);
        }
        Ok(())
    }

    fn report(&mut self, error: syn::Error) {
        self.errors.push(error);
        self.listing.incomplete = true;
    }

    /// Adds the other side of the vehicle, so that nothing is left to be mirrored.
    fn mirror(&mut self, mirror: &Mirror) -> syn::Result<()> {
        self.texts.retain(|text| !is_mirror(text));
        let points = mirror.points(&self.listing)?;
        mirror.check_stated_once(&self.texts, &self.listing)?;
        self.listing.images.extend(mirror.names(&self.listing));
        self.listing.sides.push(mirror.sides());
        let others = self.texts.iter().filter_map(|text| mirror.statement(text));
        let images = points.into_iter().map(Ok).chain(others);
        let images: Vec<syn::Result<TokenStream>> = images.collect();
        images.into_iter().try_for_each(|image| self.add(image?))
    }

    /// Adds a statement.
    fn add(&mut self, text: TokenStream) -> syn::Result<()> {
        self.texts.push(text.clone().into_iter().collect());
        let read = |input: ParseStream<'_>| statement(input, &mut self.listing);
        read.parse2(text)
    }
}

fn is_mirror(text: &[TokenTree]) -> bool {
    let mut words = text.iter().filter_map(|token| match token {
        TokenTree::Ident(word) => Some(word),
        _ => None,
    });
    words.next().is_some_and(|word| word == MIRROR.word)
}
