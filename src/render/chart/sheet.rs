//! Drawing panels with `plotters`, and the element round them.

use super::brush::{Drawn, FINE, SIDES, WIDTH, fine, plain, spot, style};
use super::legend::{self, ROW};
use super::paint::{GREY, INK};
use super::panel::{Entry, Panel};
use super::{Chart, Heading, Plot, plot};
use crate::error::Error;
use crate::render::labels;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, VPos};
use std::fmt::Write;

/// Draws title, legend and panels, one below the other.
pub(super) fn draw(heading: &Heading, entries: &[Entry], panels: &[Panel]) -> Result<Chart, Error> {
    let places = legend::flow(entries);
    let rows = places.last().map_or(0, |(row, _)| row + 1);
    let top = 58.0 + ROW * rows as f64;
    let height = top + panels.iter().map(|panel| panel.height).sum::<f64>() + 8.0;
    let mut content = String::new();
    let plots = plot_all(
        &mut content,
        height,
        top,
        heading,
        (entries, &places),
        panels,
    )
    .map_err(|error| Error::Chart(error.to_string()))?;
    let Some(&plot) = plots.first() else {
        return Err(Error::Chart("there is nothing to draw".to_owned()));
    };
    Ok(Chart {
        svg: element(heading, height, &plot, inner(&content)),
        plot,
        panels: plots,
    })
}

fn plot_all(
    content: &mut String,
    height: f64,
    top: f64,
    heading: &Heading,
    (entries, places): (&[Entry], &[(usize, f64)]),
    panels: &[Panel],
) -> Drawn<Vec<Plot>> {
    let size = (fine(WIDTH) as u32, fine(height) as u32);
    let root = SVGBackend::with_string(content, size).into_drawing_area();
    root.fill(&WHITE)?;
    let title = plain(&labels::shortened(heading.title, 18.0, SIDES[1] - SIDES[0]));
    let title_style = style(18.0, &INK, HPos::Left, VPos::Bottom);
    let bold = TextStyle {
        font: title_style.font.style(FontStyle::Bold),
        ..title_style
    };
    root.draw(&Text::new(title, spot(SIDES[0], 28.0), bold))?;
    let subtitle = plain(&labels::shortened(
        heading.subtitle,
        13.0,
        SIDES[1] - SIDES[0],
    ));
    let left = style(13.0, &GREY, HPos::Left, VPos::Bottom);
    root.draw(&Text::new(subtitle, spot(SIDES[0], 47.0), left))?;
    for (entry, (row, x)) in entries.iter().zip(places) {
        legend::entry(&root, entry, [*x, 64.0 + ROW * *row as f64])?;
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

/// The chart's element: named for screen readers, with the plot's frame for scripts.
fn element(heading: &Heading, height: f64, plot: &Plot, content: &str) -> String {
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
        ">\n<title id=\"{prefix}-title\">{title}</title>\n<g transform=\"scale({scale})\">\n{content}\n</g>\n</svg>\n"
    );
    text
}
