//! Maps over centre distance and mesh phase: of the contacts, and of the backlash of drawn gears. A map is a grid of shades with lines
//! across it and a legend.

use crate::kit::{self, Axis, Frame, GREY, INK, Plot, TextStyle, dashed, line, scale, shaded};
use crate::pose_name::pose_name;
use gearlash::analysis::backlash_map::BacklashMap;
use gearlash::analysis::diagnosis::{Limit, Map, MapCell};
use gearlash::analysis::study::Material;
use gearlash::contact::{ContactKind, PoseClass, Status};
use gearlash_text::numbers::{fixed, shortest};
use svg::node::Node;
use svg::node::element::{Group, SVG};

/// Colours of cells and their meanings, distinguished by lightness first.
const SHADES: [(&str, &str); 7] = [
    ("#d7ebdf", "involutes, with backlash"),
    ("#a9c7e0", "involutes, interference"),
    ("#f0b45a", "tip corner off the line"),
    ("#c8452f", "fillet or undercut edge"),
    ("#4a1f2e", "jam: tip in root"),
    ("#ffffff", "nothing touches"),
    ("#ff00ff", "unproven: contact lost"),
];

/// The index of a cell's shade.
fn shade(cell: &MapCell) -> usize {
    match cell.class {
        PoseClass::Contact(ContactKind::Involute) => {
            usize::from(cell.backlash.is_some_and(|j| j < 0.0))
        }
        PoseClass::Contact(ContactKind::TipInvolute | ContactKind::TipTip) => 2,
        PoseClass::Contact(_) => 3,
        PoseClass::Jammed => 4,
        PoseClass::NoContact => 5,
        PoseClass::Unproven => 6,
    }
}

/// `map` as SVG, with `title` and `caption` (the pair) above.
pub fn map_picture(map: &Map, title: &str, caption: &str) -> String {
    let phase = format!("pitches on from {}", pose_name(&map.start));
    let grid = Grid {
        distances: &map.distances,
        columns: map.fractions.len(),
        phase: Axis::new(&phase, [0.0, 1.0]),
        limits: &map.limits,
        shades: SHADES
            .map(|(colour, name)| (colour, name.to_owned()))
            .to_vec(),
        cells: map.cells.iter().map(shade).collect(),
    };
    format!("{}\n", grid.picture(title, caption))
}

/// Steps of backlash above zero.
const STEPS: usize = 4;

/// Darker colours mean less backlash, also in black and white.
const COLOURS: [&str; 9] = [
    "#4a1f2e", "#a83224", "#e08a3c", "#8fc7a6", "#b5dac4", "#d7ebdf", "#eef7f1", "#ffffff",
    "#ff00ff",
];

/// `map` as SVG with `title` above.
pub fn backlash_map_picture(title: &str, map: &BacklashMap) -> String {
    let (grid, caption) = backlash_grid(map);
    format!("{}\n", grid.picture(title, &caption))
}

/// The map as part of a page, for a wide and for a narrow screen. Its ids begin with `prefix`.
pub(crate) fn backlash_map_in_page(prefix: &str, title: &str, map: &BacklashMap) -> String {
    let label = "Backlash over mesh cycle and centre distance";
    let (grid, caption) = backlash_grid(map);
    let wide = kit::in_page(grid.picture(title, &caption), prefix, label);
    wide + &kit::in_page(grid.drawn(&NARROW), &format!("{prefix}-narrow"), label)
}

/// The map and its caption.
fn backlash_grid(map: &BacklashMap) -> (Grid<'_>, String) {
    let [wheel, pinion] = map.teeth;
    let caption = format!(
        "{wheel} and {pinion} teeth{}: backlash j_wt over the whole mesh cycle, the least in each cell",
        match map.material {
            Material::AsMeasured => String::new(),
            material => format!(", {}", material.words()),
        }
    );
    let cells = map.cells.iter();
    let um = cells.filter_map(|cell| Some(1e3 * cell.backlash?));
    let greatest = um.fold(0.0, f64::max);
    let least = (greatest / STEPS as f64).max(1e-3);
    // Rounding does not make a step wider.
    let step = scale::round_up(least * (1.0 - 1e-9), scale::ISO_5455);
    let upto = |steps: usize| shortest(step * steps as f64);
    let mut names = vec![
        "jammed: a tip in a root".to_owned(),
        format!("interference beyond {} µm", upto(1)),
        format!("interference up to {} µm", upto(1)),
    ];
    names.extend((1..STEPS).map(|k| format!("backlash {} … {} µm", upto(k - 1), upto(k))));
    names.push(format!("backlash above {} µm", upto(STEPS - 1)));
    names.extend(["out of mesh", "not settled"].map(str::to_owned));
    let cells = map.cells.iter().map(|cell| match cell.status {
        Status::Unproven => 8,
        Status::NoContact => 7,
        Status::Jammed => 0,
        Status::Clear | Status::Interference => {
            let steps = cell.backlash.map_or(0.0, |mm| 1e3 * mm / step);
            // From −1 step on, one shade per step.
            (steps.floor() + 3.0).clamp(1.0, 6.0) as usize
        }
    });
    let (wheel, pinion) = (map.start.wheel_tooth, map.start.pinion_tooth);
    let phase = format!("pitches from mating {wheel}·{pinion} on");
    let grid = Grid {
        distances: &map.distances,
        columns: map.columns,
        phase: Axis::new(&phase, [0.0, map.matings as f64]),
        limits: &map.limits,
        shades: COLOURS.into_iter().zip(names).collect(),
        cells: cells.collect(),
    };
    (grid, caption)
}

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

struct Grid<'a> {
    /// Centre distances of the rows, mm, ascending.
    distances: &'a [f64],
    columns: usize,
    phase: Axis,
    limits: &'a [Limit],
    /// Colours and names; the legend shows those that occur.
    shades: Vec<(&'static str, String)>,
    /// The index of each cell's shade, row by row.
    cells: Vec<usize>,
}

impl Grid<'_> {
    /// The map with `title` and `caption` (the pair), the field and its legend.
    fn picture(&self, title: &str, caption: &str) -> SVG {
        let left = WIDE.field.left;
        let style = TextStyle::new(18.0);
        let title = style.shortened(title, WIDE.width - left - 16.0);
        self.drawn(&WIDE)
            .add(style.verbatim(&title, [left, 34.0]))
            .add(SMALL.grey().text(caption, [left, 58.0]))
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
            frame: field,
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
        let named = self.limits.iter().rev().map(|limit| {
            let label = format!("{} {}", fixed(limit.distance, 4), limit.name);
            (plot.spot((0.0, limit.distance))[1], label)
        });
        let named: Vec<(f64, String)> = named.collect();
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
            if *y > field.bottom {
                let label = format!("{label}: below the map");
                group.append(SMALL.grey().text(&label, spot));
                continue;
            }
            let own = label.contains("a of the pair");
            let ends = [[field.left, *y], [field.right, *y]];
            let across = if own {
                line(&ends, INK, 2.0)
            } else {
                dashed(&ends, INK, 1.0, "6 3")
            };
            // A light line under a dark one is visible on any shade.
            let halo = line(&ends, "#ffffff", 3.0);
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
