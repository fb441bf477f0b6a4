//! What is left out of an outline and why, and how the numbers were found.

use super::super::phrases::j_wt;
use super::OutlineReport;
use gearlash_files::numbers::bound_um;
use maud::{Markup, html};

/// What is left out, why, and what stands in its place.
const LEFT_OUT: [(&str, &str, &str); 6] = [
    (
        "backlash by formula, models 1 to 3",
        "needs a line of action",
        "–",
    ),
    (
        "contact ratio, undercut, form circles",
        "needs a base circle",
        "–",
    ),
    ("limits of radial clearance", "needs a module", "–"),
    (
        "grades of pitch and profile",
        "needs a reference circle",
        "–",
    ),
    (
        "spans and dimensions over pins",
        "no part of the mesh",
        "by contact: gearlash gauge DRAWING --span 3 --pin 3.5",
    ),
    (
        "proven extremes between poses",
        "needs a bound for any curve",
        "extremes of sampled poses",
    ),
];

pub(super) fn section(report: &OutlineReport) -> Markup {
    let poses: usize = report.runs.iter().map(|run| run.poses.len()).sum();
    let errors = report.runs.iter().flat_map(|run| &run.poses);
    let error = errors
        .filter_map(|pose| Some(pose.j_wt?.1))
        .reduce(f64::max);
    html! {
        section id="left-out" {
            h2 { "Left out" }
            p { "An outline has no module and no involute, and nothing is computed from a guessed one." }
            div.scroll tabindex="0" role="region" aria-label="Left out" {
                table {
                    thead { tr { th scope="col" { "left out" } th scope="col" { "why" } th scope="col" { "in its place" } } }
                    tbody { @for (what, why, instead) in LEFT_OUT {
                        tr { th scope="row" { (what) } td { (why) } td.text { (instead) } }
                    } }
                }
            }
        }
        section id="method" {
            h2 { "Method and error bound" }
            p {
                "The " (report.pair.study.locked.name()) " is locked; its mate is turned until the right flanks touch, and until the left flanks touch. "
                "The angle between is the lost motion, signed: negative backlash means that the teeth would have to overlap. Times the mate’s operating pitch "
                "radius, which the numbers of teeth alone give, it is the circumferential backlash " (j_wt()) "."
            }
            p {
                "Contacts are searched on the curves as drawn: every pair of pieces that can meet is bounded or cut, none is left out, so that each of the "
                (poses) " poses is proven. "
                @if report.runs.iter().all(|run| run.certified) {
                    "Polygons (parry) that are refined round each contact bear it out: turned slightly open from it nothing touches, turned slightly closed "
                    "something does. "
                }
                @if let Some(error) = error {
                    "The error of " (j_wt()) " is at most " (bound_um(error)) " µm: rounding, what the search left open, and how far the curves may lie from what "
                    "was drawn. "
                }
                "How far a drawing lies from the gear that was meant, such as the chords of its flanks, nobody can tell from the drawing. Least and greatest are of "
                "the whole mesh cycle by sampled poses, closer round the best of them."
            }
            p {
                "Teeth are numbered clockwise from the first at or beyond +y of each drawing, whose picture shows the reference face. A tooth’s tip and root are the "
                "last hundredth of its height; between is flank. “Turns freely from”: the zero-backlash centre distance, at which the tightest of these poses just touches."
            }
        }
    }
}
