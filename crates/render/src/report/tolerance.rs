//! The page of a population of pairs.

use super::figures::{collapsed, figure};
use super::gears;
use super::page::PageFrame;
use super::phrases::{j_wt, limits, plain, with_symbols};
use super::table::{Table, cells, columns, mark};
use crate::chart::population::Pictures;
use gearlash::analysis::diagnosis::CheckVerdict;
use gearlash::population::{
    CONFIDENCE, JACKKNIFE_GROUPS, LIMIT_SIGMAS, OutcomeKind, PITCH_LIMIT_SIGMAS,
};
use gearlash_input::tolerance::{ToleranceFile, ToleranceResult, sentence, without_worst_case};
use gearlash_results::population;
use gearlash_text::numbers::shortest;
use maud::{Markup, Render, html};

/// Input of a page of a population.
#[derive(Debug, Clone, Copy)]
pub struct ToleranceReport<'a> {
    /// The pair file.
    pub file: &'a ToleranceFile,
    /// The run.
    pub result: &'a ToleranceResult,
    /// Its pictures.
    pub pictures: &'a Pictures,
    /// Day of the page, as printed.
    pub date: &'a str,
}

/// The page of `report`, in UTF-8.
pub fn tolerance_report(report: &ToleranceReport) -> String {
    let sections = [
        ("result", "Result"),
        ("input", "Input"),
        ("spread", "Spread"),
        ("contributions", "Contributions"),
        ("worst", "Worst assemblies"),
        ("method", "Method"),
    ];
    let about = &report.result.about;
    let main = html! {
        (result(report))
        (input(report))
        (spread(report.result))
        (contributions(report))
        (worst(report.result))
        (method(report.result))
    };
    let page_frame = PageFrame {
        title: &about.title,
        file: &about.title,
        date: report.date,
        sections: &sections,
        same: "The same pair file, seed and version give the same numbers, on any number of machines.",
    };
    page_frame.page(&main)
}

fn result(report: &ToleranceReport) -> Markup {
    let result = report.result;
    let state = match result.is_met() {
        Some(false) => CheckVerdict::Fail,
        _ => CheckVerdict::Pass,
    };
    let answer = format!("{}.", sentence(result));
    html! {
        section id="result" {
            @if result.is_met().is_some() {
                div.verdict.(state.name()) {
                    p.state { (mark(state)) }
                    p.answer { (with_symbols(&answer)) }
                }
            } @else {
                p.answer { strong { (with_symbols(&answer)) } }
            }
            p {
                (result.assemblies) " assemblies of seed " (result.seed)
                ", each over its whole mesh cycle and every rotation. In brackets the interval that holds the share of the whole population with "
                (shortest(100.0 * CONFIDENCE)) " %."
            }
            @if let Some(chart) = &report.pictures.histogram { (figure(chart)) }
            (figure(&report.pictures.convergence))
        }
    }
}

/// The gears, their assembly, the scatter and the requirement.
fn input(report: &ToleranceReport) -> Markup {
    let pair = &report.file.pair;
    // Specs are plain data, which JSON can always hold.
    let assembly = serde_json::to_value(&pair.spec.assembly).unwrap_or_default();
    let scatters = serde_json::to_value(&report.file.tolerance).unwrap_or_default();
    let share = report.result.about.max_ppm;
    let share = share.map(|ppm| format!("at most {} ppm outside", shortest(ppm)));
    let mut required = limits(&pair.study.requirements);
    required.extend(share);
    let required = required.join(", ");
    html! {
        section id="input" {
            h2 { "Input" }
            (gears::table(pair))
            (stated_table("Assembly", &assembly))
            (stated_table("What scatters, [tolerance]", &scatters))
            p {
                "Required: "
                @if required.is_empty() { "nothing beyond that the gears assemble." } @else { (with_symbols(&required)) "." }
            }
        }
    }
}

fn stated_table(caption: &str, table: &serde_json::Value) -> Markup {
    let mut rows = Vec::new();
    statements("", table, &mut rows);
    let columns = columns(" | ");
    let rows = rows.iter();
    let rows = rows.map(|(name, value)| cells![plain(name), plain(value)]);
    Table::new(caption, html! { (caption) }, columns, rows).render()
}

/// The statements of a table of the pair file, one row per inner table: its key and its values in a line.
fn statements(key: &str, table: &serde_json::Value, rows: &mut Vec<(String, String)>) {
    let Some(table) = table.as_object() else {
        return;
    };
    let mut values = Vec::new();
    for (name, value) in table {
        match value {
            serde_json::Value::Null | serde_json::Value::Object(_) => {}
            serde_json::Value::Array(list) if list.len() > 8 => {
                values.push(format!("{name} {} values", list.len()));
            }
            serde_json::Value::Array(list) => {
                let list: Vec<String> = list.iter().map(ToString::to_string).collect();
                values.push(format!("{name} {}", list.join(", ")));
            }
            serde_json::Value::String(text) => values.push(format!("{name} {text}")),
            other => values.push(format!("{name} {other}")),
        }
    }
    match key {
        // Each key at the top has a row.
        "" => rows.extend(values.iter().filter_map(|value| {
            let (name, value) = value.split_once(' ')?;
            Some((name.to_owned(), value.to_owned()))
        })),
        _ if values.is_empty() => {}
        _ => rows.push((key.to_owned(), values.join(", "))),
    }
    for (name, value) in table {
        let key = match key {
            "" => name.clone(),
            key => format!("{key}.{name}"),
        };
        statements(&key, value, rows);
    }
}

fn spread(result: &ToleranceResult) -> Markup {
    let caption = html! { "Circumferential backlash " (j_wt()) " over the mesh cycle, µm" };
    html! {
        section id="spread" {
            h2 { "Spread" }
            (Table::of_shown("Spread", caption, &population::spread(result)))
            @for remark in population::remarks(result) { p { (plain(&remark)) } }
        }
    }
}

fn contributions(report: &ToleranceReport) -> Markup {
    let [least, greatest] = &report.result.contributions;
    let caption = html! {
        "Share of the variance, %, with standard errors, of " (least.rows) " rows"
        @for (found, end) in [(least, "least"), (greatest, "greatest")] {
            @if found.unused_rows > 0 { "; " (found.unused_rows) " rows without a " (end) " backlash are left out" }
        }
    };
    let shown = population::contributions(report.result);
    html! {
        section id="contributions" {
            h2 { "Contributions" }
            @match &report.pictures.contributions {
                Some(chart) => (figure(chart)),
                None => p { "None were found: too few rows of the samples, or nothing varies." },
            }
            @if !shown.is_empty() { (Table::of_shown("Contributions", caption, &shown)) p { (population::SHARES) } }
        }
    }
}

fn worst(result: &ToleranceResult) -> Markup {
    html! {
        section id="worst" {
            h2 { "Worst assemblies" }
            p { "Each is a pair file beside this page, worst_01.toml and on: gearlash simulate finds the same." }
            (Table::of_shown("Worst assemblies", html! {}, &population::worst(result)))
        }
    }
}

fn method(result: &ToleranceResult) -> Markup {
    let about = &result.about;
    let counts = &result.tally.counts;
    html! {
        section id="method" {
            h2 { "Method" }
            (collapsed("How the shares and the spread are found", "how the shares and the spread are found", html! {
            p {
                "Each assembly is drawn by the seed and its number alone. Its least and greatest backlash are proven over every mating and rotation. "
                (counts.of(OutcomeKind::Clear)) " assemblies are clear, " (counts.of(OutcomeKind::Interference)) " interfere, " (counts.of(OutcomeKind::Jammed)) " are jammed, "
                (counts.of(OutcomeKind::NoContact)) " out of mesh, " (counts.of(OutcomeKind::Unproven)) " without a result; " (counts.of(OutcomeKind::Impossible))
                " draws are of no gear. None is left out of the shares."
            }
            p { "Intervals of shares: Clopper and Pearson. Quantiles: to 0.01 µm. Capability: what it says of shares holds of normal populations." }
            @if about.limit_cases.is_some() {
                p {
                    "Worst case: every scatter at its limit. Without an end, and so cut at "
                    (shortest(LIMIT_SIGMAS)) " standard deviations or at stated limits: "
                    (if about.unbounded.is_empty() { "none".to_owned() } else { plain(&about.unbounded.join(", ")) })
                    ". Pitch: flanks in contact " (shortest(PITCH_LIMIT_SIGMAS))
                    " standard deviations of their cumulative deviation out. Root sum of squares: of what each changes alone."
                }
            } @else if let Some(why) = without_worst_case(about) {
                p { (why) }
            }
            p {
                "Contributions: Sobol’ indices by the estimators of Saltelli et al. (2010), standard errors by the jackknife over "
                (JACKKNIFE_GROUPS) " groups of rows."
            }
            }))
        }
    }
}
