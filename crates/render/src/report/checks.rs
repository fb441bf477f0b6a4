//! Every check with its margin.

use super::marks::mark;
use super::page::Page;
use super::phrases::{j_wt, plain, study};
use gearlash::analysis::diagnosis::{Check, Group, Verdict};
use gearlash::pair::Member;
use gearlash_files::numbers::{fixed, stated_distance};
use gearlash_results::text::check::{doubts, governing, outlines, unit};
use maud::{Markup, html};

pub(super) fn section(page: &Page) -> Markup {
    let diagnosis = &page.report.analysis.diagnosis;
    let several = diagnosis.groups.len() > 1;
    let asked = page.report.analysis.runs.iter();
    let poses: usize = asked.map(|run| run.poses.len()).sum();
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
            div.scroll tabindex="0" role="region" aria-label="Checks" {
                table {
                    thead { tr {
                        th scope="col" { "verdict" }
                        th scope="col" { "check" }
                        th scope="col" { "gear" }
                        @if several { th.n scope="col" { i { "a" } " mm" } th scope="col" { "material" } }
                        th.n scope="col" { "formula" }
                        th.n scope="col" { "outlines" }
                        th.n scope="col" { "limit" }
                        th.n scope="col" { "margin" }
                        th scope="col" { "unit" }
                    } }
                    tbody { @for (group, check) in governing(diagnosis) { (row(several, group, check)) } }
                }
            }
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

/// A note with true minus signs and the symbol of backlash.
fn remark(note: &str) -> Markup {
    let mut words = String::new();
    for word in note.split_inclusive(' ') {
        match word.strip_prefix('-') {
            Some(number) if number.starts_with(|c: char| c.is_ascii_digit()) => {
                words.push('−');
                words.push_str(number);
            }
            _ => words.push_str(word),
        }
    }
    let mut parts = words.split("j_wt");
    html! {
        (parts.next().unwrap_or_default())
        @for part in parts { (j_wt()) (part) }
    }
}

fn row(several: bool, group: &Group, check: &Check) -> Markup {
    html! {
        tr {
            td.w { (mark(check.verdict)) }
            th.text scope="row" {
                (check.title)
                @if !check.note.is_empty() { div.remark { (remark(&check.note)) } }
            }
            td { (check.gear.map_or("", Member::name)) }
            @if several {
                td.n { (stated_distance(group.assembly.center_distance())) }
                td.w { (group.material.words()) }
            }
            td.n { (fixed(check.formula, 4)) }
            td.n { (outlines(check, |number| fixed(number, 4))) }
            td.n { (fixed(check.limit, 4)) }
            td.n { (fixed(check.margin, 4)) }
            td { (unit(check.unit)) }
        }
    }
}
