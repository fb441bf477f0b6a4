//! Reading a chart back: places of marks in data.

use gearlash_render::chart::Plot;
use roxmltree::{Document, Node};

/// Colours of the looks (Okabe and Ito's blue and vermillion; ink).
pub const RIGHT: &str = "#0072B2";
pub const LEFT: &str = "#D55E00";
pub const INK: &str = "#1B1F24";

/// Half a pixel at 800 px.
pub const HALF: f64 = 0.5;

/// The factor of the group that all marks stand in.
fn scale(document: &Document) -> f64 {
    let group = document.descendants().find(|node| node.has_tag_name("g"));
    let transform = group.unwrap().attribute("transform").unwrap();
    let factor = transform.strip_prefix("scale(").unwrap();
    factor.strip_suffix(')').unwrap().parse().unwrap()
}

fn pairs(node: Node, scale: f64) -> Vec<(f64, f64)> {
    let points = node.attribute("points").unwrap().split_whitespace();
    points
        .map(|point| {
            let (x, y) = point.split_once(',').unwrap();
            let number = |text: &str| text.parse::<f64>().unwrap() * scale;
            (number(x), number(y))
        })
        .collect()
}

/// Points of every polyline of a colour, units of the `viewBox`, in the order of drawing.
pub fn polylines(document: &Document, colour: &str) -> Vec<Vec<(f64, f64)>> {
    let scale = scale(document);
    let lines = document
        .descendants()
        .filter(|node| node.has_tag_name("polyline") && node.attribute("stroke") == Some(colour));
    lines.map(|line| pairs(line, scale)).collect()
}

/// Centres of the filled circles of a colour, units of the `viewBox`.
pub fn circles(document: &Document, colour: &str) -> Vec<(f64, f64)> {
    let scale = scale(document);
    let circles = document
        .descendants()
        .filter(|node| node.has_tag_name("circle") && node.attribute("fill") == Some(colour));
    let number = |node: Node, name| node.attribute(name).unwrap().parse::<f64>().unwrap() * scale;
    circles
        .map(|node| (number(node, "cx"), number(node, "cy")))
        .collect()
}

/// Where a script puts a value, as the `data-` attributes tell it.
pub fn place(plot: &Plot, (x, y): (f64, f64)) -> (f64, f64) {
    let part = |[from, to]: [f64; 2], value: f64| (value - from) / (to - from);
    (
        plot.left + part(plot.x, x) * (plot.right - plot.left),
        plot.bottom + part(plot.y, y) * (plot.top - plot.bottom),
    )
}

/// How far two places lie apart, the larger of both directions.
pub fn apart(a: (f64, f64), b: (f64, f64)) -> f64 {
    f64::max((a.0 - b.0).abs(), (a.1 - b.1).abs())
}
