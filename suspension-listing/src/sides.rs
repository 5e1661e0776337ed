//! The sides of the vehicle that a listing mirrors, as names have them.

/// The words that are exchanged, first the word of the stated side.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Sides(pub(crate) [String; 2]);

impl Sides {
    /// Whether a name belongs to the stated side.
    pub(crate) fn is_stated(&self, name: &str) -> bool {
        let [stated, _] = &self.0;
        name.split('_').any(|word| word == stated)
    }

    /// Whether a name belongs to either side.
    pub(crate) fn is_named(&self, name: &str) -> bool {
        name.split('_')
            .any(|word| self.0.iter().any(|side| word == side))
    }

    /// How something with an image is named, and something without, in words.
    pub(crate) fn how_named(&self) -> String {
        let [one, other] = &self.0;
        format!(
            "write `{one}` in the names of parts that both sides have, and neither `{one}` nor `{other}` in those of parts that only one side has"
        )
    }

    /// A name, or a sentence, with the words exchanged.
    pub(crate) fn exchanged(&self, text: &str) -> String {
        let [one, other] = &self.0;
        let is_between = |character: char| !character.is_alphanumeric();
        let exchange = |piece: &str| {
            let word = piece.trim_end_matches(is_between);
            let between = &piece[word.len()..];
            let word = match word {
                word if word == one => other,
                word if word == other => one,
                word => word,
            };
            format!("{word}{between}")
        };
        text.split_inclusive(is_between).map(exchange).collect()
    }
}
