//! Reads the listings that a listing includes.

use std::collections::BTreeSet;
use std::mem;
use std::path::{Path, PathBuf};

use proc_macro2::{Span, TokenStream};
use syn::Ident;
use syn::parse::{ParseStream, Parser};

use super::Reading;
use crate::errors;
use crate::include::{Include, Included, mistakes};
use crate::lexed::{self, MOST_BYTES};
use crate::mistake::Mistake;
use crate::sides::Sides;

/// The largest depth of listings included in listings.
const DEEPEST_INCLUDED: usize = 4;

/// The largest number of included listings in all.
const MOST_INCLUDED: usize = 100;

impl Reading<'_> {
    /// Adds the statements of another listing. After one too many no more are added: a listing that includes itself
    /// twice would be refused once for each way to it.
    pub(super) fn include(&mut self, include: &Include) {
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
            file,
            depth: self.depth + 1,
            ..Self::new(Span::call_site(), self.includes, self.included)
        };
        let read = |input: ParseStream<'_>| reading.all(input);
        let read = read.parse2(tokens);
        let read = read.and_then(|()| mem::take(&mut reading.errors).into_result());
        let included = mem::take(&mut reading.listing.included);
        read.map_err(|error| mistakes(text, &included, error))?;
        let names = reading.listing.declared();
        let texts = reading.texts.into_iter();
        Ok(Flat {
            names: names.map(|(name, _)| name.to_string()).collect(),
            statements: texts.map(TokenStream::from_iter).collect(),
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
