//! The description of a listing in its own text.

/// Returns the first sentence of a listing's description.
pub(crate) fn first_sentence(text: &str) -> String {
    let lines = text.lines().map_while(|line| line.strip_prefix("//! "));
    let paragraph = lines.collect::<Vec<_>>().join(" ");
    let end = paragraph.find(". ").map_or(paragraph.len(), |end| end + 1);
    paragraph[..end].to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn first_sentence_ends_at_its_full_stop_or_with_the_paragraph() {
        let text = "//! An arm, 0.4 m long,\n//! rear left. More.\n//!\n//! Axes.\nfixed: a;\n";
        assert_eq!(first_sentence(text), "An arm, 0.4 m long, rear left.");
        assert_eq!(first_sentence("//! An arm\n//!\n//! Axes.\n"), "An arm");
    }
}
