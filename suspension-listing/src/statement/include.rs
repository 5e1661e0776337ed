//! `include front: steered_axle at [2.6, 0.0, 0.0];` or `include left: "corner.linkage";`: all statements of another listing,
//! with the name of the include as a prefix of its names, and its positions moved.
//!
//! The included listing is renamed as text, and then read as if it were written here. A name that it uses without
//! declaring it refers to the including listing.

use std::collections::BTreeSet;

use proc_macro2::{Delimiter, Group, Literal, Punct, Spacing, TokenStream, TokenTree};
use syn::ext::IdentExt;
use syn::parse::{ParseStream, Parser};
use syn::{Error, Ident, LitStr, Token};

use super::operands;
use super::points::{position, vector};
use super::role::{KINGPIN, WHEEL};
use super::word::Word;
use crate::errors;
use crate::include::{Include, Source};
use crate::lexed::{handed_on, is_punct};
use crate::system::AXES;
use crate::vector::Vector;

pub(crate) const INCLUDE: Word = Word {
    word: "include",
    syntax: "include front: steered_axle at [2.6, 0.0, 0.0];",
    read: |_, input, listing| {
        let name = operands::name(input)?;
        input.parse::<Token![:]>()?;
        listing.include = Some(Include {
            source: source(input, &name)?,
            name,
            at: position(input)?,
        });
        Ok(())
    },
};

/// Words of the language that occur at places where names do.
pub(super) const WORDS: [&str; 6] = ["at", "on", "along", "about", "length", "angle"];

/// A name of the catalogue, or a file's path in quotes.
fn source(input: ParseStream<'_>, name: &Ident) -> syn::Result<Source> {
    if !operands::is_literal(input) {
        let linkage = operands::name(input)?;
        if input.peek(Token![.]) || input.peek(Token![/]) {
            let message =
                format!("a file stands in quotes, as in `include {name}: \"corner.linkage\";`");
            return Err(errors::at(&linkage, message));
        }
        return Ok(Source::OfCatalogue(linkage));
    }
    let path: LitStr = input.parse()?;
    if path.value().is_empty() {
        let message = format!(
            "`{name}` names no file; write the path of a file of statements, for example `include {name}: \"corner.linkage\";`"
        );
        return Err(Error::new(path.span(), message));
    }
    Ok(Source::File(path))
}

impl Include {
    /// Rewrites a statement of another listing that declares `names` so that it can be read here.
    ///
    /// # Errors
    ///
    /// If one of the names would be read as a word of the language.
    pub(crate) fn statement(
        &self,
        tokens: &TokenStream,
        names: &BTreeSet<String>,
    ) -> syn::Result<TokenStream> {
        if let Some(word) = WORDS.iter().find(|word| names.contains(**word)) {
            return Err(self.named_as_a_word(word));
        }
        let tokens = handed_on(tokens.clone(), self.name.span());
        Ok(self.renamed(tokens, names))
    }

    /// A statement has its word after its docs, and a role has the name of the wheel after its word.
    fn renamed(&self, tokens: TokenStream, names: &BTreeSet<String>) -> TokenStream {
        let mut tokens = tokens.into_iter();
        let mut renamed = Vec::new();
        for mut token in tokens.by_ref() {
            let is_word = matches!(token, TokenTree::Ident(_));
            if is_word {
                // Mistakes of the listing as a whole do not belong to the other listing.
                token.set_span(self.name.span());
            }
            renamed.push(token);
            if is_word {
                break;
            }
        }
        let is_role =
            |word: &TokenTree| [WHEEL.word, KINGPIN.word].contains(&word.to_string().as_str());
        if renamed.last().is_some_and(is_role) {
            match tokens.next() {
                Some(TokenTree::Ident(name)) => renamed.push(self.prefixed(&name).into()),
                colon => renamed.extend([self.name.clone().into()].into_iter().chain(colon)),
            }
        }
        self.operands(renamed, tokens, names)
    }

    /// Appends to some tokens the renamed and moved operands that follow.
    fn operands(
        &self,
        before: Vec<TokenTree>,
        tokens: impl Iterator<Item = TokenTree>,
        names: &BTreeSet<String>,
    ) -> TokenStream {
        let mut renamed = before;
        let mut tokens = tokens.peekable();
        while let Some(token) = tokens.next() {
            let before = renamed.last();
            let is_last = tokens.peek().is_none();
            let is_behind = |mark| before.is_some_and(|before| is_punct(before, mark));
            let is_axis = |name: &Ident| {
                let is_axis = AXES.iter().any(|axis| name == axis);
                is_behind('.') || (is_axis && is_last && is_behind(','))
            };
            let is_position = matches!(before, Some(TokenTree::Ident(at)) if at == "at");
            renamed.push(match token {
                TokenTree::Ident(name) if !is_axis(&name) && names.contains(&name.to_string()) => {
                    self.prefixed(&name).into()
                }
                TokenTree::Group(group) => {
                    let content = match (group.delimiter(), self.at) {
                        (Delimiter::Bracket, Some(by)) if is_position => moved(group.stream(), by),
                        (Delimiter::Bracket, _) => group.stream(),
                        _ => self.operands(Vec::new(), group.stream().into_iter(), names),
                    };
                    let mut renamed = Group::new(group.delimiter(), content);
                    renamed.set_span(group.span());
                    renamed.into()
                }
                other => other,
            });
        }
        renamed.into_iter().collect()
    }

    fn prefixed(&self, name: &Ident) -> Ident {
        Ident::new(&self.prefixed_name(&name.unraw().to_string()), name.span())
    }

    /// The name here of a name of the other listing.
    pub(crate) fn prefixed_name(&self, name: &str) -> String {
        format!("{}_{name}", self.name.unraw())
    }

    fn named_as_a_word(&self, word: &str) -> Error {
        errors::at(
            &self.name,
            format!(
                "`{}` uses `{word}`, a word of statements, as a name; choose another name in that file to include it",
                self.source.name()
            ),
        )
    }
}

/// A position `x, y, z`, moved; tokens that cannot be read stay, to be reported.
fn moved(position: TokenStream, by: Vector) -> TokenStream {
    let mut bracketed = TokenStream::new();
    bracketed.extend([TokenTree::from(Group::new(
        Delimiter::Bracket,
        position.clone(),
    ))]);
    let read = |input: ParseStream<'_>| vector(input, "a design position");
    let Ok(at) = read.parse2(bracketed) else {
        return position;
    };
    let mut moved = TokenStream::new();
    for (x, by) in at.into_iter().zip(by) {
        let x = x + by;
        if x < 0.0 {
            moved.extend([TokenTree::from(Punct::new('-', Spacing::Alone))]);
        }
        moved.extend([
            TokenTree::from(Literal::f64_unsuffixed(x.abs())),
            Punct::new(',', Spacing::Alone).into(),
        ]);
    }
    moved
}
