//! Text: how it is set, and how much room it takes.

use super::frame::{Frame, Spot, number};
use super::paint::{GREY, INK};
use gearlash_files::characters::plain;
use svg::node::Blob;
use svg::node::element::Element;
use svg::node::{Node, Text};

/// Which part of a text stands at its place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Anchor {
    Start,
    Middle,
    End,
}

/// How a text is set.
#[derive(Debug, Clone, Copy)]
pub struct TextStyle {
    size: f64,
    colour: &'static str,
    anchor: Anchor,
    bold: bool,
}

/// Symbols of lengths as they stand in text, and as they are set: italic with a subscript.
const SYMBOLS: [(&str, &str); 2] = [("j_wt", "wt"), ("j_bn", "bn")];

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

    /// Second-rank.
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

    /// Width of `text`, or more.
    pub fn width(self, text: &str) -> f64 {
        // DejaVu Sans Bold is an eighth wider.
        let wider = if self.bold { 1.125 } else { 1.0 };
        wider * width(text, self.size)
    }

    /// `text` cut to `room` with an ellipsis where it is longer.
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

    /// Smaller where `text` is longer than `room`, but no smaller than `least`.
    pub fn fitted(self, text: &str, room: f64, least: f64) -> TextStyle {
        let width = self.width(text);
        match width > room {
            true => TextStyle {
                size: f64::max(self.size * room / width, least),
                ..self
            },
            false => self,
        }
    }

    /// How far below the middle of its capitals a text's baseline lies.
    pub fn below_middle(self) -> f64 {
        0.35 * self.size
    }

    /// A `<text>` at `at`, on its baseline. Characters that XML cannot hold become spaces.
    pub fn text(self, content: &str, at: Spot) -> Element {
        let mut element = self.element(at);
        element.append(Text::new(plain(content)));
        element
    }

    /// The same with the first `j_wt` or `j_bn` in it set as a symbol.
    pub fn symbols(self, content: &str, at: Spot) -> Element {
        let plain = plain(content);
        let Some((name, subscript)) = SYMBOLS.iter().find(|(name, _)| plain.contains(name)) else {
            return self.text(content, at);
        };
        let (before, after) = plain.split_once(name).unwrap_or_default();
        // A space at the start of a tspan is lost in some programs; a shift is kept.
        let shift = number(self.size * 0.3);
        let after = after.trim_start();
        let drop = number(self.size * 0.22);
        let mut element = self.element(at);
        element.append(Blob::new(format!(
            "{}<tspan font-style=\"italic\">j</tspan><tspan dy=\"{drop}\" font-size=\"{}\">{subscript}</tspan><tspan dx=\"{shift}\" dy=\"-{drop}\">{}</tspan>",
            Text::new(before),
            number(self.size * 0.72),
            Text::new(after),
        )));
        element
    }

    /// A text that can be read across a line: a white one with a thick outline, and itself over it. Two elements, since
    /// many readers draw an outline over its own text whatever `paint-order` says.
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

/// Width of a text at `size`.
///
/// Widths are those of DejaVu Sans, the widest of the usual sans-serif faces, rounded up, as no
/// font is there to ask.
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

/// Height of capitals and digits at `size`.
fn cap_height(size: f64) -> f64 {
    0.73 * size
}

/// The box of a text of `size` centred at `middle`.
pub fn room(text: &str, size: f64, middle: Spot) -> Frame {
    let (half, rise) = (0.5 * width(text, size), 0.5 * cap_height(size));
    Frame {
        left: middle[0] - half,
        top: middle[1] - rise,
        right: middle[0] + half,
        bottom: middle[1] + rise,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A title with U+FFFF made a snapshot that no parser reads.
    #[test]
    fn a_text_of_a_picture_is_xml() {
        let content = "a\u{ffff}b j_wt \u{1}<c>";
        let drawn = TextStyle::new(12.0).symbols(content, [0.0; 2]).to_string();
        let read = roxmltree::Document::parse(&drawn).unwrap();
        let words: String = read.descendants().filter_map(|node| node.text()).collect();
        assert!(words.contains("a b"), "{words}");
    }

    /// With `paint-order` some readers showed white blots in place of labels.
    #[test]
    fn a_halo_lies_below_its_text() {
        let drawn = TextStyle::new(12.0).haloed("least", [0.0; 2]);
        let [halo, text] = drawn.map(|element| element.to_string());
        assert!(halo.contains("stroke-width=\"3\"") && halo.contains("fill=\"#ffffff\""));
        assert!(!text.contains("stroke") && text.contains(INK));
        assert!(!halo.contains("paint-order"));
    }
}
