//! Text: its style, and the room it takes.

use super::frame::{Frame, Spot, number};
use super::paint::{GREY, INK};
use gearlash_text::characters::plain;
use svg::node::element::Element;
use svg::node::{Blob, Node, Text};

/// The part of a text at its place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Anchor {
    Start,
    Middle,
    End,
}

#[derive(Debug, Clone, Copy)]
pub struct TextStyle {
    size: f64,
    colour: &'static str,
    anchor: Anchor,
    bold: bool,
}

/// Symbols as written in text; they are set italic with a subscript.
const SYMBOLS: [&str; 10] = [
    "j_wt", "j_bn", "j_bt", "f_p", "f_u", "F_p", "F_r", "F_i", "f_i", "M_dK",
];
/// The start of a span's symbol; the number of teeth spanned follows.
const SPAN: &str = "W_";

impl TextStyle {
    /// Dark text of `size` that starts at its place.
    pub const fn new(size: f64) -> TextStyle {
        TextStyle {
            size,
            colour: INK,
            anchor: Anchor::Start,
            bold: false,
        }
    }

    pub const fn colour(self, colour: &'static str) -> TextStyle {
        TextStyle { colour, ..self }
    }

    pub const fn grey(self) -> TextStyle {
        self.colour(GREY)
    }

    pub const fn bold(self) -> TextStyle {
        TextStyle { bold: true, ..self }
    }

    pub const fn anchored(self, anchor: Anchor) -> TextStyle {
        TextStyle { anchor, ..self }
    }

    pub const fn middle(self) -> TextStyle {
        self.anchored(Anchor::Middle)
    }

    pub const fn end(self) -> TextStyle {
        self.anchored(Anchor::End)
    }

    /// An upper bound of the width of `text`.
    pub fn width(self, text: &str) -> f64 {
        // DejaVu Sans Bold is an eighth wider.
        let wider = if self.bold { 1.125 } else { 1.0 };
        wider * width(text, self.size)
    }

    /// `text`, cut to `room` with an ellipsis where it is longer.
    pub fn shortened(self, text: &str, room: f64) -> String {
        if self.width(text) <= room {
            return text.to_owned();
        }
        let mut kept = String::new();
        for c in text.chars() {
            if self.width(&kept) + self.width(&format!("{c}…")) > room {
                break;
            }
            kept.push(c);
        }
        kept + "…"
    }

    /// `text` in lines no wider than `room`, broken at spaces. There are at most `most` lines; the last is cut as by
    /// [`Self::shortened`].
    pub fn wrapped(self, text: &str, room: f64, most: usize) -> Vec<String> {
        let mut lines = vec![String::new()];
        for word in text.split(' ') {
            let full = lines.len() == most;
            if let Some(line) = lines.last_mut() {
                let longer = if line.is_empty() {
                    word.to_owned()
                } else {
                    format!("{line} {word}")
                };
                if full || line.is_empty() || self.width(&longer) <= room {
                    *line = longer
                } else {
                    lines.push(word.to_owned())
                }
            }
        }
        let lines = lines.iter();
        lines.map(|line| self.shortened(line, room)).collect()
    }

    /// A smaller size where `text` is longer than `room`, but at least `least`.
    pub fn fitted(self, text: &str, room: f64, least: f64) -> TextStyle {
        let width = self.width(text);
        if width > room {
            TextStyle {
                size: f64::max(self.size * room / width, least),
                ..self
            }
        } else {
            self
        }
    }

    /// Distance of a text's baseline below the middle of its capitals.
    pub fn below_middle(self) -> f64 {
        0.35 * self.size
    }

    /// A `<text>` at `at`, on its baseline, with symbols. Characters that XML cannot hold become spaces.
    ///
    /// With symbols the anchor is always the start, moved by the width: LibreOffice anchors each tspan by itself.
    pub fn text(self, content: &str, at: Spot) -> Element {
        let content = plain(content);
        if next_symbol(&content).is_none() {
            return self.verbatim(&content, at);
        }
        let before = match self.anchor {
            Anchor::Start => 0.0,
            Anchor::Middle => 0.5,
            Anchor::End => 1.0,
        };
        let start = [at[0] - before * self.width(&content), at[1]];
        let mut element = self.anchored(Anchor::Start).element(start);
        element.append(Blob::new(self.with_symbols(&content)));
        element
    }

    /// A `<text>` with a user's words, without symbols.
    pub fn verbatim(self, content: &str, at: Spot) -> Element {
        let mut element = self.element(at);
        element.append(Text::new(plain(content)));
        element
    }

    /// The content of a `<text>` with symbols.
    fn with_symbols(self, content: &str) -> String {
        let (drop, small) = (number(self.size * 0.22), number(self.size * 0.72));
        let (mut rest, mut set) = (content, String::new());
        while let Some((before, letter, subscript, after)) = next_symbol(rest) {
            // LibreOffice drops a breaking space before a tspan; a no-break space stays.
            let before = &match before.strip_suffix(' ') {
                Some(before) => format!("{before}\u{a0}"),
                None => before.to_owned(),
            };
            set += &self.after_symbol(before, !set.is_empty());
            let rise = if set.is_empty() || !before.is_empty() {
                String::new()
            } else {
                format!(" dy=\"-{drop}\"")
            };
            set += &format!(
                "<tspan font-style=\"italic\"{rise}>{letter}</tspan><tspan dy=\"{drop}\" font-size=\"{small}\">{subscript}</tspan>"
            );
            rest = after;
        }
        set + &self.after_symbol(rest, true)
    }

    /// Text after a symbol, back on the baseline after a subscript.
    fn after_symbol(self, text: &str, lowered: bool) -> String {
        if !lowered || text.is_empty() {
            return Text::new(text).to_string();
        }
        let drop = number(self.size * 0.22);
        // Some programs drop a space at the start of a tspan; a shift is kept.
        let (shift, text) = match text.strip_prefix(' ') {
            Some(text) => (format!(" dx=\"{}\"", number(self.size * 0.3)), text),
            None => (String::new(), text),
        };
        format!("<tspan{shift} dy=\"-{drop}\">{}</tspan>", Text::new(text))
    }

    /// A text that is readable across a line: white with a thick outline, then itself over it. There are two elements, because
    /// many readers draw an outline over its own text despite `paint-order`.
    pub fn haloed(self, content: &str, at: Spot) -> [Element; 2] {
        let mut halo = self.colour("#ffffff").text(content, at);
        halo.assign("stroke", "#ffffff");
        halo.assign("stroke-width", "3");
        halo.assign("stroke-linejoin", "round");
        halo.assign("aria-hidden", "true");
        [halo, self.text(content, at)]
    }

    fn element(self, at: Spot) -> Element {
        let mut element = Element::new("text");
        element.assign("x", number(at[0]));
        element.assign("y", number(at[1]));
        element.assign("font-size", number(self.size));
        element.assign("fill", self.colour);
        match self.anchor {
            Anchor::Start => {}
            Anchor::Middle => element.assign("text-anchor", "middle"),
            Anchor::End => element.assign("text-anchor", "end"),
        }
        if self.bold {
            element.assign("font-weight", "bold");
        }
        element
    }
}

/// The text before the first symbol, its letter and subscript, and the text after it.
fn next_symbol(text: &str) -> Option<(&str, &str, &str, &str)> {
    let span = text.find(SPAN).map(|at| {
        let digits = text[at + SPAN.len()..].chars();
        let digits = digits.take_while(char::is_ascii_digit).count();
        &text[at..at + SPAN.len() + digits]
    });
    let span = span.filter(|span| span.len() > SPAN.len());
    let found = SYMBOLS.into_iter().chain(span).filter_map(|symbol| {
        let at = text.find(symbol)?;
        let (before, after) = (&text[..at], &text[at + symbol.len()..]);
        let part = |c: char| c.is_alphanumeric() || c == '_';
        // Not inside a word, as in a title or a file's name.
        (!before.ends_with(part) && !after.starts_with(part)).then_some((before, symbol, after))
    });
    let (before, symbol, after) = found.min_by_key(|(before, ..)| before.len())?;
    let (letter, subscript) = symbol.split_once('_')?;
    Some((before, letter, subscript, after))
}

/// Width of a text at `size`.
///
/// Widths are those of DejaVu Sans, the widest of the usual sans-serif faces, rounded up; no font is loaded.
fn width(text: &str, size: f64) -> f64 {
    let em: f64 = text
        .chars()
        .map(|c| match c {
            'i' | 'j' | 'l' | '.' | ',' | ':' | ';' | '|' | '\'' | 'I' | ' ' | '·' => 0.35,
            'f' | 't' | 'r' | '(' | ')' | '-' | '/' => 0.42,
            'm' | 'w' | 'M' | 'W' | '@' | '%' | '…' | '±' | '≤' | '−' | '=' | '—' => 1.0,
            'A'..='Z' => 0.78,
            ' '..='~' | '–' | 'µ' => 0.65,
            _ => 1.0,
        })
        .sum();
    em * size
}

/// Height of capitals and digits, as a share of the size.
const CAP_HEIGHT: f64 = 0.73;

/// The box of a text of `size` centred at `middle`.
pub fn room(text: &str, size: f64, middle: Spot) -> Frame {
    let (half, rise) = (0.5 * width(text, size), 0.5 * (CAP_HEIGHT * size));
    let [x, y] = middle;
    Frame::new([x - half, y - rise], [x + half, y + rise])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Axes and captions named symbols as a file does: j_wt.
    #[test]
    fn symbols_have_their_subscripts_and_the_text_after_them_its_baseline() {
        let content = "F_p 3, f_p 1 µm, my_f_p_file";
        let drawn = TextStyle::new(10.0).text(content, [0.0; 2]).to_string();
        let read = roxmltree::Document::parse(&drawn).unwrap();
        let spans = read.descendants().filter(|node| node.has_tag_name("tspan"));
        let shown = spans.map(|node| {
            let dy = node.attribute("dy").unwrap_or("0");
            format!("{} {}", dy, node.text().unwrap().trim())
        });
        let shown = shown.collect::<Vec<_>>().join("|");
        assert_eq!(
            shown,
            "0 F|2.20 p|-2.20 3,|0 f|2.20 p|-2.20 1 µm, my_f_p_file"
        );
    }

    /// LibreOffice 7.4 took the space before a symbol away, and put each tspan of an anchored text at the text's own place.
    #[test]
    fn a_text_with_symbols_starts_where_it_stands_and_keeps_its_space() {
        for (anchor, least, most) in [(Anchor::Middle, -60.0, -40.0), (Anchor::End, -120.0, -80.0)]
        {
            // 16 letters of DejaVu Sans at 10 units: about 0.6 em each.
            let style = TextStyle::new(10.0).anchored(anchor);
            let drawn = style.text("backlash j_wt, µm", [0.0; 2]).to_string();
            assert!(!drawn.contains("text-anchor"), "{drawn}");
            let read = roxmltree::Document::parse(&drawn).unwrap();
            let x: f64 = read.root_element().attribute("x").unwrap().parse().unwrap();
            assert!((least..most).contains(&x), "{x}");
            assert!(drawn.contains("backlash\u{a0}<tspan"), "{drawn}");
        }
    }
}
