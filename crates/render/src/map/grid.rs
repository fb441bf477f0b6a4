//! A grid of shades over a phase and the centre distance, with lines across it and a legend.

use crate::kit::{self, Axis, Frame, GREY, INK, Plot, TextStyle, line};
use gearlash::analysis::diagnosis::Limit;
use gearlash_files::numbers::fixed;
use svg::node::Node;
use svg::node::element::{Group, SVG};

const WIDTH: f64 = 900.0;
const FIELD: Frame = Frame {
    left: 90.0,
    top: 92.0,
    right: 560.0,
    bottom: 520.0,
};
/// From the field to the legend, and of its rows.
const BELOW: f64 = 66.0;
const ROW: f64 = 24.0;

const SMALL: TextStyle = TextStyle::new(12.0);

/// What is drawn.
pub struct Grid<'a> {
    /// Centre distances of the rows, mm, rising.
    pub distances: &'a [f64],
    pub columns: usize,
    pub phase: Axis,
    /// What is drawn across.
    pub limits: &'a [Limit],
    /// Colours and names; those that occur stand in the legend.
    pub shades: Vec<(&'static str, String)>,
    /// Row by row, the place of each cell's shade.
    pub cells: Vec<usize>,
}

impl Grid<'_> {
    /// `title`, what pair it is of (`caption`), the field and its legend.
    pub fn picture(&self, title: &str, caption: &str) -> SVG {
        let legend = self.used();
        let height = FIELD.bottom + BELOW + ROW * legend.len().div_ceil(3).max(2) as f64 + 6.0;
        kit::blank_sheet(WIDTH, height)
            .add(TextStyle::new(18.0).verbatim(title, [FIELD.left, 34.0]))
            .add(SMALL.grey().text(caption, [FIELD.left, 58.0]))
            .add(self.drawn_cells())
            .add(FIELD.border())
            .add(self.axes())
            .add(self.drawn_limits())
            .add(self.legend(&legend))
    }

    /// Cells of one shade beside each other in a row are one rectangle.
    fn drawn_cells(&self) -> Group {
        let mut group = Group::new().set("shape-rendering", "crispEdges");
        let (rows, columns) = (self.distances.len(), self.columns);
        let (width, height) = (FIELD.width() / columns as f64, FIELD.height() / rows as f64);
        for (row, cells) in self.cells.chunks(columns.max(1)).enumerate() {
            let top = FIELD.bottom - (row + 1) as f64 * height;
            let mut column = 0;
            for run in cells.chunk_by(|a, b| a == b) {
                let left = FIELD.left + column as f64 * width;
                column += run.len();
                let right = FIELD.left + column as f64 * width;
                let frame = Frame {
                    left,
                    top,
                    right,
                    bottom: top + height,
                };
                group.append(frame.rectangle().set("fill", self.shades[run[0]].0));
            }
        }
        group
    }

    /// The field with its data: the phase, the centre distance upwards.
    fn plot(&self) -> Plot {
        let Frame {
            left,
            right,
            top,
            bottom,
        } = FIELD;
        let first = self.distances.first().copied().unwrap_or_default();
        let last = self.distances.last().copied().unwrap_or_default();
        let half = 0.5 * (last - first) / (self.distances.len().max(2) - 1) as f64;
        Plot {
            left,
            right,
            top,
            bottom,
            x: self.phase.range,
            y: [first - half, last + half],
        }
    }

    fn axes(&self) -> Group {
        let plot = self.plot();
        let y = Axis::new("centre distance a, mm", plot.y);
        kit::axes(&plot, [&self.phase, &y], [6, 10])
    }

    /// Lines across the field, their names on the right, moved apart where they would collide.
    fn drawn_limits(&self) -> Group {
        const APART: f64 = 17.0;
        let (plot, mut group) = (self.plot(), Group::new());
        // From the top down.
        let named: Vec<(f64, String)> = self
            .limits
            .iter()
            .rev()
            .map(|limit| {
                let label = format!("{} {}", fixed(limit.distance, 4), limit.name);
                (plot.spot((0.0, limit.distance))[1], label)
            })
            .collect();
        let inside = |y: f64| y <= FIELD.bottom;
        let mut heights: Vec<f64> = named.iter().map(|(y, _)| *y).collect();
        // Down past the one above, then up from the bottom.
        for i in 1..heights.len() {
            heights[i] = heights[i].max(heights[i - 1] + APART);
        }
        let mut lowest = FIELD.bottom + 2.0 * APART;
        for height in heights.iter_mut().rev() {
            *height = height.min(lowest);
            lowest = *height - APART;
        }
        for ((y, label), at) in named.iter().zip(heights) {
            if !inside(*y) {
                let label = format!("{label}: below the map");
                group.append(SMALL.grey().text(&label, [FIELD.right + 25.0, at + 4.0]));
                continue;
            }
            let own = label.contains("a of the pair");
            let mut across = line(
                &[[FIELD.left, *y], [FIELD.right, *y]],
                INK,
                if own { 2.0 } else { 1.0 },
            );
            if !own {
                across = across.set("stroke-dasharray", "6 3");
            }
            // Light under dark: the line shows on any shade.
            let halo = line(&[[FIELD.left, *y], [FIELD.right, *y]], "#ffffff", 3.0);
            group.append(halo.set("stroke-opacity", "0.60"));
            group.append(across);
            group.append(line(
                &[
                    [FIELD.right, *y],
                    [FIELD.right + 12.0, at],
                    [FIELD.right + 20.0, at],
                ],
                GREY,
                0.8,
            ));
            group.append(SMALL.text(label, [FIELD.right + 25.0, at + 4.0]));
        }
        group
    }

    /// The shades that occur.
    fn used(&self) -> Vec<&(&'static str, String)> {
        let used = |(number, shade)| self.cells.contains(&number).then_some(shade);
        self.shades.iter().enumerate().filter_map(used).collect()
    }

    fn legend(&self, used: &[&(&'static str, String)]) -> Group {
        let mut group = Group::new();
        for (i, (colour, name)) in used.iter().enumerate() {
            let left = FIELD.left + (i % 3) as f64 * 250.0;
            let top = FIELD.bottom + BELOW + (i / 3) as f64 * ROW;
            let frame = Frame {
                left,
                top,
                right: left + 22.0,
                bottom: top + 14.0,
            };
            let swatch = frame.rectangle().set("fill", *colour);
            group.append(swatch.set("stroke", GREY).set("stroke-width", "0.8"));
            group.append(TextStyle::new(13.0).text(name, [left + 30.0, top + 11.5]));
        }
        group
    }
}
