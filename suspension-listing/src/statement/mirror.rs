//! `mirror: left -> right;`: all that is named `left`, as a whole or between underscores, once more on the other side of the
//! vehicle, named `right`.
//!
//! A statement is mirrored as text: names exchange the two words, and positions and directions the sign of y. The copies
//! have the places of what they are copies of.

use proc_macro2::{Delimiter, Group, Punct, Spacing, TokenStream, TokenTree};
use syn::{Error, Ident, Token};

use super::include::WORDS;
use super::operands::arrow;
use super::points::{FIXED, FREE};
use super::role::{KINGPIN, WHEEL};
use super::word::Word;
use crate::errors::{self, Errors};
use crate::kind::Kind;
use crate::lexed::placed;
use crate::listing::{Listing, Point};
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
        if listing.mirror.is_some() {
            return Err(stated_twice(&head.word));
        }
        listing.mirror = Some(sides);
        Ok(())
    },
};

/// The words that are exchanged.
pub(crate) struct Mirror {
    pub(crate) sides: [Ident; 2],
}

impl Mirror {
    /// The statements that declare the images of points.
    ///
    /// # Errors
    ///
    /// Where there are none, or the listing has one already.
    pub(crate) fn points(&self, listing: &Listing) -> syn::Result<Vec<TokenStream>> {
        let fixed = listing.fixed.iter().map(|point| (FIXED.word, point));
        let free = listing.free.iter().map(|point| (FREE.word, point));
        let named = fixed.chain(free);
        let named = named.filter(|(_, point)| self.is_named(&point.named.name));
        let named: Vec<(&str, &Point)> = named.collect();
        let [side, _] = &self.sides;
        // The points may be those of a statement that could not be read, an `include` say.
        if named.is_empty() && !listing.incomplete {
            return Err(nothing_named(side));
        }
        let is_image = |(name, _): &(&Ident, Kind)| {
            let mut images = named.iter();
            images.any(|(_, point)| self.exchanged(&point.named.name) == **name)
        };
        if let Some((name, _)) = listing.declared().find(is_image) {
            return Err(stated_beside(name, &self.exchanged(name)));
        }
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

    /// The image of a statement; `None` where it has no name, or one of neither side.
    ///
    /// # Errors
    ///
    /// At a sum of y with other coordinates, of which the exchange of names makes no image.
    pub(crate) fn statement(&self, tokens: &[TokenTree]) -> Option<syn::Result<TokenStream>> {
        let [_, name] = word_and_name(tokens)?;
        if !self.is_named(name) {
            return None;
        }
        Some(match y_beside_others(tokens) {
            Some(y) => Err(mixed(y)),
            None => Ok(self.tokens(tokens.iter().cloned())),
        })
    }

    /// Checks that the image of no statement is stated too.
    ///
    /// # Errors
    ///
    /// At the name of each that is.
    pub(crate) fn check_stated_once(&self, statements: &[Vec<TokenTree>]) -> syn::Result<()> {
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
        }
        errors.into_result()
    }

    fn made_already(&self, [word, image]: [&Ident; 2], [of, name]: [&Ident; 2]) -> Error {
        let [one, other] = &self.sides;
        errors::at(
            image,
            format!(
                "`mirror` makes `{word} {image}` already, as the image of `{of} {name}`; remove this one, or, where the sides differ, state both \
                 under names without `{one}` and `{other}`"
            ),
        )
    }

    fn tokens(&self, tokens: impl IntoIterator<Item = TokenTree>) -> TokenStream {
        let mut is_attribute = false;
        let image = |token| {
            let image = match token {
                TokenTree::Ident(name) => self.exchanged(&name).into(),
                TokenTree::Group(group) if !is_attribute => self.group(&group).into(),
                other => other,
            };
            is_attribute = matches!(&image, TokenTree::Punct(punct) if punct.as_char() == '#');
            image
        };
        tokens.into_iter().map(image).collect()
    }

    fn group(&self, group: &Group) -> Group {
        let content = match group.delimiter() {
            Delimiter::Bracket => opposite(group.stream()),
            _ => self.tokens(group.stream()),
        };
        let mut image = Group::new(group.delimiter(), content);
        image.set_span(group.span());
        image
    }

    fn is_named(&self, name: &Ident) -> bool {
        let [side, _] = &self.sides;
        name.to_string().split('_').any(|word| side == word)
    }

    /// A name with the words exchanged.
    fn exchanged(&self, name: &Ident) -> Ident {
        let [one, other] = self.sides.each_ref().map(ToString::to_string);
        let text = name.to_string();
        let exchange = |word| match word {
            word if word == one => other.as_str(),
            word if word == other => one.as_str(),
            word => word,
        };
        let words: Vec<&str> = text.split('_').map(exchange).collect();
        let exchanged = syn::parse_str::<Ident>(&words.join("_"));
        let mut image = exchanged.unwrap_or_else(|_| name.clone());
        image.set_span(name.span());
        image
    }
}

/// The word of a statement and its name, behind its docs; `None` of one without a name.
fn word_and_name(tokens: &[TokenTree]) -> Option<[&Ident; 2]> {
    let mut parts =
        tokens.split(|token| matches!(token, TokenTree::Punct(punct) if punct.as_char() == ':'));
    match parts.next()? {
        [.., TokenTree::Ident(word), TokenTree::Ident(name)] => Some([word, name]),
        _ => None,
    }
}

/// Whether the names of such statements are of these alone, and not of wheels.
fn has_own_name(word: &Ident) -> bool {
    ![WHEEL.word, KINGPIN.word].iter().any(|of| word == of)
}

/// `x, -y, z` of `x, y, z`.
fn opposite(vector: TokenStream) -> TokenStream {
    let is_comma =
        |token: &TokenTree| matches!(token, TokenTree::Punct(punct) if punct.as_char() == ',');
    let is_minus =
        |token: &TokenTree| matches!(token, TokenTree::Punct(punct) if punct.as_char() == '-');
    let (mut commas, mut begins_y, mut image) = (0, false, Vec::new());
    for token in vector {
        let begins = std::mem::take(&mut begins_y);
        if is_comma(&token) {
            commas += 1;
            begins_y = commas == 1;
        }
        match token {
            minus if begins && is_minus(&minus) => {}
            number if begins => {
                let mut minus = Punct::new('-', Spacing::Alone);
                minus.set_span(number.span());
                image.extend([TokenTree::Punct(minus), number]);
            }
            other => image.push(other),
        }
    }
    image.into_iter().collect()
}

/// The y of a sum that has other coordinates too.
fn y_beside_others(tokens: &[TokenTree]) -> Option<&Ident> {
    let is_dot =
        |token: &TokenTree| matches!(token, TokenTree::Punct(punct) if punct.as_char() == '.');
    let axes = tokens.windows(2).filter_map(|pair| match pair {
        [dot, TokenTree::Ident(axis)] if is_dot(dot) => Some(axis),
        _ => None,
    });
    let (y, others): (Vec<&Ident>, Vec<&Ident>) = axes.partition(|axis| *axis == "y");
    y.first().copied().filter(|_| !others.is_empty())
}

fn mixed(y: &Ident) -> Error {
    errors::at(
        y,
        "`mirror` makes no image of a sum of y with x or z, whose y would change its sign; state it for each side, under \
         names without the words that are exchanged",
    )
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

fn nothing_named(side: &Ident) -> Error {
    errors::at(
        side,
        format!(
            "no point is named `{side}`, as a whole or between underscores; name the points of that \
             side so, or remove the statement"
        ),
    )
}
