//! Places of keys in a TOML text, and its syntax errors.

use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue, Error};

/// Longest text in which places are searched, bytes. The search parses it a second time, and a parser takes a hundred times its
/// size (tuned: two gears of 10 000 teeth with every list written out have half as many).
const MAX_LOCATED: usize = 1 << 20;

/// The byte range in `text` of each of the dotted `keys`; `None`: not found.
///
/// A value has the range of key and value, a table that of its name. An absent key has that of the innermost table it belongs to.
/// Where `text` is no TOML, the empty keys have the ranges of its [`syntax_errors`], in order.
pub fn of_keys<'k>(text: &str, keys: impl Iterator<Item = &'k str>) -> Vec<Option<Range<usize>>> {
    if text.len() > MAX_LOCATED {
        return keys.map(|_| None).collect();
    }
    match DeTable::parse(text) {
        Ok(file) => keys.map(|key| in_table(file.get_ref(), key)).collect(),
        Err(_) => {
            let mut errors = syntax_errors(text).into_iter();
            let mut next = || errors.next().and_then(|error| error.span());
            keys.map(|key| key.is_empty().then(&mut next).flatten())
                .collect()
        }
    }
}

/// The line in `text` of each of the dotted `keys`, from 1. A key that is not there has the line of the innermost table.
pub fn lines_of_keys<'k>(text: &str, keys: impl Iterator<Item = &'k str>) -> Vec<Option<usize>> {
    let line = |span: Range<usize>| 1 + text[..span.start].matches('\n').count();
    let spans = of_keys(text, keys).into_iter();
    spans.map(|span| span.map(line)).collect()
}

/// The syntax errors of `text` in its order. Each line has one, as further errors mostly follow from the first. A text over the
/// limit has one in all.
pub fn syntax_errors(text: &str) -> Vec<Error> {
    if text.len() > MAX_LOCATED {
        return DeTable::parse(text).err().into_iter().collect();
    }
    let (_, mut errors) = DeTable::parse_recoverable(text);
    let ends: Vec<usize> = text.match_indices('\n').map(|(at, _)| at).collect();
    let start = |error: &Error| error.span().unwrap_or_default().start;
    errors.sort_by_cached_key(|error| start(error) as u64);
    errors.dedup_by_key(|error| ends.partition_point(|end| *end < start(error)));
    errors
}

fn in_table(mut table: &DeTable, path: &str) -> Option<Range<usize>> {
    let mut innermost = None;
    for segment in segments(path) {
        let entry = table.iter().find(|(name, _)| is_named(name, segment));
        let Some((name, value)) = entry else {
            break;
        };
        match value.get_ref() {
            DeValue::Table(inner) => {
                innermost = Some(name.span());
                table = inner;
            }
            _ => return Some(name.span().start..value.span().end),
        }
    }
    innermost
}

/// The keys of a dotted path. A dot in quotes is part of its key.
fn segments(path: &str) -> impl Iterator<Item = &str> {
    let mut quoted = false;
    path.split(move |c| {
        quoted ^= c == '"';
        c == '.' && !quoted
    })
}

/// Whether messages write the key `name` as `segment`: as it is, or in quotes.
fn is_named(name: &Spanned<toml::de::DeString>, segment: &str) -> bool {
    let name = name.get_ref().as_ref();
    name == segment || segment.starts_with('"') && format!("{name:?}") == segment
}

/// The dotted path of `name` in the table at `path`.
pub fn below(path: &str, name: &str) -> String {
    match path {
        "" => name.to_owned(),
        _ => format!("{path}.{name}"),
    }
}
