//! Backlash over the centre distance, as in Figures 20–21 of the founding study.

use super::captions::{
    backlash_axis, draw_limits, empty, entry, interference, unproven_note, without_value,
};
use super::panel::{Look, Mark, Panel, Point, Swatch, backlash_range, range};
use super::sheet::{self, Chart, Heading, PictureError};
use crate::kit::{Anchor, Axis};
use crate::pose_name::pose_name;
use gearlash::analysis::curves::{DistancePoint, OverDistance};
use gearlash::analysis::measured::Band;
use gearlash::analysis::outcome::AtDistance;
use gearlash::pair::{BacklashUnit, Mating};
use gearlash_text::numbers::{fixed, trimmed};

/// Fill of the band with and without bearing clearance.
const FILLS: [f64; 2] = [0.14, 0.22];

/// Backlash of one pose, or the mean of two, over the centre distance, in `unit`. There are the simulated and the analytic band, the band
/// with bearing clearance, and the measured values.
///
/// # Errors
/// [`PictureError`] when all poses are proven and there is neither a value nor a measurement.
pub fn distance(
    unit: BacklashUnit,
    heading: &Heading,
    curve: &OverDistance,
    distances: &[AtDistance],
) -> Result<Chart, PictureError> {
    let place = |a: f64, um: Option<f64>| -> Point { (a, um.map(|um| unit.of_um(um, a))) };
    // The least and the greatest end of a band, for gears moved together and apart by `play`.
    let ends = |band: fn(&DistancePoint) -> Option<Band>, play: f64| {
        [-1.0, 1.0].map(|end| -> Vec<Point> {
            let point = |point: &DistancePoint| {
                let a = point.center_distance;
                let um = band(point).map(|band| if end < 0.0 { band.min_um } else { band.max_um });
                (a, um.map(|um| unit.of_um(um, a + end * play)))
            };
            curve.points.iter().map(point).collect()
        })
    };
    let simulated = ends(|point| point.bands.simulated, 0.0);
    let analytic = ends(|point| point.bands.line_of_action, 0.0);
    let with_clearance = ends(|point| point.bands.with_clearance, curve.clearance);
    let measured = |side: fn(&gearlash::analysis::study::MeasuredRow) -> f64| -> Vec<Point> {
        let rows = curve.measured.iter();
        rows.map(|row| place(row.center_distance, Some(side(row))))
            .collect()
    };
    let (right, left) = (measured(|row| row.right_um), measured(|row| row.left_um));
    let mut marks = Vec::new();
    let mut legend = Vec::new();
    // Absent curves are neither drawn nor named.
    let any = |ends: &[Vec<Point>; 2]| ends[0].iter().any(|point| point.1.is_some());
    if curve.clearance > 0.0 && any(&with_clearance) {
        marks.extend(band(&with_clearance, Look::Limit, FILLS[0]));
        let clearance = trimmed(curve.clearance, 3, 6);
        let name = format!("with bearing clearance (a ± {clearance} mm)");
        legend.push(entry(&name, Look::Limit, Swatch::LineInBand(FILLS[0])));
    }
    if any(&simulated) {
        marks.extend(band(&simulated, Look::Plain, FILLS[1]));
        let name = if curve.two_materials {
            "simulated, most to least material"
        } else {
            "simulated"
        };
        legend.push(entry(name, Look::Plain, Swatch::LineInBand(FILLS[1])));
    }
    if any(&analytic) {
        marks.extend(outline(&analytic, Look::Third));
        legend.push(entry("by formula (model 3)", Look::Third, Swatch::Line));
    }
    let ranges: Vec<[Point; 2]> = distances.iter().map(|at| range_of(at, place)).collect();
    for points in ranges.iter().map(|ends| ends.to_vec()) {
        marks.push(Mark::Dots(points.clone(), Look::Plain));
        marks.push(Mark::Line(points, Look::Plain, 1.0));
    }
    if !ranges.is_empty() {
        let name = "least and greatest of all poses, every tooth";
        legend.push(entry(name, Look::Plain, Swatch::Dot));
    }
    for (name, points, look) in [
        ("measured, right flanks", &right, Look::Right),
        ("measured, left flanks", &left, Look::Left),
    ] {
        if !points.is_empty() {
            legend.push(entry(name, look, Swatch::Dot));
            marks.push(Mark::Dots(points.clone(), look));
        }
    }
    let bands = [&simulated, &analytic, &with_clearance]
        .into_iter()
        .flatten();
    let drawn = bands.chain([&right, &left]).flatten();
    let values = drawn.chain(ranges.iter().flatten());
    let values = values.filter_map(|point| point.1);
    let words = "the mating is jammed or out of mesh at every centre distance";
    let nothing = || PictureError(words.to_owned());
    let places = curve.points.iter().map(|point| point.center_distance);
    let x = range(places, [0.0; 2], 1e-6).ok_or_else(nothing)?;
    let x_axis = Axis::new("centre distance a, mm", x);
    let details = unproven_note(curve.unproven) + &poses(&curve.matings);
    let Some(y) = backlash_range(values, unit.of_um(1.0, x[1])) else {
        if curve.unproven == 0 {
            return Err(nothing());
        }
        let panel = empty(x_axis, "no pose that is proven has a backlash");
        return Ok(sheet::draw(heading, &details, &[], &[panel]));
    };
    let mut panel = Panel::new(x_axis, backlash_axis(unit, y), 380.0, marks);
    let details = details + &draw_limits(&mut panel, unit, &curve.required);
    // The bands rise from the lower left.
    interference(&mut panel, x[0]);
    panel.marks.extend(gaps(curve, [x, y]));
    if let Some(from) = curve.assembles_from {
        panel.marks.push(Mark::upright(from, y, Look::Limit, 1.2));
        let words = format!("assembles from a = {} mm on", fixed(from, 4));
        let words = Mark::text([from, y[0]], [-6.0, -24.0], words, Anchor::End);
        panel.marks.push(words);
    }
    Ok(sheet::draw(heading, &details, &legend, &[panel]))
}

/// Least and greatest backlash of all poses at a centre distance.
fn range_of(at: &AtDistance, place: impl Fn(f64, Option<f64>) -> Point) -> [Point; 2] {
    [at.all.least, at.all.greatest].map(|found| {
        let backlash = found.and_then(|found| found.pose.simulated.backlash);
        place(at.center_distance, backlash.map(|mm| mm * 1e3))
    })
}

fn poses(matings: &[Mating]) -> String {
    let teeth = |mating: &Mating| format!("{}·{}", mating.wheel_tooth, mating.pinion_tooth);
    match matings {
        [one] => pose_name(one),
        poses => {
            let poses = poses.iter();
            let named = poses.map(|one| format!("{} flanks {}", one.flank.name(), teeth(one)));
            let named = named.collect::<Vec<_>>().join(", ");
            format!("mean of two poses: {named} (wheel·pinion)")
        }
    }
}

/// The reason for no simulated backlash, in the middle of each range of centre distances without one.
fn gaps(curve: &OverDistance, [x, y]: [[f64; 2]; 2]) -> impl Iterator<Item = Mark> {
    let stretches = curve.points.chunk_by(|a, b| a.gap == b.gap);
    stretches.filter_map(move |stretch| {
        let status = stretch.first()?.gap?;
        let ends = [stretch.first()?, stretch.last()?].map(|point| point.center_distance);
        let middle = 0.5 * (ends[0] + ends[1]);
        // The name of a narrow range at an edge is inside the plot.
        let (at, shift, anchor) = match (middle - x[0]) / (x[1] - x[0]) {
            part if part < 0.1 => (x[0], 6.0, Anchor::Start),
            part if part > 0.9 => (x[1], -6.0, Anchor::End),
            _ => (middle, 0.0, Anchor::Middle),
        };
        let words = without_value([status].into_iter());
        Some(Mark::text(
            [at, 0.5 * (y[0] + y[1])],
            [shift, 0.0],
            words,
            anchor,
        ))
    })
}

fn band(ends: &[Vec<Point>; 2], look: Look, opacity: f64) -> [Mark; 3] {
    let [low, high] = outline(ends, look);
    [Mark::Band(ends.clone(), look, opacity), low, high]
}

fn outline(ends: &[Vec<Point>; 2], look: Look) -> [Mark; 2] {
    ends.clone().map(|points| Mark::Line(points, look, 1.4))
}
