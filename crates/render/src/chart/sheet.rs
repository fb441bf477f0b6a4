//! The SVG element of a chart: title, legend, panels one below the other, and labels above all lines.

use super::labels::{self, Lacking};
use super::marks::{self, bar};
use super::panel::{Entry, Mark, Panel, Swatch};
use crate::kit::{FONTS, Frame, NUMBERS, Plot, TextStyle, axes, grid, line, number};
use gearlash_text::characters::plain;
use svg::node::Node;
use svg::node::element::{Group, SVG, Title};

/// Layout of a chart for one screen width. Units of the `viewBox` are pixels there.
struct Layout {
    width: f64,
    margin: f64,
    /// Left edge of every plot, with room for the numbers and the name of the y axis.
    left: f64,
    /// Most numbers along an x axis.
    most: usize,
    title: TextStyle,
    details: TextStyle,
    /// Most lines of a title and of a line of details.
    lines: [usize; 2],
    suffix: &'static str,
}

/// For a page and for paper: 0.22 mm per unit across A4.
const WIDE: Layout = Layout {
    width: 800.0,
    margin: 16.0,
    left: 80.0,
    most: 12,
    title: TextStyle::new(18.0).bold(),
    details: TextStyle::new(13.0).grey(),
    lines: [1, 2],
    suffix: "",
};
const NARROW: Layout = Layout {
    width: 390.0,
    margin: 8.0,
    left: 68.0,
    most: 6,
    title: TextStyle::new(15.0).bold(),
    details: TextStyle::new(12.0).grey(),
    lines: [2, 4],
    suffix: "-narrow",
};

/// Height of a line of the title and of one below it.
const LINES: [f64; 2] = [20.0, 17.0];
/// Height of the x axis with numbers and name, and with numbers alone.
const X_AXIS: [f64; 2] = [42.0, 22.0];
/// Height of a y axis per number.
const NUMBER_HEIGHT: f64 = 32.0;
const PANEL_LINE: f64 = 16.0;
/// How often an axis gets more room for its texts, and how much each time, units.
const WIDENINGS: usize = 5;
const WIDER: f64 = 18.0;

/// Texts above and beside a chart. They can hold any characters and are escaped.
#[derive(Debug, Clone, PartialEq)]
pub struct Heading<'a> {
    /// Start of every id in the SVG: a letter, then letters, digits, `-` and `_`; unique in a page.
    pub prefix: &'a str,
    /// First line.
    pub title: &'a str,
    /// Second line; may be empty.
    pub subtitle: &'a str,
}

impl<'a> Heading<'a> {
    /// The heading of a chart alone in its file.
    pub fn alone(title: &'a str, subtitle: &'a str) -> Heading<'a> {
        Heading {
            prefix: "chart",
            title,
            subtitle,
        }
    }
}

/// A complete chart.
#[derive(Debug, Clone, PartialEq)]
pub struct Chart {
    /// One `<svg>` element with a `viewBox`, without XML prolog; its `data-` attributes repeat the first of `panels`.
    pub svg: String,
    /// Every panel's frame from above, in data.
    pub panels: Vec<Plot>,
    drawn_from: Source,
}

/// The content of a chart, drawn at any width.
#[derive(Debug, Clone, PartialEq)]
struct Source {
    prefix: String,
    title: String,
    lines: Vec<String>,
    entries: Vec<Entry>,
    panels: Vec<Panel>,
}

impl Chart {
    /// The chart for a screen 390 pixels wide. Its ids end with `-narrow`.
    #[must_use]
    pub fn narrow(&self) -> Chart {
        self.drawn_from.draw(&NARROW)
    }

    /// This chart with the panels of `below` under its own, and with its lines and names that are new.
    pub(super) fn above(mut self, below: Chart) -> Chart {
        let (own, further) = (&mut self.drawn_from, below.drawn_from);
        for line in further.lines {
            if !own.lines.contains(&line) {
                own.lines.push(line);
            }
        }
        for entry in further.entries {
            if own.entries.iter().all(|known| known.name != entry.name) {
                own.entries.push(entry);
            }
        }
        own.panels.extend(further.panels);
        self.drawn_from.draw(&WIDE)
    }
}

/// A picture that cannot be drawn.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("the chart cannot be drawn: {0}")]
pub struct PictureError(pub(crate) String);

/// Draws title, `details` (a line below the heading's own; may be empty), legend and panels, at least one, one below the other.
pub(super) fn draw(heading: &Heading, details: &str, entries: &[Entry], panels: &[Panel]) -> Chart {
    let lines = [heading.subtitle, details].into_iter();
    let source = Source {
        prefix: heading.prefix.to_owned(),
        title: heading.title.to_owned(),
        lines: lines
            .filter(|line| !line.is_empty())
            .map(str::to_owned)
            .collect(),
        entries: entries.to_vec(),
        panels: panels.to_vec(),
    };
    source.draw(&WIDE)
}

impl Source {
    fn draw(&self, layout: &Layout) -> Chart {
        let sides = [layout.margin, layout.width - layout.margin];
        let room = sides[1] - sides[0];
        let mut head = Group::new();
        let title = layout.title.wrapped(&self.title, room, layout.lines[0]);
        for (number, line) in title.iter().enumerate() {
            let foot = 23.5 + LINES[0] * number as f64;
            head.append(layout.title.verbatim(line, [sides[0], foot]));
        }
        let below = 41.0 + LINES[0] * (title.len() - 1) as f64;
        let lines = self.lines.iter();
        let lines = lines.flat_map(|line| layout.details.wrapped(line, room, layout.lines[1]));
        let mut count = 0;
        for line in lines {
            let foot = below + 2.5 + LINES[1] * f64::from(count);
            head.append(layout.details.text(&line, [sides[0], foot]));
            count += 1;
        }
        // Keeps the room of one line where there is none.
        let above = below + LINES[1] * f64::from(count.max(1));
        let (legend, rows) = draw_legend(&self.entries, sides, above + 6.0);
        let mut from = above + ROW * rows as f64;
        let (mut plots, mut drawn) = (Vec::new(), Group::new());
        let mut labels = Group::new().set("class", "gearlash-labels");
        for panel in &self.panels {
            let (plot, height) = layout.draw_panel(panel, from, &mut drawn, &mut labels);
            from += height;
            plots.push(plot);
        }
        let id = format!("{}{}", self.prefix, layout.suffix);
        let mut element = element(&id, &self.title, [layout.width, from + 8.0], &plots[0])
            .add(head)
            .add(legend)
            .add(drawn);
        let texts = labels.get_children();
        if texts.is_some_and(|labels| !labels.is_empty()) {
            element = element.add(labels);
        }
        Chart {
            svg: format!("{element}\n"),
            panels: plots,
            drawn_from: self.clone(),
        }
    }
}

impl Layout {
    /// Draws a panel with the upper edge `from`, its texts into `labels`. Returns its plot and its height.
    fn draw_panel(
        &self,
        panel: &Panel,
        from: f64,
        drawn: &mut Group,
        labels: &mut Group,
    ) -> (Plot, f64) {
        let mut panel = panel.clone();
        let title = self.panel_title(&panel);
        let more = PANEL_LINE * title.1.len().saturating_sub(1) as f64;
        let mut placed = Vec::new();
        let mut plot = self.place(&panel, from + more);
        for widening in 0..=WIDENINGS {
            let lacking;
            (placed, lacking) = labels::place(&panel, &plot);
            let Some(lacking) = lacking.filter(|_| widening < WIDENINGS) else {
                break;
            };
            let room = WIDER / plot.scale()[1];
            match lacking {
                Lacking::Above => panel.y.range[1] += room,
                Lacking::Below => panel.y.range[0] -= room,
            }
            plot = self.place(&panel, from + more);
        }
        let both = [&panel.x, &panel.y];
        let most = [self.most, (panel.height / NUMBER_HEIGHT) as usize];
        for mark in &panel.marks {
            if let Mark::Ground(below) = mark {
                drawn.append(marks::ground(&plot, *below));
            }
        }
        drawn.append(grid(&plot, both, most));
        drawn.append(axes(&plot, both, most));
        let (style, lines) = title;
        for (number, line) in lines.iter().enumerate() {
            let foot = plot.frame.top - 6.0 - PANEL_LINE * (lines.len() - 1 - number) as f64;
            drawn.append(style.text(line, [plot.frame.left, foot]));
        }
        for mark in &panel.marks {
            marks::draw(mark, &plot, drawn);
        }
        for (line, at) in &placed {
            // Readable across a grid, and across a cursor that a script draws below.
            for element in labels::STYLE.haloed(line, *at) {
                labels.append(element);
            }
        }
        (plot, panel.height + more)
    }

    /// The plot of a panel with the upper edge `from`.
    fn place(&self, panel: &Panel, from: f64) -> Plot {
        let below = X_AXIS[usize::from(panel.x.name.is_empty())];
        let top = from + if panel.title.is_empty() { 8.0 } else { 24.0 };
        let right = self.width - self.right_margin(panel);
        Plot {
            frame: Frame::new([self.left, top], [right, from + panel.height - below]),
            x: panel.x.range,
            y: panel.y.range,
        }
    }

    /// Margin right of the plot: half of the last number where it is near the edge.
    fn right_margin(&self, panel: &Panel) -> f64 {
        let x = &panel.x;
        let ticks = x.ticks(self.most);
        let (None, Some(&last)) = (x.teeth, ticks.at.last()) else {
            return self.margin;
        };
        let half = 0.5 * NUMBERS.width(&ticks.number(last));
        let room = self.width - self.margin - self.left;
        let left_over = (x.range[1] - last) / (x.range[1] - x.range[0]) * room;
        f64::max(self.margin, half + 2.0 - left_over)
    }

    fn panel_title(&self, panel: &Panel) -> (TextStyle, Vec<String>) {
        if panel.title.is_empty() {
            return (TextStyle::new(13.0), Vec::new());
        }
        let room = self.width - self.margin - self.left;
        let style = TextStyle::new(13.0).fitted(&panel.title, room, 11.0);
        (style, style.wrapped(&panel.title, room, 3))
    }
}

/// The chart's element with a width and height, a name for screen readers, and the plot's frame for scripts.
fn element(id: &str, name: &str, [width, height]: [f64; 2], plot: &Plot) -> SVG {
    let title = Title::new(plain(name)).set("id", format!("{id}-title"));
    let mut element = SVG::new()
        .set("id", id)
        .set("class", "gearlash-chart")
        .set("role", "img")
        .set("aria-labelledby", format!("{id}-title"))
        .set("viewBox", format!("0 0 {width} {height}"))
        .set("font-family", FONTS);
    for (name, value) in [
        ("left", plot.frame.left),
        ("right", plot.frame.right),
        ("top", plot.frame.top),
        ("bottom", plot.frame.bottom),
        ("x0", plot.x[0]),
        ("x1", plot.x[1]),
        ("y0", plot.y[0]),
        ("y1", plot.y[1]),
    ] {
        element = element.set(format!("data-{name}"), value.to_string());
    }
    let ground = Frame::new([0.0, 0.0], [width, height]);
    element
        .add(title)
        .add(ground.rectangle().set("fill", "white"))
}

const ROW: f64 = 19.0;
const NAMES: TextStyle = TextStyle::new(12.0);
const SAMPLE: f64 = 30.0;
/// Distance of a name from the left end of its entry.
const NAME: f64 = SAMPLE + 6.0;
const LINE: f64 = 14.0;

/// The legend between the edges `sides`, with the middle of its first row at `top`; and its number of rows.
fn draw_legend(entries: &[Entry], sides: [f64; 2], top: f64) -> (Group, usize) {
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
