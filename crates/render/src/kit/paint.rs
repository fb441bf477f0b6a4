//! Colours, on paper and on a dark page.
//!
//! They are distinguished by lightness first, so that they survive black-and-white print: metal light, gap medium, overlap dark
//! and hatched. Only green and red are easily confused; those two differ in lightness and hatching.

use std::collections::BTreeSet;
use std::fmt::Write;

/// Lines and text.
pub const INK: &str = "#1b1f24";
/// Second-rank text and thin lines.
pub const GREY: &str = "#565d66";
pub const GRID: &str = "#d5d9de";
pub const WHEEL: &str = "#dde2e8";
pub const PINION: &str = "#f3ead9";
/// Gap between facing flanks.
pub const GAP: &str = "#6cc5a8";
/// Overlap, under its hatching.
pub const OVERLAP: &str = "#e0402c";
/// Hatching of an overlap, and the edge of its label.
pub const HATCH: &str = "#5a0d05";
/// Line of action and path of contact.
pub const ACTION: &str = "#0072b2";
/// Band of the path of contact.
pub const PATH: &str = "#9ccbe8";

/// The `<style>` element that shows the pictures in `text` on a dark screen: each colour becomes another. A picture on its own has no
/// style sheet, and prints as drawn.
pub fn dark_style(text: &str) -> String {
    let mut found = BTreeSet::new();
    for property in ["fill", "stroke"] {
        let before = format!(" {property}=\"");
        for rest in text.split(before.as_str()).skip(1) {
            let colour = rest.split('"').next().unwrap_or_default();
            found.extend(rgb(colour).map(|rgb| (property, colour, rgb)));
        }
    }
    let mut rules = String::new();
    for (property, colour, paper) in found {
        let [r, g, b] = dark(paper);
        let _ = write!(
            rules,
            "[{property}=\"{colour}\"]{{{property}:#{r:02x}{g:02x}{b:02x}}}"
        );
    }
    format!("<style>@media screen and (prefers-color-scheme: dark){{{rules}}}</style>")
}

/// Red, green and blue of a colour as pictures state it.
fn rgb(colour: &str) -> Option<[u8; 3]> {
    if colour == "white" {
        return Some([255; 3]);
    }
    let digits = colour
        .strip_prefix('#')
        .filter(|digits| digits.len() == 6)?;
    let [_, r, g, b] = u32::from_str_radix(digits, 16).ok()?.to_be_bytes();
    Some([r, g, b])
}

/// A colour of the same hue with light and dark exchanged: invert(.92) and hue-rotate(180deg) of CSS filters (W3C, Filter Effects 1). White becomes
/// the paper of the dark page.
fn dark(paper: [u8; 3]) -> [u8; 3] {
    let [r, g, b] = paper.map(|part| 0.92 - 0.84 * f64::from(part) / 255.0);
    let turned = [
        -0.574 * r + 1.430 * g + 0.144 * b,
        0.426 * r + 0.430 * g + 0.144 * b,
        0.426 * r + 1.430 * g - 0.856 * b,
    ];
    turned.map(|part| (255.0 * part).round().clamp(0.0, 255.0) as u8)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Source: the style of the page, whose paper is #141414.
    #[test]
    fn each_colour_has_a_rule() {
        let style = dark_style(
            "<path fill=\"white\" stroke=\"#1b1f24\"/><path fill=\"white\"/><path fill=\"none\"/>",
        );
        assert_eq!(style.matches("fill:").count(), 1);
        assert!(style.contains("[fill=\"white\"]{fill:#141414}"), "{style}");
        assert!(style.contains("[stroke=\"#1b1f24\"]{stroke:#"), "{style}");
    }
}
