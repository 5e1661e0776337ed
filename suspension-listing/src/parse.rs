//! From tokens to the listing. A statement that cannot be read is reported and skipped.

mod statement;

use std::cell::Cell;
use std::collections::BTreeSet;
use std::mem;
use std::path::{Path, PathBuf};

use proc_macro2::{Span, TokenStream, TokenTree};
use syn::parse::{ParseStream, Parser};
use syn::{Attribute, Ident};

use crate::errors::{self, Errors};
use crate::include::{Include, IncludeSource, Included, mistakes};
use crate::lexed::{self, MOST_BYTES};
use crate::listing::Listing;
use crate::mistake::Mistake;
use crate::sides::Sides;
use crate::statement::mirror::{MIRROR, Mirror};
use crate::statement::operands::lines;
use statement::{skip_statement, statement, tokens};

/// The largest depth of listings included in listings.
const DEEPEST_INCLUDED: usize = 4;

/// The largest number of included listings in all.
const MOST_INCLUDED: usize = 100;

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
    let read = everything(input, span, includes)?;
    Ok((read.listing, read.errors))
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
    let read = everything(input, Span::call_site(), includes)?;
    read.errors.into_result()?;
    Ok(read.texts.into_iter().map(TokenStream::from_iter).collect())
}

/// What is read from a listing.
struct Everything {
    listing: Listing,
    errors: Errors,
    texts: Vec<Vec<TokenTree>>,
}

fn everything(
    input: ParseStream<'_>,
    span: Span,
    includes: &dyn IncludeSource,
) -> syn::Result<Everything> {
    let included = Cell::new(Some(0));
    let mut reading = Reading {
        listing: Listing::empty(span),
        errors: Errors::default(),
        texts: Vec::new(),
        includes,
        includes_named: BTreeSet::new(),
        file: PathBuf::new(),
        depth: 0,
        included: &included,
    };
    reading.all(input)?;
    Ok(Everything {
        listing: reading.listing,
        errors: reading.errors,
        texts: reading.texts,
    })
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

impl Reading<'_> {
    fn all(&mut self, input: ParseStream<'_>) -> syn::Result<()> {
        match lines(&input.call(Attribute::parse_inner)?) {
            Ok(lines) => self.listing.docs = lines,
            Err(error) => self.errors.push(error),
        }
        while !input.is_empty() {
            let ahead = input.fork();
            match statement(input, &mut self.listing) {
                Ok(()) => match self.listing.include.take() {
                    Some(include) => self.include(&include),
                    None => self.texts.push(tokens(&ahead)?),
                },
                Err(error) => {
                    self.report(error);
                    skip_statement(input)?;
                }
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

    /// Adds the statements of another listing. After one too many no more are added: a listing that includes itself
    /// twice would be refused once for each way to it.
    fn include(&mut self, include: &Include) {
        if self.included.get().is_none() {
            self.listing.incomplete = true;
        } else if let Err(error) = self.try_include(include) {
            self.report(error);
        }
    }

    fn try_include(&mut self, include: &Include) -> syn::Result<()> {
        self.check_stated_once(&include.name)?;
        let file = include.source.path(&self.file);
        let text = self.text(include, &file)?;
        let flat = lexed::with_lexer_places(|| self.flat(include, text, file))?;
        self.listing.included.extend(flat.included);
        self.listing.sides.extend(flat.sides);
        let images = flat.images.iter().map(|name| include.prefixed_name(name));
        self.listing.images.extend(images);
        let mut statements = flat.statements.iter();
        statements.try_for_each(|tokens| self.add(include.statement(tokens, &flat.names)?))
    }

    /// The text of another listing.
    fn text(&self, include: &Include, file: &Path) -> syn::Result<String> {
        let refuse = |message| include.refused(message);
        let name = include.source.name();
        let before = self.included.take();
        let before = before.filter(|count| self.depth < DEEPEST_INCLUDED && *count < MOST_INCLUDED);
        let Some(count) = before else {
            return Err(refuse(format!(
                "`{name}` is one include too many: includes may be nested {DEEPEST_INCLUDED} deep, with {MOST_INCLUDED} in all; \
                 check whether a listing includes itself"
            )));
        };
        self.included.set(Some(count + 1));
        let text = self.includes.text(include.source.wanted(&name, file));
        let text = text.map_err(refuse)?;
        if text.len() > MOST_BYTES {
            let bytes = text.len();
            return Err(refuse(format!(
                "`{name}` is {bytes} bytes long; at most {MOST_BYTES} are allowed"
            )));
        }
        Ok(text)
    }

    /// Refuses a name under which something else is included: each of its names would be stated twice.
    fn check_stated_once(&mut self, name: &Ident) -> syn::Result<()> {
        if self.includes_named.insert(name.to_string()) {
            return Ok(());
        }
        let message = format!("the name `{name}` is already taken by an include; choose another");
        Err(errors::at(name, message))
    }

    /// The statements of an included text.
    fn flat(&self, include: &Include, text: String, file: PathBuf) -> syn::Result<Flat> {
        let tokens = lexed::tokens(&text);
        let inner = include.included(text, tokens.as_ref().ok());
        let read = tokens.and_then(|tokens| self.read(inner.text(), tokens, file));
        let mut flat = read.map_err(|mistakes| inner.wrong(mistakes))?;
        flat.included.push(inner);
        Ok(flat)
    }

    fn read(&self, text: &str, tokens: TokenStream, file: PathBuf) -> Result<Flat, Vec<Mistake>> {
        let mut reading = Self {
            listing: Listing::empty(Span::call_site()),
            errors: Errors::default(),
            texts: Vec::new(),
            includes_named: BTreeSet::new(),
            file,
            depth: self.depth + 1,
            ..*self
        };
        let read = |input: ParseStream<'_>| reading.all(input);
        let read = read.parse2(tokens);
        let read = read.and_then(|()| mem::take(&mut reading.errors).into_result());
        let included = mem::take(&mut reading.listing.included);
        read.map_err(|error| mistakes(text, &included, error))?;
        let names = reading.listing.declared();
        Ok(Flat {
            names: names.map(|(name, _)| name.to_string()).collect(),
            statements: reading
                .texts
                .into_iter()
                .map(TokenStream::from_iter)
                .collect(),
            included,
            sides: reading.listing.sides,
            images: reading.listing.images,
        })
    }
}

/// A listing without includes and without a mirror.
struct Flat {
    names: BTreeSet<String>,
    statements: Vec<TokenStream>,
    /// The texts that it comes from.
    included: Vec<Included>,
    /// The sides between which it was mirrored, and the names of the images.
    sides: Vec<Sides>,
    images: BTreeSet<String>,
}

fn is_mirror(text: &[TokenTree]) -> bool {
    let mut words = text.iter().filter_map(|token| match token {
        TokenTree::Ident(word) => Some(word),
        _ => None,
    });
    words.next().is_some_and(|word| word == MIRROR.word)
}
