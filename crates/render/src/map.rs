//! The map of what touches over centre distance and mesh phase, as a picture and as rows.

use crate::kit::{self, Axis, Frame, GREY, INK, Plot, TextStyle, line, number};
use crate::pose_name::pose_name;
use gearlash::analysis::diagnosis::{Map, MapCell};
use gearlash::contact::{ContactKind, PoseClass};
use svg::Document;
use svg::node::Node;
use svg::node::element::{Group, Rectangle};

const WIDTH: f64 = 900.0;
const HEIGHT: f64 = 640.0;
const FIELD: Frame = Frame {
    left: 90.0,
    top: 92.0,
    right: 560.0,
    bottom: 520.0,
};

const SMALL: TextStyle = TextStyle::new(12.0);

/// What a cell is coloured by; distinguished by lightness first.
#[derive(Clone, Copy, PartialEq)]
enum Shade {
    Nothing,
    Involute,
    Overlap,
    Corner,
    Fillet,
    Jam,
    Unproven,
}

impl Shade {
    const ALL: [Shade; 7] = [
        Shade::Involute,
        Shade::Overlap,
        Shade::Corner,
        Shade::Fillet,
        Shade::Jam,
        Shade::Nothing,
        Shade::Unproven,
    ];

    fn of(cell: &MapCell) -> Shade {
        match cell.class {
            PoseClass::NoContact => Shade::Nothing,
            PoseClass::Jammed => Shade::Jam,
            PoseClass::Unproven => Shade::Unproven,
            PoseClass::Contact(ContactKind::Involute) => {
                match cell.backlash.is_some_and(|j| j < 0.0) {
                    true => Shade::Overlap,
                    false => Shade::Involute,
                }
            }
            PoseClass::Contact(ContactKind::TipInvolute | ContactKind::TipTip) => Shade::Corner,
            PoseClass::Contact(_) => Shade::Fillet,
        }
    }

    fn colour(self) -> &'static str {
        match self {
            Shade::Nothing => "#ffffff",
            Shade::Involute => "#d7ebdf",
            Shade::Overlap => "#a9c7e0",
            Shade::Corner => "#f0b45a",
            Shade::Fillet => "#c8452f",
            Shade::Jam => "#4a1f2e",
            Shade::Unproven => "#ff00ff",
        }
    }

    fn name(self) -> &'static str {
        match self {
            Shade::Nothing => "nothing touches",
            Shade::Involute => "involutes, with backlash",
            Shade::Overlap => "involutes, interference",
            Shade::Corner => "tip corner off the line",
            Shade::Fillet => "fillet or undercut edge",
            Shade::Jam => "jam: tip in root",
            Shade::Unproven => "unproven: contact lost",
        }
    }
}

/// `map` as SVG; `title` and what pair it is of (`caption`) stand above.
pub fn map_picture(map: &Map, title: &str, caption: &str) -> String {
    let mut document = Document::new()
        .set("viewBox", (0, 0, WIDTH as i32, HEIGHT as i32))
        .set("width", "225mm")
        .set("height", "160mm")
        .set("font-family", "sans-serif");
    document.append(
        Rectangle::new()
            .set("width", number(WIDTH))
            .set("height", number(HEIGHT))
            .set("fill", "#ffffff"),
    );
    document.append(TextStyle::new(18.0).verbatim(title, [FIELD.left, 34.0]));
    document.append(SMALL.grey().text(caption, [FIELD.left, 58.0]));
    document.append(cells(map));
    document.append(FIELD.border());
    document.append(axes(map));
    document.append(limits(map));
    document.append(legend(map));
    document.to_string() + "\n"
}

/// Least and greatest centre distance of the field.
fn range(map: &Map) -> (f64, f64) {
    let first = map.distances.first().copied().unwrap_or_default();
    let last = map.distances.last().copied().unwrap_or_default();
    let half = 0.5 * (last - first) / (map.distances.len().max(2) - 1) as f64;
    (first - half, last + half)
}

fn height_of(map: &Map, distance: f64) -> f64 {
    plot(map).spot((0.0, distance))[1]
}

/// Cells of one shade beside each other in a row are one rectangle.
fn cells(map: &Map) -> Group {
    let mut group = Group::new().set("shape-rendering", "crispEdges");
    let (rows, columns) = (map.distances.len(), map.fractions.len());
    let (width, height) = (FIELD.width() / columns as f64, FIELD.height() / rows as f64);
    for (row, cells) in map.cells.chunks(columns.max(1)).enumerate() {
        let top = FIELD.bottom - (row + 1) as f64 * height;
        let mut column = 0;
        for run in cells.chunk_by(|a, b| Shade::of(a) == Shade::of(b)) {
            let left = FIELD.left + column as f64 * width;
            column += run.len();
            let right = FIELD.left + column as f64 * width;
            let frame = Frame {
                left,
                top,
                right,
                bottom: top + height,
            };
            group.append(frame.rectangle().set("fill", Shade::of(&run[0]).colour()));
        }
    }
    group
}

/// The field with its data: the phase over a pitch, the centre distance upwards.
fn plot(map: &Map) -> Plot {
    let Frame {
        left,
        right,
        top,
        bottom,
    } = FIELD;
    let (low, high) = range(map);
    Plot {
        left,
        right,
        top,
        bottom,
        x: [0.0, 1.0],
        y: [low, high],
    }
}

fn axes(map: &Map) -> Group {
    let plot = plot(map);
    let phase = format!("pitches on from {}", pose_name(&map.start));
    let x = Axis::new(&phase, plot.x);
    let y = Axis::new("centre distance a, mm", plot.y);
    kit::axes(&plot, [&x, &y], [6, 10])
}

/// Lines across the field, their names on the right, moved apart where they would collide.
fn limits(map: &Map) -> Group {
    const APART: f64 = 17.0;
    let mut group = Group::new();
    // From the top down.
    let named: Vec<(f64, String)> = map
        .limits
        .iter()
        .rev()
        .map(|limit| {
            let label = format!("{:.4} {}", limit.distance, limit.name);
            (height_of(map, limit.distance), label)
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
fn legend(map: &Map) -> Group {
    let mut group = Group::new();
    let used = |shade: &Shade| map.cells.iter().any(|cell| Shade::of(cell) == *shade);
    for (i, shade) in Shade::ALL.into_iter().filter(used).enumerate() {
        let left = FIELD.left + (i % 3) as f64 * 250.0;
        let top = FIELD.bottom + 66.0 + (i / 3) as f64 * 24.0;
        let frame = Frame {
            left,
            top,
            right: left + 22.0,
            bottom: top + 14.0,
        };
        let swatch = frame.rectangle().set("fill", shade.colour());
        group.append(swatch.set("stroke", GREY).set("stroke-width", "0.8"));
        group.append(TextStyle::new(13.0).text(shade.name(), [left + 30.0, top + 11.5]));
    }
    group
}
