//! The drawing of a line with many swings shows only its data, their extremes, and their period.
//!
//! Issue 14: 24/8 over a revolution, 16 poses a pitch, was irregular triangles and blocks; windows of the thinning beat with
//! the pitch. Expected places are the data's own.

use super::drawn::{HALF, INK, LEFT, RIGHT, place, polylines};
use super::{METHOD, heading};
use gearlash::analysis::curves::{Course, CoursePoint, courses, revolution};
use gearlash::gear::Side;
use gearlash::pair::SweepPlan;
use gearlash_render::chart::{self, Chart, Plot};
use roxmltree::Document;
use std::ops::ControlFlow;

type Spot = (f64, f64);

/// Half the window of an envelope (whole pitches, the next above a swing of less than 7 units), and a column.
const NEAR: f64 = 0.5 * (7.0 + 14.0) + 1.0;

/// The pair of the issue over `pitches`: a line up to a hundred or so, then an envelope.
fn periodic(pitches: u64) -> Course {
    let gear = |name: &str, teeth: u32| {
        format!(
            "[{name}]\nteeth = {teeth}\nmodule_mm = 2.0\npressure_angle_deg = 20.0\nthickness = {{ allowance_um = -60 }}\n"
        )
    };
    let text = gear("wheel", 24) + &gear("pinion", 8) + "[assembly]\ncenter_distance_mm = 32.0\n";
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("pair.toml");
    std::fs::write(&file, text).unwrap();
    let mut study = gearlash_files::read(&file).unwrap().study;
    study.sweep = Some(SweepPlan::Revolution {
        pitches,
        steps_per_pitch: 16,
        start: (1, 1),
    });
    let runs = revolution(&study, METHOD, &|| ControlFlow::Continue(())).unwrap();
    courses(&runs).remove(0)
}

/// A drawn line of a chart: its colour, and the flank and the value of the data.
type Drawn = (&'static str, Side, fn(&CoursePoint) -> Option<f64>);

const REVOLUTION: [Drawn; 2] = [
    (RIGHT, Side::Right, |point| point.simulated_um),
    (LEFT, Side::Left, |point| point.simulated_um),
];
const DIFFERENCE: [Drawn; 2] = [
    (INK, Side::Right, |point| point.off_involute_um),
    (LEFT, Side::Right, |point| point.off_michalec_um),
];

/// Lines of a colour in a plot, and where the data behind them stand.
fn lines(chart: &Chart, course: &Course, drawn: &Drawn) -> (Vec<Vec<Spot>>, Vec<Spot>) {
    let (colour, flank, value) = *drawn;
    let plot: &Plot = &chart.plot;
    let document = Document::parse(&chart.svg).unwrap();
    let within = |line: &Vec<Spot>| {
        let inside = |&(x, y): &Spot| x >= plot.left && y >= plot.top && y < plot.bottom - HALF;
        // Ticks, crosses and the axes have two points.
        line.len() > 2 && line.iter().all(inside)
            || line.len() == 2 && line[1].0 - line[0].0 > 600.0 && line.iter().all(inside)
    };
    let drawn = polylines(&document, colour);
    let drawn = drawn.into_iter().filter(within).collect();
    let of = course
        .lines
        .iter()
        .find(|line| line.flank == flank)
        .unwrap();
    let points = of.points.iter();
    let data = points.map(|point| place(plot, (point.x, value(point).unwrap())));
    (drawn, data.collect())
}

fn ends(values: impl Iterator<Item = f64> + Clone) -> [f64; 2] {
    [
        values.clone().fold(f64::INFINITY, f64::min),
        values.fold(f64::NEG_INFINITY, f64::max),
    ]
}

/// Every chart of the periodic pair with what it draws.
fn each(mut test: impl FnMut(&Chart, &Course, &Drawn)) {
    for pitches in [24, 48, 97, 240, 1000] {
        let course = periodic(pitches);
        let revolution = chart::revolution(&heading("r", "t"), &course).unwrap();
        let difference = chart::difference(&heading("d", "t"), &course, 0.1).unwrap();
        REVOLUTION
            .iter()
            .for_each(|drawn| test(&revolution, &course, drawn));
        DIFFERENCE
            .iter()
            .for_each(|drawn| test(&difference, &course, drawn));
    }
}

#[test]
fn a_drawn_line_is_within_its_data_and_reaches_their_extremes() {
    each(|chart, course, of| {
        let (drawn, data) = lines(chart, course, of);
        assert!(!drawn.is_empty(), "{}", of.0);
        for &(x, y) in drawn.iter().flatten() {
            let near = data.iter().filter(|spot| (spot.0 - x).abs() <= NEAR);
            let [low, high] = ends(near.map(|spot| spot.1));
            assert!(low - HALF <= y && y <= high + HALF, "{x} {y}: {low} {high}");
        }
        let heights = ends(drawn.iter().flatten().map(|spot| spot.1));
        let expected = ends(data.iter().map(|spot| spot.1));
        for (drawn, data) in heights.into_iter().zip(expected) {
            assert!((drawn - data).abs() < HALF, "{heights:?} {expected:?}");
        }
    });
}

#[test]
fn periodic_data_give_a_periodic_picture() {
    each(|chart, course, of| {
        let (drawn, _) = lines(chart, course, of);
        let plot = chart.plot;
        let pitch = (plot.right - plot.left) / (plot.x[1] - plot.x[0]);
        for line in &drawn {
            let last = line[line.len() - 1].0;
            for &(x, y) in line.iter().filter(|spot| spot.0 + pitch < last) {
                let spot = (x + pitch, y);
                let mut segments = line.windows(2);
                let met = segments.any(|ends| distance(spot, [ends[0], ends[1]]) < HALF);
                assert!(met, "{} at {spot:?}", of.0);
            }
        }
    });
}

/// How far a spot lies from a segment.
fn distance(spot: Spot, [from, to]: [Spot; 2]) -> f64 {
    let along = (to.0 - from.0, to.1 - from.1);
    let here = (spot.0 - from.0, spot.1 - from.1);
    let square = along.0.powi(2) + along.1.powi(2);
    let part = (here.0 * along.0 + here.1 * along.1) / square.max(f64::MIN_POSITIVE);
    let part = part.clamp(0.0, 1.0);
    (here.0 - part * along.0).hypot(here.1 - part * along.1)
}
