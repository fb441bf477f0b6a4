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

/// The legend between the edges `sides`, the middle of its first row at `top`, and how many rows it has.
pub(super) fn draw(entries: &[Entry], sides: [f64; 2], top: f64) -> (Group, usize) {
    let (mut row, mut x) = (0, sides[0]);
    let mut group = Group::new();
    for entry in entries {
        let width = SAMPLE + 10.0 + NAMES.width(&entry.name);
        if x > sides[0] && x + width > sides[1] {
            (row, x) = (row + 1, sides[0]);
        }
        let y = top + ROW * f64::from(row);
        draw_entry(entry, [x, y], &mut group);
        x += width + 14.0;
    }
    let rows = if entries.is_empty() {
        0
    } else {
        row as usize + 1
    };
    (group, rows)
}

/// One entry, its left end at `[x, y]`.
fn draw_entry(entry: &Entry, [x, y]: [f64; 2], group: &mut Group) {
    let look = entry.look;
    let frame = Frame {
        left: x,
        right: x + SAMPLE,
        top: y - 6.0,
        bottom: y + 6.0,
    };
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
    group.append(NAMES.text(&entry.name, [x + SAMPLE + 6.0, y + NAMES.below_middle()]));
}
