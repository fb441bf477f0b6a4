//! Every check with its margin.

use super::page::Page;
use super::phrases::{plain, study};
use super::table::Table;
use gearlash::analysis::diagnosis::Verdict;
use gearlash_results::text::check::{doubts, shown};
use maud::{Markup, html};

pub(super) fn section(page: &Page) -> Markup {
    let diagnosis = &page.report.analysis.diagnosis;
    let several = diagnosis.groups.len() > 1;
    let listed_runs = page.report.analysis.runs.iter();
    let poses: usize = listed_runs.map(|run| run.poses.len()).sum();
    let outcome = match diagnosis.verdict() {
        Verdict::Pass => "Every check passes.",
        Verdict::Warn => "No check fails; some values are outside the recommended range.",
        Verdict::Unproven => {
            "No check fails, but some are unproven: whether their limits are met is not known."
        }
        Verdict::Fail => "A check fails.",
    };
    html! {
        section id="checks" {
            h2 { "Checks" }
            p {
                (outcome)
                " “Formula” is of the gears’ mean teeth, “outlines” as found at the " (poses) " poses that the pair file asks for."
                @if !page.report.analysis.extremes.runs.is_empty() {
                    " The zero-backlash centre distance is that of the whole hunting cycle; the other checks are of these poses."
                }
                @if several { " Each check is shown at its worst centre distance and material." }
            }
            (Table::of_shown("Checks", html! {}, &shown(diagnosis)))
            @for reason in doubts(diagnosis) { p { strong { "Unproven: " } (plain(reason)) "." } }
            (study())
            p.note {
                "A contact is named by the curves that meet: tip-fillet is a tip on its mate’s fillet, undercut-edge the edge that undercut "
                "leaves at the foot of the involute. “0.25 pitch beyond”: turned on by a quarter of a tooth from where that flank passes "
                "through the operating pitch point."
            }
        }
    }
}
