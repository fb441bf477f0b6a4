//! The drawing of a line with many swings shows only its data, their extremes, and their period.
//!
//! Issue 14: 24/8 over a revolution, 16 poses a pitch, was irregular triangles and blocks; windows of the thinning beat with
//! the pitch. Expected places are the data's own.

use super::drawn::{HALF, INK, LEFT, Picture, RIGHT, Spot, ends, place};
use super::{first_course, of_course, of_difference, over_pitches, study_of};
use gearlash::analysis::curves::{Course, CoursePoint};
use gearlash::gear::Side;
use gearlash_render::chart::{Chart, Plot};

/// Half the window of an envelope (whole pitches, the next above a swing of less than 10 units), and a column.
const NEAR: f64 = 0.5 * (10.0 + 14.0) + 1.0;

/// The pair of the issue over `pitches`: a line up to a hundred or so, then an envelope.
/// 1806 pitches are a hunting cycle of 28 896 poses.
fn periodic(pitches: u64) -> Course {
    let gear = |name: &str, teeth: u32| {
        format!(
            "[{name}]\nteeth = {teeth}\nmodule_mm = 2.0\npressure_angle_deg = 20.0\nthickness = {{ allowance_um = -60 }}\n"
        )
    };
    let text = gear("wheel", 24) + &gear("pinion", 8) + "[assembly]\ncenter_distance_mm = 32.0\n";
    first_course(&over_pitches(study_of(&text), pitches, 16))
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

/// Lines of a chart in its plot are near their data and reach their extremes and period.
fn check(course: &Course, (chart, picture): &(Chart, Picture), drawn: &[Drawn]) {
    let plot: &Plot = &chart.panels[0];
    let inside = |&[x, y]: &Spot| {
        x >= plot.frame.left && y >= plot.frame.top && y < plot.frame.bottom - HALF
    };
    for &(colour, flank, value) in drawn {
        let mut lines = picture.lines_of(colour);
        // Ticks, crosses and the axes have two points.
        let is_long = |line: &[Spot]| line.len() > 2 || line[1][0] - line[0][0] > 600.0;
        lines.retain(|line| is_long(line) && line.iter().all(inside));
        assert!(!lines.is_empty(), "{colour}");
        let mut courses = course.lines.iter();
        let of = courses.find(|line| line.flank == flank).unwrap();
        let points = of.points.iter();
        let data = points.map(|point| place(plot, [point.x, value(point).unwrap()]));
        let data: Vec<Spot> = data.collect();
        for &[x, y] in lines.iter().copied().flatten() {
            let near = data.iter().filter(|spot| (spot[0] - x).abs() <= NEAR);
            let [low, high] = ends(near.map(|spot| spot[1]));
            assert!(low - HALF <= y && y <= high + HALF, "{x} {y}: {low} {high}");
        }
        let heights = ends(lines.iter().copied().flatten().map(|spot| spot[1]));
        let expected = ends(data.iter().map(|spot| spot[1]));
        for (drawn, data) in heights.into_iter().zip(expected) {
            assert!((drawn - data).abs() < HALF, "{heights:?} {expected:?}");
        }
        let pitch = (plot.frame.right - plot.frame.left) / (plot.x[1] - plot.x[0]);
        for line in lines {
            let last = line[line.len() - 1][0];
            for &[x, y] in line.iter().filter(|spot| spot[0] + pitch < last) {
                let spot = [x + pitch, y];
                let mut segments = line.windows(2);
                let met = segments.any(|ends| distance(spot, [ends[0], ends[1]]) < HALF);
                assert!(met, "{colour} at {spot:?}");
            }
        }
    }
}

#[test]
fn a_drawn_line_is_within_its_data_and_has_their_extremes_and_period() {
    for pitches in [24, 48, 97, 240, 1806] {
        let course = periodic(pitches);
        let revolution = of_course(&course);
        assert!(pitches < 1806 || revolution.0.svg.len() < 300_000);
        check(&course, &revolution, &REVOLUTION);
        check(&course, &of_difference(&course), &DIFFERENCE);
    }
}

/// How far a spot lies from a segment.
fn distance(spot: Spot, [from, to]: [Spot; 2]) -> f64 {
    let along = [0, 1].map(|axis| to[axis] - from[axis]);
    let here = [0, 1].map(|axis| spot[axis] - from[axis]);
    let square = along[0].powi(2) + along[1].powi(2);
    let part = (here[0] * along[0] + here[1] * along[1]) / square.max(f64::MIN_POSITIVE);
    let part = part.clamp(0.0, 1.0);
    (here[0] - part * along[0]).hypot(here[1] - part * along[1])
}
