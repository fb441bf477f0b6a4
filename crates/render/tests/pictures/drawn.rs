//! A picture read back: its texts with the room they take, its lines, boxes and dots.

use gearlash_render::chart::Plot;
use roxmltree::{Document, Node};

/// Colours of the looks (Okabe and Ito's blue and vermillion; ink).
pub const RIGHT: &str = "#0072b2";
pub const LEFT: &str = "#d55e00";
pub const INK: &str = "#1b1f24";

/// Half a pixel at 800 px.
pub const HALF: f64 = 0.5;

pub type Spot = [f64; 2];
/// Left, top, right, bottom.
pub type Room = [f64; 4];

pub struct Text {
    pub content: String,
    pub room: Room,
    /// Not turned, and no halo of another text.
    pub is_plain: bool,
    /// Stands above all lines of a chart.
    pub is_label: bool,
}

pub struct Line {
    pub stroke: String,
    pub width: String,
    pub is_filled: bool,
    /// Whether it belongs to a gear that turns: seen in the first frame of the sheet only, and reaches beyond it.
    pub turns: bool,
    pub points: Vec<Spot>,
}

pub struct Area {
    pub stroke: String,
    pub fill: String,
    pub room: Room,
}

pub struct Dot {
    pub fill: String,
    pub centre: Spot,
    pub radius: f64,
}

/// The shapes and texts of a picture in the order of drawing, in units of the `viewBox`.
#[derive(Default)]
pub struct Picture {
    pub texts: Vec<Text>,
    pub lines: Vec<Line>,
    pub areas: Vec<Area>,
    pub dots: Vec<Dot>,
}

impl Picture {
    /// Reads `svg`; panics unless it is well-formed XML whose numbers are finite.
    pub fn of(svg: &str) -> Picture {
        let document = Document::parse(svg).unwrap();
        let mut picture = Picture::default();
        for node in document.descendants() {
            let own = |name: &str| node.attribute(name).unwrap_or_default().to_owned();
            match node.tag_name().name() {
                "text" => picture.texts.push(text(&node)),
                "rect" if !own("width").ends_with('%') => {
                    let [x, y, w, h] = ["x", "y", "width", "height"].map(|at| number(&node, at));
                    picture.areas.push(Area {
                        stroke: own("stroke"),
                        fill: own("fill"),
                        room: [x, y, x + w, y + h],
                    });
                }
                "circle" => picture.dots.push(Dot {
                    fill: own("fill"),
                    centre: ["cx", "cy"].map(|at| number(&node, at)),
                    radius: number(&node, "r"),
                }),
                "path" if !node.ancestors().any(is_no_drawing) => {
                    let line = |points: &str| Line {
                        stroke: own("stroke"),
                        width: own("stroke-width"),
                        is_filled: own("fill") != "none",
                        turns: matches!(node.attribute("id"), Some("wheel" | "pinion")),
                        points: spots(points),
                    };
                    let data = own("d");
                    let parts = data.split('M').filter(|part| !part.is_empty());
                    picture.lines.extend(parts.map(line));
                }
                _ => {}
            }
        }
        picture
    }

    /// Lines of a colour.
    pub fn lines_of(&self, colour: &str) -> Vec<&[Spot]> {
        let lines = self.lines.iter().filter(|line| line.stroke == colour);
        lines.map(|line| line.points.as_slice()).collect()
    }

    /// Whether a text is as said.
    pub fn says(&self, is_said: impl Fn(&str) -> bool) -> bool {
        self.texts.iter().any(|text| is_said(&text.content))
    }

    /// Whether these are all of a text.
    pub fn has(&self, words: &str) -> bool {
        self.says(|text| text == words)
    }
}

fn number(node: &Node, name: &str) -> f64 {
    let number: f64 = node.attribute(name).unwrap().parse().unwrap();
    assert!(number.is_finite());
    number
}

/// The points of a line, `x y` each.
fn spots(data: &str) -> Vec<Spot> {
    let points = data.trim_end_matches('Z').split('L');
    let spot = |point: &str| {
        let (x, y) = point.split_once(' ').unwrap();
        let spot: Spot = [x, y].map(|number| number.parse().unwrap());
        assert!(spot.iter().all(|x| x.is_finite()));
        spot
    };
    points.map(spot).collect()
}

/// Whether a node is a filling or a limit.
fn is_no_drawing(node: Node) -> bool {
    node.has_tag_name("pattern") || node.has_tag_name("clipPath")
}

/// A text and its room: 0.62 em a character, 0.36 em a thin one, about what sans-serif faces take; a capital's height. Texts of charts are
/// DejaVu Sans, 0.58 and 0.33 em.
fn text(node: &Node) -> Text {
    let class = node.parent().and_then(|parent| parent.attribute("class"));
    let root = node.document().root_element();
    let is_chart = root.attribute("class") == Some("gearlash-chart");
    let em = if is_chart { [0.58, 0.33] } else { [0.62, 0.36] };
    let pieces = node.descendants().filter(Node::is_text);
    let content: String = pieces.filter_map(|text| text.text()).collect();
    let content = content.trim().to_owned();
    let [x, y, size] = ["x", "y", "font-size"].map(|name| number(node, name));
    let is_thin = |c: char| " ijlt.,:()·".contains(c);
    let width: f64 = content.chars().map(|c| em[usize::from(is_thin(c))]).sum();
    let left = match node.attribute("text-anchor") {
        Some("middle") => x - 0.5 * size * width,
        Some("end") => x - size * width,
        _ => x,
    };
    Text {
        content,
        room: [left, y - 0.73 * size, left + size * width, y],
        is_plain: !node.has_attribute("aria-hidden") && !node.has_attribute("transform"),
        is_label: class == Some("gearlash-labels"),
    }
}

/// Where a script puts a value, as the `data-` attributes tell it.
pub fn place(plot: &Plot, [x, y]: Spot) -> Spot {
    let part = |[from, to]: [f64; 2], value: f64| (value - from) / (to - from);
    [
        plot.frame.left + part(plot.x, x) * (plot.frame.right - plot.frame.left),
        plot.frame.bottom + part(plot.y, y) * (plot.frame.top - plot.frame.bottom),
    ]
}

/// Whether two places are one pixel.
pub fn is_at(a: Spot, b: Spot) -> bool {
    (0..2).all(|axis| (a[axis] - b[axis]).abs() < HALF)
}

/// The least and the greatest of some values.
pub fn ends(values: impl Iterator<Item = f64>) -> [f64; 2] {
    let none = [f64::INFINITY, f64::NEG_INFINITY];
    values.fold(none, |[low, high], value| [low.min(value), high.max(value)])
}

/// Whether two boxes share room.
pub fn overlap(a: &Room, b: &Room) -> bool {
    a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3]
}

/// Whether `a` lies inside `b`.
pub fn within(a: &Room, b: &Room) -> bool {
    a[0] >= b[0] && a[1] >= b[1] && a[2] <= b[2] && a[3] <= b[3]
}

/// Whether a segment goes through a box: clipped to it by Liang and Barsky's way.
pub fn meets([from, to]: [Spot; 2], room: &Room) -> bool {
    let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
    for axis in 0..2 {
        let along = to[axis] - from[axis];
        let [low, high] = [room[axis], room[axis + 2]].map(|edge| edge - from[axis]);
        if along == 0.0 {
            if low > 0.0 || high < 0.0 {
                return false;
            }
            continue;
        }
        let [first, last] = ends([low / along, high / along].into_iter());
        (enter, leave) = (enter.max(first), leave.min(last));
    }
    enter <= leave
}
