//! A snapshot read back: its texts with the room they take, its lines, its dots.

use roxmltree::{Document, Node};

/// Left, top, right, bottom.
pub type Box = [f64; 4];

/// The content of a drawn snapshot, in units of the sheet.
pub struct Picture {
    pub texts: Vec<(String, Box)>,
    /// Frames, solid or dashed: rectangles with an outline.
    pub frames: Vec<Box>,
    pub lines: Vec<[[f64; 2]; 2]>,
    /// Outlines of turning gears, which are seen in the first frame of the sheet only and reach beyond it.
    pub turning: Vec<[[f64; 2]; 2]>,
    /// Contact points: centre, radius, filled.
    pub dots: Vec<([f64; 2], f64, bool)>,
}

fn number(node: &Node, name: &str) -> f64 {
    node.attribute(name).unwrap().parse().unwrap()
}

/// Reads `svg`; panics unless it is well-formed XML whose numbers are finite.
pub fn read(svg: &str) -> Picture {
    let document = Document::parse(svg).unwrap();
    let mut picture = Picture {
        texts: Vec::new(),
        frames: Vec::new(),
        lines: Vec::new(),
        turning: Vec::new(),
        dots: Vec::new(),
    };
    for node in document.descendants() {
        match node.tag_name().name() {
            "text" => picture.texts.push(text(&node)),
            "rect" if node.has_attribute("stroke") => {
                let [x, y, w, h] = ["x", "y", "width", "height"].map(|name| number(&node, name));
                picture.frames.push([x, y, x + w, y + h]);
            }
            "circle" => picture.dots.push((
                [number(&node, "cx"), number(&node, "cy")],
                number(&node, "r"),
                node.attribute("fill") != Some("white"),
            )),
            "path" if !node.ancestors().any(is_no_drawing) => {
                let data = node.attribute("d").unwrap().trim_start_matches('M');
                let points: Vec<[f64; 2]> = data
                    .trim_end_matches('Z')
                    .split('L')
                    .filter(|point| !point.is_empty())
                    .map(|point| {
                        let (x, y) = point.split_once(' ').unwrap();
                        [x, y].map(|number| number.parse().unwrap())
                    })
                    .collect();
                assert!(points.iter().flatten().all(|x| x.is_finite()));
                let turns = matches!(node.attribute("id"), Some("wheel" | "pinion"));
                let lines = if turns {
                    &mut picture.turning
                } else {
                    &mut picture.lines
                };
                lines.extend(points.windows(2).map(|pair| [pair[0], pair[1]]));
            }
            _ => {}
        }
    }
    picture
}

/// Whether a node is a filling or a limit.
fn is_no_drawing(node: Node) -> bool {
    node.has_tag_name("pattern") || node.has_tag_name("clipPath")
}

/// A text and its room: 0.62 em a character, 0.36 em a thin one, about what sans-serif faces take; a capital's height.
fn text(node: &Node) -> (String, Box) {
    let content: String = node
        .descendants()
        .filter(Node::is_text)
        .filter_map(|text| text.text())
        .collect();
    let content = content.trim().to_owned();
    let size = number(node, "font-size");
    let thin = |c: &char| " ijlt.,:()·".contains(*c);
    let count = content.chars().count() as f64;
    let thin = content.chars().filter(thin).count() as f64;
    let width = size * (0.62 * (count - thin) + 0.36 * thin);
    let (x, y) = (number(node, "x"), number(node, "y"));
    let left = match node.attribute("text-anchor") {
        Some("middle") => x - 0.5 * width,
        Some("end") => x - width,
        _ => x,
    };
    (content, [left, y - 0.73 * size, left + width, y])
}

/// Whether two boxes share room.
pub fn overlap(a: &Box, b: &Box) -> bool {
    a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3]
}

/// Whether `a` lies inside `b`.
pub fn within(a: &Box, b: &Box) -> bool {
    a[0] >= b[0] && a[1] >= b[1] && a[2] <= b[2] && a[3] <= b[3]
}

/// Whether a line meets a box: by its ends, or by having the box's corners on both its sides.
pub fn meets([from, to]: &[[f64; 2]; 2], area: &Box) -> bool {
    let reach = [
        from[0].min(to[0]),
        from[1].min(to[1]),
        from[0].max(to[0]),
        from[1].max(to[1]),
    ];
    let touches =
        reach[0] <= area[2] && area[0] <= reach[2] && reach[1] <= area[3] && area[1] <= reach[3];
    let side = |x: f64, y: f64| {
        (to[0] - from[0]) * (y - from[1]) - (to[1] - from[1]) * (x - from[0]) > 0.0
    };
    let corners = [
        side(area[0], area[1]),
        side(area[2], area[1]),
        side(area[0], area[3]),
        side(area[2], area[3]),
    ];
    touches && corners.iter().any(|c| *c) && corners.iter().any(|c| !*c)
}
