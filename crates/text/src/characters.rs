//! Text from files, made fit for what shows it: a terminal, a log, a picture, a page, JSON.
//!
//! Titles, file names, keys and cells come from outside. A terminal, picture or page may act on some of their characters. Every
//! place that prints or writes such text passes it through [`plain`], JSON through [`json`].

use std::path::Path;

/// Whether `c` is unsafe: a terminal, picture or page acts on it, or cannot hold it.
///
/// Controls move a terminal's cursor, change its colours and end lines; so do the separators U+2028 and U+2029. Unicode's
/// `Bidi_Control` (PropList.txt; UAX #9) and the deprecated format characters beside it, U+206A to U+206F, turn the text behind them
/// round. XML 1.0 §2.2 (production `Char`) leaves out U+FFFE and U+FFFF, HTML all noncharacters.
fn is_unsafe(c: char) -> bool {
    let code = c as u32;
    c.is_control()
        || matches!(c, '\u{61C}' | '\u{200E}' | '\u{200F}' | '\u{2028}'..='\u{202E}' | '\u{2066}'..='\u{206F}')
        || (0xFDD0..=0xFDEF).contains(&code)
        || code & 0xFFFE == 0xFFFE
}

/// `text` on one line, with a space for each unsafe character, and as no command of a CI log.
///
/// GitHub's runner takes a line that begins with `::`, white space before it or not, as a command, and `##[…]` anywhere in a line;
/// Azure's takes `##vso[…]`, TeamCity's `##teamcity[…]`. A space goes between the two signs.
pub fn plain(text: &str) -> String {
    let mut plain: String = text
        .chars()
        .map(|c| if is_unsafe(c) { ' ' } else { c })
        .collect();
    if let Some(rest) = plain.trim_start().strip_prefix("::") {
        plain = format!(": :{rest}");
    }
    for second in signs_of_commands(&plain).into_iter().rev() {
        plain.insert(second, ' ');
    }
    plain
}

/// `text` as a cell of CSV: [`plain`], and no formula. A spreadsheet takes a cell that begins with `=`, `+`, `-` or `@` for one; an apostrophe before it
/// makes it text.
pub fn cell(text: &str) -> String {
    let cell = plain(text);
    if cell.trim_start().starts_with(['=', '+', '-', '@']) {
        format!("'{cell}")
    } else {
        cell
    }
}

/// Longest line of an error message, characters: a path as long as Linux allows (4096 bytes) and the message. No line should come
/// near it; a longer one is cut visibly.
const LONGEST_LINE: usize = 6000;

/// `text` as one line of a message: [`plain`] and not too long.
pub fn line(text: &str) -> String {
    cut(&plain(text), LONGEST_LINE)
}

/// `text` of a file, shown with its lines and at its byte offsets. Each byte of an unsafe character becomes a space, except
/// line ends. So does the second sign of a `##` that would begin a command of a CI log.
pub fn quoted_source(text: &str) -> String {
    let mut shown = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '\n' | '\t' => shown.push(c),
            c if is_unsafe(c) => shown.extend(std::iter::repeat_n(' ', c.len_utf8())),
            c => shown.push(c),
        }
    }
    for second in signs_of_commands(&shown) {
        shown.replace_range(second..second + 1, " ");
    }
    shown
}

/// The place of the second sign of each `##` in `text` that begins a command: a word or none follows, and a bracket.
fn signs_of_commands(text: &str) -> Vec<usize> {
    let word = |c: char| c.is_ascii_alphanumeric() || matches!(c, '-' | '_' | '.');
    let begins = |rest: &str| rest.trim_start_matches(word).starts_with('[');
    let seconds = text
        .match_indices('#')
        .filter(|(at, _)| text[..*at].ends_with('#'));
    let seconds = seconds.filter(|(at, _)| begins(&text[at + 1..]));
    seconds.map(|(at, _)| at).collect()
}

/// JSON `text` that reads the same, with every unsafe character, line ends between values excepted, and every `##` written as an
/// escape.
///
/// Outside strings JSON has no such characters, and inside them no line ends.
pub fn json(text: String) -> String {
    let unfit = |c: char| is_unsafe(c) && c != '\n';
    if !text.contains(unfit) && !text.contains("##") {
        return text;
    }
    let mut escaped = String::with_capacity(text.len() + 16);
    let mut before = ' ';
    for c in text.chars() {
        if unfit(c) || c == '#' && before == '#' {
            for unit in c.encode_utf16(&mut [0; 2]) {
                escaped += &format!("\\u{unit:04x}");
            }
        } else {
            escaped.push(c);
        }
        before = c;
    }
    escaped
}

/// The first `most` of `words`, and the number of others: "a, b and 3 more".
pub fn first_of(words: impl IntoIterator<Item = String>, most: usize) -> String {
    let mut words = words.into_iter();
    let first: Vec<String> = words.by_ref().take(most).collect();
    let first = first.join(", ");
    match words.count() {
        0 => first,
        more => format!("{first} and {more} more"),
    }
}

/// "a, b or c", with `last` before the last word.
pub fn listed(words: &[String], last: &str) -> String {
    match words.split_last() {
        Some((word, rest)) if !rest.is_empty() => format!("{} {last} {word}", rest.join(", ")),
        _ => words.concat(),
    }
}

/// `text` with at most `most` characters; a longer one is cut and ends with an ellipsis.
pub fn cut(text: &str, most: usize) -> String {
    match text.char_indices().nth(most) {
        Some((end, _)) => format!("{} …", &text[..end]),
        None => text.to_owned(),
    }
}

/// `path` as one word of a shell.
pub fn shell_word(path: &Path) -> String {
    let text = path.display().to_string();
    let is_plain = |c: char| c.is_alphanumeric() || "/._-+=:,@%".contains(c);
    if !text.is_empty() && text.chars().all(is_plain) {
        text
    } else {
        format!("'{}'", text.replace('\'', "'\\''"))
    }
}
