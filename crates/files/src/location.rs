//! Where in a TOML text the keys of problems stand.

use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// Bytes of a text in which places are looked for: it is parsed for that a second time, and a parser takes a hundred times its size
/// (tuned: two gears of 10 000 teeth with every list written out have half as many).
const MOST_LOCATED: usize = 1 << 20;

/// Bytes of `text` at which each of the dotted `keys` stands, key and value; of a table its name; of a key that is not there the
/// innermost table it should stand in. An empty key means the syntax error of a text that is no TOML. `None`: nowhere.
pub fn of_keys<'k>(text: &str, keys: impl Iterator<Item = &'k str>) -> Vec<Option<Range<usize>>> {
    if text.len() > MOST_LOCATED {
        return keys.map(|_| None).collect();
    }
    match DeTable::parse(text) {
        Ok(file) => keys.map(|key| in_table(file.get_ref(), key)).collect(),
        Err(error) => {
            let syntax = |key: &str| error.span().filter(|_| key.is_empty());
            keys.map(syntax).collect()
        }
    }
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

/// The keys of a dotted path, a dot in quotes being part of its key.
fn segments(path: &str) -> impl Iterator<Item = &str> {
    let mut quoted = false;
    path.split(move |c| {
        quoted ^= c == '"';
        c == '.' && !quoted
    })
}

/// Whether `name` is what a message calls `segment`: as it stands, or in quotes.
fn is_named(name: &Spanned<toml::de::DeString>, segment: &str) -> bool {
    let name = name.get_ref().as_ref();
    name == segment || segment.starts_with('"') && format!("{name:?}") == segment
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "title = \"a\"\n[wheel]\nteeth = 44\nspan = { teeth = 6, mm = 50.5 }\n\"a.b\" = 1\n[wheel.runout]\ntotal_um = 3\n";

    fn at(key: &str) -> Option<&'static str> {
        of_keys(TEXT, [key].into_iter())[0]
            .clone()
            .map(|span| &TEXT[span])
    }

    #[test]
    fn a_key_stands_where_it_is_written() {
        assert_eq!(at("title"), Some("title = \"a\""));
        assert_eq!(at("wheel.teeth"), Some("teeth = 44"));
        assert_eq!(at("wheel.span.mm"), Some("mm = 50.5"));
        assert_eq!(at("wheel.\"a.b\""), Some("\"a.b\" = 1"));
        assert_eq!(at("wheel.runout.total_um"), Some("total_um = 3"));
    }

    #[test]
    fn a_missing_key_stands_in_its_table() {
        assert_eq!(at("wheel.module_mm"), Some("wheel"));
        assert_eq!(at("wheel.runout.high_tooth"), Some("runout"));
        assert_eq!(at("wheel.span.min_mm"), Some("span"));
        assert_eq!(at("pinion.teeth"), None);
        assert_eq!(at(""), None);
    }

    #[test]
    fn a_syntax_error_has_its_place() {
        let spans = of_keys("a = 1\nb = x\n", ["", "a"].into_iter());
        assert_eq!(spans[0], Some(10..11));
        assert_eq!(spans[1], None);
    }
}
