//! Which of two lines is of which material.

use super::panel::Mark;
use crate::kit::Anchor;
use gearlash::analysis::curves::{Course, CourseLine, CoursePoint};
use gearlash::analysis::study::Material;

/// Height of a panel's plot, units, or less.
const PLOT: f64 = 170.0;
/// From here on two lines are distinguished, units.
const APART: f64 = 2.5;
/// From a line's end to its label, and from label to label, units.
const SHIFT: f64 = 10.0;
const LABEL: f64 = 14.0;

/// Which line is which, for a title.
pub(super) fn thin(course: &Course) -> &'static str {
    let mut lines = course.lines.iter();
    match lines.any(|line| line.material == Material::Least) {
        true => " (thin: least material)",
        false => "",
    }
}

/// Width of a material's line.
pub(super) fn width(material: Material) -> f64 {
    match material {
        Material::Most | Material::AsMeasured => 1.8,
        Material::Least => 0.8,
    }
}

/// The material at the right end of each of two `lines`, on a panel whose axis goes over `y`; none where both end on one
/// spot, and none for one line.
pub(super) fn ends<'a>(
    lines: impl Iterator<Item = &'a CourseLine>,
    value: fn(&CoursePoint) -> Option<f64>,
    factor: f64,
    y: [f64; 2],
) -> Vec<Mark> {
    let end = |line: &CourseLine| {
        let last = line.points.last()?;
        Some((line.material.name(), [last.x, value(last)? * factor]))
    };
    let mut ends: Vec<(&str, [f64; 2])> = lines.filter_map(end).collect();
    ends.sort_by(|a, b| b.1[1].total_cmp(&a.1[1]));
    let [(upper, high), (lower, low)] = ends[..] else {
        return Vec::new();
    };
    let height = |at: [f64; 2]| (at[1] - y[0]) / (y[1] - y[0]) * PLOT;
    if height(high) - height(low) < APART {
        return Vec::new();
    }
    // Above and below; both on one side where the other has no room.
    let shifts = match (PLOT - height(high) < LABEL, height(low) < LABEL) {
        (true, false) => [SHIFT, SHIFT + LABEL],
        (false, true) => [-SHIFT - LABEL, -SHIFT],
        _ => [-SHIFT, SHIFT],
    };
    let text = |name: &str, at: [f64; 2], down: f64| {
        Mark::text(at, [-3.0, down], format!("{name} material"), Anchor::End)
    };
    vec![text(upper, high, shifts[0]), text(lower, low, shifts[1])]
}
