//! The outcome of `compare`: text, JUnit XML, GitHub annotations, Markdown.

mod markdown;

use crate::junit::{self, Case, Suite};
use crate::layout::{Screen, Tone, where_it_is};
use crate::verdict::sentence;
use crate::{ComparedPair, doubts};
use gearlash::analysis::compare::Verdict;
use gearlash::analysis::tally::RunTally;
use gearlash::analysis::verdict::Requirement;
use gearlash_files::characters::plain;
use gearlash_files::numbers::{signed_um, stated_distance, um_ascii};
use std::fmt::Write;
use std::io;

pub(crate) use markdown::escape as markdown_text;
pub use markdown::markdown;

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

/// What the runs come to.
fn outcome(pair: &ComparedPair) -> PairOutcome {
    let fails = |run: &&RunTally| !run.passes(pair.allow_off_line);
    let mut failing = pair.runs.iter().filter(fails).peekable();
    if failing.peek().is_none() {
        return PairOutcome::Agrees;
    }
    // A run that is jammed or out of mesh throughout disagrees with nothing, whatever the formula says.
    let disagrees = |run: &RunTally| run.compared > 0 && run.disagrees(pair.allow_off_line);
    if failing.clone().any(disagrees) {
        return PairOutcome::Disagrees;
    }
    match failing.any(|run| run.unproven > 0) {
        true => PairOutcome::Unproven,
        false => PairOutcome::Nothing,
    }
}

/// JUnit XML: a suite a file, the verdict its first case, then a case a run.
///
/// # Errors
/// None: it is written to memory.
pub fn junit(pairs: &[ComparedPair]) -> io::Result<String> {
    let suite = |pair: &ComparedPair| {
        let verdict = pair.verdict();
        let first = Case {
            name: sentence(&verdict),
            failure: (verdict.requirement == Requirement::NotMet).then(|| sentence(&verdict)),
        };
        let runs = pair.runs.iter().map(|run| Case {
            name: run_name(run),
            failure: failure(pair, run),
        });
        Suite {
            file: pair.file.clone(),
            title: pair.title.clone(),
            cases: std::iter::once(first).chain(runs).collect(),
            said: Vec::new(),
        }
    };
    let suites: Vec<Suite> = pairs.iter().map(suite).collect();
    junit::junit("gearlash compare", &suites)
}

/// One run's name and what is wrong with it; `None` when it passes.
fn failure(pair: &ComparedPair, run: &RunTally) -> Option<String> {
    if run.passes(pair.allow_off_line) {
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
    let [above, below, off_line] =
        [Verdict::Above, Verdict::Below, Verdict::OffLine].map(|verdict| run.count(verdict));
    let (less, alone) = (run.compared_off_line, run.simulated_alone());
    let mut failing = vec![(above, "above the formula"), (below, "below the formula")];
    // What a run without anything to compare touches is said already.
    if !pair.allow_off_line && run.compared > 0 {
        failing.extend([
            (less, "off-line contact"),
            (alone, "off-line contact where model 3 has no value"),
            (off_line - less - alone, "jammed where model 3 has a value"),
        ]);
    }
    for (count, what) in failing {
        if count > 0 {
            parts.push(format!("{count} of {} poses: {what}", run.poses));
        }
    }
    // A largest difference that agrees is not what failed.
    let worst = run.worst();
    let worst = worst.filter(|(pose, _)| pose.verdict != Verdict::Agrees);
    let worst = worst.map_or(String::new(), |(pose, difference)| {
        format!(
            "; largest difference {} µm at {} (tolerance {} + bound {} µm)",
            signed_um(difference, 4),
            where_it_is(pose),
            pair.tolerance_um,
            um_ascii(pose.simulated.error_bound.unwrap_or(0.0), 4),
        )
    });
    Some(parts.join(", ") + &worst)
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
        stated_distance(run.assembly.center_distance()),
        run.material.name()
    )
}

/// Text on `screen`: a line a run, failures explained, a verdict a file.
pub fn text(pairs: &[ComparedPair], screen: &Screen) -> String {
    let mut text = String::new();
    for pair in pairs {
        let _ = writeln!(text, "{} — {}", plain(&pair.file), plain(&pair.title));
        let _ = writeln!(text, "  {}", sentence(&pair.verdict()));
        for run in &pair.runs {
            let difference = match run.worst() {
                Some((_, difference)) => {
                    format!("simulated − model 3 up to {} µm", signed_um(difference, 4))
                }
                None => "nothing to compare".to_owned(),
            };
            let verdict = match failure(pair, run) {
                None => match trouble(run) {
                    Some(what) => format!("{} ({what})", screen.toned(Tone::Good, "ok")),
                    None => screen.toned(Tone::Good, "ok"),
                },
                Some(reason) => format!("{}  {reason}", screen.toned(Tone::Bad, "FAIL")),
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
        let _ = match outcome(pair) {
            PairOutcome::Agrees => writeln!(text, "  agree {within}"),
            PairOutcome::Disagrees => writeln!(
                text,
                "  {}: no agreement {within}",
                screen.toned(Tone::Bad, "FAILED")
            ),
            PairOutcome::Unproven => writeln!(
                text,
                "  {} at some poses: agreement {within} not shown",
                screen.toned(Tone::Doubtful, "UNPROVEN")
            ),
            PairOutcome::Nothing => writeln!(text, "  NOTHING TO COMPARE at some centre distance"),
        };
    }
    screen.fold(&text)
}

/// GitHub workflow commands: an error a failing run, a notice a passing file.
pub fn github(pairs: &[ComparedPair]) -> String {
    let mut text = String::new();
    for pair in pairs {
        for run in &pair.runs {
            if let Some(reason) = failure(pair, run) {
                let _ = writeln!(
                    text,
                    "::error file={},title={}::{}",
                    escape_property(&pair.file),
                    escape_property(&format!("gearlash compare: {}", run_name(run))),
                    escape(&reason)
                );
            }
        }
        let verdict = pair.verdict();
        if verdict.requirement == Requirement::NotMet {
            let _ = writeln!(
                text,
                "::error file={},title=gearlash compare: requirement::{}",
                escape_property(&pair.file),
                escape(&sentence(&verdict))
            );
        }
        if pair.passes() {
            let _ = writeln!(
                text,
                "::notice file={},title=gearlash compare::{} Simulated and analytic backlash agree within {} µm + error bound",
                escape_property(&pair.file),
                escape(&sentence(&verdict)),
                pair.tolerance_um
            );
        }
    }
    text
}

/// Escapes as GitHub's workflow commands ask for: `%` in data, `:` and `,` too in properties. Line ends are gone by then.
pub(crate) fn escape(text: &str) -> String {
    plain(text).replace('%', "%25")
}

pub(crate) fn escape_property(text: &str) -> String {
    escape(text).replace(':', "%3A").replace(',', "%2C")
}
