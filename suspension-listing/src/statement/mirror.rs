//! `mirror: left -> right;`: all that is named `left`, as a whole or between underscores, once more on the other side of the
//! vehicle, named `right`.
//!
//! A statement is mirrored as text: names exchange the two words, and positions and directions the sign of y. The copies
//! have the places of what they are copies of.

use proc_macro2::{Delimiter, Group, Punct, Spacing, TokenStream, TokenTree};
use syn::{Error, Ident, Token};

use super::operands::arrow;
use super::word::Word;
use crate::errors;
use crate::kind::Kind;
use crate::listing::{Listing, Named, Point};

pub(crate) const MIRROR: Word = Word {
    word: "mirror",
    syntax: "mirror: left -> right;",
    read: |head, input, listing| {
        input.parse::<Token![:]>()?;
        let sides = arrow(input)?;
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
    /// Adds to a listing the images of its points.
    ///
    /// # Errors
    ///
    /// Where there are none, or the listing has one already.
    pub(crate) fn points(&self, listing: &mut Listing) -> syn::Result<()> {
        let images = |points: &[Point]| -> Vec<Point> {
            let named = points
                .iter()
                .filter(|point| self.is_named(&point.named.name));
            named.map(|point| self.image(point)).collect()
        };
        let [fixed, free] = [&listing.fixed, &listing.free].map(|points| images(points));
        let [side, _] = &self.sides;
        if fixed.is_empty() && free.is_empty() {
            return Err(nothing_named(side));
        }
        let is_image = |(name, _): &(&Ident, Kind)| {
            let mut images = fixed.iter().chain(&free);
            images.any(|image| image.named.name == **name)
        };
        let stated = listing.declared().find(is_image);
        if let Some((name, _)) = stated {
            return Err(stated_beside(name, &self.exchanged(name)));
        }
        listing.fixed.extend(fixed);
        listing.free.extend(free);
        Ok(())
    }

    fn image(&self, Point { named, at }: &Point) -> Point {
        let named = Named {
            docs: named.docs.clone(),
            name: self.exchanged(&named.name),
        };
        let at = at.map(|[x, y, z]| [x, 0.0 - y, z]);
        Point { named, at }
    }

    /// The image of a statement; `None` where it has no name, or one of neither side.
    pub(crate) fn statement(&self, tokens: &[TokenTree]) -> Option<TokenStream> {
        // Behind its docs.
        let names = tokens
            .split(|token| matches!(token, TokenTree::Punct(punct) if punct.as_char() == ':'));
        let name = names.into_iter().next()?.last()?;
        let TokenTree::Ident(name) = name else {
            return None;
        };
        let image = self.tokens(tokens.iter().cloned());
        self.is_named(name).then_some(image)
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

/// `x, -y, z` of `x, y, z`.
fn opposite(vector: TokenStream) -> TokenStream {
    let is_comma =
        |token: &TokenTree| matches!(token, TokenTree::Punct(punct) if punct.as_char() == ',');
    let is_minus =
        |token: &TokenTree| matches!(token, TokenTree::Punct(punct) if punct.as_char() == '-');
    let (mut commas, mut image) = (0, Vec::new());
    for token in vector {
        let starts = image.last().is_some_and(is_comma);
        let is_of_y = commas == 1 && starts;
        commas += usize::from(is_comma(&token));
        match token {
            minus if is_of_y && is_minus(&minus) => continue,
            number if is_of_y => {
                let mut minus = Punct::new('-', Spacing::Alone);
                minus.set_span(number.span());
                image.extend([TokenTree::Punct(minus), number]);
            }
            other => image.push(other),
        }
    }
    image.into_iter().collect()
}

fn stated_twice(word: &Ident) -> Error {
    errors::at(word, "`mirror` is stated twice; remove one")
}

fn stated_beside(name: &Ident, original: &Ident) -> Error {
    errors::at(
        name,
        format!("`{name}` is the image of `{original}`; remove it, or give it another name"),
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
