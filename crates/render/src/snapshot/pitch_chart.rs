//! `j_wt` over a pitch as a small chart.

use super::subject::INSETS;
use super::turning::{course, motion, times};
use crate::kit::{Anchor, Frame, GREY, INK, PATH, Spot, TextStyle, dot, line};
use gearlash::contact::{PoseResult, Status};
use gearlash_files::numbers::um;
use svg::node::element::Group;

/// The chart's frame.
const CHART: Frame = Frame::new([730.0, INSETS[0].top], [1146.0, 700.0]);
/// The reason why no step has a value.
fn no_value(steps: &[PoseResult]) -> &'static str {
    if steps.iter().any(|step| step.status() == Status::Unproven) {
        "no value: unproven, jammed or out of mesh"
    } else {
        "no value: jammed or out of mesh"
    }
}

/// `j_wt` over the pitch, with a dot that moves along it.
pub fn draw(steps: &[PoseResult]) -> Group {
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
        group = group
            .add(line(
                &[[x, CHART.bottom], [x, CHART.bottom + 5.0]],
                INK,
                1.0,
            ))
            .add(label(
                words,
                [x, CHART.bottom + 20.0],
                if part == 1.0 {
                    Anchor::End
                } else {
                    Anchor::Middle
                },
            ));
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
                &um(value, 2),
                [CHART.left - 12.0, y + 4.5],
                Anchor::End,
            ));
    }
    let times = times(steps);
    let spots: Vec<Option<Spot>> = values
        .iter()
        .enumerate()
        .map(|(step, value)| Some([CHART.left + times[step] * CHART.width(), height((*value)?)]))
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
        let [x, y] = [0, 1].map(|axis| course(&spots, &times, axis));
        let runner = dot(spots[0].0, 5.0, true).set("fill", PATH);
        group = group.add(runner.add(motion("cx", &x)).add(motion("cy", &y)));
    }
    group
}
