//! Messages that may quote a file, on a terminal.

use suspension_listing::text::escape_control;

/// The longest message that may quote a file, in characters as they are printed: twice the longest sentence of the program.
const LONGEST: usize = 1000;

/// The characters at the end of a longer quotation that stay.
const ENDING: usize = 100;

/// The longest word that is not cut, in characters.
const WORD: usize = 50;

/// Returns a text that may quote a file in a form fit for a terminal: control characters are escaped, and the middle of a
/// long text is cut, because the advice stands at its end.
pub(super) fn fit_for_terminal(text: &str) -> String {
    let text = escape_control(text);
    let characters: Vec<char> = text.chars().collect();
    if characters.len() <= LONGEST {
        return text;
    }
    let first = &characters[..LONGEST - ENDING];
    let last = &characters[characters.len() - ENDING..];
    // Words, for example the names of a list, are not cut.
    let is_space = |character: &char| *character == ' ';
    let end = first.iter().rposition(is_space);
    let end = end.filter(|end| first.len() - end <= WORD);
    let start = last.iter().take(WORD).position(is_space);
    let first = &first[..end.unwrap_or(first.len())];
    let last = &last[start.map_or(0, |space| space + 1)..];
    format!(
        "{} ... {}",
        String::from_iter(first),
        String::from_iter(last)
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::source::Source;

    #[test]
    fn a_message_is_one_line_of_escaped_text() {
        let source = Source::new("a.toml", "");
        let long = "\u{1b}[31m\n".to_owned() + &"é".repeat(2 * LONGEST) + "; did you mean `e`?";
        let message = source.refuse(&(0..0), long).to_string();
        assert!(message.starts_with("a.toml:1:1: \\u{1b}[31m\\né"));
        assert!(message.contains("é ... é") && message.chars().count() < LONGEST + 50);
        assert!(message.ends_with("é; did you mean `e`?"));
    }

    #[test]
    fn a_message_with_many_control_characters_is_cut_as_long_as_any() {
        let quoted = format!("`0{}` is no number", "\0".repeat(LONGEST - 20));
        let message = Source::new("a.toml", "").refuse(&(0..0), quoted);
        let message = message.to_string();
        assert!(message.chars().count() < LONGEST + 50, "{message}");
        assert!(message.ends_with("` is no number"), "{message}");
    }

    #[test]
    fn a_long_list_of_names_is_cut_between_names() {
        let names: Vec<String> = (0..LONGEST).map(|n| format!("lower_ball_{n}")).collect();
        let list = format!(
            "unknown point; known are {}, the last one",
            names.join(", ")
        );
        let message = Source::new("a.toml", "").refuse(&(0..0), &list).to_string();
        let (first, last) = message.split_once(" ... ").expect("cut");
        let whole = |name: &str| names.iter().any(|known| known == name);
        let before = first
            .rsplit(", ")
            .next()
            .map(|name| name.trim_end_matches(','));
        assert!(before.is_some_and(whole), "{message}");
        assert!(last.split(", ").next().is_some_and(whole), "{message}");
    }
}
