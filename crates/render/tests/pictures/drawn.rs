//! Reading a chart back: places of marks in data.

use gearlash_render::chart::Plot;
use roxmltree::{Document, Node};

/// Colours of the looks (Okabe and Ito's blue and vermillion; ink).
pub const RIGHT: &str = "#0072b2";
pub const LEFT: &str = "#d55e00";
pub const INK: &str = "#1b1f24";

/// Half a pixel at 800 px.
pub const HALF: f64 = 0.5;

fn number(node: Node, name: &str) -> f64 {
    node.attribute(name).unwrap().parse().unwrap()
}

fn points(data: &str) -> Vec<(f64, f64)> {
    let points = data.trim_start_matches('M').split('L');
    let pair = |point: &str| {
        let (x, y) = point.split_once(' ').unwrap();
        (x.parse().unwrap(), y.parse().unwrap())
    };
    points.map(pair).collect()
}

/// Lines, and bars as round their corners from the lower left one on.
fn line(node: Node) -> Vec<(f64, f64)> {
    if node.has_tag_name("path") {
        return points(node.attribute("d").unwrap());
    }
    let [x, y, width, height] = ["x", "y", "width", "height"].map(|name| number(node, name));
    let (left, right, top, bottom) = (x, x + width, y, y + height);
    vec![(left, bottom), (right, bottom), (right, top), (left, top)]
}

/// Points of every line of a colour, units of the `viewBox`, in the order of drawing.
pub fn polylines(document: &Document, colour: &str) -> Vec<Vec<(f64, f64)>> {
    let lines = document.descendants().filter(|node| {
        node.attribute("stroke") == Some(colour)
            && (node.has_tag_name("path") || node.has_tag_name("rect"))
    });
    lines.map(line).collect()
}

/// Centres of the filled circles of a colour, units of the `viewBox`.
pub fn circles(document: &Document, colour: &str) -> Vec<(f64, f64)> {
    let circles = document
        .descendants()
        .filter(|node| node.has_tag_name("circle") && node.attribute("fill") == Some(colour));
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
pub fn distance(a: (f64, f64), b: (f64, f64)) -> f64 {
    f64::max((a.0 - b.0).abs(), (a.1 - b.1).abs())
}
