//! The gears turning through a pitch, in contact all the time: one SVG, moved by SMIL.
//!
//! Without SMIL it shows its first frame. Rotations between two steps are interpolated; marks jump where
//! another pair of teeth takes over.

use super::gears::lines_over;
use super::labels::Occupied;
use super::marks::dot;
use super::page::{
    Frame, GREY, HEIGHT, INK, OVERLAP, PATH, PINION, Spot, UNITS_PER_MM, WHEEL, WIDTH, line,
    number, path_data, text,
};
use super::snapshot::{INSETS, MAIN, Snapshot, hatch, names};
use super::view::{MARGIN, View};
use super::{caption, clip, main_view};
use crate::gear::Side;
use crate::mesh::{Meeting, Scene, SweptPose};
use crate::pair::Member;
use std::f64::consts::TAU;
use svg::node::Node;
use svg::node::element::{
    Animate, AnimateTransform, ClipPath, Definitions, Group, Path, Rectangle, SVG, Use,
};

/// How long a pitch takes.
const DURATION: &str = "6s";
/// The chart's frame.
const CHART: Frame = Frame {
    left: 730.0,
    top: INSETS[0].top,
    right: 1146.0,
    bottom: 700.0,
};
const MEMBERS: [Member; 2] = [Member::Wheel, Member::Pinion];

/// The SVG text of `steps` through a pitch, evenly apart, of which `view` shows the first.
pub fn animation(view: &Snapshot, steps: &[SweptPose]) -> String {
    let scenes: Vec<Scene> = steps
        .iter()
        .map(|step| Scene::new(view.assembly, &step.pose, &step.lost_motion))
        .collect();
    let first = Scene::new(view.assembly, view.pose, view.lost_motion);
    let main = main_view::view(&first, MAIN);
    let mut occupied = Occupied::default();
    let mating = [
        view.pose.mating().wheel_tooth,
        view.pose.mating().pinion_tooth,
    ];
    let metal = metal(&first, &scenes, &main, &mut occupied);
    let over = lines_over(&first, &main, &Side::BOTH, Group::new(), &mut occupied);
    for meeting in first.meetings() {
        for point in [meeting.on_locked, meeting.on_free] {
            occupied.frame(super::marks::around(main.spot(point), 4.0));
        }
    }
    let (numbers, _) = main_view::tooth_numbers(&first, &main, mating, &mut occupied);
    let turning = |(member, numbers)| {
        let axis = main.spot(first.placed(member).axis());
        let motion = rotation(&turns(&scenes, member), axis);
        Group::new().add(motion).add(numbers)
    };
    let numbers = MEMBERS.into_iter().zip(numbers).map(turning);
    let numbers = numbers.fold(
        Group::new().set("clip-path", "url(#mesh-frame)"),
        Group::add,
    );
    let sheet = SVG::new()
        .set("viewBox", format!("0 0 {WIDTH} {HEIGHT}"))
        .set("width", format!("{}mm", WIDTH / UNITS_PER_MM))
        .set("height", format!("{}mm", HEIGHT / UNITS_PER_MM))
        .set("font-family", "sans-serif")
        .add(hatch())
        .add(
            Rectangle::new()
                .set("width", "100%")
                .set("height", "100%")
                .set("fill", "white"),
        )
        .add(caption::draw(
            view,
            &first,
            MAIN.left,
            WIDTH - 2.0 * MAIN.left,
        ))
        .add(names(&first))
        .add(metal)
        .add(Group::new().set("clip-path", "url(#mesh-frame)").add(over))
        .add(MAIN.border())
        .add(marks(&scenes, &main))
        .add(numbers)
        .add(super::scale::bar(
            [MAIN.left, MAIN.bottom + 16.0],
            main.scale(),
        ))
        .add(chart(steps))
        .add(key());
    format!("{sheet}\n")
}

/// Both gears, each turned about its axis.
fn metal(first: &Scene, scenes: &[Scene], view: &View, occupied: &mut Occupied) -> Group {
    let mut definitions = Definitions::new().add(
        ClipPath::new()
            .set("id", "mesh-frame")
            .add(view.frame().rectangle()),
    );
    let mut turned = Vec::new();
    for member in MEMBERS {
        let placed = first.placed(member);
        let turns = turns(scenes, member);
        let axis = view.spot(placed.axis());
        let frame = view.frame();
        // What comes into the frame in a pitch stands no farther off than its farthest corner moves.
        let corners = [
            [frame.left, frame.top],
            [frame.right, frame.top],
            [frame.left, frame.bottom],
            [frame.right, frame.bottom],
        ];
        let far = corners.map(|[x, y]| (x - axis[0]).hypot(y - axis[1]));
        let angle = turns
            .iter()
            .fold(0.0, |most, turn| f64::max(most, turn.abs()));
        let moved = far.into_iter().fold(0.0, f64::max) * angle;
        let reach = view.reach() + moved / view.scale();
        let outline = placed.outline_near(view.middle(), reach, view.chord());
        let spots: Vec<Spot> = outline.iter().map(|point| view.spot(*point)).collect();
        let polygon = clip::polygon(&spots, &frame.grown(MARGIN + moved));
        occupied.line(&polygon);
        let motion = || rotation(&turns, axis);
        let name = member.name();
        let shape = || Use::new().set("href", format!("#{name}"));
        definitions = definitions
            .add(
                Path::new()
                    .set("id", name)
                    .set("d", path_data(&polygon, true)),
            )
            .add(
                ClipPath::new()
                    .set("id", format!("{name}-clip"))
                    .add(shape()),
            )
            .add(
                ClipPath::new()
                    .set("id", format!("{name}-turning"))
                    .add(shape().add(motion())),
            );
        let fill = if member == Member::Wheel {
            WHEEL
        } else {
            PINION
        };
        let gear = Group::new().add(motion()).add(shape().set("fill", fill));
        let outline = Group::new().add(motion()).add(
            shape()
                .set("fill", "none")
                .set("stroke", INK)
                .set("stroke-width", "2.40")
                .set("stroke-linejoin", "round")
                .set("clip-path", format!("url(#{name}-clip)")),
        );
        turned.push((gear, outline));
    }
    let mut group = Group::new()
        .set("clip-path", "url(#mesh-frame)")
        .add(definitions);
    let mut outlines = Group::new();
    for (gear, outline) in turned {
        group = group.add(gear);
        outlines = outlines.add(outline);
    }
    group.add(outlines).add(overlap(scenes, view))
}

/// The pinion's metal once more, where the wheel's is too.
fn overlap(scenes: &[Scene], view: &View) -> Group {
    let pinion = Member::Pinion;
    let axis = view.spot(scenes[0].placed(pinion).axis());
    let turns = turns(scenes, pinion);
    let layers = [OVERLAP, "url(#hatch)"].map(|fill| {
        let shape = Use::new().set("href", format!("#{}", pinion.name()));
        Group::new()
            .add(rotation(&turns, axis))
            .add(shape.set("fill", fill))
    });
    let clip = Group::new().set("clip-path", "url(#wheel-turning)");
    layers.into_iter().fold(clip, Group::add)
}

/// Turns about `axis`, a place of the sheet.
fn rotation(turns: &[f64], axis: Spot) -> AnimateTransform {
    // y is down on the sheet: clockwise is positive there.
    let [x, y] = axis.map(number);
    let value =
        |turn: &f64| format!("{:.4} {x} {y}", -turn.to_degrees()).replace("-0.0000 ", "0.0000 ");
    let values: Vec<String> = turns.iter().map(value).collect();
    AnimateTransform::new()
        .set("attributeName", "transform")
        .set("type", "rotate")
        .set("dur", DURATION)
        .set("repeatCount", "indefinite")
        .set("values", values.join(";"))
}

/// How far a gear has turned at each step since the first, rad.
fn turns(scenes: &[Scene], member: Member) -> Vec<f64> {
    let mut turns: Vec<f64> = Vec::new();
    for scene in scenes {
        let turn = scene.placed(member).direction(1) - scenes[0].placed(member).direction(1);
        let last = turns.last().copied().unwrap_or(0.0);
        turns.push(turn - TAU * ((turn - last) / TAU).round());
    }
    turns
}

/// The contacts: filled where the gears touch, open the two points that meet on the other side.
fn marks(scenes: &[Scene], view: &View) -> Group {
    let mut group = Group::new().set("clip-path", "url(#mesh-frame)");
    for side in Side::BOTH {
        let meetings: Vec<Option<&Meeting>> = scenes
            .iter()
            .map(|scene| scene.meetings().iter().find(|meeting| meeting.side == side))
            .collect();
        for on_free in [true, false] {
            let spots: Option<Vec<(Spot, [u32; 2])>> = meetings
                .iter()
                .map(|meeting| {
                    let meeting = (*meeting)?;
                    let at = if on_free {
                        meeting.on_free
                    } else {
                        meeting.on_locked
                    };
                    let teeth = MEMBERS.map(|member| meeting.touch(member).tooth);
                    Some((view.spot(at), teeth))
                })
                .collect();
            let touching = meetings
                .iter()
                .all(|meeting| meeting.is_some_and(|meeting| meeting.turn == 0.0));
            // A side that is out of mesh at some step has no marks; one in contact needs one dot.
            if let Some(spots) = spots.filter(|_| !(touching && on_free)) {
                let [x, y] = [0, 1].map(|axis| course(&spots, axis));
                group = group.add(
                    dot(spots[0].0, 4.0, touching)
                        .add(motion("cx", &x))
                        .add(motion("cy", &y)),
                );
            }
        }
    }
    group
}

/// Values and key times of one coordinate; where other teeth take over, both places at one time.
fn course(spots: &[(Spot, [u32; 2])], axis: usize) -> [String; 2] {
    let last = (spots.len() - 1) as f64;
    let (mut values, mut times) = (Vec::new(), Vec::new());
    for (step, (spot, teeth)) in spots.iter().enumerate() {
        let time = format!("{:.5}", step as f64 / last);
        if step > 0 && spots[step - 1].1 != *teeth {
            values.push(number(spots[step - 1].0[axis]));
            times.push(time.clone());
        }
        values.push(number(spot[axis]));
        times.push(time);
    }
    [values.join(";"), times.join(";")]
}

fn motion(attribute: &str, [values, times]: &[String; 2]) -> Animate {
    Animate::new()
        .set("attributeName", attribute)
        .set("dur", DURATION)
        .set("repeatCount", "indefinite")
        .set("values", values.as_str())
        .set("keyTimes", times.as_str())
}

/// `j_wt` over the pitch, with a dot that runs along.
fn chart(steps: &[SweptPose]) -> Group {
    let values: Vec<Option<f64>> = steps.iter().map(|step| step.backlash).collect();
    let found = || values.iter().flatten().copied();
    let mut title = text(
        "j_wt in µm over a pitch",
        [CHART.left, CHART.top - 14.0],
        16.0,
        false,
    );
    title.assign("font-weight", "bold");
    let mut group = Group::new().add(title).add(CHART.border());
    let label = |words: &str, at: Spot, anchor: &str| {
        let mut words = text(words, at, 13.0, true);
        words.assign("text-anchor", anchor);
        words.assign("fill", GREY);
        words
    };
    for (words, part) in [("0", 0.0), ("½", 0.5), ("1 pitch", 1.0)] {
        let x = CHART.left + part * CHART.width();
        group = group
            .add(line(
                &[[x, CHART.bottom], [x, CHART.bottom + 5.0]],
                INK,
                1.0,
            ))
            .add(label(
                words,
                [x, CHART.bottom + 20.0],
                if part == 1.0 { "end" } else { "middle" },
            ));
    }
    let (Some(least), Some(most)) = (found().reduce(f64::min), found().reduce(f64::max)) else {
        let [x, y] = CHART.middle();
        return group.add(label("no value: jammed or out of mesh", [x, y], "middle"));
    };
    // At least a tenth of a micrometre, below which the labels would all be alike.
    let room = f64::max(0.15 * (most - least), 5e-5);
    let height = |value: f64| {
        let part = (value - least + room) / (most - least + 2.0 * room);
        CHART.bottom - part * CHART.height()
    };
    let ends = if most - least < 1e-5 {
        vec![most]
    } else {
        vec![least, most]
    };
    for value in ends {
        let y = height(value);
        group = group
            .add(
                line(&[[CHART.left, y], [CHART.right, y]], GREY, 0.8)
                    .set("stroke-dasharray", "2 4"),
            )
            .add(label(
                &caption::micrometres(value),
                [CHART.left - 12.0, y + 4.5],
                "end",
            ));
    }
    let last = (values.len() - 1) as f64;
    let spots: Vec<Option<Spot>> = values
        .iter()
        .enumerate()
        .map(|(step, value)| {
            Some([
                CHART.left + step as f64 / last * CHART.width(),
                height((*value)?),
            ])
        })
        .collect();
    for run in spots.split(Option::is_none) {
        let run: Vec<Spot> = run.iter().flatten().copied().collect();
        if run.len() > 1 {
            group = group.add(line(&run, INK, 2.0));
        }
    }
    let all: Option<Vec<(Spot, [u32; 2])>> =
        spots.iter().map(|spot| Some(((*spot)?, [0, 0]))).collect();
    if let Some(spots) = all {
        let [x, y] = [0, 1].map(|axis| course(&spots, axis));
        let runner = dot(spots[0].0, 5.0, true).set("fill", PATH);
        group = group.add(runner.add(motion("cx", &x)).add(motion("cy", &y)));
    }
    group
}

/// What the marks mean, and what to do with a still picture.
fn key() -> Group {
    let [x, y] = [MAIN.left, 780.0];
    let mut group = Group::new()
        .add(dot([x + 8.0, y], 4.0, true))
        .add(dot([x + 214.0, y], 4.0, false))
        .add(dot([x + 230.0, y], 4.0, false));
    for (words, left) in [
        ("where the gears touch", 20.0),
        (
            "points of the other flanks that would meet · lines and circles as in a snapshot",
            242.0,
        ),
    ] {
        let mut words = text(words, [x + left, y + 4.5], 13.0, true);
        words.assign("fill", INK);
        group = group.add(words);
    }
    let mut note = text(
        "animated in a browser; elsewhere its first frame. Rotations found at every sixtieth of the pitch, to scale",
        [x, y + 29.5],
        13.0,
        true,
    );
    note.assign("fill", GREY);
    group.add(note)
}
