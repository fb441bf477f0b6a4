//! Two outlines of one gear: A to scale, B's deviation from it enlarged, with its greatest and least value.

use super::subject::{INSETS, MAIN};
use super::view::{MARGIN, View};
use crate::kit::{
    ACTION, Frame, GAP, HEIGHT, INK, Ids, OVERLAP, Spot, TextStyle, WHEEL, WIDTH, arrow,
    blank_sheet, clip, clipped, define_frame, dot, line, polygon, scale,
};
use gearlash::outline::{Deviation, OutlineDifference, OutlineGear};
use gearlash_input::outlines::ComparedOutlines;
use gearlash_results::{difference_sentence, turn_words};
use gearlash_text::numbers::{fixed, signed_um};
use nalgebra::Point2;
use svg::node::element::Group;

/// The largest deviation is enlarged to this share of a pitch at the tips, so that it is visible and stays with its tooth.
const ENLARGED: f64 = 0.15;
const PITCHES: f64 = 1.6;
/// Points nearer than this on the sheet are merged: half a line's width.
const MERGE_WITHIN: f64 = 0.5;

/// The difference of two outlines as the SVG text of a sheet.
pub fn outline_difference(compared: &ComparedOutlines) -> String {
    let [a, _] = &compared.gears;
    let found = &compared.difference;
    let factor = factor(a, compared.farthest().beyond.abs());
    let fits = 0.5 * (MAIN.height() - 60.0) / a.tip_radius();
    let main = View::at_most(MAIN, Point2::origin(), fits, scale::FINE);
    let ids = Ids::default();
    let teeth = [1, found.greatest.tooth, found.least.tooth];
    let mut sheet = blank_sheet(WIDTH, HEIGHT)
        .add(caption(compared, factor))
        .add(outlines(found, &main, "whole", &ids, factor))
        .add(numbers(a, &teeth, &main))
        .add(MAIN.border());
    let pitch = a.pitch() * a.tip_radius();
    let places = [("greatest", &found.greatest), ("least", &found.least)];
    for ((name, at), frame) in places.into_iter().zip(INSETS) {
        let fits = frame.height() / (PITCHES * pitch);
        let near = View::at_most(frame, at.point, fits, scale::FINE);
        let words = words(compared, name, at);
        let style = TextStyle::new(14.0).fitted(&words, frame.width(), 9.0);
        sheet = sheet
            .add(style.text(&words, [frame.left, frame.top - 8.0]))
            .add(outlines(found, &near, name, &ids, factor))
            .add(mark(at, &near, factor))
            .add(frame.border())
            .add(scale::bar([frame.left, frame.bottom + 16.0], near.scale))
            .add(mark(at, &main, factor));
    }
    sheet = sheet
        .add(scale::bar([MAIN.left, MAIN.bottom + 16.0], main.scale))
        .add(legend(factor));
    format!("{sheet}\n")
}

/// Enlargement of deviations: 1, 2 or 5 times a power of ten, at least 1.
fn factor(a: &OutlineGear, farthest: f64) -> f64 {
    let room = ENLARGED * a.pitch() * a.tip_radius();
    if farthest > 1e-9 * room {
        scale::round_down(room / farthest, scale::ISO_5455).max(1.0)
    } else {
        1.0
    }
}

/// The drawn point of B at a place of A.
fn enlarged(at: &Deviation, factor: f64) -> Point2<f64> {
    at.point + at.normal * (factor * at.beyond)
}

fn outlines(found: &OutlineDifference, view: &View, id: &str, ids: &Ids, factor: f64) -> Group {
    let wide = view.frame.grown(MARGIN);
    let spots = |at: &Deviation| [at.point, enlarged(at, factor)].map(|point| view.spot(point));
    let far = |from: Spot, to: Spot| (from[0] - to[0]).hypot(from[1] - to[1]) >= MERGE_WITHIN;
    let mut places: Vec<[Spot; 2]> = Vec::new();
    let mut strips: Vec<(bool, Vec<[Spot; 2]>)> = Vec::new();
    for at in &found.along {
        let here = spots(at);
        if places
            .last()
            .is_some_and(|last| !far(last[0], here[0]) && !far(last[1], here[1]))
        {
            continue;
        }
        places.push(here);
        let more = at.beyond > 0.0;
        match strips.last_mut().filter(|(sign, _)| *sign == more) {
            Some((_, strip)) => strip.push(here),
            None => strips.push((more, vec![here])),
        }
    }
    places.extend(places.first().copied());
    let lines = [0, 1].map(|k| places.iter().map(|place| place[k]).collect::<Vec<Spot>>());
    let limit = format!("{id}-frame");
    let mut group = clipped(ids, &limit)
        .add(define_frame(ids, &limit, &view.frame))
        .add(polygon(&clip::polygon(&lines[0], &wide), WHEEL));
    for (more, strip) in &strips {
        let back = strip.iter().rev().map(|place| place[1]);
        let ring: Vec<Spot> = strip.iter().map(|place| place[0]).chain(back).collect();
        let shown = clip::polygon(&ring, &wide);
        if !shown.is_empty() {
            group = group.add(polygon(&shown, if *more { OVERLAP } else { GAP }));
        }
    }
    for (of, colour, width) in [(&lines[1], ACTION, 1.2), (&lines[0], INK, 1.6)] {
        for run in clip::runs(of, &wide) {
            group = group.add(line(&run, colour, width).set("stroke-linejoin", "round"));
        }
    }
    group
}

/// A place on A, and the line from it to B as drawn.
fn mark(at: &Deviation, view: &View, factor: f64) -> Group {
    let [from, to] = [at.point, enlarged(at, factor)].map(|point| view.spot(point));
    let group = Group::new().add(dot(from, 4.5, false));
    if (to[0] - from[0]).hypot(to[1] - from[1]) > 16.0 {
        group.add(arrow(from, to, 1.4))
    } else {
        group
    }
}

/// Numbers of A's teeth, below their roots.
fn numbers(a: &OutlineGear, teeth: &[u32], view: &View) -> Group {
    let style = TextStyle::new(14.0).middle();
    let mut shown = teeth.to_vec();
    shown.sort_unstable();
    shown.dedup();
    shown.iter().fold(Group::new(), |group, tooth| {
        let (sin, cos) = (a.drawn_direction() + a.tooth_angle(f64::from(*tooth))).sin_cos();
        let radius = a.root_radius() - 24.0 / view.scale;
        let [x, y] = view.spot(Point2::new(radius * cos, radius * sin));
        group.add(style.text(&tooth.to_string(), [x, y + style.below_middle()]))
    })
}

fn words(compared: &ComparedOutlines, name: &str, at: &Deviation) -> String {
    let place = compared.in_drawing(at);
    format!(
        "{name}: {} µm, tooth {}, radius {} mm, at ({}, {}) mm in A",
        signed_um(at.beyond, 2).replace('-', "−"),
        at.tooth,
        fixed(at.point.coords.norm(), 4),
        fixed(place.x, 4),
        fixed(place.y, 4)
    )
}

fn caption(compared: &ComparedOutlines, factor: f64) -> Group {
    let (left, room) = (MAIN.left, WIDTH - 2.0 * MAIN.left);
    let [a, b] = &compared.files;
    let title = format!("A {a} and B {b}");
    let (heading, second) = (TextStyle::new(24.0).bold(), TextStyle::new(16.0));
    let warning = format!("deviations × {factor}: B is not to scale");
    let (sentence, turned) = (difference_sentence(compared), turn_words(compared));
    let right = second.bold().end().colour("#a32014");
    let first = heading.fitted(&title, room, 14.0);
    let grey = second.grey().fitted(&turned, room, 11.0);
    Group::new()
        .add(first.verbatim(&heading.shortened(&title, 1.6 * room), [left, 46.0]))
        .add(grey.text(&turned, [left, 73.0]))
        .add(second.text(&second.shortened(&sentence, room), [left, 97.0]))
        .add(right.text(&warning, [MAIN.right, MAIN.top - 8.0]))
}

fn legend(factor: f64) -> Group {
    let y = 772.0;
    let style = TextStyle::new(13.0);
    let of_b = format!("B, its distance from A × {factor}");
    let lines = [(INK, 1.6, "A", 30.0), (ACTION, 1.2, of_b.as_str(), 130.0)];
    let fills = [
        (OVERLAP, "B has more material", 430.0),
        (GAP, "B has less material", 680.0),
    ];
    let mut group = Group::new();
    for (colour, width, words, x) in lines {
        group = group
            .add(line(&[[x, y], [x + 36.0, y]], colour, width))
            .add(style.text(words, [x + 44.0, y + 4.5]));
    }
    for (colour, words, x) in fills {
        let frame = Frame::new([x, y - 6.0], [x + 36.0, y + 6.0]);
        group = group
            .add(polygon(&frame.corners(), colour))
            .add(style.text(words, [x + 44.0, y + 4.5]));
    }
    group
}
