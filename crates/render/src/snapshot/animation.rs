//! The gears turning through a pitch, always in contact: one SVG, moved by SMIL; and `j_wt` over the pitch as a small chart.
//!
//! Without SMIL it shows its first frame. Rotations between two steps are interpolated; marks jump where
//! another pair of teeth takes over.

use super::caption;
use super::gears::lines_over;
use super::labels::tooth_numbers;
use super::subject::{INSETS, MAIN, Snapshot, names};
use super::view::{MARGIN, View, mesh_view};
use crate::kit::{
    Anchor, Frame, GREY, HEIGHT, INK, Ids, OVERLAP, Occupied, PATH, PINION, Spot, TextStyle, WHEEL,
    WIDTH, area, around, blank_sheet, clip, clipped, dashed, define_area, define_frame, dot, hatch,
    inner_outline, line, number, path_data, scale,
};
use gearlash::contact::{DrawnContact, MeshSection, PoseResult, Scene, Status};
use gearlash::gear::Side;
use gearlash::pair::Member;
use gearlash_text::numbers::{ascii, fixed, um};
use std::f64::consts::TAU;
use svg::node::element::{Animate, AnimateTransform, ClipPath, Group, Path};

/// The SVG text of `steps` through a pitch, in ascending order; `view` shows the first. For gears that vary along the face
/// `sections` has the section of each step, all at one place; for others it is empty.
pub fn animation(view: &Snapshot, steps: &[PoseResult], sections: &[MeshSection]) -> String {
    let steps_in_sections = steps.iter().enumerate();
    let scenes = steps_in_sections.map(|(number, step)| {
        let at_step = Snapshot {
            pose: &step.pose,
            found: step.found.as_ref(),
            section: sections.get(number),
            ..*view
        };
        at_step.scene()
    });
    let scenes: Vec<Scene> = scenes.collect();
    let first = view.scene();
    let main = mesh_view(&first, MAIN);
    let mut occupied = Occupied::default();
    let mating = view.drawn_pose().mating();
    let times = times(steps);
    let metal = metal(&first, &scenes, &times, &main, &mut occupied);
    let over = lines_over(&first, &main, &Side::BOTH, Group::new(), &mut occupied);
    for contact in first.contacts() {
        for point in [contact.on_locked, contact.on_free] {
            occupied.frame(around(main.spot(point), 4.0));
        }
    }
    let (numbers, _) = tooth_numbers(&first, &main, mating, &mut occupied);
    let turning = |(member, numbers)| {
        let axis = main.spot(first.placed(member).axis());
        let motion = rotation(&turns(&scenes, member), &times, axis);
        Group::new().add(motion).add(numbers)
    };
    let numbers = Member::BOTH.into_iter().zip(numbers).map(turning);
    let ids = Ids::default();
    let numbers = numbers.fold(clipped(&ids, "mesh-frame"), Group::add);
    let room = WIDTH - 2.0 * MAIN.left;
    let sheet = blank_sheet(WIDTH, HEIGHT)
        .add(hatch(&ids))
        .add(caption::draw_turning(view, &first, steps, MAIN.left, room))
        .add(names(&first, &MAIN))
        .add(metal)
        .add(clipped(&ids, "mesh-frame").add(over))
        .add(MAIN.border())
        .add(marks(&scenes, &times, &main))
        .add(numbers)
        .add(scale::bar([MAIN.left, MAIN.bottom + 16.0], main.scale))
        .add(pitch_chart(steps))
        .add(key(view.section.is_some()));
    format!("{sheet}\n")
}

/// The contacts: filled where the gears touch; open for the two points that meet on the other side.
fn marks(scenes: &[Scene], times: &[f64], view: &View) -> Group {
    let mut group = clipped(&Ids::default(), "mesh-frame");
    for side in Side::BOTH {
        let contacts = scenes.iter().map(|scene| scene.contacts().iter());
        let contacts = contacts.map(|mut each| each.find(|contact| contact.side == side));
        let contacts: Vec<Option<&DrawnContact>> = contacts.collect();
        for on_free in [true, false] {
            let spots = contacts.iter().map(|contact| {
                let contact = (*contact)?;
                let at = if on_free {
                    contact.on_free
                } else {
                    contact.on_locked
                };
                let teeth = Member::BOTH.map(|member| contact.touch(member).tooth);
                Some((view.spot(at), teeth))
            });
            let spots: Option<Vec<(Spot, [u32; 2])>> = spots.collect();
            let touch = |contact: &Option<&DrawnContact>| {
                contact.is_some_and(|contact| contact.turn == 0.0)
            };
            let touching = contacts.iter().all(touch);
            // Sections of gears that vary along the face touch only at some steps.
            let fills = (!touching && contacts.iter().any(touch)).then(|| {
                let fill = |contact| if touch(contact) { INK } else { "white" };
                jumping("fill", contacts.iter().map(fill), times)
            });
            // A side that is out of mesh at some step has no marks; one in contact needs a single dot.
            if let Some(spots) = spots.filter(|_| !(touching && on_free)) {
                let [x, y] = [0, 1].map(|axis| course(&spots, times, axis));
                let filled = touch(&contacts[0]);
                let mut mark = dot(spots[0].0, 4.0, filled)
                    .add(motion("cx", &x))
                    .add(motion("cy", &y));
                if let Some(fills) = fills {
                    mark = mark.add(fills);
                }
                group = group.add(mark);
            }
        }
    }
    group
}

/// The meaning of the marks, and help for a still picture.
fn key(is_section: bool) -> Group {
    let open = if is_section {
        "points of flanks that would meet · lines and circles as in a snapshot"
    } else {
        "points of the other flanks that would meet · lines and circles as in a snapshot"
    };
    let [x, y] = [MAIN.left, 780.0];
    let mut group = Group::new()
        .add(dot([x + 8.0, y], 4.0, true))
        .add(dot([x + 214.0, y], 4.0, false))
        .add(dot([x + 230.0, y], 4.0, false));
    for (words, left) in [("where the gears touch", 20.0), (open, 242.0)] {
        group = group.add(TextStyle::new(13.0).text(words, [x + left, y + 4.5]));
    }
    let note = "animated in a browser; elsewhere its first frame. Found at every sixtieth of the pitch and at its extremes, to scale";
    group.add(TextStyle::new(13.0).grey().text(note, [x, y + 29.5]))
}

/// Both gears, each turned about its axis.
fn metal(
    first: &Scene,
    scenes: &[Scene],
    times: &[f64],
    view: &View,
    occupied: &mut Occupied,
) -> Group {
    let ids = Ids::default();
    let mut definitions = define_frame(&ids, "mesh-frame", &view.frame);
    let mut gears = Vec::new();
    let mut outlines = Group::new();
    for (member, fill) in Member::BOTH.into_iter().zip([WHEEL, PINION]) {
        let placed = first.placed(member);
        let turns = turns(scenes, member);
        let axis = view.spot(placed.axis());
        let frame = &view.frame;
        // Metal that enters the frame during a pitch is at most as far off as its farthest corner moves.
        let corners = frame.corners();
        let far = corners.map(|[x, y]| (x - axis[0]).hypot(y - axis[1]));
        let angle = turns.iter().map(|turn| turn.abs()).fold(0.0, f64::max);
        let moved = far.into_iter().fold(0.0, f64::max) * angle;
        let reach = view.reach() + moved / view.scale;
        let outline = placed.outline_near(view.middle, reach, view.chord());
        let polygon = clip::polygon(&view.spots(&outline), &frame.grown(MARGIN + moved));
        occupied.line(&polygon);
        let motion = || rotation(&turns, times, axis);
        let name = member.name();
        let turning = Path::new().set("d", path_data(&polygon, true));
        let limit = ClipPath::new().set("id", format!("{name}-turning"));
        definitions = define_area(definitions, &ids, name, &polygon);
        definitions = definitions.add(limit.add(turning.add(motion())));
        let filled = area(&ids, name).set("fill", fill);
        gears.push(Group::new().add(motion()).add(filled));
        let outline = inner_outline(&ids, name, INK, "2.40");
        outlines = outlines.add(Group::new().add(motion()).add(outline));
    }
    let drawn = clipped(&ids, "mesh-frame").add(definitions);
    let drawn = gears.into_iter().fold(drawn, Group::add);
    drawn.add(outlines).add(overlap(scenes, times, view))
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
    let limit = clipped(&Ids::default(), "wheel-turning");
    layers.into_iter().fold(limit, Group::add)
}

/// Rotation of a gear at each step since the first, rad.
fn turns(scenes: &[Scene], member: Member) -> Vec<f64> {
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
fn times(steps: &[PoseResult]) -> Vec<f64> {
    let fraction = |step: &PoseResult| step.pose.mating().fraction;
    let (first, last) = (fraction(&steps[0]), fraction(&steps[steps.len() - 1]));
    let part = |step| (fraction(step) - first) / (last - first);
    steps.iter().map(part).collect()
}

fn key_times(times: &[f64]) -> String {
    let words: Vec<String> = times.iter().map(|time| fixed(*time, 6)).collect();
    words.join(";")
}

const DURATION: &str = "6s";

/// Turns about `axis`, a place of the sheet.
fn rotation(turns: &[f64], times: &[f64], axis: Spot) -> AnimateTransform {
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
fn course(spots: &[(Spot, [u32; 2])], times: &[f64], axis: usize) -> [String; 2] {
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
fn jumping<'v>(attribute: &str, values: impl Iterator<Item = &'v str>, times: &[f64]) -> Animate {
    let values: Vec<&str> = values.collect();
    motion(attribute, &[values.join(";"), key_times(times)]).set("calcMode", "discrete")
}

/// Moves one coordinate along its course.
fn motion(attribute: &str, [values, times]: &[String; 2]) -> Animate {
    Animate::new()
        .set("attributeName", attribute)
        .set("dur", DURATION)
        .set("repeatCount", "indefinite")
        .set("values", values.as_str())
        .set("keyTimes", times.as_str())
}

const CHART: Frame = Frame::new([730.0, INSETS[0].top], [1146.0, 700.0]);
fn no_value(steps: &[PoseResult]) -> &'static str {
    if steps.iter().any(|step| step.status() == Status::Unproven) {
        "no value: unproven, jammed or out of mesh"
    } else {
        "no value: jammed or out of mesh"
    }
}

/// `j_wt` over the pitch, with a dot that moves along it.
fn pitch_chart(steps: &[PoseResult]) -> Group {
    let values: Vec<Option<f64>> = steps.iter().map(|step| step.backlash).collect();
    let found = || values.iter().flatten().copied();
    let title = TextStyle::new(16.0).bold();
    let title = title.text("j_wt in µm over a pitch", [CHART.left, CHART.top - 14.0]);
    let mut group = Group::new().add(title).add(CHART.border());
    let label = |words: &str, at: Spot, anchor: Anchor| {
        let style = TextStyle::new(13.0).grey();
        style.anchored(anchor).text(words, at)
    };
    for (words, part) in [("0", 0.0), ("½", 0.5), ("1 pitch", 1.0)] {
        let x = CHART.left + part * CHART.width();
        let is_last = part == 1.0;
        let anchor = if is_last { Anchor::End } else { Anchor::Middle };
        let tick = [[x, CHART.bottom], [x, CHART.bottom + 5.0]];
        let words = label(words, [x, CHART.bottom + 20.0], anchor);
        group = group.add(line(&tick, INK, 1.0)).add(words);
    }
    let (Some(least), Some(most)) = (found().reduce(f64::min), found().reduce(f64::max)) else {
        let [x, y] = CHART.middle();
        return group.add(label(no_value(steps), [x, y], Anchor::Middle));
    };
    // At least a tenth of a micrometre: below it all labels would be equal.
    let room = f64::max(0.15 * (most - least), 5e-5);
    let height = |value: f64| {
        let part = (value - least + room) / (most - least + 2.0 * room);
        CHART.bottom - part * CHART.height()
    };
    let is_level = most - least < 1e-5;
    let ends: &[f64] = if is_level { &[most] } else { &[least, most] };
    for &value in ends {
        let y = height(value);
        let value = label(&um(value, 2), [CHART.left - 12.0, y + 4.5], Anchor::End);
        let ends = [[CHART.left, y], [CHART.right, y]];
        group = group.add(dashed(&ends, GREY, 0.8, "2 4")).add(value);
    }
    let times = times(steps);
    let spots = values.iter().zip(&times);
    let spots =
        spots.map(|(value, time)| Some([CHART.left + time * CHART.width(), height((*value)?)]));
    let spots: Vec<Option<Spot>> = spots.collect();
    for run in spots.split(Option::is_none) {
        let run: Vec<Spot> = run.iter().flatten().copied().collect();
        if run.len() > 1 {
            group = group.add(line(&run, INK, 2.0));
        }
    }
    let all: Option<Vec<(Spot, [u32; 2])>> =
        spots.iter().map(|spot| Some(((*spot)?, [0, 0]))).collect();
    if let Some(spots) = all {
        let [x, y] = [0, 1].map(|axis| course(&spots, &times, axis));
        let runner = dot(spots[0].0, 5.0, true).set("fill", PATH);
        group = group.add(runner.add(motion("cx", &x)).add(motion("cy", &y)));
    }
    group
}
