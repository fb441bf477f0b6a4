//! The charts of the page.

use super::page::Page;
use super::table::Table;
use crate::chart::{self, Chart, Heading, PictureError};
use crate::pose_name::phase_name;
use gearlash::analysis::curves::{Course, DistancePoint, Followed};
use gearlash::gear::Inspection;
use gearlash::pair::BacklashUnit;
use gearlash_results::gauge::GearGrades;
use gearlash_text::numbers::stated_distance;
use maud::{Markup, PreEscaped, Render, html};

/// Most centre distances and phases whose curves are in the page (tuned: some 100 kB each).
const MOST_COURSES: usize = 12;

/// Backlash over the teeth: the centre distance with the least backlash; the others are collapsed.
pub(super) fn revolutions(page: &Page) -> Result<Markup, PictureError> {
    let draw = |number: usize, course: &Course| {
        let title = format!("Backlash over the teeth {}", place(course));
        let id = id(number);
        let drawn = chart::revolution(BacklashUnit::Um, &heading(page, &id, &title)?, course);
        Ok(html! {
            figure.chart tabindex="0" {
                (svg(&drawn))
                figcaption.hint { "Click or tap the chart: the mesh below turns to that pose." }
            }
        })
    };
    over_teeth(page, "backlash over the teeth", draw)
}

fn place(course: &Course) -> String {
    let a = stated_distance(course.center_distance);
    format!("at a = {a} mm{}", phase_name(course.phase))
}

fn id(number: usize) -> String {
    format!("revolution{number}")
}

/// The courses whose charts are in the page, each with the chart's id.
pub(super) fn charted<'p>(page: &'p Page) -> Vec<(String, &'p Course)> {
    let drawn = drawn_courses(page).into_iter();
    drawn
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
        let mut points = course.lines.iter().flat_map(|line| &line.points);
        let is_comparable = points.any(|point| {
            point.off_michalec_um.is_some()
                || point.off_involute_um.is_some()
                || point.off_line_of_action_um.is_some()
        });
        if is_comparable {
            let prefix = format!("difference{number}");
            let drawn = chart::difference(&heading(page, &prefix, &title)?, course, tolerance)?;
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
            (more(&others, html! {
                @for number in rest { (draw(*number)?) }
                @if left_out > 0 && phases {
                    p.note {
                        (left_out) " more by " code { "gearlash chart" } ", where the pair file has "
                        code { "[sweep] revolutions = \"hunting\"" } " and " code { "start = [1, P]" } " in place of " code { "phases" } "."
                    }
                } @else if left_out > 0 {
                    p.note { (left_out) " more by " code { "gearlash chart --center-distance" } "." }
                }
            }))
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
                let binds = if number == 0 { " (least backlash)" } else { "" };
                format!(", mating {wheel}·{pinion}{binds}")
            }
        };
        let title = format!("Backlash over the centre distance{of}");
        let prefix = format!("distance{number}");
        let heading = heading(page, &prefix, &title)?;
        let drawn = chart::distance(BacklashUnit::Um, &heading, curve, &page.distances)?;
        figures.push(figure(&drawn));
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
        @if !rest.is_empty() { (more(others, html! { @for figure in rest { (figure) } })) }
    })
}

/// The heading of the next chart: its title, and the pair's below it.
fn heading<'h>(
    page: &Page<'h>,
    prefix: &'h str,
    title: &'h str,
) -> Result<Heading<'h>, PictureError> {
    page.tick()?;
    Ok(Heading {
        prefix,
        title,
        subtitle: &page.report.pair.study.title,
    })
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
        let drawn = chart::inspection(&heading(page, &prefix, &title)?, name, &inspection)?;
        Ok::<Markup, PictureError>(tall(&drawn))
    };
    Ok(html! {
        h3 { "Deviations tooth by tooth" }
        (draw("wheel", wheel)?)
        (draw("pinion", pinion)?)
        @for gear in page.report.grades {
            @if let Some(read) = gear.profile.as_ref().filter(|read| read.deviates()) {
                (deviations(page, gear, ["profile", "Profile"], |heading| chart::profiles(heading, read))?)
            }
            @if let Some(read) = &gear.lead {
                (deviations(page, gear, ["lead", "Lead"], |heading| chart::leads(heading, read))?)
            }
        }
    })
}

/// Deviations of a gear as `draw` shows them. `names`: their kind in an id and in a title.
fn deviations(
    page: &Page,
    gear: &GearGrades,
    names: [&str; 2],
    draw: impl Fn(&Heading) -> Result<Chart, PictureError>,
) -> Result<Markup, PictureError> {
    let title = format!("{} deviations of the {}", names[1], gear.name);
    let prefix = format!("{}-{}", names[0], gear.name);
    Ok(tall(&draw(&heading(page, &prefix, &title)?)?))
}

/// Rows above which a table is collapsed in `<details>`.
const LONG: usize = 12;

/// A table; a long one is collapsed in `<details>` named `what`.
pub(super) fn folded(what: &str, table: &Table) -> Markup {
    let rows = table.rows.len();
    html! {
        @if rows > LONG {
            (collapsed(&format!("{what}: {rows} rows"), what, table.render()))
        } @else {
            (table)
        }
    }
}

/// `content` in collapsed `<details>` under `summary`; on paper a note that `what` is left out.
pub(super) fn collapsed(summary: &str, what: &str, content: Markup) -> Markup {
    html! {
        details {
            summary { (summary) }
            (content)
        }
        p.paper.note { "Not printed: " (what) ". Expand it on the screen before printing." }
    }
}

pub(super) fn more(what: &str, content: Markup) -> Markup {
    collapsed(&format!("More: {what}"), what, content)
}

pub(super) fn figure(chart: &Chart) -> Markup {
    html! { figure.chart tabindex="0" { (svg(chart)) } }
}

fn tall(chart: &Chart) -> Markup {
    html! { figure.chart.tall tabindex="0" { (svg(chart)) } }
}

/// A chart for a wide and for a narrow screen; the style sheet shows one of them.
pub(super) fn svg(chart: &Chart) -> Markup {
    html! { (PreEscaped(&chart.svg)) (PreEscaped(chart.narrow().svg)) }
}
