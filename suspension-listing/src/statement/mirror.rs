//! `mirror: left -> right;`: every point and statement with the word `left` in its name, as a whole or between
//! underscores, is repeated on the other side of the vehicle, with the word `right`.
//!
//! A statement is mirrored as text: the two words are exchanged in names, and the sign of y is changed in positions
//! and directions. The copies have the places of their originals.

mod image;
mod no_image;

use proc_macro2::{TokenStream, TokenTree};
use syn::{Error, Ident, Token};

use self::no_image::without_image;
use super::include::WORDS;
use super::operands::arrow;
use super::points::{FIXED, FREE};
use super::role::{KINGPIN, WHEEL};
use super::word::Word;
use crate::errors::{self, Errors};
use crate::lexed::{is_punct, placed};
use crate::listing::{Listing, Point};
use crate::sides::Sides;
use crate::system::AXES;

pub(crate) const MIRROR: Word = Word {
    word: "mirror",
    syntax: "mirror: left -> right;",
    read: |head, input, listing| {
        input.parse::<Token![:]>()?;
        let sides = arrow(input)?;
        let is_word = |side: &&Ident| WORDS.iter().chain(&AXES).any(|word| side == word);
        if let Some(side) = sides.iter().find(is_word) {
            return Err(errors::at(
                side,
                format!(
                    "`{side}` is a word of statements; name the sides by other words, left and right"
                ),
            ));
        }
        let [one, other] = &sides;
        if one == other {
            return Err(errors::at(
                other,
                format!(
                    "both sides are named `{other}`; name the other side by another word, as in `mirror: left -> right;`"
                ),
            ));
        }
        if listing.mirror.is_some() {
            return Err(stated_twice(&head.word));
        }
        listing.mirror = Some(sides);
        Ok(())
    },
};

/// Makes the images.
pub(crate) struct Mirror {
    sides: Sides,
    /// The word of the stated side.
    side: Ident,
}

impl Mirror {
    /// A mirror between two sides, the stated one first.
    pub(crate) fn new(sides: [Ident; 2]) -> Self {
        let words = sides.each_ref().map(ToString::to_string);
        let [side, _] = sides;
        Self {
            sides: Sides(words),
            side,
        }
    }

    pub(crate) fn sides(&self) -> Sides {
        self.sides.clone()
    }

    /// The names of the images of all declared names of a listing.
    pub(crate) fn names(&self, listing: &Listing) -> Vec<String> {
        let named = listing.declared().filter(|(name, _)| self.is_named(name));
        named
            .map(|(name, _)| self.exchanged(name).to_string())
            .collect()
    }

    /// The statements that declare the images of points.
    ///
    /// # Errors
    ///
    /// If there are none, and at each that the listing already has.
    pub(crate) fn points(&self, listing: &Listing) -> syn::Result<Vec<TokenStream>> {
        let fixed = listing.fixed.iter().map(|point| (FIXED.word, point));
        let free = listing.free.iter().map(|point| (FREE.word, point));
        let named = fixed.chain(free);
        let named = named.filter(|(_, point)| self.is_named(&point.named.name));
        let named: Vec<(&str, &Point)> = named.collect();
        // The points may be those of a statement that could not be read, for example an `include`.
        if named.is_empty() && !listing.incomplete {
            return Err(nothing_named(&self.side));
        }
        let mut errors = Errors::default();
        for (name, _) in listing.declared() {
            let mut originals = named.iter().map(|(_, point)| &point.named.name);
            if let Some(original) = originals.find(|point| self.exchanged(point) == *name) {
                errors.push(stated_beside(name, original));
            }
        }
        errors.into_result()?;
        Ok(named
            .into_iter()
            .map(|(word, point)| self.declared(word, point))
            .collect())
    }

    /// The statement that declares the image of a point.
    fn declared(&self, word: &str, Point { named, at }: &Point) -> TokenStream {
        let docs = named.docs.iter().map(|line| format!("#[doc = {line:?}] "));
        let at = at.map_or_else(String::new, |[x, y, z]| {
            format!(" at [{x:?}, {:?}, {z:?}]", 0.0 - y)
        });
        let text = format!(
            "{word}: {}{}{at};",
            docs.collect::<String>(),
            self.exchanged(&named.name)
        );
        let declared = text.parse().unwrap_or_default();
        placed(declared, named.name.span())
    }

    /// The image of a statement; `None` if it has no name, or a name of neither side.
    ///
    /// # Errors
    ///
    /// At a quantity of which exchanging names does not make the image.
    pub(crate) fn statement(&self, tokens: &[TokenTree]) -> Option<syn::Result<TokenStream>> {
        let [_, name] = word_and_name(tokens)?;
        if !self.is_named(name) {
            return None;
        }
        Some(match without_image(tokens) {
            Some(error) => Err(error),
            None => Ok(self.tokens(tokens.iter().cloned())),
        })
    }

    /// Checks that no image is stated too, neither of a statement nor of a point.
    ///
    /// # Errors
    ///
    /// At the name of each image that is stated.
    pub(crate) fn check_stated_once(
        &self,
        statements: &[Vec<TokenTree>],
        listing: &Listing,
    ) -> syn::Result<()> {
        let mut errors = Errors::default();
        let named = || statements.iter().filter_map(|text| word_and_name(text));
        for [word, name] in named().filter(|[_, name]| self.is_named(name)) {
            let image = self.exchanged(name);
            let is_image = |[other, stated]: &[&Ident; 2]| {
                // Wheels and kingpins share their names with other statements.
                **stated == image
                    && has_own_name(word) == has_own_name(other)
                    && (has_own_name(word) || *other == word)
            };
            if let Some([other, stated]) = named().find(is_image) {
                errors.push(self.made_already([other, stated], [word, name]));
            }
            let mut points = listing.points().filter(|_| has_own_name(word));
            if let Some(point) = points.find(|point| **point == image) {
                errors.push(named_as_an_image(point, [word, name]));
            }
        }
        errors.into_result()
    }

    fn made_already(&self, [word, image]: [&Ident; 2], [of, name]: [&Ident; 2]) -> Error {
        let [one, other] = &self.sides.0;
        errors::at(
            image,
            format!(
                "`mirror` makes `{word} {image}` already, as the image of `{of} {name}`; remove this one, or, where the sides differ, state both \
                 under names without `{one}` and `{other}`"
            ),
        )
    }

    fn is_named(&self, name: &Ident) -> bool {
        self.sides.is_stated(&name.to_string())
    }

    /// A name with the words exchanged.
    fn exchanged(&self, name: &Ident) -> Ident {
        let exchanged = syn::parse_str::<Ident>(&self.sides.exchanged(&name.to_string()));
        let mut image = exchanged.unwrap_or_else(|_| name.clone());
        image.set_span(name.span());
        image
    }
}

/// The word of a statement and its name, which follow its docs; `None` for a statement without a name.
fn word_and_name(tokens: &[TokenTree]) -> Option<[&Ident; 2]> {
    let mut parts = tokens.split(|token| is_punct(token, ':'));
    match parts.next()? {
        [.., TokenTree::Ident(word), TokenTree::Ident(name)] => Some([word, name]),
        _ => None,
    }
}

/// Whether the names of such statements are their own, and not those of wheels.
fn has_own_name(word: &Ident) -> bool {
    ![WHEEL.word, KINGPIN.word].iter().any(|of| word == of)
}

fn stated_twice(word: &Ident) -> Error {
    errors::at(word, "`mirror` is stated twice; remove one")
}

fn stated_beside(name: &Ident, original: &Ident) -> Error {
    errors::at(
        name,
        format!(
            "`mirror` makes `{name}`, as the image of `{original}`; remove it here, or give it another name"
        ),
    )
}

fn named_as_an_image(point: &Ident, [of, name]: [&Ident; 2]) -> Error {
    errors::at(
        point,
        format!(
            "`mirror` makes `{of} {point}`, as the image of `{of} {name}`; give the point another name"
        ),
    )
}

fn nothing_named(side: &Ident) -> Error {
    errors::at(
        side,
        format!(
            "no point is named `{side}`, as a whole or between underscores; name the points of that \
             side so, or remove the statement"
        ),
    )
}
