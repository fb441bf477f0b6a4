//! Text in a picture: how much room it takes, and a place for it where nothing is.

use super::clip;
use super::sheet::{Frame, Spot};

/// Room a text takes: width and height of its capitals at `size`.
///
/// Widths are those of DejaVu Sans, the widest of the usual sans-serif faces, rounded up, as no
/// font is there to ask.
pub fn width(text: &str, size: f64) -> f64 {
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
pub fn cap_height(size: f64) -> f64 {
    0.73 * size
}

/// `text` cut to `room` with an ellipsis where it is longer.
pub fn shortened(text: &str, size: f64, room: f64) -> String {
    if width(text, size) <= room {
        return text.to_owned();
    }
    let mut kept = String::new();
    for c in text.chars() {
        if width(&kept, size) + width(&format!("{c}…"), size) > room {
            break;
        }
        kept.push(c);
    }
    kept + "…"
}

/// What labels keep clear of.
#[derive(Debug, Default)]
pub struct Occupied {
    lines: Vec<[Spot; 2]>,
    boxes: Vec<Frame>,
}

/// Clear room round a label, units of the sheet.
pub const CLEAR: f64 = 3.0;

impl Occupied {
    /// Takes the place of a line.
    pub fn line(&mut self, points: &[Spot]) {
        self.lines
            .extend(points.windows(2).map(|pair| [pair[0], pair[1]]));
    }

    /// Takes the place of a box's edge.
    pub fn border(&mut self, frame: Frame) {
        let Frame {
            left,
            top,
            right,
            bottom,
        } = frame;
        self.line(&[
            [left, top],
            [right, top],
            [right, bottom],
            [left, bottom],
            [left, top],
        ]);
    }

    /// Takes the place of a box.
    pub fn frame(&mut self, frame: Frame) {
        self.boxes.push(frame);
    }

    /// Whether a line meets any box.
    pub fn crosses_frame(&self, line: &[Spot; 2]) -> bool {
        let [from, to] = *line;
        let boxes = &mut self.boxes.iter();
        boxes.any(|taken| clip::segment(from, to, taken).is_some())
    }

    /// Whether nothing lies in `room` or within [`CLEAR`] of it.
    pub fn is_free(&self, room: &Frame) -> bool {
        self.is_clear(room, CLEAR)
    }

    /// Whether nothing lies in `room` or within `clear` of it.
    pub fn is_clear(&self, room: &Frame, clear: f64) -> bool {
        let room = room.grown(clear);
        !self.boxes.iter().any(|taken| taken.overlaps(&room))
            && !self
                .lines
                .iter()
                .any(|[from, to]| clip::segment(*from, *to, &room).is_some())
    }
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
