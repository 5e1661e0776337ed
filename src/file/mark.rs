//! What is wrong at a place of a text: one line, and on a terminal the line of the text with a mark under the
//! place.

use std::io::{IsTerminal, stderr};
use std::ops::Range;

use annotate_snippets::{AnnotationKind, Level, Renderer, Snippet};

use crate::file::source::Source;

/// The message for whoever reads standard error.
pub(super) fn message(source: &Source, span: &Range<usize>, what: &str) -> String {
    if !stderr().is_terminal() {
        return in_one_line(source, span, what);
    }
    let renderer = match std::env::var_os("NO_COLOR") {
        Some(_) => Renderer::plain(),
        None => Renderer::styled(),
    };
    marked(&renderer, source, span, what)
}

fn in_one_line(source: &Source, span: &Range<usize>, what: &str) -> String {
    format!("{}: {what}", source.place(span))
}

fn marked(renderer: &Renderer, source: &Source, span: &Range<usize>, what: &str) -> String {
    if source.text().get(span.clone()).is_none() {
        return in_one_line(source, span, what);
    }
    let place = AnnotationKind::Primary.span(span.clone());
    let snippet = Snippet::source(source.text())
        .path(source.name())
        .annotation(place);
    renderer.render(&[Level::ERROR.primary_title(what).element(snippet)])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_line_is_shown_with_a_mark_under_the_place() {
        let source = Source::new("a.linkage", "free: tip;\nlink arm: hnge -> tip;\n");
        let start = source.text().find("hnge").unwrap();
        let shown = marked(
            &Renderer::plain(),
            &source,
            &(start..start + 4),
            "no point `hnge`",
        );
        let lines: Vec<&str> = shown.lines().collect();
        assert_eq!(lines[0], "error: no point `hnge`");
        assert!(lines[1].ends_with("--> a.linkage:2:11"), "{shown}");
        assert!(lines[3].ends_with("link arm: hnge -> tip;"), "{shown}");
        assert_eq!(lines[4].find("^^^^"), lines[3].find("hnge"), "{shown}");
    }

    #[test]
    fn a_place_beyond_the_text_is_told_in_one_line() {
        let source = Source::new("a.linkage", "free: é;");
        for span in [7..8, 90..91] {
            let shown = marked(&Renderer::plain(), &source, &span, "wrong");
            assert_eq!(shown.lines().count(), 1, "{shown}");
        }
    }
}
