//! The legend: entries in rows.

use super::canvas::{Area, Drawn, SIDES, closed, dot, fine, plain, spot, style};
use super::paint::{INK, Look};
use super::panel::{Entry, Sample};
use crate::kit::labels;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, VPos};

/// Height of a row.
pub(super) const ROW: f64 = 19.0;

/// Row and left edge of each entry.
pub(super) fn flow(legend: &[Entry]) -> Vec<(usize, f64)> {
    let (mut row, mut x) = (0, SIDES[0]);
    let mut places = Vec::new();
    for entry in legend {
        let width = 40.0 + labels::width(&entry.name, 12.0);
        if x > SIDES[0] && x + width > SIDES[1] {
            (row, x) = (row + 1, SIDES[0]);
        }
        places.push((row, x));
        x += width + 14.0;
    }
    places
}

/// Draws one entry, its left end at `[x, y]`.
pub(super) fn entry(root: &Area, entry: &Entry, [x, y]: [f64; 2]) -> Drawn<()> {
    let colour = entry.look.colour();
    let boxed = [spot(x, y - 6.0), spot(x + 30.0, y + 6.0)];
    match entry.sample {
        Sample::Band(opacity) | Sample::LineInBand(opacity) => {
            root.draw(&Rectangle::new(boxed, colour.mix(opacity).filled()))?;
        }
        Sample::Bar => {
            let opacity = if entry.look == Look::Left { 0.25 } else { 1.0 };
            root.draw(&Rectangle::new(boxed, colour.mix(opacity).filled()))?;
            let outline = colour.stroke_width(fine(1.0) as u32);
            root.draw(&PathElement::new(closed(boxed).to_vec(), outline))?;
        }
        Sample::Dot => dot(root, spot(x + 15.0, y), entry.look)?,
        Sample::Line => {}
    }
    if matches!(entry.sample, Sample::Line | Sample::LineInBand(_)) {
        let [on, off] = entry.look.dash().unwrap_or([30.0, 1.0]);
        let mut from = 0.0;
        while from < 30.0 {
            let piece = vec![spot(x + from, y), spot(x + f64::min(from + on, 30.0), y)];
            root.draw(&PathElement::new(
                piece,
                colour.stroke_width(fine(1.6) as u32),
            ))?;
            from += on + off;
        }
    }
    let words = style(12.0, &INK, HPos::Left, VPos::Center);
    root.draw(&Text::new(plain(&entry.name), spot(x + 36.0, y), words))
}
