//! A chart's element: title, legend, panels one below the other, and the labels above all lines.

use super::legend::{self, ROW};
use super::marks;
use super::panel::{Entry, Mark, Panel};
use crate::kit::{FONTS, Frame, NUMBERS, Plot, TextStyle, axes, grid};
use gearlash_files::characters::plain;
use svg::node::Node;
use svg::node::element::{Group, SVG, Title};

/// Width of every chart, units of the `viewBox`: pixels on a screen, 0.22 mm across A4.
const WIDTH: f64 = 800.0;
/// Left and right edge of what is drawn.
const SIDES: [f64; 2] = [16.0, 784.0];
/// Height of a line below the title.
const LINE: f64 = 17.0;
/// Left edge of every plot: room for the numbers and the name of the y axis.
const LEFT: f64 = 80.0;
/// Room of the x axis' numbers and name, and of numbers alone.
const X_AXIS: [f64; 2] = [42.0, 22.0];
/// Most numbers along an x axis.
const MOST: usize = 12;
/// Height of a y axis a number.
const NUMBER_HEIGHT: f64 = 32.0;

const TITLE: TextStyle = TextStyle::new(18.0).bold();
const DETAILS: TextStyle = TextStyle::new(13.0).grey();

/// What stands above and beside a chart. Texts may hold anything: they are escaped.
#[derive(Debug, Clone, PartialEq)]
pub struct Heading<'a> {
    /// Start of every id in the SVG: a letter, then letters, digits, `-` and `_`; unique in a page.
    pub prefix: &'a str,
    /// First line.
    pub title: &'a str,
    /// Second line; may be empty.
    pub subtitle: &'a str,
}

/// A chart, complete.
#[derive(Debug, Clone, PartialEq)]
pub struct Chart {
    /// One `<svg>` element with a `viewBox`, without XML prolog; its `data-` attributes repeat `plot`.
    pub svg: String,
    /// Where the data are: the first panel's frame.
    pub plot: Plot,
    /// Every panel's frame from above, `plot` first.
    pub panels: Vec<Plot>,
}

/// A picture that cannot be drawn.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("the chart cannot be drawn: {0}")]
pub struct PictureError(pub(crate) String);

/// Draws title, `details` (a line below the heading's own; may be empty), legend and panels, one below the other.
pub(super) fn draw(
    heading: &Heading,
    details: &str,
    entries: &[Entry],
    panels: &[Panel],
) -> Result<Chart, PictureError> {
    let room = SIDES[1] - SIDES[0];
    let lines = [heading.subtitle, details].into_iter();
    let lines: Vec<&str> = lines.filter(|line| !line.is_empty()).collect();
    // Room for one line stays where there is none.
    let above = 41.0 + LINE * lines.len().max(1) as f64;
    let (legend, rows) = legend::draw(entries, SIDES, above + 6.0);
    let top = above + ROW * rows as f64;
    let height = top + panels.iter().map(|panel| panel.height).sum::<f64>() + 8.0;
    let mut head =
        Group::new().add(TITLE.verbatim(&TITLE.shortened(heading.title, room), [SIDES[0], 23.5]));
    for (number, line) in lines.iter().enumerate() {
        let foot = 43.5 + LINE * number as f64;
        head.append(DETAILS.text(&DETAILS.shortened(line, room), [SIDES[0], foot]));
    }
    let mut from = top;
    let (mut plots, mut drawn) = (Vec::new(), Group::new());
    let mut labels = Group::new().set("class", "gearlash-labels");
    for panel in panels {
        let plot = place(panel, from);
        from += panel.height;
        let solid = draw_panel(panel, &plot, &mut drawn);
        label(panel, &plot, solid, &mut labels);
        plots.push(plot);
    }
    let Some(&plot) = plots.first() else {
        return Err(PictureError("there is nothing to draw".to_owned()));
    };
    let mut element = element(heading, height, &plot)
        .add(head)
        .add(legend)
        .add(drawn);
    if labels
        .get_children()
        .is_some_and(|labels| !labels.is_empty())
    {
        element = element.add(labels);
    }
    Ok(Chart {
        svg: format!("{element}\n"),
        plot,
        panels: plots,
    })
}

/// Where the plot of a panel stands whose upper edge is `from`.
pub(super) fn place(panel: &Panel, from: f64) -> Plot {
    let below = match panel.x.name.is_empty() {
        true => X_AXIS[1],
        false => X_AXIS[0],
    };
    Plot {
        left: LEFT,
        right: WIDTH - right_margin(panel),
        top: from + if panel.title.is_empty() { 8.0 } else { 24.0 },
        bottom: from + panel.height - below,
        x: panel.x.range,
        y: panel.y.range,
    }
}

/// Room beside the plot: half of the last number where it stands near the edge.
fn right_margin(panel: &Panel) -> f64 {
    let (x, margin) = (&panel.x, WIDTH - SIDES[1]);
    let ticks = x.ticks(MOST);
    let (None, Some(&last)) = (x.teeth, ticks.at.last()) else {
        return margin;
    };
    let half = 0.5 * NUMBERS.width(&ticks.number(last));
    let left_over = (x.range[1] - last) / (x.range[1] - x.range[0]) * (SIDES[1] - LEFT);
    f64::max(margin, half + 2.0 - left_over)
}

/// Draws a panel; whether one of its lines is drawn by its edges.
fn draw_panel(panel: &Panel, plot: &Plot, group: &mut Group) -> bool {
    for mark in &panel.marks {
        if let Mark::Ground { y } = mark {
            group.append(marks::ground(plot, *y));
        }
    }
    let both = [&panel.x, &panel.y];
    let most = [MOST, (panel.height / NUMBER_HEIGHT) as usize];
    group.append(grid(plot, both, most));
    group.append(axes(plot, both, most));
    if !panel.title.is_empty() {
        let above = [plot.left, plot.top - 6.0];
        group.append(title_style(panel).text(&panel.title, above));
    }
    let mut solid = false;
    for mark in &panel.marks {
        solid |= marks::draw(mark, plot, group);
    }
    solid
}

fn title_style(panel: &Panel) -> TextStyle {
    TextStyle::new(13.0).fitted(&panel.title, SIDES[1] - LEFT, 9.0)
}

/// The texts in a plot, with a halo: readable across a line, and across a cursor that a script puts below them.
fn label(panel: &Panel, plot: &Plot, solid: bool, labels: &mut Group) {
    let mut add = |style: TextStyle, text: &str, at| {
        for element in style.haloed(text, at) {
            labels.append(element);
        }
    };
    if solid {
        let words = "shaded: min–max envelope of swings too narrow to draw";
        let style = TextStyle::new(11.0).end();
        let title = title_style(panel).width(&panel.title);
        // Beside the title where both have room, else below it.
        let down = match title + style.width(words) <= plot.right - plot.left {
            true => -4.0,
            false => 13.0,
        };
        add(style, words, [plot.right, plot.top + down]);
    }
    for mark in &panel.marks {
        if let Mark::Text {
            at,
            shift,
            text,
            anchor,
        } = mark
        {
            let style = TextStyle::new(12.0).anchored(*anchor);
            let [x, y] = plot.spot((at[0], at[1]));
            add(
                style,
                text,
                [x + shift[0], y + shift[1] + style.below_middle()],
            );
        }
    }
}

/// The chart's element: named for screen readers, with the plot's frame for scripts.
fn element(heading: &Heading, height: f64, plot: &Plot) -> SVG {
    let prefix = heading.prefix;
    let title = Title::new(plain(heading.title)).set("id", format!("{prefix}-title"));
    let mut element = SVG::new()
        .set("id", prefix)
        .set("class", "gearlash-chart")
        .set("role", "img")
        .set("aria-labelledby", format!("{prefix}-title"))
        .set("viewBox", format!("0 0 {WIDTH} {height}"))
        .set("font-family", FONTS);
    for (name, value) in [
        ("left", plot.left),
        ("right", plot.right),
        ("top", plot.top),
        ("bottom", plot.bottom),
        ("x0", plot.x[0]),
        ("x1", plot.x[1]),
        ("y0", plot.y[0]),
        ("y1", plot.y[1]),
    ] {
        element = element.set(format!("data-{name}"), value.to_string());
    }
    let ground = Frame {
        left: 0.0,
        right: WIDTH,
        top: 0.0,
        bottom: height,
    };
    element
        .add(title)
        .add(ground.rectangle().set("fill", "white"))
}
