//! The legend: entries in rows.

use super::marks::bar;
use super::panel::{Entry, Swatch};
use crate::kit::{Frame, TextStyle, line, number};
use svg::node::Node;
use svg::node::element::Group;

/// Height of a row.
pub(super) const ROW: f64 = 19.0;
const NAMES: TextStyle = TextStyle::new(12.0);
/// Width of a sample.
const SAMPLE: f64 = 30.0;
/// Distance of a name from the left end of its entry.
const NAME: f64 = SAMPLE + 6.0;
/// Line spacing of a name.
const LINE: f64 = 14.0;

/// The legend between the edges `sides`, with the middle of its first row at `top`; and its number of rows.
pub(super) fn draw(entries: &[Entry], sides: [f64; 2], top: f64) -> (Group, usize) {
    let mut group = Group::new();
    // The next free place: row, and x.
    let (mut row, mut x) = (0, sides[0]);
    for entry in entries {
        let lines = NAMES.wrapped(&entry.name, sides[1] - sides[0] - NAME, 3);
        let width = NAME + NAMES.width(&lines[0]);
        if x > sides[0] && x + width > sides[1] {
            (row, x) = (row + 1, sides[0]);
        }
        let y = top + ROW * row as f64;
        draw_sample(entry, [x, y], &mut group);
        for (number, line) in lines.iter().enumerate() {
            let foot = y + LINE * number as f64 + NAMES.below_middle();
            group.append(NAMES.text(line, [x + NAME, foot]));
        }
        match lines.len() {
            1 => x += width + 18.0,
            more => (row, x) = (row + more, sides[0]),
        }
    }
    let rows = row + usize::from(x > sides[0]);
    (group, rows)
}

/// The sample of an entry, its left end at `[x, y]`.
fn draw_sample(entry: &Entry, [x, y]: [f64; 2], group: &mut Group) {
    let look = entry.look;
    let frame = Frame::new([x, y - 6.0], [x + SAMPLE, y + 6.0]);
    if let Swatch::Band(opacity) | Swatch::LineInBand(opacity) = entry.sample {
        let band = frame.rectangle().set("fill", look.colour());
        group.append(band.set("fill-opacity", number(opacity)));
    }
    match entry.sample {
        Swatch::Line | Swatch::LineInBand(_) => {
            let sample = line(&[[x, y], [x + SAMPLE, y]], look.colour(), 1.6);
            group.append(look.dashed(sample));
        }
        Swatch::Bar => group.append(bar(&frame, look)),
        Swatch::Dot => group.append(look.mark([x + 0.5 * SAMPLE, y])),
        Swatch::Band(_) => {}
    }
}
