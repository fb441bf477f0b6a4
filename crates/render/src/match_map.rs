//! A map of wheels and pinions.
//!
//! A pair's shade is the deviation of its backlash from the target, in the best assembly phase: the larger of both extremes over
//! the mesh cycle. A cross marks pairs that meet the requirement in no phase.

use crate::kit::{Frame, INK, TextStyle, blank_sheet, disc, line, number, scale, shaded, turned};
use gearlash_input::matching::MatchResult;
use gearlash_text::characters::plain;
use gearlash_text::numbers::{rounded, shortest};
use svg::node::Node;
use svg::node::element::Group;

const WIDTH: f64 = 900.0;
const FIELD: Frame = Frame::new([110.0, 84.0], [650.0, 624.0]);
const HEIGHT: f64 = 740.0;
/// Most gears of a kind that are named individually.
const MOST_NAMED: usize = 45;
/// Room for upright names below the field.
const UPRIGHT: f64 = 100.0;

const SMALL: TextStyle = TextStyle::new(12.0);

/// Shades for increasing distance from the target, distinguished by lightness.
const SHADES: [&str; 5] = ["#08457e", "#2f7ab8", "#6fa9d3", "#abcde6", "#dce9f4"];

/// Wheels downwards, pinions to the right; a dot marks a matched pair.
pub fn match_map(result: &MatchResult) -> String {
    let size = result.names.each_ref().map(Vec::len);
    let step = step(result);
    let (title, room) = (TextStyle::new(18.0), WIDTH - 2.0 * 24.0);
    let sentence = SMALL.shortened(&result.sentence(), room);
    blank_sheet(WIDTH, HEIGHT)
        .add(title.verbatim(&title.shortened(&plain(&result.title), room), [24.0, 32.0]))
        .add(SMALL.grey().verbatim(&sentence, [24.0, 54.0]))
        .add(cells(result, size, step))
        .add(FIELD.border())
        .add(dots(result, size))
        .add(names(result, size))
        .add(legend(result, step))
        .to_string()
}

/// The deviation of a pair's backlash from the target, µm, where it has a backlash.
fn deviation_um(result: &MatchResult, wheel: usize, pinion: usize) -> Option<f64> {
    let fit = result.matrix.pair_fit(wheel, pinion)?.best;
    fit.off.is_finite().then_some(1e3 * fit.off)
}

/// Width of a shade, µm: a round number. The last shade begins within the range of the pairs that meet the requirement.
fn step(result: &MatchResult) -> f64 {
    let [wheels, pinions] = result.names.each_ref().map(Vec::len);
    let pairs = (0..wheels).flat_map(|wheel| (0..pinions).map(move |pinion| (wheel, pinion)));
    let meeting = pairs.filter(|&(wheel, pinion)| meets(result, wheel, pinion));
    let farthest = meeting.filter_map(|(wheel, pinion)| deviation_um(result, wheel, pinion));
    let farthest = farthest.fold(0.0, f64::max);
    scale::round_down((farthest / 4.0).max(0.1), scale::FINE)
}

fn meets(result: &MatchResult, wheel: usize, pinion: usize) -> bool {
    let pair = result.matrix.pair_fit(wheel, pinion);
    pair.is_some_and(|pair| pair.phases_that_meet > 0)
}

/// The shade of a pair; `None` where it has no backlash.
fn shade(result: &MatchResult, wheel: usize, pinion: usize, step: f64) -> Option<&'static str> {
    let off = deviation_um(result, wheel, pinion)?;
    let last = SHADES.len() - 1;
    Some(SHADES[((off / step) as usize).min(last)])
}

fn cell([wheel, pinion]: [usize; 2], [wheels, pinions]: [usize; 2]) -> Frame {
    let corner = |wheel: usize, pinion: usize| {
        [
            FIELD.left + pinion as f64 * (FIELD.width() / pinions as f64),
            FIELD.top + wheel as f64 * (FIELD.height() / wheels as f64),
        ]
    };
    Frame::new(corner(wheel, pinion), corner(wheel + 1, pinion + 1))
}

/// The shades of the pairs, and crosses over those that miss the requirement.
fn cells(result: &MatchResult, size: [usize; 2], step: f64) -> Group {
    let [wheels, pinions] = size;
    let shades = (0..wheels).map(|wheel| {
        let row = (0..pinions).map(|pinion| shade(result, wheel, pinion, step));
        row.map(|shade| shade.unwrap_or("#ffffff")).collect()
    });
    let mut crosses = Group::new();
    for wheel in 0..wheels {
        for pinion in (0..pinions).filter(|pinion| !meets(result, wheel, *pinion)) {
            crosses.append(cross_out(&cell([wheel, pinion], size)));
        }
    }
    let shades: Vec<Vec<&str>> = shades.collect();
    Group::new().add(shaded(&FIELD, &shades)).add(crosses)
}

/// A cross over a cell, readable on every shade.
fn cross_out(cell: &Frame) -> Group {
    let half = (0.22 * cell.width().min(cell.height())).min(5.0);
    let [x, y] = cell.middle();
    let mut group = Group::new();
    for (colour, width) in [("#ffffff", 2.6), (INK, 1.1)] {
        for tilt in [half, -half] {
            let stroke = [[x - half, y - tilt], [x + half, y + tilt]];
            group.append(line(&stroke, colour, width));
        }
    }
    group
}

fn dots(result: &MatchResult, size: [usize; 2]) -> Group {
    let first = cell([0, 0], size);
    let radius = (0.28 * first.width().min(first.height())).clamp(1.2, 7.0);
    let dots = result.places.iter().map(|&(wheel, pinion)| {
        disc(cell([wheel, pinion], size).middle(), radius, INK)
            .set("stroke", "#ffffff")
            .set("stroke-width", number(0.25 * radius))
    });
    dots.fold(Group::new(), Group::add)
}

/// The names of the gears where there are few enough, else their number.
fn names(result: &MatchResult, size: [usize; 2]) -> Group {
    let mut group = Group::new();
    let [wheels, pinions] = size;
    let left = FIELD.left - 6.0;
    if wheels <= MOST_NAMED {
        for (wheel, name) in result.names[0].iter().enumerate() {
            let [_, y] = cell([wheel, 0], size).middle();
            let name = SMALL.shortened(&plain(name), FIELD.left - 16.0);
            group.append(SMALL.end().verbatim(&name, [left, y + 4.0]));
        }
    } else {
        let text = format!("{wheels} wheels");
        group.append(SMALL.end().text(&text, [left, FIELD.middle()[1]]));
    }
    if pinions > MOST_NAMED {
        let text = format!("{pinions} pinions");
        let below = [FIELD.middle()[0], FIELD.bottom + 16.0];
        return group.add(SMALL.middle().text(&text, below));
    }
    let room = FIELD.width() / pinions as f64 - 4.0;
    let names: Vec<String> = result.names[1].iter().map(|name| plain(name)).collect();
    let lie = names.iter().all(|name| SMALL.width(name) <= room);
    for (pinion, name) in names.iter().enumerate() {
        let [x, _] = cell([0, pinion], size).middle();
        if lie {
            let at = [x, FIELD.bottom + 16.0];
            group.append(SMALL.middle().verbatim(name, at));
        } else {
            let at = [x + SMALL.below_middle(), FIELD.bottom + 8.0];
            let name = SMALL.shortened(name, UPRIGHT);
            group.append(turned(SMALL.end().verbatim(&name, at), at));
        }
    }
    group
}

fn legend(result: &MatchResult, step: f64) -> Group {
    let left = FIELD.right + 20.0;
    let mut y = FIELD.top + 12.0;
    let mut group = Group::new().add(SMALL.bold().text("from the target, best phase", [left, y]));
    let um = |value: f64| shortest(rounded(value, 6));
    let target = format!("target {} µm", um(1e3 * result.wanted));
    group.append(SMALL.grey().text(&target, [left, y + 20.0]));
    y += 24.0;
    for (number, colour) in SHADES.iter().enumerate() {
        y += 24.0;
        let frame = Frame::new([left, y - 12.0], [left + 16.0, y + 4.0]);
        let from = step * number as f64;
        let name = if number + 1 == SHADES.len() {
            format!("{} µm or more", um(from))
        } else {
            format!("{} … {} µm", um(from), um(from + step))
        };
        group.append(frame.rectangle().set("fill", *colour).set("stroke", INK));
        group.append(SMALL.text(&name, [left + 24.0, y]));
    }
    y += 26.0;
    let frame = Frame::new([left, y - 12.0], [left + 16.0, y + 4.0]);
    group.append(cross_out(&frame));
    group.append(SMALL.text("misses what is required", [left + 24.0, y]));
    y += 26.0;
    let dot = disc([left + 8.0, y - 4.0], 5.0, INK);
    let phases = format!("{} assembly phases of each pair", result.matrix.phases());
    group
        .add(dot)
        .add(SMALL.text("go together", [left + 24.0, y]))
        .add(SMALL.grey().text(&phases, [left, y + 28.0]))
}
