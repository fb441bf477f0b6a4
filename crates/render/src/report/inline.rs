//! An SVG picture as part of a page: ids of its own, a name for screen readers.

use crate::error::PictureError;
use crate::snapshot::PAPER_NOTE;
use quick_xml::events::attributes::Attribute;
use quick_xml::events::{BytesStart, Event};
use quick_xml::{Reader, Writer};
use std::borrow::Cow;

/// `svg` with `prefix` before each of its ids and wherever one is referred to, called `label`.
///
/// # Errors
/// [`PictureError`] for what is no XML: none for a picture gearlash drew.
pub(super) fn inline(svg: &str, prefix: &str, label: &str) -> Result<String, PictureError> {
    let unreadable = |error: String| PictureError(format!("a picture is not well-formed: {error}"));
    let mut reader = Reader::from_str(svg);
    let mut writer = Writer::new(Vec::new());
    loop {
        let event = match reader.read_event().map_err(|e| unreadable(e.to_string()))? {
            Event::Eof => break,
            Event::Decl(_) | Event::DocType(_) => continue,
            // A page shows pictures at any size.
            Event::Text(text) if text.trim() == PAPER_NOTE => continue,
            Event::Start(tag) => Event::Start(renamed(&tag, prefix, label).map_err(unreadable)?),
            Event::Empty(tag) => Event::Empty(renamed(&tag, prefix, label).map_err(unreadable)?),
            other => other,
        };
        writer
            .write_event(event)
            .map_err(|e| unreadable(e.to_string()))?;
    }
    String::from_utf8(writer.into_inner()).map_err(|e| unreadable(e.to_string()))
}

fn renamed(tag: &BytesStart, prefix: &str, label: &str) -> Result<BytesStart<'static>, String> {
    let name = tag.name().into_inner().to_owned();
    let mut renamed = BytesStart::new(name.clone());
    for attribute in tag.attributes() {
        let attribute = attribute.map_err(|error| error.to_string())?;
        let value = attribute.value;
        let value = match attribute.key.as_ref() {
            "id" => format!("{prefix}-{value}"),
            "href" => value.replacen('#', &format!("#{prefix}-"), 1),
            _ => value.replace("url(#", &format!("url(#{prefix}-")),
        };
        // As it stands: it is escaped already.
        renamed.push_attribute(Attribute {
            key: attribute.key,
            value: Cow::Owned(value),
        });
    }
    if name == "svg" {
        renamed.push_attribute(("role", "img"));
        renamed.push_attribute(("aria-label", label));
    }
    Ok(renamed)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ids_and_what_refers_to_them_get_the_prefix() {
        let svg = r##"<svg xmlns="http://www.w3.org/2000/svg"><path id="a"/><g clip-path="url(#a)"><use href="#a"/></g><text>id="a" url(#a) &lt;b&gt;</text></svg>"##;
        assert_eq!(
            inline(svg, "p", "a < b").unwrap(),
            r##"<svg xmlns="http://www.w3.org/2000/svg" role="img" aria-label="a &lt; b"><path id="p-a"/><g clip-path="url(#p-a)"><use href="#p-a"/></g><text>id="a" url(#a) &lt;b&gt;</text></svg>"##
        );
        assert!(inline("<svg><g></svg>", "p", "").is_err());
    }
}
