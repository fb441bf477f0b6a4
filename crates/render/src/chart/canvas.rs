//! Units, text styles and small marks on the backend's fine pixels.

use super::paint::{Look, Shape};
pub(super) use gearlash_files::characters::plain;
use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

/// Width of every chart, units of the `viewBox`: pixels on a screen, 0.22 mm across A4.
pub(super) const WIDTH: f64 = 800.0;
/// Left and right edge of what is drawn.
pub(super) const SIDES: [f64; 2] = [16.0, 784.0];
/// Pixels of the backend in a unit.
pub(super) const FINE: f64 = 10.0;

/// A part of the sheet.
pub(super) type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
/// What drawing ends with.
pub(super) type Drawn<T> = Result<T, DrawingAreaErrorKind<std::io::Error>>;

/// A text of `size` units.
pub(super) fn style(
    size: f64,
    colour: &'static RGBColor,
    across: HPos,
    up: VPos,
) -> TextStyle<'static> {
    // The backend divides sizes by 1.24.
    let font = ("sans-serif", size * FINE * 1.24).into_font();
    TextStyle::from(font)
        .color(colour)
        .pos(Pos::new(across, up))
}

/// A rectangle as a line: the backend draws an unfilled one without a width.
pub(super) fn closed<T: Copy>([(x0, y0), (x1, y1)]: [(T, T); 2]) -> [(T, T); 5] {
    [(x0, y0), (x1, y0), (x1, y1), (x0, y1), (x0, y0)]
}

/// Pixels of a length in units.
pub(super) fn fine(units: f64) -> i32 {
    (units * FINE).round() as i32
}

/// Pixels of a place.
pub(super) fn spot(x: f64, y: f64) -> (i32, i32) {
    (fine(x), fine(y))
}

/// A single value's mark.
pub(super) fn dot(area: &Area, (x, y): (i32, i32), look: Look) -> Drawn<()> {
    let r = fine(3.5);
    let stroke = look.colour().stroke_width(fine(1.4) as u32);
    match look.shape() {
        Shape::Disc => area.draw(&Circle::new((x, y), r, look.colour().filled())),
        Shape::Square => {
            let corners = [(x - r, y - r), (x + r, y + r)];
            area.draw(&Rectangle::new(corners, WHITE.filled()))?;
            area.draw(&PathElement::new(closed(corners).to_vec(), stroke))
        }
        Shape::Cross => {
            for tilt in [-r, r] {
                let line = vec![(x - r, y - tilt), (x + r, y + tilt)];
                area.draw(&PathElement::new(line, stroke))?;
            }
            Ok(())
        }
    }
}
