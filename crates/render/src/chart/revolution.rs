//! Backlash over the teeth, as in Figures 17–19 of the founding study.

use super::captions::{
    backlash_axis, course_axis, course_caption, draw_limits, empty, entry, interference,
    unproven_note, unproven_of, without_value,
};
use super::panel::{Look, Mark, Panel, Point, Swatch, backlash_range};
use super::sheet::{self, Chart, Heading};
use crate::kit::Anchor;
use gearlash::analysis::curves::{Course, CourseLine, Extreme};
use gearlash::analysis::extremes::CoveredPhases;
use gearlash::analysis::study::Material;
use gearlash::gear::Side;
use gearlash::pair::BacklashUnit;
use gearlash_results::verdict::cycle_words;
use gearlash_text::numbers::backlash;

const FILL: f64 = 0.2;

/// Smallest difference that a label shows, µm.
const SHOWN: f64 = 0.1;

/// Backlash over the teeth at one centre distance, in `unit`: one band per flank, from most to least material, with the teeth that bind at
/// the least and greatest backlash.
pub fn revolution(unit: BacklashUnit, heading: &Heading, course: &Course) -> Chart {
    let of_um = |um| unit.of_um(um, course.center_distance);
    let unproven = unproven_note(unproven_of(course.lines.iter()));
    let points = |line: &CourseLine| -> Vec<Point> {
        let points = line.points.iter();
        points
            .map(|point| (point.x, point.simulated_um.map(of_um)))
            .collect()
    };
    let points_of_all = || course.lines.iter().flat_map(|line| &line.points);
    let without = || {
        let without = points_of_all().filter(|point| point.simulated_um.is_none());
        without_value(without.map(|point| point.status))
    };
    let values = points_of_all().filter_map(|point| point.simulated_um.map(of_um));
    let cycle_extremes_outside = cycle_extremes_outside(course);
    let values = values.chain(cycle_extremes_outside.iter().flatten().copied().map(of_um));
    let Some(y) = backlash_range(values, of_um(1.0)) else {
        let words = format!("no pose has a backlash: {}", without());
        let panel = empty(course_axis(course), &words);
        let details = unproven + &course_caption(course);
        return sheet::draw(heading, &details, &[], &[panel]);
    };
    let axis = backlash_axis(unit, y);
    let mut panel = Panel::new(course_axis(course), axis, 360.0, Vec::new());
    let limits = draw_limits(&mut panel, unit, &course.required);
    let mut legend = Vec::new();
    // Only one band is filled, because both coincide where there are no pitch deviations.
    for (flank, look, fill) in [
        (Side::Right, Look::Right, true),
        (Side::Left, Look::Left, false),
    ] {
        let of = |material: Material| {
            let mut lines = course.lines.iter();
            lines.find(|line| (line.flank, line.material) == (flank, material))
        };
        let name = format!("{} flank at the pitch point", flank.name());
        let (most, least) = (of(Material::Most), of(Material::Least));
        if let (Some(most), Some(least)) = (most, least) {
            let mut sample = Swatch::Line;
            if fill {
                let band = Mark::Band([most, least].map(points), look, FILL);
                panel.marks.push(band);
                sample = Swatch::LineInBand(FILL);
            }
            let name = format!("{name}: most material (below) to least (above)");
            legend.push(entry(&name, look, sample));
        } else if let Some(line) = most.or(least).or(of(Material::AsMeasured)) {
            let name = match line.material {
                Material::AsMeasured => name,
                material => format!("{name}, {} material", material.name()),
            };
            legend.push(entry(&name, look, Swatch::Line));
        }
        let lines = course.lines.iter().filter(|line| line.flank == flank);
        let lines = lines.map(|line| Mark::Line(points(line), look, 1.6));
        panel.marks.extend(lines);
    }
    let busy = course.least.as_ref().map_or(0.0, |least| least.x);
    interference(&mut panel, busy);
    let shown = |um| {
        let value = backlash(unit, um, course.center_distance, 1);
        format!("{value} {}", unit.name())
    };
    match (&course.least, &course.greatest) {
        // One pose is both where all agree within their error bounds.
        (Some(least), Some(greatest)) if least == greatest => {
            let at = [panel.x.range[0], of_um(least.backlash_um)];
            let words = format!("{} everywhere", shown(least.backlash_um));
            panel
                .marks
                .push(Mark::text(at, [8.0, -14.0], words, Anchor::Start));
        }
        (Some(least), Some(greatest)) => {
            for (word, extreme, shift) in [("least", least, 16.0), ("greatest", greatest, -16.0)] {
                let y = of_um(extreme.backlash_um);
                let word = format!("{word} {}", shown(extreme.backlash_um));
                let label = label(&word, extreme, y, shift, panel.x.range);
                panel.marks.extend(label);
            }
        }
        _ => {}
    }
    for (um, word, shift) in [
        (cycle_extremes_outside[0], "least", 14.0),
        (cycle_extremes_outside[1], "greatest", -14.0),
    ] {
        let Some(um) = um else {
            continue;
        };
        let (x, y) = (panel.x.range, of_um(um));
        let cycle = cycle_words(&course.cycle_phases);
        let the = if course.cycle_phases == CoveredPhases::All {
            "the "
        } else {
            ""
        };
        let words = format!("{word} of {the}{cycle} {}", shown(um));
        panel.marks.push(Mark::level(x, y, Look::Limit, 1.2));
        panel
            .marks
            .push(Mark::text([x[1], y], [-8.0, shift], words, Anchor::End));
    }
    let gaps = if points_of_all().any(|point| point.simulated_um.is_none()) {
        format!(" · gaps: {}", without())
    } else {
        String::new()
    };
    let details = format!("{unproven}{}{limits}{gaps}", course_caption(course));
    sheet::draw(heading, &details, &legend, &[panel])
}

/// Least and greatest backlash of the mesh cycle, µm, where they exceed those of the course: at other teeth.
fn cycle_extremes_outside(course: &Course) -> [Option<f64>; 2] {
    let ends = [
        (&course.least, course.cycle_um[0], -1.0),
        (&course.greatest, course.cycle_um[1], 1.0),
    ];
    ends.map(|(attained, of_cycle, sign)| {
        let attained = attained.as_ref().map(|extreme| extreme.backlash_um);
        of_cycle.filter(|um| attained.is_none_or(|attained| sign * (um - attained) >= SHOWN))
    })
}

/// A cross at an extreme, at height `y`, with its words and the binding teeth.
pub(super) fn label(
    words: &str,
    extreme: &Extreme,
    y: f64,
    shift: f64,
    [left, right]: [f64; 2],
) -> [Mark; 2] {
    let part = (extreme.x - left) / (right - left);
    let (anchor, across) = match part {
        _ if part < 0.3 => (Anchor::Start, 7.0),
        _ if part > 0.7 => (Anchor::End, -7.0),
        _ => (Anchor::Middle, 0.0),
    };
    let teeth = |(wheel, pinion): (u32, u32)| format!("{wheel}·{pinion}");
    let [right_teeth, left_teeth] = [extreme.right, extreme.left].map(teeth);
    let words = format!("{words}: right flanks {right_teeth}, left flanks {left_teeth} touch");
    [
        Mark::Dots(vec![(extreme.x, Some(y))], Look::Plain),
        Mark::text([extreme.x, y], [across, shift], words, anchor),
    ]
}
