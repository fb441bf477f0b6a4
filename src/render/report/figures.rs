//! The charts of the page.

use super::Page;
use super::words::distance;
use crate::compare::ComparedRun;
use crate::curves::{Course, courses};
use crate::error::Error;
use crate::gear::Inspection;
use crate::render::chart::{self, Chart};
use maud::{Markup, PreEscaped, html};

/// Centre distances and phases whose curves stand in the page (tuned: some 100 kB each).
const MOST_COURSES: usize = 12;

/// Backlash over the teeth: the centre distance with the least backlash, the others to be opened.
///
/// `viewed` are the runs that the mesh view shows.
pub(super) fn revolutions(page: &Page, viewed: &[&ComparedRun]) -> Result<Markup, Error> {
    let draw = |number: usize, course: &Course| {
        let title = format!("Backlash over the teeth at a = {} mm", distance(course.center_distance));
        let drawn = chart::revolution(&format!("revolution{number}"), &title, course)?;
        Ok(figure(&drawn, &viewer_runs(course, viewed)))
    };
    over_teeth(page, "Backlash over the teeth at the other centre distances", draw)
}

/// Simulation minus formula over the teeth, likewise.
pub(super) fn difference(page: &Page) -> Result<Markup, Error> {
    let tolerance = page.report.study.tolerance_um;
    let draw = |number: usize, course: &Course| {
        let title = format!("Simulation minus formula at a = {} mm", distance(course.center_distance));
        let comparable = course.lines.iter().flat_map(|line| &line.points);
        let comparable = comparable
            .map(|point| [point.off_michalec_um, point.off_involute_um, point.off_line_of_action_um])
            .any(|models| models.iter().any(Option::is_some));
        match comparable {
            false => Ok(html! { p { (title) ": no pose has both values." } }),
            true => {
                let prefix = format!("difference{number}");
                let drawn = chart::difference(&prefix, &title, course, tolerance)?;
                Ok(figure(&drawn, ""))
            }
        }
    };
    over_teeth(page, "Simulation minus formula at the other centre distances", draw)
}

/// `draw` of the course with the least backlash, and of the others in `<details>` under `others`.
fn over_teeth(
    page: &Page,
    others: &str,
    draw: impl Fn(usize, &Course) -> Result<Markup, Error>,
) -> Result<Markup, Error> {
    let courses = courses(page.report.revolution);
    let backlash = |course: &Course| course.least.map_or(f64::INFINITY, |least| least.backlash_um);
    let least = courses.iter().enumerate();
    let least = least.reduce(|least, next| match backlash(next.1) < backlash(least.1) {
        true => next,
        false => least,
    });
    let Some((first, course)) = least else {
        return Ok(html! {});
    };
    let rest = courses.iter().enumerate().filter(|(number, _)| *number != first);
    let rest: Vec<_> = rest.take(MOST_COURSES - 1).collect();
    let left_out = courses.len() - 1 - rest.len();
    Ok(html! {
        (draw(first, course)?)
        @if !rest.is_empty() {
            details {
                summary { (others) }
                @for (number, course) in rest { (draw(number, course)?) }
                @if left_out > 0 {
                    p.note { (left_out) " more by " code { "gearlash chart --center-distance" } "." }
                }
            }
        }
    })
}

/// The places in `viewed` of the runs that `course` shows.
fn viewer_runs(course: &Course, viewed: &[&ComparedRun]) -> String {
    let shown = viewed.iter().enumerate().filter(|(_, run)| {
        run.run.assembly.center_distance() == course.center_distance && run.run.phase == course.phase
    });
    let places: Vec<String> = shown.map(|(place, _)| place.to_string()).collect();
    places.join(" ")
}

/// Backlash over the centre distance.
pub(super) fn over_distance(page: &Page) -> Result<Markup, Error> {
    let curve = page.report.over_distance;
    let (wheel, pinion) = curve.mating;
    let shown = curve.points.iter().any(|point| point.bands.simulated.is_some());
    if !shown && curve.measured.is_empty() {
        return Ok(html! {});
    }
    let title = format!("Backlash over the centre distance, teeth {wheel} and {pinion}");
    Ok(figure(&chart::distance("distance", &title, curve)?, ""))
}

/// Pitch, thickness and runout of each gear, tooth by tooth.
pub(super) fn inspections(page: &Page) -> Result<Markup, Error> {
    let Some((_, wheel, pinion)) = page.report.study.materials.first() else {
        return Ok(html! {});
    };
    let draw = |name: &str, gear| {
        let title = format!("Deviations of the {name}, tooth by tooth");
        let drawn = chart::inspection(&format!("inspection-{name}"), &title, name, &Inspection::of(gear))?;
        Ok::<Markup, Error>(figure(&drawn, ""))
    };
    Ok(html! {
        (draw("wheel", wheel)?)
        (draw("pinion", pinion)?)
    })
}

/// A chart; one with `runs` moves with the mesh view.
fn figure(chart: &Chart, runs: &str) -> Markup {
    let runs = (!runs.is_empty()).then_some(runs);
    html! { figure.chart data-viewer-runs=[runs] { (PreEscaped(&chart.svg)) } }
}
