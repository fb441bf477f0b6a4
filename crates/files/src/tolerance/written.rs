//! The result of a run as JSON and CSV.

use super::result::ToleranceResult;
use super::sentence::{phases_of_limits, sentence};
use super::worst::worst_name;
use crate::characters::csv_text;
use crate::numbers::rounded;
use gearlash::population::{
    CONFIDENCE, Contributions, LIMIT_SHARE, LIMIT_SIGMAS, PITCH_LIMIT_SIGMAS, QUANTILES, Share,
    SpreadStatistics,
};
use serde_json::{Map, Value, json};

/// Whole tenths of a nanometre as they came: no more digits than those.
fn um(mm: impl Into<Option<f64>>) -> Option<f64> {
    mm.into().map(|mm| rounded(1e3 * mm, 4))
}

fn ppm(share: f64) -> f64 {
    rounded(1e6 * share, 3)
}

impl ToleranceResult {
    /// The result, which ends in a line end.
    pub fn to_json(&self) -> String {
        let (about, tally) = (&self.about, &self.tally);
        let statistics = &self.statistics;
        let share = |share: &Share| {
            json!({
                "count": share.count,
                "ppm": ppm(share.share),
                "low_ppm": ppm(share.low),
                "high_ppm": ppm(share.high),
            })
        };
        let counts = &tally.counts;
        let both = |index: usize| {
            about.limit_cases.map(|cases| {
                json!({ "least_um": um(cases[index][0]), "greatest_um": um(cases[index][1]) })
            })
        };
        let worst = self.worst.iter().enumerate().map(|(index, worst)| {
            json!({
                "assembly": worst.number,
                "least_um": um(worst.least_mm),
                "greatest_um": um(worst.greatest_mm),
                "file": worst_name(index),
            })
        });
        let course = self.convergence();
        let course = course.iter().map(|point| {
            json!({
                "assemblies": point.assemblies,
                "ppm": ppm(point.share.share),
                "low_ppm": ppm(point.share.low),
                "high_ppm": ppm(point.share.high),
            })
        });
        let result = json!({
            "gearlash": self.version,
            "title": about.title,
            "input_sha256": self.input_sha256,
            "seed": self.seed,
            "assemblies": self.assemblies,
            "sentence": sentence(self),
            "requirement": {
                "min_um": um(about.min_mm),
                "max_um": um(about.max_mm),
                "others": about.others,
                "max_ppm": about.max_ppm,
                "met": self.is_met(),
            },
            "outcomes": {
                "clear": counts.clear,
                "interference": counts.interference,
                "jammed": counts.jammed,
                "no_contact": counts.no_contact,
                "unproven": counts.unproven,
                "impossible": counts.impossible,
                "bracket_wide": tally.doubtful,
            },
            "confidence": CONFIDENCE,
            "below": share(&statistics.below),
            "above": share(&statistics.above),
            "outside": share(&statistics.outside),
            "least": spread(&statistics.least),
            "greatest": spread(&statistics.greatest),
            "if_normal": {
                "cp": statistics.cp.map(|cp| rounded(cp, 4)),
                "cpk": statistics.cpk.map(|cpk| rounded(cpk, 4)),
            },
            "limits": {
                // "worst": each number is of the assembly phase where it is the worst; null where the phase does not scatter.
                "phase": phases_of_limits(about).map(|_| "worst"),
                "at_mean": both(0),
                "worst_case": both(1),
                "root_sum_of_squares": both(2),
                "without_end": about.without_end,
                "cut_at_sigmas": LIMIT_SIGMAS,
                "cut_at_share": LIMIT_SHARE,
                "pitch_cut_at_sigmas": PITCH_LIMIT_SIGMAS,
            },
            "contributions": {
                "least": contributions(&self.contributions[0]),
                "greatest": contributions(&self.contributions[1]),
            },
            "worst": worst.collect::<Vec<_>>(),
            "convergence": course.collect::<Vec<_>>(),
        });
        // Such values never fail.
        serde_json::to_string_pretty(&result).unwrap_or_default() + "\n"
    }

    /// The numbers in a table: a row a number, with its interval or standard error where it has one.
    ///
    /// # Errors
    /// None of a table in memory.
    pub fn to_csv(&self) -> csv::Result<String> {
        let mut rows = Rows(Vec::new());
        let statistics = &self.statistics;
        for (name, share) in [
            ("below", &statistics.below),
            ("above", &statistics.above),
            ("outside", &statistics.outside),
        ] {
            let ends = [share.low, share.high].map(|end| Some(ppm(end)));
            rows.add(name, Some(ppm(share.share)), "ppm", ends, None);
        }
        for (name, spread) in [
            ("least", &statistics.least),
            ("greatest", &statistics.greatest),
        ] {
            let mut one = |what: &str, mm: Option<f64>| {
                rows.add(&format!("{name} {what}"), um(mm), "um", [None; 2], None);
            };
            one("mean", spread.mean);
            one("sigma", spread.sigma);
            for (p, quantile) in QUANTILES.iter().zip(spread.quantiles) {
                one(&format!("{} %", rounded(100.0 * p, 3)), quantile);
            }
            one("least", spread.least.map(|(mm, _)| mm));
            one("greatest", spread.greatest.map(|(mm, _)| mm));
        }
        rows.add("cp if normal", statistics.cp, "", [None; 2], None);
        rows.add("cpk if normal", statistics.cpk, "", [None; 2], None);
        if let Some(cases) = self.about.limit_cases {
            for (case, name) in cases
                .iter()
                .zip(["at mean", "worst case", "root sum of squares"])
            {
                for (mm, end) in case.iter().zip(["least", "greatest"]) {
                    rows.add(&format!("{end} {name}"), um(*mm), "um", [None; 2], None);
                }
            }
        }
        for (found, end) in self.contributions.iter().zip(["least", "greatest"]) {
            for one in &found.each {
                for (order, index) in [("first-order", one.first), ("total", one.total)] {
                    let name = format!("{end} {order} contribution of {}", one.factor.name());
                    let value = Some(rounded(index.value, 5));
                    rows.add(&name, value, "", [None; 2], Some(rounded(index.error, 5)));
                }
            }
        }
        rows.written()
    }
}

struct Rows(Vec<[String; 6]>);

impl Rows {
    fn add(
        &mut self,
        name: &str,
        value: Option<f64>,
        unit: &str,
        ends: [Option<f64>; 2],
        error: Option<f64>,
    ) {
        let text = |number: Option<f64>| number.map_or(String::new(), |number| number.to_string());
        let [low, high] = ends.map(text);
        self.0.push([
            name.to_owned(),
            text(value),
            unit.to_owned(),
            low,
            high,
            text(error),
        ]);
    }

    fn written(self) -> csv::Result<String> {
        let mut writer = csv::Writer::from_writer(Vec::new());
        writer.write_record(["what", "value", "unit", "low", "high", "standard_error"])?;
        for row in self.0 {
            writer.write_record(row)?;
        }
        csv_text(writer)
    }
}

/// The histogram: lower end of each bin, µm, and how many have their least and their greatest there.
pub fn histogram_csv(result: &ToleranceResult) -> String {
    let tally = &result.tally;
    let mut text = "from_um,least,greatest\n".to_owned();
    let (least, greatest) = (&tally.least.histogram, &tally.greatest.histogram);
    let bins: std::collections::BTreeSet<i64> =
        least.keys().chain(greatest.keys()).copied().collect();
    for bin in bins {
        let of = |histogram: &std::collections::BTreeMap<i64, u64>| {
            histogram.get(&bin).copied().unwrap_or_default()
        };
        text += &format!("{},{},{}\n", bin as f64 / 100.0, of(least), of(greatest));
    }
    text
}

fn spread(spread: &SpreadStatistics) -> Value {
    let quantiles = QUANTILES.iter().zip(spread.quantiles);
    let quantiles: Map<String, Value> = quantiles
        .map(|(p, mm)| (format!("{}", rounded(100.0 * p, 3)), json!(um(mm))))
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

fn contributions(found: &Contributions) -> Value {
    let each = found.each.iter().map(|one| {
        json!({
            "quantity": one.factor.name(),
            "first_order": rounded(one.first.value, 5),
            "first_order_error": rounded(one.first.error, 5),
            "total": rounded(one.total.value, 5),
            "total_error": rounded(one.total.error, 5),
        })
    });
    json!({
        "rows": found.rows,
        "rows_left_out": found.left_out,
        "each": each.collect::<Vec<_>>(),
    })
}
