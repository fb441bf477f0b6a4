//! Drawing tools of all pictures: sheet, lines, texts, marks, axes and room for labels.
//!
//! Snapshots, maps and charts share them. They use the `svg` crate and only features of plain SVG readers: no script, no style
//! sheet, no `paint-order`. A text with a halo is two elements, and [`area`] describes the limits of clips.

pub mod clip;
mod frame;
mod marks;
mod occupied;
mod paint;
mod plot;
pub mod scale;
mod sheet;
mod text;

pub use frame::{Frame, Spot, number};
pub use marks::{around, arrow, cross, diamond, disc, dot, hatch, shaded, square, turned};
pub use occupied::{CLEAR, Occupied};
pub use paint::{ACTION, GAP, GREY, HATCH, INK, OVERLAP, PATH, PINION, WHEEL, dark_style};
pub use plot::{Axis, NUMBERS, Plot, axes, grid};
pub use sheet::{
    FONTS, HEIGHT, Ids, UNITS_PER_MM, WIDTH, area, blank_sheet, clipped, dashed, define_area,
    define_frame, group, in_page, inner_outline, line, path_data, polygon, within_area,
};
pub use text::{Anchor, TextStyle, room};
