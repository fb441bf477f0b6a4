//! Backlash of two outlines over their mesh cycle.

use super::captions::{backlash_axis, empty, entry, interference, unproven_note, without_value};
use super::paint::Look;
use super::panel::{Mark, Panel, Point, Swatch, backlash_range};
use super::revolution::label;
use super::sheet::{self, Chart, Heading, PictureError};
use crate::kit::Axis;
use gearlash::analysis::curves::Extreme;
use gearlash::analysis::outlines::{OutlinePose, OutlineRun};
use gearlash::contact::Status;
use gearlash::gear::Side;
use gearlash::pair::BacklashUnit;
use gearlash_files::numbers::{backlash, stated_distance};

/// Share of the height that the words below a value need.
const CLOSE: f64 = 0.08;

/// Backlash of `runs` at one centre distance in `unit`, a line a material, with the teeth that touch where it is least and greatest; below zero
/// they interfere, and a gap is a pose without a value.
///
/// # Errors
/// [`PictureError`]: no runs.
pub fn outlines(
    unit: BacklashUnit,
    heading: &Heading,
    runs: &[OutlineRun],
) -> Result<Chart, PictureError> {
    let (Some(first), Some(start)) = (runs.first(), runs.first().and_then(|run| run.poses.first()))
    else {
        return Err(PictureError("there are no poses to draw".to_owned()));
    };
    let of_um = |um| unit.of_um(um, first.pair.center_distance());
    let shown = |pose: &OutlinePose| pose.j_wt.map(|(mm, _)| of_um(mm * 1e3));
    let poses = || runs.iter().flat_map(|run| &run.poses);
    let gaps = || {
        poses()
            .filter(|pose| pose.j_wt.is_none())
            .map(OutlinePose::status)
    };
    let words = without_value(gaps());
    let unproven = gaps().filter(|status| *status == Status::Unproven).count();
    let mut details = format!(
        "{}a = {} mm · {} pitches, the whole mesh cycle, from mating {}·{} on",
        unproven_note(unproven),
        stated_distance(first.pair.center_distance()),
        first.matings,
        start.mating.wheel_tooth,
        start.mating.pinion_tooth,
    );
    let x = Axis::new("pitches from the first pose", [0.0, first.matings as f64]);
    let closer = runs
        .iter()
        .flat_map(|run| run.least.iter().chain(&run.greatest));
    let Some(y) = backlash_range(poses().chain(closer).filter_map(shown), of_um(1.0)) else {
        let panel = empty(x, &format!("no pose has a backlash: {words}"));
        return sheet::draw(heading, &details, &[], &[panel]);
    };
    let mut panel = Panel {
        title: String::new(),
        x,
        y: backlash_axis(unit, y),
        height: 360.0,
        marks: Vec::new(),
    };
    let mut legend = Vec::new();
    for (run, look) in runs.iter().zip([Look::Right, Look::Left]) {
        legend.push(entry(run.material.words(), look, Swatch::Line));
        let points: Vec<Point> = run
            .poses
            .iter()
            .map(|pose| (pose.pitches, shown(pose)))
            .collect();
        panel.marks.push(Mark::line(points, look, 1.6));
    }
    let ends = [
        (
            "least",
            16.0,
            runs.iter()
                .filter_map(|run| extreme(run, run.least.as_ref()?))
                .min_by(order),
        ),
        (
            "greatest",
            -16.0,
            runs.iter()
                .filter_map(|run| extreme(run, run.greatest.as_ref()?))
                .max_by(order),
        ),
    ];
    interference(&mut panel, ends[0].2.map_or(0.0, |least| least.x));
    let [low, high] = panel.y.range;
    for (word, shift, end) in ends {
        let Some(end) = end else { continue };
        // No room below it: above.
        let height = of_um(end.backlash_um);
        let shift = match height < low + CLOSE * (high - low) {
            true => -16.0,
            false => shift,
        };
        let value = backlash(unit, end.backlash_um, first.pair.center_distance(), 1);
        let word = format!("{word} {value} {}", unit.name());
        let words = label(&word, &end, height, shift, panel.x.range);
        panel.marks.extend(words);
    }
    if gaps().next().is_some() {
        details += &format!(" · gaps: {words}");
    }
    let legend = if runs.len() > 1 { &legend[..] } else { &[] };
    sheet::draw(heading, &details, legend, &[panel])
}

fn order(a: &Extreme, b: &Extreme) -> std::cmp::Ordering {
    a.backlash_um.total_cmp(&b.backlash_um)
}

/// A pose as the end of a curve is labelled.
fn extreme(run: &OutlineRun, pose: &OutlinePose) -> Option<Extreme> {
    let [right, left] = pose.contacts();
    let [right, left] = [right?, left?].map(|contact| (contact.wheel.tooth, contact.pinion.tooth));
    Some(Extreme {
        // One that was looked at more closely may be a little before the first pose: the end of the cycle.
        x: pose.pitches.rem_euclid(run.matings as f64),
        backlash_um: pose.j_wt?.0 * 1e3,
        material: run.material,
        flank: Side::Right,
        right,
        left,
    })
}
