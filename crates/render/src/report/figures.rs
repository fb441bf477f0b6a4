//! The charts of the page.

use super::page::Page;
use super::table::Table;
use crate::chart::PictureError;
use crate::chart::{self, Chart, Heading};
use gearlash::analysis::curves::{Course, DistancePoint, Followed};
use gearlash::gear::Inspection;
use gearlash_files::numbers::stated_distance;
use gearlash_results::grades::GearGrades;
use maud::{Markup, PreEscaped, html};

/// Most centre distances and phases whose curves are in the page (tuned: some 100 kB each).
const MOST_COURSES: usize = 12;

/// Least height of a profile chart, µm, as for the gauge.
const LEAST_PROFILE: f64 = 0.1;

/// Backlash over the teeth: the centre distance with the least backlash; the others are collapsed.
pub(super) fn revolutions(page: &Page) -> Result<Markup, PictureError> {
    let draw = |number: usize, course: &Course| {
        let title = format!("Backlash over the teeth {}", place(course));
        let drawn = chart::revolution(&heading(page, &id(number), &title), course)?;
        Ok(html! {
            figure.chart tabindex="0" {
                (svg(&drawn))
                figcaption.hint { "Click or tap the chart: the mesh below turns to that pose." }
            }
        })
    };
    over_teeth(page, "backlash over the teeth", draw)
}

/// Centre distance and phase of a course.
fn place(course: &Course) -> String {
    let phase = course.phase.map_or(String::new(), |(wheel, pinion)| {
        format!(", phase {wheel}·{pinion}")
    });
    format!(
        "at a = {} mm{phase}",
        stated_distance(course.center_distance)
    )
}

/// Id of the chart of a course.
fn id(number: usize) -> String {
    format!("revolution{number}")
}

/// The courses whose charts are in the page, each with the chart's id.
pub(super) fn charted<'p>(page: &'p Page) -> Vec<(String, &'p Course)> {
    let drawn = drawn_courses(page);
    drawn
        .into_iter()
        .map(|number| (id(number), &page.courses[number]))
        .collect()
}

/// The indices of those courses; the one with the least backlash of all comes first.
fn drawn_courses(page: &Page) -> Vec<usize> {
    let least = page.whole.least.and_then(|least| {
        let run = &least.run.run;
        let is_of = |course: &Course| {
            let is_of_phase = course.phase.is_none() || course.phase == run.phase;
            course.center_distance == run.assembly.center_distance() && is_of_phase
        };
        page.courses.iter().position(is_of)
    });
    let least = least.or((!page.courses.is_empty()).then_some(0));
    let others = (0..page.courses.len()).filter(|number| Some(*number) != least);
    least.into_iter().chain(others).take(MOST_COURSES).collect()
}

/// Simulation minus formula over the teeth: the centre distance with the least backlash; the others are collapsed.
pub(super) fn difference(page: &Page) -> Result<Markup, PictureError> {
    let tolerance = page.report.pair.study.tolerance_um;
    let draw = |number: usize, course: &Course| {
        let title = format!("Simulation minus formula {}", place(course));
        let comparable = course.lines.iter().flat_map(|line| &line.points);
        let comparable = comparable
            .map(|point| {
                [
                    point.off_michalec_um,
                    point.off_involute_um,
                    point.off_line_of_action_um,
                ]
            })
            .any(|models| models.iter().any(Option::is_some));
        if comparable {
            let prefix = format!("difference{number}");
            let drawn = chart::difference(&heading(page, &prefix, &title), course, tolerance)?;
            Ok(figure(&drawn))
        } else {
            Ok(html! { p { (title) ": no pose has both values." } })
        }
    };
    over_teeth(page, "simulation minus formula", draw)
}

/// `draw` for the course with the least backlash; and for the others in `<details>`, named `what`.
fn over_teeth(
    page: &Page,
    what: &str,
    draw: impl Fn(usize, &Course) -> Result<Markup, PictureError>,
) -> Result<Markup, PictureError> {
    let drawn = drawn_courses(page);
    let left_out = page.courses.len() - drawn.len();
    let draw = |number: usize| draw(number, &page.courses[number]);
    let Some((first, rest)) = drawn.split_first() else {
        return Ok(html! {});
    };
    let phases = page.courses.iter().any(|course| course.phase.is_some());
    let others = match (phases, page.distances.len()) {
        (true, 1) => format!("{what} in the other phases"),
        (true, _) => format!("{what} at the other centre distances and in the other phases"),
        (false, _) => format!("{what} at the other centre distances"),
    };
    Ok(html! {
        (draw(*first)?)
        @if !rest.is_empty() {
            details {
                summary { "More: " (others) }
                @for number in rest { (draw(*number)?) }
                @if left_out > 0 && phases {
                    p.note {
                        (left_out) " more by " code { "gearlash chart" } ", where the pair file has "
                        code { "[sweep] revolutions = \"hunting\"" } " and " code { "start = [1, P]" } " in place of " code { "phases" } "."
                    }
                } @else if left_out > 0 {
                    p.note { (left_out) " more by " code { "gearlash chart --center-distance" } "." }
                }
            }
            (not_on_paper(&others))
        }
    })
}

/// Backlash over the centre distance: the binding mating; other measured ones are collapsed.
pub(super) fn over_distance(page: &Page) -> Result<Markup, PictureError> {
    let mut figures = Vec::new();
    for (number, curve) in page.report.analysis.over_distance.iter().enumerate() {
        let simulated = |point: &DistancePoint| point.bands.simulated.is_some();
        if !curve.points.iter().any(simulated) && curve.measured.is_empty() {
            continue;
        }
        let of = match curve.followed {
            Followed::Pose(_) => " at the pose that binds".to_owned(),
            Followed::Teeth(wheel, pinion) => {
                let binds = if number == 0 { ", which bind" } else { "" };
                format!(", teeth {wheel} and {pinion}{binds}")
            }
        };
        let title = format!("Backlash over the centre distance{of}");
        let prefix = format!("distance{number}");
        figures.push(figure(&chart::distance(
            &heading(page, &prefix, &title),
            curve,
            &page.distances,
        )?));
    }
    let others = "backlash of the other measured matings over the centre distance";
    let Some((first, rest)) = figures.split_first() else {
        return Ok(html! {
            p {
                "Left out: over these centre distances the gears are jammed or out of mesh"
                @if page.report.analysis.over_distance.iter().any(|curve| curve.unproven > 0) { ", or it is unproven" }
                "."
            }
        });
    };
    Ok(html! {
        (first)
        @if !rest.is_empty() {
            details {
                summary { "More: " (others) }
                @for figure in rest { (figure) }
            }
            (not_on_paper(others))
        }
    })
}

/// The heading of a chart: its title, and the pair's below it.
fn heading<'h>(page: &Page<'h>, prefix: &'h str, title: &'h str) -> Heading<'h> {
    Heading {
        prefix,
        title,
        subtitle: &page.report.pair.study.title,
    }
}

/// Pitch, thickness and runout of each gear, tooth by tooth.
pub(super) fn inspections(page: &Page) -> Result<Markup, PictureError> {
    let Some((_, wheel, pinion)) = page.report.pair.study.materials.first() else {
        return Ok(html! {});
    };
    let draw = |name: &str, gear| {
        let inspection = Inspection::of(gear);
        if !inspection.deviates() {
            return Ok(html! {
                p { "No pitch, thickness or runout deviations are given for the teeth of the " (name) "." }
            });
        }
        let title = format!("Deviations of the {name}, tooth by tooth");
        let prefix = format!("inspection-{name}");
        let drawn = chart::inspection(&heading(page, &prefix, &title), name, &inspection)?;
        Ok::<Markup, PictureError>(html! { figure.chart.tall tabindex="0" { (svg(&drawn)) } })
    };
    Ok(html! {
        h3 { "Deviations tooth by tooth" }
        (draw("wheel", wheel)?)
        (draw("pinion", pinion)?)
        @for gear in page.report.grades {
            (profiles(page, gear)?)
            (leads(page, gear)?)
        }
    })
}

/// Profile deviation of a gear over the roll length, where it has any.
fn profiles(page: &Page, gear: &GearGrades) -> Result<Markup, PictureError> {
    let Some(read) = gear.profile.as_ref().filter(|read| read.deviates()) else {
        return Ok(html! {});
    };
    let title = format!("Profile deviations of the {}", gear.name);
    let prefix = format!("profile-{}", gear.name);
    let drawn = chart::profiles(&heading(page, &prefix, &title), read, LEAST_PROFILE)?;
    Ok(html! { figure.chart.tall tabindex="0" { (svg(&drawn)) } })
}

/// Lead deviation of a gear over the height, where it has any.
fn leads(page: &Page, gear: &GearGrades) -> Result<Markup, PictureError> {
    let Some(read) = &gear.lead else {
        return Ok(html! {});
    };
    let title = format!("Lead deviations of the {}", gear.name);
    let prefix = format!("lead-{}", gear.name);
    let drawn = chart::leads(&heading(page, &prefix, &title), read, LEAST_PROFILE)?;
    Ok(html! { figure.chart.tall tabindex="0" { (svg(&drawn)) } })
}

/// Rows above which a table is collapsed in `<details>`.
const LONG: usize = 12;

/// A table; a long one is collapsed in `<details>` named `what`.
pub(super) fn folded(what: &str, table: &Table) -> Markup {
    let rows = table.rows.len();
    html! {
        @if rows > LONG {
            details {
                summary { (what) ": " (rows) " rows" }
                (table)
            }
            (not_on_paper(what))
        } @else {
            (table)
        }
    }
}

/// A note on paper in place of collapsed `<details>`.
pub(super) fn not_on_paper(what: &str) -> Markup {
    html! { p.paper.note { "Not printed: " (what) ". Expand it on the screen before printing." } }
}

/// A chart as a figure of the page.
pub(super) fn figure(chart: &Chart) -> Markup {
    html! { figure.chart tabindex="0" { (svg(chart)) } }
}

/// A chart for a wide and for a narrow screen; the style sheet shows one of them.
pub(super) fn svg(chart: &Chart) -> Markup {
    html! { (PreEscaped(&chart.svg)) (PreEscaped(chart.narrow().svg)) }
}
