//! Colours.
//!
//! They are distinguished by lightness first, so that they survive black-and-white print: metal light, gap medium, overlap dark
//! and hatched. Only green and red are easily confused; those two differ in lightness and hatching.

/// Lines and text.
pub const INK: &str = "#1b1f24";
/// Second-rank text and thin lines.
pub const GREY: &str = "#565d66";
/// Grid of a plot.
pub const GRID: &str = "#d5d9de";
/// Wheel metal.
pub const WHEEL: &str = "#dde2e8";
/// Pinion metal.
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
