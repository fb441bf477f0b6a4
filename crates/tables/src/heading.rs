//! Meaning of a heading: the words of a column's own cell and of the group above it, and the unit.
//!
//! `headings.toml` holds the words: quantities, flanks, units and labels, in German and English. Every word must be known: "left limit" is not
//! a left flank.
//!
//! Words are in lower case there, without blanks and `-`, `_`, `.`, `:` in them; `#` stands for a number, as in "W3". Symbols are written as
//! they are: `fp` is the single pitch deviation, `Fp` the cumulative one, `FR` may be a right flank.

use super::column::{Column, Quantity};
use gearlash::gear::Side;
use gearlash_text::{Node, file_numbers};
use serde::{Deserialize, Deserializer};
use std::collections::{BTreeMap, HashMap, HashSet};
use std::sync::LazyLock;

type Set = HashSet<String>;

/// The words of `headings.toml`.
#[derive(Debug, Default, Deserialize)]
struct Vocabulary {
    #[serde(deserialize_with = "by_word")]
    symbols: HashMap<String, Quantity>,
    #[serde(deserialize_with = "by_word")]
    quantities: HashMap<String, Quantity>,
    flanks: Flanks,
    words: Words,
    #[serde(deserialize_with = "by_word")]
    units: HashMap<String, String>,
    statistics: Statistics,
}

#[derive(Debug, Default, Deserialize)]
struct Flanks {
    left: Set,
    right: Set,
    flank: Set,
}

#[derive(Debug, Default, Deserialize)]
struct Words {
    fillers: Set,
    ball: Set,
    diameter_sign: Set,
    counting: Set,
    no_unit: Set,
}

#[derive(Debug, Default, Deserialize)]
struct Statistics {
    symbols: Set,
    words: Set,
}

/// A test reads the file, too.
static VOCABULARY: LazyLock<Vocabulary> = LazyLock::new(|| {
    let words: toml::Table = include_str!("headings.toml").parse().unwrap_or_default();
    // Serde reads the types from the same tree as those of a pair file. To read them from TOML itself takes 70 kB of code more.
    Node::from(toml::Value::Table(words))
        .to()
        .unwrap_or_default()
});

/// Reads lists of words, one for each meaning, as the meaning of each word.
fn by_word<'de, D: Deserializer<'de>, T: Deserialize<'de> + Ord + Clone>(
    lists: D,
) -> Result<HashMap<String, T>, D::Error> {
    let lists = BTreeMap::<T, Vec<String>>::deserialize(lists)?;
    // The first meaning counts.
    let words = lists.into_iter().rev();
    let each = words
        .flat_map(|(meaning, words)| words.into_iter().map(move |word| (word, meaning.clone())));
    Ok(each.collect())
}

/// The unit in `text`, with or without brackets.
pub fn unit(text: &str) -> Option<&'static str> {
    let bare = text.trim().trim_start_matches(['(', '[']);
    let bare = bare.trim_end_matches([')', ']']).trim().to_lowercase();
    let bare = bare.strip_prefix("in ").unwrap_or(&bare);
    VOCABULARY.units.get(bare).map(String::as_str)
}

/// Whether `text` is a placeholder for no unit in a row of units.
pub fn is_no_unit(text: &str) -> bool {
    let bare = text.trim_matches(['(', ')', '[', ']', '.', ' ']);
    VOCABULARY.words.no_unit.contains(&bare.to_lowercase())
}

/// A heading without its unit and the diameter of its ball.
#[derive(Debug)]
pub struct Named {
    pub name: String,
    pub unit: Option<&'static str>,
    /// Diameter of a ball or pin, mm.
    pub ball_mm: Option<f64>,
}

/// Splits unit and diameter off a heading: `Fr (ball 2.5 mm) [µm]` has both.
pub fn named(text: &str) -> Named {
    let (rest, ball_mm) = without_ball(text).unzip();
    let (name, unit) = name_and_unit(rest.as_deref().unwrap_or(text));
    Named {
        name: name.to_owned(),
        unit,
        ball_mm,
    }
}

/// A heading with a length after a word for a ball: the rest, and the length, mm. `Kugel 2,5 mm` and `Ball D=2.75mm` have one.
fn without_ball(text: &str) -> Option<(String, f64)> {
    if !text.contains('m') || !text.contains(|c: char| c.is_ascii_digit()) {
        return None;
    }
    let separators = |c: char| c.is_whitespace() || "=:()[]".contains(c);
    let word = |part: &&str| !part.trim_end_matches(separators).is_empty();
    let parts: Vec<&str> = text.split_inclusive(separators).filter(word).collect();
    let words = parts.iter().map(|part| part.trim_end_matches(separators));
    let words: Vec<&str> = words.collect();
    let known = &VOCABULARY.words;
    let is_body = |word: &&str| {
        known.ball.contains(&plain(word)) || of_word(word) == Some(Quantity::OverPins)
    };
    let is_ball = |at: &usize| {
        let word = plain(words[*at]);
        let is_sign = known.diameter_sign.contains(&word);
        known.ball.contains(&word) || (is_sign && words[..*at].iter().any(is_body))
    };
    (0..words.len()).filter(is_ball).find_map(|at| {
        // The unit is in the word of the number, or in the next one.
        let lengths =
            (at + 2..=words.len().min(at + 3)).map(|end| (end, words[at + 1..end].concat()));
        let mut numbers = lengths.filter_map(|(end, length)| {
            let number = length.strip_suffix("mm")?;
            let mm = file_numbers::number(number)?.value;
            (mm > 0.0).then_some((end, mm))
        });
        let (end, mm) = numbers.next()?;
        Some((parts[..at].concat() + &parts[end..].concat(), mm))
    })
}

/// Splits the unit off a heading: `left (µm)`, `left [µm]`, `left_um` and `left / µm` have one. Other text in brackets is part of
/// the name.
fn name_and_unit(text: &str) -> (&str, Option<&'static str>) {
    let text = text.trim();
    for (open, close) in [('(', ')'), ('[', ']')] {
        if let Some((name, inner)) = text
            .strip_suffix(close)
            .and_then(|rest| rest.rsplit_once(open))
            && let Some(unit) = unit(inner)
        {
            return (name.trim(), Some(unit));
        }
    }
    let last = text.rsplit_once(|c: char| matches!(c, '_' | '/') || c.is_whitespace());
    match last.map(|(name, word)| (name, unit(word))) {
        Some((name, Some(unit))) => (name.trim_end_matches(['/', ' ']), Some(unit)),
        _ => (text, None),
    }
}

/// Meaning of `name`, without its unit, below the `group` heading; `None` where a word is unknown or two words contradict.
pub fn meaning(name: &str, group: Option<&str>) -> Option<Column> {
    let own = of_words(name);
    let Some(group) = group else { return own };
    match own.map(|own| own.quantity) {
        // Another quantity below the heading of a flank does not belong to the flank.
        Some(quantity) if quantity != Quantity::Unstated && !quantity.is_pitch() => own,
        _ => of_words(&format!("{group} {name}")),
    }
}

/// Whether `name` heads tooth numbers where the column counts 1, 2, 3.
pub fn is_counting(name: &str) -> bool {
    VOCABULARY.words.counting.contains(&plain(name))
}

/// The number of a tooth without a word before it: `7`, `Z7` and `Zahn 7`.
pub fn tooth_number(text: &str) -> &str {
    let number = text.trim_start_matches(|c: char| !c.is_ascii_digit());
    let word = &text[..text.len() - number.len()];
    if word.is_empty() {
        return text;
    }
    let is_known = is_counting(word) || of_word(word) == Some(Quantity::Tooth);
    if is_known { number } else { text }
}

/// The flank that a word or letter in a cell names.
pub fn side(text: &str) -> Option<Side> {
    match of_words(text) {
        Some(Column {
            side,
            quantity: Quantity::Unstated,
        }) => side,
        _ => letter(&plain(text)),
    }
}

/// One letter means a flank only beside a quantity or the word.
fn letter(word: &str) -> Option<Side> {
    match word {
        "l" => Some(Side::Left),
        "r" => Some(Side::Right),
        _ => None,
    }
}

fn of_words(name: &str) -> Option<Column> {
    if let Some(quantity) = VOCABULARY.quantities.get(&plain(name)) {
        return Some(Column::of(*quantity));
    }
    let (mut side, mut rest, mut has_flank) = (None, Vec::new(), false);
    let (mut is_letter, mut is_both) = (false, false);
    for part in parts(name) {
        let word = plain(part);
        let flanks = &VOCABULARY.flanks;
        if flanks.flank.contains(&word) {
            has_flank = true;
            continue;
        }
        let letter = letter(&word);
        is_letter |= letter.is_some();
        let found = if flanks.left.contains(&word) {
            Some(Side::Left)
        } else if flanks.right.contains(&word) {
            Some(Side::Right)
        } else {
            letter
        };
        match found {
            Some(found) => is_both |= side.replace(found).is_some_and(|side| side != found),
            None => rest.push(part),
        }
    }
    let meaning_of = |side, quantity| Some(Column { side, quantity });
    if is_both {
        // "Flanke L/R": each row names its flank.
        return meaning_of(None, Quantity::Flank).filter(|_| has_flank && rest.is_empty());
    }
    if rest.is_empty() {
        let quantity = if side.is_some() {
            Quantity::Unstated
        } else {
            Quantity::Flank
        };
        return meaning_of(side, quantity).filter(|_| has_flank || (side.is_some() && !is_letter));
    }
    if let Some(quantity) = of_word(&rest.concat()) {
        return meaning_of(side, quantity);
    }
    rest.retain(|word| !VOCABULARY.words.fillers.contains(&plain(word)));
    let is_number = |word: &&str| word.bytes().all(|b| b.is_ascii_digit());
    let number = match rest.iter().copied().filter(is_number).collect::<Vec<_>>()[..] {
        [] => None,
        [one] => Some(one.parse::<u32>().ok()?),
        _ => return None,
    };
    rest.retain(|word| !is_number(word));
    let mut found = of_word(&rest.concat());
    if found.is_some() {
        rest.clear();
    }
    for word in rest {
        let quantity = of_word(word)?;
        found = Some(match found {
            None => quantity,
            Some(before) if before == quantity => quantity,
            Some(Quantity::Pitch) if quantity.is_pitch() => quantity,
            Some(before) if quantity == Quantity::Pitch && before.is_pitch() => before,
            // "Rundlauf (Lücke)": of the probe in a space.
            Some(Quantity::Runout) if quantity == Quantity::Space => Quantity::Runout,
            Some(Quantity::Space) if quantity == Quantity::Runout => Quantity::Runout,
            Some(_) => return None,
        });
    }
    let quantity = match (found?, number) {
        (Quantity::OverPins, Some(3)) => Quantity::OverThreePins,
        (found @ Quantity::Span, _) | (found @ Quantity::OverPins, Some(2)) | (found, None) => {
            found
        }
        _ => return None,
    };
    meaning_of(side, quantity)
}

/// Whether a word of `name` is a space between teeth.
pub fn has_space(name: &str) -> bool {
    parts(name).any(|word| of_word(word) == Some(Quantity::Space))
}

/// The words of `name`: `Zahn-Nr.` and `W_k` are one each, `Fp-links` and `fpL` are two.
fn parts(name: &str) -> impl Iterator<Item = &str> {
    let separators = |c: char| c.is_whitespace() || "/,:=()[]|#".contains(c);
    let words = name.split(separators).flat_map(|word| {
        let is_one = word.contains(['-', '_']) && of_word(word).is_some();
        word.split(move |c| matches!(c, '-' | '_') && !is_one)
    });
    let words = words.flat_map(|word| {
        let symbol = word.strip_suffix(['L', 'R']);
        let symbol = symbol.filter(|symbol| VOCABULARY.symbols.contains_key(*symbol));
        let (one, other) = word.split_at(symbol.map_or(0, str::len));
        [one, other]
    });
    words.filter(|part| !part.is_empty())
}

fn of_word(word: &str) -> Option<Quantity> {
    // "F_r" is Fr.
    let symbol = word.trim_end_matches('.').replace('_', "");
    let symbol = VOCABULARY.symbols.get(&symbol);
    let plain = plain(word);
    let letters = plain.trim_end_matches(|c: char| c.is_ascii_digit());
    let known = |word: &str| VOCABULARY.quantities.get(word);
    let found = symbol.or_else(|| known(&plain));
    let numbered = || known(&format!("{letters}#")).filter(|_| letters.len() < plain.len());
    found.or_else(numbered).copied()
}

/// `name` in lower case without blanks, hyphens, underscores, points and colons.
pub fn plain(name: &str) -> String {
    let counts = |c: &char| !c.is_whitespace() && !matches!(c, '-' | '_' | '.' | ':');
    name.chars()
        .filter(counts)
        .flat_map(char::to_lowercase)
        .collect()
}

/// Whether `text` labels a line of statistics: `max`, `Fp max`, `σ (n−1)`, `Klasse 6`; a number alone is no label.
pub fn is_statistic(text: &str) -> bool {
    let Statistics { symbols, words } = &VOCABULARY.statistics;
    let (name, _) = name_and_unit(text);
    let separators = |c: char| c.is_whitespace() || "=()[]:".contains(c);
    let mut parts = name.split(separators).filter(|part| !part.is_empty());
    let is_label =
        |part: &str| symbols.contains(part.trim_end_matches('.')) || words.contains(&plain(part));
    let is_known = |part: &str| {
        is_label(part)
            || part.split(['-', '–', '/']).all(is_label)
            || part.bytes().all(|b| b.is_ascii_digit())
    };
    let mut has_word = false;
    let all = parts.all(|part| {
        has_word |= !part.starts_with(|c: char| c.is_ascii_digit());
        is_known(part)
    });
    words.contains(&plain(name)) || (all && has_word)
}

/// Whether `text` is not a tooth number but words, a date or all teeth: "Fp ges.", "i.O.", "Zahnweite W3", "12.03.2024", "1–44".
///
/// "Zahn 7" is one, too, unless it `may_be_tooth`: the line has values.
pub fn is_remark(text: &str, may_be_tooth: bool) -> bool {
    let begins = text.starts_with(|c: char| c.is_alphabetic());
    if begins && text.chars().filter(|c| c.is_alphabetic()).count() > 1 {
        let name = text.trim_end_matches(|c: char| c.is_ascii_digit() || " .:".contains(c));
        let quantity = of_words(name).map(|meaning| meaning.quantity);
        let is_place = matches!(
            quantity,
            Some(Quantity::Tooth | Quantity::Number | Quantity::Space | Quantity::FirstTooth)
        );
        return !(may_be_tooth && is_place && text.bytes().any(|b| b.is_ascii_digit()));
    }
    let ends: Vec<&str> = text.split(['-', '–', '…']).map(str::trim).collect();
    if let [first, last] = ends[..] {
        // All teeth: "1 – 44". A tooth is named by one number.
        return first == "1" && last.parse::<u32>().is_ok();
    }
    let parts: Vec<&str> = text.split(['.', '-', '/']).collect();
    let are_digits = parts
        .iter()
        .all(|part| part.bytes().all(|b| b.is_ascii_digit()));
    let lengths: Vec<usize> = parts.iter().map(|part| part.len()).collect();
    are_digits && (lengths == [2, 2, 4] || lengths == [4, 2, 2])
}
