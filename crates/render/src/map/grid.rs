//! A grid of shades over a phase and the centre distance, with lines across it and a legend.

use crate::kit::{self, Axis, Frame, GREY, INK, Plot, TextStyle, line, shaded};
use gearlash::analysis::diagnosis::Limit;
use gearlash_files::numbers::fixed;
use svg::node::Node;
use svg::node::element::{Group, SVG};

struct Layout {
    width: f64,
    field: Frame,
    /// Distance from the field to the legend: the axis, and the names of the limits where they are below.
    below: f64,
    across: usize,
    is_narrow: bool,
}

const WIDE: Layout = Layout {
    width: 900.0,
    field: Frame::new([90.0, 92.0], [560.0, 520.0]),
    below: 66.0,
    across: 3,
    is_narrow: false,
};

/// For a screen 390 pixels wide: the page has title and caption, and names of limits are below the field.
const NARROW: Layout = Layout {
    width: 390.0,
    field: Frame::new([66.0, 10.0], [380.0, 330.0]),
    below: 60.0,
    across: 1,
    is_narrow: true,
};

const ROW: f64 = 24.0;

const SMALL: TextStyle = TextStyle::new(12.0);

pub struct Grid<'a> {
    /// Centre distances of the rows, mm, ascending.
    pub distances: &'a [f64],
    pub columns: usize,
    pub phase: Axis,
    pub limits: &'a [Limit],
    /// Colours and names; the legend shows those that occur.
    pub shades: Vec<(&'static str, String)>,
    /// The index of each cell's shade, row by row.
    pub cells: Vec<usize>,
}

impl Grid<'_> {
    /// The map with `title` and `caption` (the pair), the field and its legend.
    pub fn picture(&self, title: &str, caption: &str) -> SVG {
        let left = WIDE.field.left;
        self.drawn(&WIDE)
            .add(TextStyle::new(18.0).verbatim(title, [left, 34.0]))
            .add(SMALL.grey().text(caption, [left, 58.0]))
    }

    /// The field and its legend for a screen 390 pixels wide; the page has the caption.
    pub fn narrow(&self) -> SVG {
        self.drawn(&NARROW)
    }

    fn drawn(&self, layout: &Layout) -> SVG {
        let legend = self.used();
        let rows = legend.len().div_ceil(layout.across).max(2);
        let limits = if layout.is_narrow {
            self.limits.len()
        } else {
            0
        };
        let height = layout.field.bottom + layout.below + ROW * (rows + limits) as f64 + 6.0;
        kit::blank_sheet(layout.width, height)
            .add(self.drawn_cells(&layout.field))
            .add(layout.field.border())
            .add(self.axes(layout))
            .add(self.drawn_limits(layout, rows))
            .add(legend_of(&legend, layout))
    }

    fn drawn_cells(&self, field: &Frame) -> Group {
        let rows = self.cells.chunks(self.columns.max(1)).rev();
        let shades = rows.map(|row| row.iter().map(|shade| self.shades[*shade].0).collect());
        shaded(field, &shades.collect::<Vec<Vec<&str>>>())
    }

    /// The field in data: the phase to the right, the centre distance upwards.
    fn plot(&self, field: Frame) -> Plot {
        let first = self.distances.first().copied().unwrap_or_default();
        let last = self.distances.last().copied().unwrap_or_default();
        let half = 0.5 * (last - first) / (self.distances.len().max(2) - 1) as f64;
        Plot {
            left: field.left,
            right: field.right,
            top: field.top,
            bottom: field.bottom,
            x: self.phase.range,
            y: [first - half, last + half],
        }
    }

    fn axes(&self, layout: &Layout) -> Group {
        let plot = self.plot(layout.field);
        let y = Axis::new("centre distance a, mm", plot.y);
        let ticks = if layout.is_narrow { [4, 8] } else { [6, 10] };
        kit::axes(&plot, [&self.phase, &y], ticks)
    }

    /// Lines across the field. Their names are on the right, moved apart where they would collide. On a narrow screen they are
    /// below the `rows` of the legend, the uppermost first.
    fn drawn_limits(&self, layout: &Layout, rows: usize) -> Group {
        const LABEL_SPACING: f64 = 17.0;
        let field = layout.field;
        let (plot, mut group) = (self.plot(field), Group::new());
        // From top to bottom.
        let named: Vec<(f64, String)> = self
            .limits
            .iter()
            .rev()
            .map(|limit| {
                let label = format!("{} {}", fixed(limit.distance, 4), limit.name);
                (plot.spot((0.0, limit.distance))[1], label)
            })
            .collect();
        let inside = |y: f64| y <= field.bottom;
        let mut heights: Vec<f64> = named.iter().map(|(y, _)| *y).collect();
        // Pushed down below the one above, then up from the bottom.
        for i in 1..heights.len() {
            heights[i] = heights[i].max(heights[i - 1] + LABEL_SPACING);
        }
        let mut lowest = field.bottom + 2.0 * LABEL_SPACING;
        for height in heights.iter_mut().rev() {
            *height = height.min(lowest);
            lowest = *height - LABEL_SPACING;
        }
        for (number, ((y, label), at)) in named.iter().zip(heights).enumerate() {
            let spot = if layout.is_narrow {
                let down = (rows + number) as f64 * ROW;
                [10.0, field.bottom + layout.below + down + 11.5]
            } else {
                [field.right + 25.0, at + 4.0]
            };
            if !inside(*y) {
                let label = format!("{label}: below the map");
                group.append(SMALL.grey().text(&label, spot));
                continue;
            }
            let own = label.contains("a of the pair");
            let mut across = line(
                &[[field.left, *y], [field.right, *y]],
                INK,
                if own { 2.0 } else { 1.0 },
            );
            if !own {
                across = across.set("stroke-dasharray", "6 3");
            }
            // A light line under a dark one is visible on any shade.
            let halo = line(&[[field.left, *y], [field.right, *y]], "#ffffff", 3.0);
            group.append(halo.set("stroke-opacity", "0.60"));
            group.append(across);
            if !layout.is_narrow {
                let [x, far] = [field.right, field.right + 20.0];
                group.append(line(&[[x, *y], [x + 12.0, at], [far, at]], GREY, 0.8));
            }
            group.append(SMALL.text(label, spot));
        }
        group
    }

    fn used(&self) -> Vec<&(&'static str, String)> {
        let used = |(number, shade)| self.cells.contains(&number).then_some(shade);
        self.shades.iter().enumerate().filter_map(used).collect()
    }
}

/// Samples of the shades in `used`.
fn legend_of(used: &[&(&'static str, String)], layout: &Layout) -> Group {
    let mut group = Group::new();
    for (i, (colour, name)) in used.iter().enumerate() {
        let start = if layout.is_narrow {
            10.0
        } else {
            layout.field.left
        };
        let left = start + (i % layout.across) as f64 * 250.0;
        let top = layout.field.bottom + layout.below + (i / layout.across) as f64 * ROW;
        let frame = Frame::new([left, top], [left + 22.0, top + 14.0]);
        group.append(frame.painted(colour, GREY, "0.8"));
        group.append(TextStyle::new(13.0).text(name, [left + 30.0, top + 11.5]));
    }
    group
}
