//! The image of a statement as text, with the words of the sides exchanged in names and the sign of y changed in
//! positions and directions.

use proc_macro2::{Delimiter, Group, Punct, Spacing, TokenStream, TokenTree};

use super::Mirror;
use crate::lexed::is_punct;

impl Mirror {
    pub(super) fn tokens(&self, tokens: impl IntoIterator<Item = TokenTree>) -> TokenStream {
        let mut is_attribute = false;
        let image = |token| {
            let image = match token {
                TokenTree::Ident(name) => self.exchanged(&name).into(),
                TokenTree::Group(group) if !is_attribute => self.group(&group).into(),
                other => other,
            };
            is_attribute = is_punct(&image, '#');
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
}

/// `x, -y, z` from `x, y, z`.
fn opposite(vector: TokenStream) -> TokenStream {
    let (mut commas, mut begins_y, mut image) = (0, false, Vec::new());
    for token in vector {
        let begins = std::mem::take(&mut begins_y);
        if is_punct(&token, ',') {
            commas += 1;
            begins_y = commas == 1;
        }
        match token {
            minus if begins && is_punct(&minus, '-') => {}
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
