//! The result of a population: its shares, spread, contributions and worst assemblies, each a row type with one list of columns.

use crate::column::{PeopleColumn, Row, Value, json_text, list, row_type, shown};
use crate::layout::Screen;
use gearlash::population::{
    CONFIDENCE, Contribution, Contributions, Estimate, LIMIT_SHARE, LIMIT_SIGMAS, OutcomeKind,
    PITCH_LIMIT_SIGMAS, QUANTILES, Share, SpreadStatistics,
};
use gearlash_input::tolerance::{
    ToleranceResult, Worst, phases_of_limits, sentence, without_backlash, without_worst_case,
    worst_name,
};
use gearlash_text::characters::plain;
use gearlash_text::numbers::{fixed, rounded, within};
use serde_json::json;
use std::collections::{BTreeMap, BTreeSet};

/// A length in µm, in whole tenths of a nanometre: the digits of rows.
fn um(mm: impl Into<Option<f64>>) -> Option<f64> {
    mm.into().map(|mm| rounded(1e3 * mm, 4))
}

fn ppm(share: f64) -> f64 {
    rounded(1e6 * share, 3)
}

/// The share of a population that misses a limit.
struct ShareRow {
    name: &'static str,
    /// The number of assemblies that the share refers to, where that is not all.
    assemblies: Option<u64>,
    share: Share,
}

row_type!(row: ShareRow {
    "assemblies" Plain => Value::optional(row.assemblies);
    "count" Plain => Value::optional(row.assemblies.is_none().then_some(row.share.count));
    "ppm" Plain => ppm(row.share.share);
    "low_ppm" Plain => ppm(row.share.low);
    "high_ppm" Plain => ppm(row.share.high);
});

/// A statistic of the least and of the greatest backlash.
struct SpreadRow {
    name: String,
    /// Its name in CSV.
    csv: String,
    ends: [Option<f64>; 2],
}

row_type!(row: SpreadRow {
    "" Plain [heading(shown("j_wt µm").left())] => row.name.clone();
    "" Fixed(2) [heading(shown("least"))] => Value::um(row.ends[0]);
    "" Fixed(2) [heading(shown("greatest"))] => Value::um(row.ends[1]);
});

/// The statistics of the spread.
fn spread_rows(result: &ToleranceResult) -> Vec<SpreadRow> {
    let both = [&result.statistics.least, &result.statistics.greatest];
    let mut rows = Vec::new();
    let mut add = |name: &str, csv: &str, ends| {
        let (name, csv) = (name.to_owned(), csv.to_owned());
        rows.push(SpreadRow { name, csv, ends });
    };
    add("mean", "mean", both.map(|one| one.mean));
    add("standard deviation", "sigma", both.map(|one| one.sigma));
    for (index, p) in QUANTILES.iter().enumerate() {
        let percent = format!("{} %", rounded(100.0 * p, 3));
        let ends = both.map(|one| one.quantiles[index]);
        add(&format!("{percent} below"), &percent, ends);
    }
    let drawn =
        |of: fn(&SpreadStatistics) -> Option<(f64, u64)>| both.map(|one| of(one).map(|end| end.0));
    add("least drawn", "least", drawn(|one| one.least));
    add("greatest drawn", "greatest", drawn(|one| one.greatest));
    if let Some([mean, worst, roots]) = result.about.limit_cases {
        add("at the mean", "at mean", mean);
        add("worst case", "worst case", worst);
        add("root sum of squares", "root sum of squares", roots);
    }
    rows
}

/// The contribution of a quantity to the variance of the least and of the greatest backlash: total and first order.
struct ContributionRow {
    name: &'static str,
    least: [Estimate; 2],
    greatest: Option<[Estimate; 2]>,
}

row_type!(row: ContributionRow {
    "" Plain [heading(shown("share of the variance, %").left())] => row.name;
    "" Plain [heading(shown("of the least"))] => percent(row.least[0]);
    "" Plain [heading(shown("by itself").spare(1))] => percent(row.least[1]);
    "" Plain [heading(shown("of the greatest"))] => Value::optional(row.greatest.map(|of| percent(of[0])));
    "" Plain [heading(shown("by itself").spare(1))] => Value::optional(row.greatest.map(|of| percent(of[1])));
});

/// Sentences below the table that define a share of the variance.
pub const SHARES: &str = "A share counts joint effects at each quantity that takes part, so shares can add to more than 100 %; \
     by itself leaves joint effects out. ± is the standard error: within it a small share can be negative, and one by itself the larger.";

fn percent(index: Estimate) -> String {
    within(100.0 * index.value, 100.0 * index.error)
}

fn contribution_rows(result: &ToleranceResult) -> Vec<ContributionRow> {
    let [least, greatest] = &result.contributions;
    let rows = least.each.iter().enumerate();
    let rows = rows.map(|(index, one)| ContributionRow {
        name: one.factor.name(),
        least: [one.total, one.first],
        greatest: greatest.each.get(index).map(|one| [one.total, one.first]),
    });
    rows.collect()
}

/// One of the worst assemblies.
struct WorstRow {
    index: usize,
    number: u64,
    ends: [Option<f64>; 2],
}

row_type!(row: WorstRow {
    "assembly" Plain [heading(shown("worst assemblies").left())] => row.number;
    "least_um" Fixed(2) [heading(shown("least µm"))] => um(row.ends[0]);
    "greatest_um" Fixed(2) [heading(shown("greatest µm"))] => um(row.ends[1]);
    "file" Plain => worst_name(row.index);
});

fn worst_rows(result: &ToleranceResult) -> Vec<WorstRow> {
    let row = |(index, worst): (usize, &Worst)| WorstRow {
        index,
        number: worst.number,
        ends: [worst.least_mm, worst.greatest_mm],
    };
    result.worst.iter().enumerate().map(row).collect()
}

/// A number of the result in CSV.
struct NumberRow {
    name: String,
    value: Option<f64>,
    unit: &'static str,
    interval: [Option<f64>; 2],
    error: Option<f64>,
}

impl NumberRow {
    fn new(name: impl Into<String>, value: Option<f64>, unit: &'static str) -> NumberRow {
        NumberRow {
            name: name.into(),
            value,
            unit,
            interval: [None; 2],
            error: None,
        }
    }
}

row_type!(row: NumberRow {
    "what" Plain => row.name.clone();
    "value" Plain => row.value;
    "unit" Plain => row.unit;
    "low" Plain => row.interval[0];
    "high" Plain => row.interval[1];
    "standard_error" Plain => row.error;
});

fn shares(result: &ToleranceResult) -> [ShareRow; 3] {
    let found = &result.statistics;
    let each = [
        ("below", found.below),
        ("above", found.above),
        ("outside", found.outside),
    ];
    each.map(|(name, share)| ShareRow {
        name,
        assemblies: None,
        share,
    })
}

/// The numbers as CSV, one row per number, with its interval or standard error where it has one.
pub fn csv(result: &ToleranceResult) -> String {
    let mut rows = Vec::new();
    for ShareRow { name, share, .. } in shares(result) {
        rows.push(NumberRow {
            interval: [share.low, share.high].map(|end| Some(ppm(end))),
            ..NumberRow::new(name, Some(ppm(share.share)), "ppm")
        });
    }
    let statistics = &result.statistics;
    let mut spread = spread_rows(result);
    let cases = spread.split_off(QUANTILES.len() + 4);
    let name = |end: usize| ["least", "greatest"][end];
    let number = |row: &SpreadRow, end: usize| {
        let of = format!("{} {}", name(end), row.csv);
        NumberRow::new(of, um(row.ends[end]), "um")
    };
    for end in 0..2 {
        rows.extend(spread.iter().map(|row| number(row, end)));
    }
    rows.push(NumberRow::new("cp if normal", statistics.cp, ""));
    rows.push(NumberRow::new("cpk if normal", statistics.cpk, ""));
    for row in &cases {
        rows.extend([0, 1].map(|end| number(row, end)));
    }
    for (end, found) in result.contributions.iter().enumerate() {
        for one in &found.each {
            for (order, index) in [("first-order", one.first), ("total", one.total)] {
                let of = format!(
                    "{} {order} contribution of {}",
                    name(end),
                    one.factor.name()
                );
                rows.push(NumberRow {
                    error: Some(rounded(index.error, 5)),
                    ..NumberRow::new(of, Some(rounded(index.value, 5)), "")
                });
            }
        }
    }
    NumberRow::columns().csv(&rows)
}

/// The histogram as CSV: the lower end of each bin, µm, and the number of assemblies with their least and their greatest there.
pub fn histogram_csv(result: &ToleranceResult) -> String {
    let tally = &result.tally;
    let both = [&tally.least.histogram, &tally.greatest.histogram];
    let bins: BTreeSet<i64> = both.iter().flat_map(|of| of.keys()).copied().collect();
    let mut text = "from_um,least,greatest\n".to_owned();
    for bin in bins {
        let count = |of: &BTreeMap<i64, u64>| of.get(&bin).copied().unwrap_or_default();
        let [least, greatest] = both.map(count);
        text += &format!("{},{least},{greatest}\n", bin as f64 / 100.0);
    }
    text
}

row_type!(row: Contribution {
    "quantity" Plain => row.factor.name();
    "first_order" Plain => rounded(row.first.value, 5);
    "first_order_error" Plain => rounded(row.first.error, 5);
    "total" Plain => rounded(row.total.value, 5);
    "total_error" Plain => rounded(row.total.error, 5);
});

/// The result as JSON with a line end.
pub fn json(result: &ToleranceResult) -> String {
    let (about, tally) = (&result.about, &result.tally);
    let (counts, statistics) = (&tally.counts, &result.statistics);
    let [below, above, outside] = shares(result).map(|row| row.json());
    let both = |index: usize| {
        let [least, greatest] = about.limit_cases?[index].map(um);
        Some(json!({ "least_um": least, "greatest_um": greatest }))
    };
    let course = result.convergence().into_iter().map(|point| ShareRow {
        name: "outside",
        assemblies: Some(point.assemblies),
        share: point.share,
    });
    json_text(&json!({
        "gearlash": result.version,
        "title": about.title,
        "input_sha256": result.input_sha256,
        "seed": result.seed,
        "assemblies": result.assemblies,
        "sentence": sentence(result),
        "requirement": {
            "min_um": um(about.min_mm),
            "max_um": um(about.max_mm),
            "others": about.others,
            "max_ppm": about.max_ppm,
            "met": result.is_met(),
        },
        "outcomes": {
            "clear": counts.of(OutcomeKind::Clear),
            "interference": counts.of(OutcomeKind::Interference),
            "jammed": counts.of(OutcomeKind::Jammed),
            "no_contact": counts.of(OutcomeKind::NoContact),
            "unproven": counts.of(OutcomeKind::Unproven),
            "impossible": counts.of(OutcomeKind::Impossible),
            "bracket_wide": tally.doubtful,
        },
        "confidence": CONFIDENCE,
        "below": below,
        "above": above,
        "outside": outside,
        "least": spread_json(&statistics.least),
        "greatest": spread_json(&statistics.greatest),
        "if_normal": {
            "cp": statistics.cp.map(|cp| rounded(cp, 4)),
            "cpk": statistics.cpk.map(|cpk| rounded(cpk, 4)),
        },
        "limits": {
            // "worst": each number is of its worst assembly phase; null where the phase does not scatter.
            "phase": phases_of_limits(about).map(|_| "worst"),
            "at_mean": both(0),
            "worst_case": both(1),
            "root_sum_of_squares": both(2),
            "without_end": about.unbounded,
            "cut_at_sigmas": LIMIT_SIGMAS,
            "cut_at_share": LIMIT_SHARE,
            "pitch_cut_at_sigmas": PITCH_LIMIT_SIGMAS,
        },
        "contributions": {
            "least": contributions_json(&result.contributions[0]),
            "greatest": contributions_json(&result.contributions[1]),
        },
        "worst": list(&worst_rows(result)),
        "convergence": list(&course.collect::<Vec<_>>()),
    }))
}

fn spread_json(spread: &SpreadStatistics) -> serde_json::Value {
    let quantiles = QUANTILES.iter().zip(spread.quantiles);
    let quantiles: serde_json::Map<_, _> = quantiles
        .map(|(p, mm)| (rounded(100.0 * p, 3).to_string(), json!(um(mm))))
        .collect();
    let end = |end: Option<(f64, u64)>| {
        end.map(|(mm, number)| json!({ "um": um(mm), "assembly": number }))
    };
    json!({
        "count": spread.count,
        "mean_um": um(spread.mean),
        "sigma_um": um(spread.sigma),
        "percent_um": quantiles,
        "least": end(spread.least),
        "greatest": end(spread.greatest),
    })
}

fn contributions_json(found: &Contributions) -> serde_json::Value {
    json!({ "rows": found.rows, "rows_left_out": found.unused_rows, "each": list(&found.each) })
}

/// The spread for people: quantiles, extremes and limit cases.
pub fn spread(result: &ToleranceResult) -> Vec<PeopleColumn> {
    SpreadRow::columns().in_um(&spread_rows(result))
}

/// The contributions for people; empty where none were computed.
pub fn contributions(result: &ToleranceResult) -> Vec<PeopleColumn> {
    ContributionRow::columns().in_um(&contribution_rows(result))
}

/// The worst assemblies for people.
pub fn worst(result: &ToleranceResult) -> Vec<PeopleColumn> {
    WorstRow::columns().in_um(&worst_rows(result))
}

/// Remarks on the spread, one sentence each: capability, and exclusions from its numbers.
pub fn remarks(result: &ToleranceResult) -> Vec<String> {
    let (about, statistics) = (&result.about, &result.statistics);
    let capability = [("Cp", statistics.cp), ("Cpk", statistics.cpk)];
    let capability: Vec<String> = capability
        .into_iter()
        .filter_map(|(name, value)| Some(format!("{name} {}", fixed(value?, 2))))
        .collect();
    let mut remarks = Vec::new();
    if !capability.is_empty() {
        remarks.push(format!(
            "Process capability, if normal: {} (1: 3 standard deviations to the nearer limit).",
            capability.join(", ")
        ));
    }
    remarks.extend(without_backlash(result));
    remarks.extend(phases_of_limits(about).map(str::to_owned));
    if about.limit_cases.is_some() && !about.unbounded.is_empty() {
        remarks.push(format!(
            "Worst case: every quantity at its limit. Distributions without an end are cut at stated limits, else at 3 standard deviations: {}.",
            about.unbounded.join(", ")
        ));
    }
    remarks.extend(without_worst_case(about).map(str::to_owned));
    remarks
}

/// The result for a terminal: the sentence, the spread beside worst case and root sum of squares, the contributions, the worst
/// assemblies.
pub fn text(result: &ToleranceResult, screen: &Screen) -> String {
    let mut text = screen.paragraphs(&format!("{}.", sentence(result)));
    text.push('\n');
    text += &screen.paragraphs(&format!(
        "{}: {} assemblies of seed {}, each over its whole mesh cycle.",
        plain(&result.about.title),
        result.assemblies,
        result.seed
    ));
    text.push('\n');
    text += &SpreadRow::columns().text(&spread_rows(result), screen);
    for remark in remarks(result) {
        text += &screen.fold(&format!("{remark}\n"));
    }
    let contributions = contribution_rows(result);
    if !contributions.is_empty() {
        text.push('\n');
        text += &ContributionRow::columns().text(&contributions, screen);
        text += &screen.fold(&format!("{SHARES}\n"));
    }
    text.push('\n');
    text + &WorstRow::columns().text(&worst_rows(result), screen)
}
