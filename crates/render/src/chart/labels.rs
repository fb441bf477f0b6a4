//! Texts in a plot, placed so that none crosses a line, a mark or another text.
//!
//! A text has a preferred place in the data. Candidates go up, down and sideways from there; the nearest free one is taken. Where
//! none is near, the axis gets more room and the texts are placed again.

use super::panel::{Mark, Panel};
use super::{marks, thin};
use crate::kit::{Anchor, Frame, Occupied, Plot, Spot, TextStyle, around};

pub(super) const STYLE: TextStyle = TextStyle::new(12.0);
const LINE: f64 = 15.0;
/// Height of capitals at [`STYLE`], and depth of letters and subscripts below them.
const CAPITALS: f64 = 0.73 * 12.0;
const DEPTH: f64 = 3.0;
const EDGE: f64 = 3.0;
/// Steps between candidates, down and across.
const STEPS: [f64; 2] = [3.0, 12.0];
/// A text more distant than this from its preferred place lacks room (tuned: three lines).
const NEAR: f64 = 48.0;
const CLEAR: f64 = 2.0;

/// A line of a text, and the left end of its baseline.
type Line = (String, Spot);

/// The side of the data on which a text lacks room.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Lacking {
    Above,
    Below,
}

/// The lines of the texts of `panel` in `plot`, and the side where room is lacking, if any; a text is then placed as free as possible.
pub(super) fn place(panel: &Panel, plot: &Plot) -> (Vec<Line>, Option<Lacking>) {
    let mut taken = obstacles(panel, plot);
    let (mut placed, mut lacking) = (Vec::new(), None);
    let note = "shaded: min–max envelope of swings too narrow to draw";
    let corner = [panel.x.range[1], panel.y.range[1]];
    let note = Mark::text(corner, [-4.0, 10.0], note, Anchor::End);
    let note = marks::has_envelope(&panel.marks, plot).then_some(note);
    for mark in panel.marks.iter().chain(&note) {
        let Mark::Text {
            at,
            shift,
            text,
            anchor,
        } = mark
        else {
            continue;
        };
        let lines = STYLE.wrapped(text, plot.frame.width() - 2.0 * EDGE, 3);
        let widths = lines.iter().map(|line| STYLE.width(line));
        let size = [
            widths.fold(0.0, f64::max),
            CAPITALS + DEPTH + LINE * (lines.len() - 1) as f64,
        ];
        let [x, y] = plot.spot((at[0], at[1]));
        let left = match anchor {
            Anchor::Start => x + shift[0],
            Anchor::Middle => x + shift[0] - 0.5 * size[0],
            Anchor::End => x + shift[0] - size[0],
        };
        // A text of several lines extends away from its place.
        let first = y + shift[1] - 0.5 * CAPITALS;
        let top = if shift[1] < 0.0 {
            first + CAPITALS + DEPTH - size[1]
        } else {
            first
        };
        let (room, far) = nearest([left, top], size, plot, &taken);
        let is_upper = y < plot.frame.middle()[1];
        lacking = lacking.or(match far {
            Some(far) if far <= NEAR => None,
            _ if is_upper => Some(Lacking::Above),
            // An axis that begins at 0 does not extend below it.
            Some(_) if plot.y[0] == 0.0 => None,
            None if plot.y[0] == 0.0 => Some(Lacking::Above),
            _ => Some(Lacking::Below),
        });
        taken.frame(room);
        let foot = |number: usize| room.top + CAPITALS + LINE * number as f64;
        let lines = lines.into_iter().enumerate();
        placed.extend(lines.map(|(number, line)| (line, [room.left, foot(number)])));
    }
    (placed, lacking)
}

/// The free room of a size nearest to `wanted` (its upper left corner), and its distance; `None` where none is free.
fn nearest(wanted: Spot, size: [f64; 2], plot: &Plot, taken: &Occupied) -> (Frame, Option<f64>) {
    let within = plot.frame;
    let first = [
        wanted[0]
            .min(within.right - EDGE - size[0])
            .max(within.left + EDGE),
        wanted[1]
            .min(within.bottom - EDGE - size[1])
            .max(within.top + EDGE),
    ];
    let at = |left: f64, top: f64| Frame::new([left, top], [left + size[0], top + size[1]]);
    let ways = |axis: usize, room: f64| {
        let count = (room / STEPS[axis]) as i32;
        (-count..=count).map(move |step| f64::from(step) * STEPS[axis])
    };
    let mut candidates: Vec<(f64, Frame)> = Vec::new();
    for down in ways(0, within.height()) {
        for across in ways(1, 0.5 * within.width()) {
            let frame = at(first[0] + across, first[1] + down);
            if within.grown(0.1 - EDGE).holds(&frame) {
                candidates.push((down.abs() + 0.4 * across.abs(), frame));
            }
        }
    }
    // Numbers that are not negative have the order of their bits.
    candidates.sort_by_cached_key(|(away, _)| away.to_bits());
    let mut candidates = candidates.iter();
    match candidates.find(|(_, frame)| taken.is_clear(frame, CLEAR)) {
        Some((far, frame)) => (*frame, Some(*far)),
        None => (at(first[0], first[1]), None),
    }
}

/// The obstacles in a plot: lines, single values and bars.
fn obstacles(panel: &Panel, plot: &Plot) -> Occupied {
    let mut taken = Occupied::default();
    for mark in &panel.marks {
        match mark {
            Mark::Line(points, ..) => {
                for run in thin::runs(points, 1.0 / plot.scale()[0]) {
                    let spots: Vec<Spot> = run.iter().map(|point| plot.spot(*point)).collect();
                    taken.line(&spots);
                }
            }
            Mark::Dots(points, _) => {
                let known = points.iter().filter_map(|&(x, y)| Some((x, y?)));
                known.for_each(|point| taken.frame(around(plot.spot(point), 4.0)));
            }
            Mark::Bar(x, y, _) => {
                taken.frame(plot.between(*x, *y));
            }
            Mark::Ground(_) | Mark::Shade(..) | Mark::Band(..) | Mark::Text { .. } => {}
        }
    }
    taken
}
