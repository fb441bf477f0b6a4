//! Error reports: a line each, and below it the part of the pair file in question, in colour on a terminal.

use super::console::has_colours;
use crate::error::Error;
use annotate_snippets::{AnnotationKind, Element, Level, Origin, Renderer, Snippet};
use gearlash_text::InputError;
use gearlash_text::characters::{plain, quoted_source};
use std::ops::Range;

/// Longest line of a pair file that is shown, bytes; for a longer one only the place is reported (tuned: a list of 200 values).
const LONGEST_SHOWN: usize = 2000;

/// `error` for standard error, each of its lines complete. Content of files acts on no terminal or log.
pub(super) fn explain(error: &Error) -> String {
    let renderer = if has_colours(&std::io::stderr()) {
        Renderer::styled()
    } else {
        Renderer::plain()
    };
    rendered(error, &renderer)
}

fn rendered(error: &Error, renderer: &Renderer) -> String {
    let titled = |line: &str, place: Option<Element>| {
        let title = Level::ERROR.primary_title(line);
        renderer.render(&[title.elements(place)]) + "\n"
    };
    match error {
        Error::Input(input) => {
            let mut shown = None;
            let problems = input.lines().into_iter().zip(input.spans());
            let text = problems.map(|(line, span)| {
                // Problems of one table have one place, shown with the first.
                let new = span.clone().filter(|_| span != shown);
                shown = span;
                titled(&line, new.map(|span| place(input, &span)))
            });
            text.collect()
        }
        Error::Several(errors) => {
            let errors = errors.iter();
            errors.map(|error| rendered(error, renderer)).collect()
        }
        other => {
            let lines = other.lines();
            lines.iter().map(|line| titled(line, None)).collect()
        }
    }
}

/// The text at `span` of the file, or where a long line has it.
fn place(input: &InputError, span: &Range<usize>) -> Element<'static> {
    let text = &input.text;
    let start = text[..span.start].rfind('\n').map_or(0, |end| end + 1);
    let end = text[start..]
        .find('\n')
        .map_or(text.len(), |end| start + end);
    let number = 1 + text[..start].matches('\n').count();
    let path = plain(&input.file.display().to_string());
    let shown = quoted_source(&text[start..end]);
    if shown.len() > LONGEST_SHOWN {
        let column = 1 + text[start..span.start].chars().count();
        let place = Origin::path(path).line(number);
        return place.char_column(column).into();
    }
    // A value of several lines is shown by its first.
    let marked = span.start - start..span.end.min(end) - start;
    let annotation = AnnotationKind::Primary.span(marked);
    let snippet = Snippet::source(shown).path(path).line_start(number);
    snippet.annotation(annotation).into()
}

#[cfg(test)]
mod tests {
    use super::*;
    use gearlash_text::Problem;

    fn input(key: &str, text: &str) -> Error {
        Error::Input(InputError {
            file: "pair.toml".into(),
            problems: vec![Problem {
                key: key.to_owned(),
                value: None,
                reason: "wrong".to_owned(),
                help: "mend it".to_owned(),
            }],
            text: text.to_owned(),
        })
    }

    #[test]
    fn a_long_line_is_reported_by_its_place() {
        let text = format!("list = [{}]\n", "1, ".repeat(2000));
        let text = rendered(&input("list", &text), &Renderer::plain());
        let expected = "error: pair.toml: list: wrong; mend it\n--> pair.toml:1:1\n";
        assert_eq!(text, expected);
    }

    #[test]
    fn nothing_in_the_file_acts_on_the_terminal() {
        let text = "a = \"\u{202e}x##[error]y\"\n";
        let text = rendered(&input("a", text), &Renderer::plain());
        assert!(
            !text.contains(['\u{202e}']) && !text.contains("##["),
            "{text}"
        );
        assert!(text.contains("1 | a = \"   x# [error]y\""), "{text}");
    }
}
