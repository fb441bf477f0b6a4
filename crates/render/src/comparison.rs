//! The outcome of `compare`: text, JSON, JUnit XML, GitHub annotations, Markdown.

mod junit;
mod markdown;

use super::table::where_it_is;
use super::unproven::doubts;
use gearlash::compare::{ComparedPose, Verdict};
use gearlash::tally::RunTally;
use gearlash_files::characters::{self, plain};
use gearlash_files::numbers::{distance, signed_um, um_ascii};
use gearlash_files::results::{MatingRecord, UnprovenRecord, mating_record, unproven_record};
use serde::Serialize;
use std::fmt::Write;

pub use junit::junit;
pub use markdown::markdown;

/// One compared pair file.
#[derive(Debug)]
pub struct ComparedPair {
    /// The file as named on the command line.
    pub file: String,
    /// Its title.
    pub title: String,
    /// Tolerance in force, µm.
    pub tolerance_um: f64,
    /// Whether off-line contact passes.
    pub allow_off_line: bool,
    /// Every run.
    pub runs: Vec<RunTally>,
}

/// What a pair file comes to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum PairOutcome {
    /// Every run passes.
    Agrees,
    /// Some run disagrees.
    Disagrees,
    /// None disagrees, but some poses are not proven: nobody knows about them.
    Unproven,
    /// None disagrees, but in some there was nothing to compare: that is no agreement.
    Nothing,
}

impl ComparedPair {
    /// Whether every run passes.
    pub fn passes(&self) -> bool {
        self.runs.iter().all(|run| run.passes(self.allow_off_line))
    }

    /// What the runs come to.
    fn outcome(&self) -> PairOutcome {
        let fails = |run: &&RunTally| !run.passes(self.allow_off_line);
        let mut failing = self.runs.iter().filter(fails).peekable();
        if failing.peek().is_none() {
            return PairOutcome::Agrees;
        }
        // A run that is jammed or out of mesh throughout disagrees with nothing, whatever the formula says.
        let disagrees = |run: &RunTally| run.compared > 0 && run.disagrees(self.allow_off_line);
        if failing.clone().any(disagrees) {
            return PairOutcome::Disagrees;
        }
        match failing.any(|run| run.unproven > 0) {
            true => PairOutcome::Unproven,
            false => PairOutcome::Nothing,
        }
    }

    /// One run's name and what is wrong with it; `None` when it passes.
    fn failure(&self, run: &RunTally) -> Option<String> {
        if run.passes(self.allow_off_line) {
            return None;
        }
        let mut parts = Vec::new();
        let unproven = run.unproven;
        if let Some(first) = run.first_unproven.first() {
            parts.push(format!(
                "{unproven} of {} poses: unproven, first {}: {}",
                run.poses,
                where_it_is(first),
                doubts(first)
            ));
        }
        if run.compared == 0 && unproven < run.poses {
            parts.push(format!("nothing to compare: {}", without_value(run)));
        }
        for verdict in [Verdict::Above, Verdict::Below, Verdict::OffLine] {
            let count = run.count(verdict);
            // What a run without anything to compare touches is said already.
            let counts = !(self.allow_off_line || run.compared == 0);
            if count > 0 && (verdict != Verdict::OffLine || counts) {
                parts.push(format!(
                    "{count} of {} poses: {}",
                    run.poses,
                    verdict.name()
                ));
            }
        }
        let worst = run.worst().map_or(String::new(), |(pose, difference)| {
            format!(
                "; largest difference {} µm at {} (tolerance {} + bound {} µm)",
                signed_um(difference, 4),
                where_it_is(pose),
                self.tolerance_um,
                um_ascii(pose.swept.error_bound.unwrap_or(0.0), 4),
            )
        });
        Some(parts.join(", ") + &worst)
    }
}

/// Why poses have no backlash, or no formula to set beside it.
fn without_value(run: &RunTally) -> String {
    let parts = [
        (run.jammed, "jammed"),
        (run.apart, "out of mesh"),
        (run.count(Verdict::Unproven), "unproven"),
    ];
    at_poses(run, &parts).unwrap_or_else(|| "model 3 has no value at any pose".to_owned())
}

/// How many poses have negative backlash or none at all, in words; nothing where none.
fn trouble(run: &RunTally) -> Option<String> {
    let parts = [
        (run.interfering, "interference"),
        (run.jammed, "jammed"),
        (run.apart, "out of mesh"),
        (run.count(Verdict::Unproven), "unproven"),
    ];
    at_poses(run, &parts)
}

fn at_poses(run: &RunTally, parts: &[(usize, &str)]) -> Option<String> {
    let parts = parts.iter().filter(|(poses, _)| *poses > 0);
    let parts: Vec<String> = parts
        .map(|(poses, what)| format!("{what} at {poses} of {} poses", run.poses))
        .collect();
    (!parts.is_empty()).then(|| parts.join(", "))
}

fn run_name(run: &RunTally) -> String {
    format!(
        "a = {} mm, {}",
        distance(run.assembly.center_distance()),
        run.material.name()
    )
}

/// Plain text: a line a run, failures explained, a verdict a file.
pub fn text(pairs: &[ComparedPair]) -> String {
    let mut text = String::new();
    for pair in pairs {
        let _ = writeln!(text, "{} — {}", plain(&pair.file), plain(&pair.title));
        for run in &pair.runs {
            let difference = match run.worst() {
                Some((_, difference)) => {
                    format!("simulated − model 3 up to {} µm", signed_um(difference, 4))
                }
                None => "nothing to compare".to_owned(),
            };
            let verdict = match pair.failure(run) {
                None => match trouble(run) {
                    Some(what) => format!("ok ({what})"),
                    None => "ok".to_owned(),
                },
                Some(reason) => format!("FAIL  {reason}"),
            };
            let _ = writeln!(
                text,
                "  {}: {} poses, {difference}  {verdict}",
                run_name(run),
                run.poses
            );
            let off = run.count(Verdict::OffLine);
            if off > 0 && pair.allow_off_line {
                let _ = writeln!(
                    text,
                    "    {off} poses touch off the line of action (allowed by the pair file)"
                );
            }
        }
        let within = format!("within {} µm + error bound", pair.tolerance_um);
        let _ = match pair.outcome() {
            PairOutcome::Agrees => writeln!(text, "  agree {within}"),
            PairOutcome::Disagrees => writeln!(text, "  DISAGREE {within}"),
            PairOutcome::Unproven => {
                writeln!(text, "  UNPROVEN at some poses: no agreement {within}")
            }
            PairOutcome::Nothing => writeln!(text, "  NOTHING TO COMPARE at some centre distance"),
        };
    }
    text
}

#[derive(Serialize)]
struct JsonReport<'a> {
    gearlash: &'static str,
    passed: bool,
    pairs: Vec<JsonPair<'a>>,
}

#[derive(Serialize)]
struct JsonPair<'a> {
    file: &'a str,
    title: &'a str,
    tolerance_um: f64,
    allow_off_line_contact: bool,
    passed: bool,
    runs: Vec<JsonRun>,
}

#[derive(Serialize)]
struct JsonRun {
    center_distance_mm: f64,
    material: &'static str,
    poses: usize,
    compared: usize,
    passed: bool,
    off_line: usize,
    below: usize,
    above: usize,
    max_deviation_um: JsonDeviation,
    worst: Option<JsonWorst>,
    /// Poses that are not proven, none of which is compared.
    unproven: usize,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    unproven_poses: Vec<JsonUnproven>,
}

#[derive(Serialize)]
struct JsonUnproven {
    mating: MatingRecord,
    /// None where the pose itself is proven, and an end of the bearing clearance is not.
    #[serde(skip_serializing_if = "Option::is_none")]
    unproven: Option<UnprovenRecord>,
    /// All that is in doubt, in words.
    reason: String,
}

#[derive(Serialize)]
struct JsonDeviation {
    involute: Option<f64>,
    line_of_action: Option<f64>,
}

#[derive(Serialize)]
struct JsonWorst {
    wheel_tooth: u32,
    pinion_tooth: u32,
    flank: &'static str,
    fraction: f64,
    difference_um: f64,
    error_bound_um: Option<f64>,
}

/// The same as JSON.
pub fn json(pairs: &[ComparedPair]) -> Result<String, serde_json::Error> {
    let report = JsonReport {
        gearlash: env!("CARGO_PKG_VERSION"),
        passed: pairs.iter().all(ComparedPair::passes),
        pairs: pairs.iter().map(json_pair).collect(),
    };
    Ok(characters::json(serde_json::to_string_pretty(&report)?) + "\n")
}

fn json_pair(pair: &ComparedPair) -> JsonPair<'_> {
    let run = |run: &RunTally| {
        let summary = run.summary();
        JsonRun {
            center_distance_mm: run.assembly.center_distance(),
            material: run.material.name(),
            poses: run.poses,
            compared: run.compared,
            passed: run.passes(pair.allow_off_line),
            off_line: run.count(Verdict::OffLine),
            below: run.count(Verdict::Below),
            above: run.count(Verdict::Above),
            max_deviation_um: JsonDeviation {
                involute: summary.off_involute.map(|length| length * 1e3),
                line_of_action: summary.off_line_of_action.map(|length| length * 1e3),
            },
            unproven: run.count(Verdict::Unproven),
            unproven_poses: run.first_unproven.iter().map(json_unproven).collect(),
            worst: run.worst().map(|(pose, difference)| {
                let mating = pose.swept.pose.mating();
                JsonWorst {
                    wheel_tooth: mating.wheel_tooth,
                    pinion_tooth: mating.pinion_tooth,
                    flank: mating.flank.name(),
                    fraction: mating.fraction,
                    difference_um: difference * 1e3,
                    error_bound_um: pose.swept.error_bound.map(|length| length * 1e3),
                }
            }),
        }
    };
    JsonPair {
        file: &pair.file,
        title: &pair.title,
        tolerance_um: pair.tolerance_um,
        allow_off_line_contact: pair.allow_off_line,
        passed: pair.passes(),
        runs: pair.runs.iter().map(run).collect(),
    }
}

fn json_unproven(pose: &ComparedPose) -> JsonUnproven {
    JsonUnproven {
        mating: mating_record(pose.swept.pose.mating()),
        unproven: pose.swept.found.as_ref().err().map(unproven_record),
        reason: doubts(pose),
    }
}

/// GitHub workflow commands: an error a failing run, a notice a passing file.
pub fn github(pairs: &[ComparedPair]) -> String {
    let mut text = String::new();
    for pair in pairs {
        for run in &pair.runs {
            if let Some(reason) = pair.failure(run) {
                let _ = writeln!(
                    text,
                    "::error file={},title={}::{}",
                    escape_property(&pair.file),
                    escape_property(&format!("gearlash compare: {}", run_name(run))),
                    escape(&reason)
                );
            }
        }
        if pair.passes() {
            let _ = writeln!(
                text,
                "::notice file={},title=gearlash compare::simulated and analytic backlash agree within {} µm + error bound",
                escape_property(&pair.file),
                pair.tolerance_um
            );
        }
    }
    text
}

/// Escapes as GitHub's workflow commands ask for: `%` in data, `:` and `,` too in properties. Line ends are gone by then.
fn escape(text: &str) -> String {
    plain(text).replace('%', "%25")
}

fn escape_property(text: &str) -> String {
    escape(text).replace(':', "%3A").replace(',', "%2C")
}
