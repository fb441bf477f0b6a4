//! Simulation minus formula over the teeth.

use super::captions::{course_axis, course_caption, empty, entry, unproven_note, unproven_of};
use super::panel::{Look, Mark, Panel, Point, Swatch, range};
use super::sheet::{self, Chart, Heading, PictureError};
use crate::kit::{Anchor, Axis};
use gearlash::analysis::curves::{Course, CourseLine, CoursePoint};
use gearlash::analysis::study::Material;
use gearlash::gear::Side;

const BOUND: f64 = 0.16;

/// Simulated minus analytic backlash of the right-flank poses at one centre distance, one line per material: models 1 and 2 in
/// the upper panel; model 3 with the error bound of the simulation in the lower, on a separate scale.
///
/// # Errors
/// [`PictureError`] when all poses are proven and none has both values.
pub fn difference(
    heading: &Heading,
    course: &Course,
    tolerance_um: f64,
) -> Result<Chart, PictureError> {
    let lines = || course.lines.iter().filter(|line| line.flank == Side::Right);
    let of = |model: fn(&CoursePoint) -> Option<f64>, look: Look| {
        let lines = lines()
            .map(move |line| Mark::Line(points(line, model, 1.0), look, width(line.material)));
        lines.collect::<Vec<Mark>>()
    };
    let models: [fn(&CoursePoint) -> Option<f64>; 2] =
        [|point| point.off_michalec_um, |point| point.off_involute_um];
    let all = |model: fn(&CoursePoint) -> Option<f64>| {
        let points = lines().flat_map(|line| &line.points);
        points.filter_map(model)
    };
    let mut panels = Vec::new();
    let mut legend = Vec::new();
    // The y range includes zero.
    let both = || models.into_iter().flat_map(all);
    let zero = both().next().map(|_| 0.0);
    if let Some(y) = range(both().chain(zero), [0.1; 2], 1e-3) {
        legend.push(entry("minus model 1, Michalec", Look::Left, Swatch::Line));
        legend.push(entry("minus model 2, involute", Look::Plain, Swatch::Line));
        let mut marks = of(models[1], Look::Plain);
        marks.extend(of(models[0], Look::Left));
        let x = Axis {
            name: String::new(),
            ..course_axis(course)
        };
        let title = format!("minus models 1 and 2{}", thin_line_material(course));
        panels.push(Panel::new(x, Axis::new("µm", y), 230.0, marks).titled(title));
    }
    if let Some(lower) = line_of_action(course, tolerance_um) {
        let (line, bound) = (Swatch::Line, Swatch::Band(BOUND));
        legend.push(entry("minus model 3, line of action", Look::Right, line));
        legend.push(entry("error bound of the simulation", Look::Limit, bound));
        panels.push(lower);
    }
    if panels.is_empty() {
        let unproven = unproven_of(lines());
        if unproven > 0 {
            let words = "no pose that is proven has both a simulated and an analytic value";
            let details = unproven_note(unproven) + &course_caption(course);
            let panel = empty(course_axis(course), words);
            return Ok(sheet::draw(heading, &details, &[], &[panel]));
        }
        let mut values = lines().flat_map(|line| &line.points);
        if values.any(|point| point.simulated_um.is_some()) {
            let words = "no formula has a value: a drawn gear has no involute, or no two involutes reach each other";
            return Err(PictureError(words.to_owned()));
        }
        return Err(PictureError(format!(
            "no pose at centre distance {} mm has both a simulated and an analytic value: jammed or out of mesh",
            course.center_distance
        )));
    }
    let (unproven, of) = (unproven_note(unproven_of(lines())), course_caption(course));
    let details = format!("{unproven}simulated − formula, right flanks · {of}");
    Ok(sheet::draw(heading, &details, &legend, &panels))
}

fn line_of_action(course: &Course, tolerance_um: f64) -> Option<Panel> {
    let lines = || course.lines.iter().filter(|line| line.flank == Side::Right);
    let all = || lines().flat_map(|line| &line.points);
    let known = || all().filter_map(|point| point.off_line_of_action_um);
    known().next()?;
    let off = |point: &CoursePoint| point.off_line_of_action_um;
    let bound = |point: &CoursePoint| point.error_bound_um;
    let sizes = known().chain(all().filter_map(bound)).map(f64::abs);
    let (unit, name) = unit(sizes.reduce(f64::max)?);
    let bands = lines().map(|line| {
        let edges = [-1.0, 1.0].map(|sign| points(line, bound, sign / unit));
        Mark::Band(edges, Look::Limit, BOUND)
    });
    let curves = lines().map(|line| {
        let points = points(line, off, 1.0 / unit);
        Mark::Line(points, Look::Right, width(line.material))
    });
    let mut marks: Vec<Mark> = bands.chain(curves).collect();
    let values = all().filter_map(off);
    let bounds = all().filter_map(bound).flat_map(|bound| [-bound, bound]);
    let shown = values.chain(bounds).map(|value| value / unit);
    let y = range(shown, [0.18; 2], 0.1)?;
    let tolerance = tolerance_um / unit;
    let words = if y[0] < -tolerance || y[1] > tolerance {
        for limit in [-tolerance, tolerance] {
            if y[0] < limit && limit < y[1] {
                marks.push(Mark::level(course.span, limit, Look::Limit, 1.2));
            }
        }
        format!("tolerance ±{tolerance_um} µm: short dashes")
    } else {
        format!("tolerance ±{tolerance_um} µm: outside this axis")
    };
    let corner = [course.span[0], y[1]];
    marks.push(Mark::text(corner, [8.0, 10.0], words, Anchor::Start));
    let thin = thin_line_material(course);
    let title = format!("minus model 3, separate scale{thin}");
    let panel = Panel::new(course_axis(course), Axis::new(name, y), 230.0, marks);
    Some(panel.titled(title))
}

/// The points of a line: a value of each pose of the course, times `factor`.
fn points(
    line: &CourseLine,
    value: impl Fn(&CoursePoint) -> Option<f64>,
    factor: f64,
) -> Vec<Point> {
    let points = line.points.iter();
    points
        .map(|point| (point.x, value(point).map(|value| value * factor)))
        .collect()
}

/// A power of a thousandth of a micrometre suitable for values up to `largest`, and its name.
fn unit(largest: f64) -> (f64, &'static str) {
    let units = [
        (1.0, "µm"),
        (1e-3, "10⁻³ µm"),
        (1e-6, "10⁻⁶ µm"),
        (1e-9, "10⁻⁹ µm"),
    ];
    let suits = |unit: &&(f64, &str)| largest >= 0.1 * unit.0;
    *units.iter().find(suits).unwrap_or(&(1e-12, "10⁻¹² µm"))
}

/// The material of the thin lines, for a title.
fn thin_line_material(course: &Course) -> &'static str {
    let mut lines = course.lines.iter();
    if lines.any(|line| line.material == Material::Least) {
        " (thin: least material)"
    } else {
        ""
    }
}

fn width(material: Material) -> f64 {
    match material {
        Material::Most | Material::AsMeasured => 1.8,
        Material::Least => 0.8,
    }
}
