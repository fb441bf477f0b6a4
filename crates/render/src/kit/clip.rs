//! Cuts polygons and lines to a frame, so that a file holds only its picture.

use super::frame::{Frame, Spot};

/// One of the four half planes of a frame: coordinate, limit, and +1 to keep larger values.
type Edge = (usize, f64, f64);

fn edges(frame: &Frame) -> [Edge; 4] {
    [
        (0, frame.left, 1.0),
        (0, frame.right, -1.0),
        (1, frame.top, 1.0),
        (1, frame.bottom, -1.0),
    ]
}

/// The part of a closed `polygon` inside `frame` (Sutherland and Hodgman, 1974).
///
/// Separate parts stay joined along the frame's edge.
pub fn polygon(polygon: &[Spot], frame: &Frame) -> Vec<Spot> {
    edges(frame)
        .into_iter()
        .fold(polygon.to_vec(), |points, edge| {
            let mut kept = Vec::new();
            for (i, &to) in points.iter().enumerate() {
                let from = points[(i + points.len() - 1) % points.len()];
                if inside(from, edge) != inside(to, edge) {
                    kept.push(crossing(from, to, edge));
                }
                if inside(to, edge) {
                    kept.push(to);
                }
            }
            kept
        })
}

/// The part of the segment from `from` to `to` inside `frame`.
pub fn segment(mut from: Spot, mut to: Spot, frame: &Frame) -> Option<[Spot; 2]> {
    for edge in edges(frame) {
        match (inside(from, edge), inside(to, edge)) {
            (true, true) => {}
            (true, false) => to = crossing(from, to, edge),
            (false, true) => from = crossing(from, to, edge),
            (false, false) => return None,
        }
    }
    Some([from, to])
}

/// The runs of an open line that touch `frame`; whole segments, not cut at its edge.
pub fn runs(points: &[Spot], frame: &Frame) -> Vec<Vec<Spot>> {
    let mut runs: Vec<Vec<Spot>> = Vec::new();
    let mut joined = false;
    for pair in points.windows(2) {
        let touches = segment(pair[0], pair[1], frame).is_some();
        match runs.last_mut() {
            Some(run) if touches && joined => run.push(pair[1]),
            _ if touches => runs.push(pair.to_vec()),
            _ => {}
        }
        joined = touches;
    }
    runs
}

/// The parts of an open line inside `frame`, cut at its edge.
pub fn parts(points: &[Spot], frame: &Frame) -> Vec<Vec<Spot>> {
    let mut parts: Vec<Vec<Spot>> = Vec::new();
    for pair in points.windows(2) {
        let Some([from, to]) = segment(pair[0], pair[1], frame) else {
            continue;
        };
        match parts.last_mut() {
            Some(part) if part.last() == Some(&from) => part.push(to),
            _ => parts.push(vec![from, to]),
        }
    }
    parts
}

/// The places on x where the line at `y` crosses the edges of a closed `polygon`.
pub fn crossings(polygon: &[Spot], y: f64) -> Vec<f64> {
    let edges = (0..polygon.len()).map(|i| [polygon[i], polygon[(i + 1) % polygon.len()]]);
    let crossed = edges.filter(|[from, to]| (from[1] > y) != (to[1] > y));
    crossed
        .map(|[from, to]| from[0] + (y - from[1]) / (to[1] - from[1]) * (to[0] - from[0]))
        .collect()
}

fn inside(spot: Spot, (axis, limit, sign): Edge) -> bool {
    sign * (spot[axis] - limit) >= 0.0
}

fn crossing(from: Spot, to: Spot, (axis, limit, _): Edge) -> Spot {
    let part = (limit - from[axis]) / (to[axis] - from[axis]);
    let mut spot = [0, 1].map(|i| from[i] + part * (to[i] - from[i]));
    spot[axis] = limit;
    spot
}
