//! Drawing panels with `plotters`, and the element round them.

use super::canvas::{Drawn, FINE, SIDES, WIDTH, fine, plain, spot, style};
use super::legend::{self, ROW};
use super::paint::{GREY, INK};
use super::panel::{Anchor, Entry, Mark, Panel};
use super::{Chart, Heading, Plot, plot};
use crate::error::PictureError;
use crate::kit::labels;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, VPos};
use std::fmt::Write;

/// Height of a line below the title.
const LINE: f64 = 17.0;

/// Draws title, `details` (a line below the heading's own; may be empty), legend and panels, one below the other.
pub(super) fn draw(
    heading: &Heading,
    details: &str,
    entries: &[Entry],
    panels: &[Panel],
) -> Result<Chart, PictureError> {
    let lines = [heading.subtitle, details];
    let lines: Vec<&str> = lines.into_iter().filter(|line| !line.is_empty()).collect();
    // Room for one line stays where there is none.
    let above = 41.0 + LINE * lines.len().max(1) as f64;
    let places = legend::flow(entries);
    let rows = places.last().map_or(0, |(row, _)| row + 1);
    let top = above + ROW * rows as f64;
    let height = top + panels.iter().map(|panel| panel.height).sum::<f64>() + 8.0;
    let mut content = String::new();
    let plots = plot_all(
        &mut content,
        height,
        [above, top],
        (heading.title, &lines),
        (entries, &places),
        panels,
    )
    .map_err(|error| PictureError(error.to_string()))?;
    let Some(&(plot, _)) = plots.first() else {
        return Err(PictureError("there is nothing to draw".to_owned()));
    };
    Ok(Chart {
        svg: element(
            heading,
            height,
            &plot,
            inner(&content),
            &labels(panels, &plots),
        ),
        plot,
        panels: plots.into_iter().map(|(plot, _)| plot).collect(),
    })
}

fn plot_all(
    content: &mut String,
    height: f64,
    [above, top]: [f64; 2],
    (title, lines): (&str, &[&str]),
    (entries, places): (&[Entry], &[(usize, f64)]),
    panels: &[Panel],
) -> Drawn<Vec<(Plot, bool)>> {
    let size = (fine(WIDTH) as u32, fine(height) as u32);
    let root = SVGBackend::with_string(content, size).into_drawing_area();
    root.fill(&WHITE)?;
    let title = plain(&labels::shortened(title, 18.0, SIDES[1] - SIDES[0]));
    let title_style = style(18.0, &INK, HPos::Left, VPos::Bottom);
    let bold = TextStyle {
        font: title_style.font.style(FontStyle::Bold),
        ..title_style
    };
    root.draw(&Text::new(title, spot(SIDES[0], 28.0), bold))?;
    for (number, line) in lines.iter().enumerate() {
        let line = plain(&labels::shortened(line, 13.0, SIDES[1] - SIDES[0]));
        let left = style(13.0, &GREY, HPos::Left, VPos::Bottom);
        let foot = 47.0 + LINE * number as f64;
        root.draw(&Text::new(line, spot(SIDES[0], foot), left))?;
    }
    for (entry, (row, x)) in entries.iter().zip(places) {
        legend::entry(&root, entry, [*x, above + 6.0 + ROW * *row as f64])?;
    }
    let mut from = top;
    let mut plots = Vec::new();
    for panel in panels {
        let to = from + panel.height;
        let area = root.clone().shrink(
            spot(SIDES[0] - 6.0, from),
            (
                fine(WIDTH - SIDES[0] + 6.0) as u32,
                fine(panel.height) as u32,
            ),
        );
        plots.push(plot::draw(&area, panel)?);
        from = to;
    }
    root.present()?;
    Ok(plots)
}

/// What stands inside the backend's own root element.
fn inner(content: &str) -> &str {
    let from = content.find('>').map_or(0, |end| end + 1);
    let to = content.rfind("</svg>").unwrap_or(content.len());
    content.get(from..to).unwrap_or_default().trim()
}

/// The texts in the plots, above all lines, with a white halo: readable across a line, and across a cursor that a
/// script puts below them.
fn labels(panels: &[Panel], plots: &[(Plot, bool)]) -> String {
    let mut texts = String::new();
    for (panel, (plot, solid)) in panels.iter().zip(plots) {
        if *solid {
            let _ = writeln!(
                texts,
                "<text x=\"{:.1}\" y=\"{:.1}\" font-size=\"11\" text-anchor=\"end\" font-family=\"sans-serif\">shaded: swings faster than can be drawn, between their ends</text>",
                plot.right,
                plot.top - 4.0
            );
        }
        for mark in &panel.marks {
            let Mark::Text {
                at,
                shift,
                text,
                anchor,
            } = mark
            else {
                continue;
            };
            let part = |[from, to]: [f64; 2], value: f64| (value - from) / (to - from);
            let x = plot.left + part(plot.x, at[0]) * (plot.right - plot.left) + shift[0];
            let y = plot.bottom + part(plot.y, at[1]) * (plot.top - plot.bottom) + shift[1];
            let anchor = match anchor {
                Anchor::Start => "start",
                Anchor::Middle => "middle",
                Anchor::End => "end",
            };
            let text = svg::node::Text::new(plain(text));
            // Writing to a String cannot fail.
            let _ = writeln!(
                texts,
                "<text x=\"{x:.1}\" y=\"{y:.1}\" dy=\"0.35em\" text-anchor=\"{anchor}\" font-family=\"sans-serif\">{text}</text>"
            );
        }
    }
    match texts.is_empty() {
        true => texts,
        false => format!(
            "<g class=\"gearlash-labels\" font-size=\"12\" fill=\"#1b1f24\" stroke=\"#ffffff\" stroke-width=\"3\" \
             stroke-linejoin=\"round\" paint-order=\"stroke\">\n{texts}</g>\n"
        ),
    }
}

/// The chart's element: named for screen readers, with the plot's frame for scripts.
fn element(heading: &Heading, height: f64, plot: &Plot, content: &str, labels: &str) -> String {
    let prefix = heading.prefix;
    let title = svg::node::Text::new(plain(heading.title));
    let mut text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" id=\"{prefix}\" class=\"gearlash-chart\" role=\"img\" \
         aria-labelledby=\"{prefix}-title\" viewBox=\"0 0 {WIDTH} {height}\" font-family=\"sans-serif\""
    );
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
        // Writing to a String cannot fail.
        let _ = write!(text, " data-{name}=\"{value}\"");
    }
    let scale = 1.0 / FINE;
    let _ = write!(
        text,
        ">\n<title id=\"{prefix}-title\">{title}</title>\n<g transform=\"scale({scale})\">\n{content}\n</g>\n{labels}</svg>\n"
    );
    text
}
