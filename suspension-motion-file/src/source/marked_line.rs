//! Mistakes shown on a terminal as compilers show them: the line of the text with a mark under the place.

use std::io::{IsTerminal, stderr};
use std::ops::Range;

use annotate_snippets::{AnnotationKind, Level, Renderer, Snippet};

/// Returns the mistake with the marked line of a file; `None` if standard error is not a terminal.
pub(super) fn drawn(file: &str, text: &str, span: &Range<usize>, what: &str) -> Option<String> {
    let renderer = match std::env::var_os("NO_COLOR") {
        Some(_) => Renderer::plain(),
        None => Renderer::styled(),
    };
    let drawn = || marked(&renderer, file, text, span, what);
    stderr().is_terminal().then(drawn).flatten()
}

/// Returns `None` if the text has no such place.
fn marked(
    renderer: &Renderer,
    file: &str,
    text: &str,
    span: &Range<usize>,
    what: &str,
) -> Option<String> {
    text.get(span.clone())?;
    let place = AnnotationKind::Primary.span(span.clone());
    let snippet = Snippet::source(text).path(file).annotation(place);
    Some(renderer.render(&[Level::ERROR.primary_title(what).element(snippet)]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_message_shows_the_line_with_a_mark_under_the_place() {
        let text = "free: tip;\nlink arm: hnge -> tip;\n";
        let start = text.find("hnge").unwrap();
        let what = "no point `hnge`";
        let plain = Renderer::plain();
        let shown = marked(&plain, "a.linkage", text, &(start..start + 4), what).unwrap();
        let lines: Vec<&str> = shown.lines().collect();
        assert_eq!(lines[0], "error: no point `hnge`");
        assert!(lines[1].ends_with("--> a.linkage:2:11"), "{shown}");
        assert!(lines[3].ends_with("link arm: hnge -> tip;"), "{shown}");
        assert_eq!(lines[4].find("^^^^"), lines[3].find("hnge"), "{shown}");
    }

    #[test]
    fn a_place_outside_the_text_is_not_drawn() {
        for span in [7..8, 90..91] {
            let shown = marked(&Renderer::plain(), "a.linkage", "free: é;", &span, "wrong");
            assert_eq!(shown, None);
        }
    }
}
