//! A map of which wheel goes with which pinion.

use crate::kit::{Frame, INK, TextStyle, blank_sheet, number};
use gearlash_files::characters::plain;
use gearlash_files::matching::MatchResult;
use svg::node::element::{Circle, Group};

const WIDTH: f64 = 900.0;
const FIELD: Frame = Frame {
    left: 110.0,
    top: 84.0,
    right: 650.0,
    bottom: 624.0,
};
const HEIGHT: f64 = 670.0;
/// Gears of a kind up to which each is named.
const MOST_NAMED: usize = 40;

const SMALL: TextStyle = TextStyle::new(12.0);
const TINY: TextStyle = TextStyle::new(9.0);

/// Shades by the share of the assembly phases that are within what is required, and their names: told apart by lightness.
const SHADES: [(&str, &str); 4] = [
    ("#ffffff", "no phase"),
    ("#d3e3ee", "some phases"),
    ("#86afcf", "half of the phases or more"),
    ("#2f6f9f", "every phase"),
];

/// Wheels downwards, pinions to the right, each pair in the shade of how many of its phases are within what is required; a dot where the
/// two go together.
pub fn match_map(result: &MatchResult) -> String {
    let wheels = result.names[0].len();
    let pinions = result.names[1].len();
    let caption = format!("{} assembly phases of each pair", result.matrix.phases());
    let document = blank_sheet(WIDTH, HEIGHT)
        .add(TextStyle::new(18.0).verbatim(
            &TextStyle::new(18.0).shortened(&plain(&result.title), WIDTH - 2.0 * 24.0),
            [24.0, 32.0],
        ))
        .add(SMALL.grey().verbatim(
            &SMALL.shortened(&result.sentence(), WIDTH - 2.0 * 24.0),
            [24.0, 54.0],
        ))
        .add(cells(result, [wheels, pinions]))
        .add(FIELD.border())
        .add(dots(result, [wheels, pinions]))
        .add(names(result, [wheels, pinions]))
        .add(legend(&caption));
    document.to_string()
}

fn cell([wheel, pinion]: [usize; 2], [wheels, pinions]: [usize; 2]) -> Frame {
    let (width, height) = (
        FIELD.width() / pinions as f64,
        FIELD.height() / wheels as f64,
    );
    Frame {
        left: FIELD.left + pinion as f64 * width,
        top: FIELD.top + wheel as f64 * height,
        right: FIELD.left + (pinion + 1) as f64 * width,
        bottom: FIELD.top + (wheel + 1) as f64 * height,
    }
}

/// Cells of one shade beside each other in a row are one rectangle.
fn cells(result: &MatchResult, size: [usize; 2]) -> Group {
    let mut group = Group::new().set("shape-rendering", "crispEdges");
    for wheel in 0..size[0] {
        let shade = |pinion| shade(result, wheel, pinion);
        let row: Vec<usize> = (0..size[1]).map(shade).collect();
        let mut first = 0;
        for run in row.chunk_by(|a, b| a == b) {
            let last = first + run.len() - 1;
            let frame = Frame {
                right: cell([wheel, last], size).right,
                ..cell([wheel, first], size)
            };
            group = group.add(frame.rectangle().set("fill", SHADES[run[0]].0));
            first = last + 1;
        }
    }
    group
}

fn shade(result: &MatchResult, wheel: usize, pinion: usize) -> usize {
    let phases = result.matrix.phases();
    let meeting = result.matrix.pair_fit(wheel, pinion);
    match meeting.map_or(0, |meeting| meeting.meeting) {
        0 => 0,
        all if all == phases => 3,
        many if 2 * many >= phases => 2,
        _ => 1,
    }
}

fn dots(result: &MatchResult, size: [usize; 2]) -> Group {
    let mut group = Group::new();
    let radius =
        (0.28 * cell([0, 0], size).width().min(cell([0, 0], size).height())).clamp(1.2, 7.0);
    for &(wheel, pinion) in &result.places {
        let [x, y] = cell([wheel, pinion], size).middle();
        group = group.add(
            Circle::new()
                .set("cx", number(x))
                .set("cy", number(y))
                .set("r", number(radius))
                .set("fill", INK)
                .set("stroke", "#ffffff")
                .set("stroke-width", number(0.25 * radius)),
        );
    }
    group
}

/// The names of the gears, where there are few enough; else how many there are.
fn names(result: &MatchResult, size: [usize; 2]) -> Group {
    let mut group = Group::new();
    let [wheels, pinions] = size;
    if wheels <= MOST_NAMED {
        for (wheel, name) in result.names[0].iter().enumerate() {
            let [_, y] = cell([wheel, 0], size).middle();
            let name = SMALL.shortened(&plain(name), FIELD.left - 16.0);
            group = group.add(SMALL.end().verbatim(&name, [FIELD.left - 6.0, y + 4.0]));
        }
    } else {
        let text = format!("{wheels} wheels");
        group = group.add(
            SMALL
                .end()
                .text(&text, [FIELD.left - 6.0, FIELD.middle()[1]]),
        );
    }
    let below = FIELD.bottom + 16.0;
    if pinions <= MOST_NAMED {
        let room = FIELD.width() / pinions as f64 - 2.0;
        for (pinion, name) in result.names[1].iter().enumerate() {
            let [x, _] = cell([0, pinion], size).middle();
            let name = TINY.shortened(&plain(name), room);
            group = group.add(TINY.middle().verbatim(&name, [x, below]));
        }
    } else {
        let text = format!("{pinions} pinions");
        group = group.add(SMALL.middle().text(&text, [FIELD.middle()[0], below]));
    }
    group
}

fn legend(caption: &str) -> Group {
    let left = FIELD.right + 20.0;
    let mut group = Group::new();
    let mut y = FIELD.top + 12.0;
    group = group.add(SMALL.bold().text("within what is required", [left, y]));
    for (colour, name) in SHADES.iter().rev() {
        y += 24.0;
        let frame = Frame {
            left,
            top: y - 12.0,
            right: left + 16.0,
            bottom: y + 4.0,
        };
        group = group
            .add(frame.rectangle().set("fill", *colour).set("stroke", INK))
            .add(SMALL.text(name, [left + 24.0, y]));
    }
    y += 28.0;
    group
        .add(
            Circle::new()
                .set("cx", number(left + 8.0))
                .set("cy", number(y - 4.0))
                .set("r", "5")
                .set("fill", INK),
        )
        .add(SMALL.text("go together", [left + 24.0, y]))
        .add(SMALL.grey().text(caption, [left, y + 28.0]))
}
