//! Both gears' metal in one view, turning about their axes, and their overlap.

use super::view::{MARGIN, View};
use crate::kit::{
    INK, Ids, OVERLAP, Occupied, PINION, Spot, WHEEL, area, clip, define_area, inner_outline,
    number, path_data,
};
use gearlash::contact::{PoseResult, Scene};
use gearlash::pair::Member;
use gearlash_files::numbers::{ascii, fixed};
use std::f64::consts::TAU;
use svg::node::element::{Animate, AnimateTransform, ClipPath, Definitions, Group, Path};

/// Both gears, each turned about its axis.
pub fn metal(
    first: &Scene,
    scenes: &[Scene],
    times: &[f64],
    view: &View,
    occupied: &mut Occupied,
) -> Group {
    let mut definitions = Definitions::new().add(
        ClipPath::new()
            .set("id", "mesh-frame")
            .add(view.frame.rectangle()),
    );
    let ids = Ids::default();
    let mut gears = Vec::new();
    let mut outlines = Group::new();
    for (member, fill) in Member::BOTH.into_iter().zip([WHEEL, PINION]) {
        let placed = first.placed(member);
        let turns = turns(scenes, member);
        let axis = view.spot(placed.axis());
        let frame = &view.frame;
        // Metal that enters the frame during a pitch is at most as far off as its farthest corner moves.
        let far = frame
            .corners()
            .map(|[x, y]| (x - axis[0]).hypot(y - axis[1]));
        let angle = turns.iter().map(|turn| turn.abs()).fold(0.0, f64::max);
        let moved = far.into_iter().fold(0.0, f64::max) * angle;
        let reach = view.reach() + moved / view.scale;
        let outline = placed.outline_near(view.middle, reach, view.chord());
        let polygon = clip::polygon(&view.spots(&outline), &frame.grown(MARGIN + moved));
        occupied.line(&polygon);
        let motion = || rotation(&turns, times, axis);
        let name = member.name();
        let turning = Path::new().set("d", path_data(&polygon, true));
        definitions = define_area(definitions, &ids, name, &polygon).add(
            ClipPath::new()
                .set("id", format!("{name}-turning"))
                .add(turning.add(motion())),
        );
        let filled = area(&ids, name).set("fill", fill);
        gears.push(Group::new().add(motion()).add(filled));
        let outline = inner_outline(&ids, name, INK, "2.40");
        outlines = outlines.add(Group::new().add(motion()).add(outline));
    }
    let group = Group::new()
        .set("clip-path", "url(#mesh-frame)")
        .add(definitions);
    let group = gears.into_iter().fold(group, Group::add);
    group.add(outlines).add(overlap(scenes, times, view))
}

/// The pinion's metal again, clipped by the wheel's.
fn overlap(scenes: &[Scene], times: &[f64], view: &View) -> Group {
    let pinion = Member::Pinion;
    let axis = view.spot(scenes[0].placed(pinion).axis());
    let turns = turns(scenes, pinion);
    let layers = [OVERLAP, "url(#hatch)"].map(|fill| {
        let shape = area(&Ids::default(), pinion.name());
        Group::new()
            .add(rotation(&turns, times, axis))
            .add(shape.set("fill", fill))
    });
    let clip = Group::new().set("clip-path", "url(#wheel-turning)");
    layers.into_iter().fold(clip, Group::add)
}

/// Rotation of a gear at each step since the first, rad.
pub fn turns(scenes: &[Scene], member: Member) -> Vec<f64> {
    let mut turns: Vec<f64> = Vec::new();
    for scene in scenes {
        let rotation = |scene: &Scene| scene.placed(member).rotation();
        let turn = rotation(scene) - rotation(&scenes[0]);
        let last = turns.last().copied().unwrap_or(0.0);
        turns.push(turn - TAU * ((turn - last) / TAU).round());
    }
    turns
}

/// Time of each step, as a share of the time of the pitch.
pub fn times(steps: &[PoseResult]) -> Vec<f64> {
    let fraction = |step: &PoseResult| step.pose.mating().fraction;
    let (first, last) = (fraction(&steps[0]), fraction(&steps[steps.len() - 1]));
    let part = |step| (fraction(step) - first) / (last - first);
    steps.iter().map(part).collect()
}

fn key_times(times: &[f64]) -> String {
    let words: Vec<String> = times.iter().map(|time| fixed(*time, 6)).collect();
    words.join(";")
}

/// Duration of a pitch.
const DURATION: &str = "6s";

/// Turns about `axis`, a place of the sheet.
pub fn rotation(turns: &[f64], times: &[f64], axis: Spot) -> AnimateTransform {
    // y points down on the sheet, where clockwise is positive.
    let [x, y] = axis.map(number);
    let value = |turn: &f64| format!("{} {x} {y}", ascii(-turn.to_degrees(), 4));
    let values: Vec<String> = turns.iter().map(value).collect();
    AnimateTransform::new()
        .set("attributeName", "transform")
        .set("type", "rotate")
        .set("dur", DURATION)
        .set("repeatCount", "indefinite")
        .set("values", values.join(";"))
        .set("keyTimes", key_times(times))
}

/// Values and key times of one coordinate; where other teeth take over, both places at one time.
pub fn course(spots: &[(Spot, [u32; 2])], times: &[f64], axis: usize) -> [String; 2] {
    let (mut values, mut at) = (Vec::new(), Vec::new());
    for (step, (spot, teeth)) in spots.iter().enumerate() {
        if step > 0 && spots[step - 1].1 != *teeth {
            values.push(number(spots[step - 1].0[axis]));
            at.push(times[step]);
        }
        values.push(number(spot[axis]));
        at.push(times[step]);
    }
    [values.join(";"), key_times(&at)]
}

/// Sets an attribute to a new value at each step.
pub fn jumping<'v>(
    attribute: &str,
    values: impl Iterator<Item = &'v str>,
    times: &[f64],
) -> Animate {
    let values: Vec<&str> = values.collect();
    motion(attribute, &[values.join(";"), key_times(times)]).set("calcMode", "discrete")
}

/// Moves one coordinate along its course.
pub fn motion(attribute: &str, [values, times]: &[String; 2]) -> Animate {
    Animate::new()
        .set("attributeName", attribute)
        .set("dur", DURATION)
        .set("repeatCount", "indefinite")
        .set("values", values.as_str())
        .set("keyTimes", times.as_str())
}
