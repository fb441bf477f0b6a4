//! The outcome of `compare` for a pair: whether the simulation agrees with the formulas.

use crate::column::{Row, Value, list, row_type, shown};
use crate::judged::{Case, Judgement, VERDICT, escape_markdown, mark};
use crate::layout::{Screen, Tone, pose_label};
use crate::pose::pose_doubts;
use crate::run::{extremes, extremes_at, verdict_record};
use crate::verdict::{lines, message};
use gearlash::analysis::compare::{ComparedPose, PoseVerdict, Summary};
use gearlash::analysis::diagnosis::{CheckName, CheckVerdict};
use gearlash::analysis::extremes::RunExtremes;
use gearlash::analysis::tally::RunTally;
use gearlash::analysis::verdict::{RequirementOutcome, Verdict};
use gearlash::pair::Mating;
use gearlash_input::PairFile;
use gearlash_text::characters::plain;
use gearlash_text::numbers::{NONE, power, signed_um, stated_distance, um_ascii};
use serde_json::json;
use std::fmt::Write;

/// One compared pair file.
#[derive(Debug)]
pub struct ComparedPair<'a> {
    /// The file as named on the command line.
    pub name: String,
    /// The file as read.
    pub file: &'a PairFile,
    /// Tolerance, µm.
    pub tolerance_um: f64,
    /// Whether all poses are proven, and both methods agree where both are requested.
    pub is_proven: bool,
    /// Every run.
    pub runs: Vec<RunTally>,
    /// Extremes of the whole mesh cycle.
    pub extremes: Vec<RunExtremes>,
    /// The checks that fail.
    pub failed_checks: Vec<CheckName>,
}

/// The result of comparing simulation and formulas.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Agreement {
    /// Every run passes.
    Agrees,
    /// Some run disagrees.
    Disagrees,
    /// No run disagrees, but some poses are not proven.
    Unproven,
    /// No run disagrees, but some have nothing to compare.
    Nothing,
}

impl ComparedPair<'_> {
    fn allows_off_line(&self) -> bool {
        self.file.study.allow_off_line_contact
    }

    fn agreement(&self) -> Agreement {
        let fails = |run: &&RunTally| !run.passes(self.allows_off_line());
        let mut failing = self.runs.iter().filter(fails).peekable();
        if failing.peek().is_none() {
            return Agreement::Agrees;
        }
        // A run that is jammed or out of mesh throughout does not disagree.
        let disagrees = |run: &RunTally| run.compared > 0 && run.disagrees(self.allows_off_line());
        if failing.clone().any(disagrees) {
            return Agreement::Disagrees;
        }
        if failing.any(|run| run.unproven > 0) {
            Agreement::Unproven
        } else {
            Agreement::Nothing
        }
    }

    /// Whether simulation and formulas agree, in one line.
    fn first_line(&self) -> String {
        let within = format!("{} µm + error bound", self.tolerance_um);
        match self.agreement() {
            Agreement::Agrees => {
                let off = |run: &RunTally| run.count(PoseVerdict::OffLine);
                let off: usize = self.runs.iter().map(off).sum();
                let exception = match off {
                    0 => String::new(),
                    off => format!(", except at {off} poses that touch off the line of action"),
                };
                format!("Simulated and analytic backlash agree within {within}{exception}.")
            }
            Agreement::Disagrees => {
                format!("Simulated and analytic backlash do not agree within {within}.")
            }
            Agreement::Unproven => {
                format!("Simulated and analytic backlash: agreement within {within} not proven.")
            }
            Agreement::Nothing => "Nothing to compare at some centre distance.".to_owned(),
        }
    }

    /// The outcome; its text is for `screen`.
    pub fn judged(&self, screen: &Screen) -> Judgement {
        let study = &self.file.study;
        let verdict = Verdict::of_study(study, &self.extremes, self.failed_checks.clone());
        let lines = lines(&verdict);
        let agrees = self.agreement() == Agreement::Agrees && self.is_proven;
        let kept = verdict.requirement.is_kept();
        let failures = self.runs.iter();
        let failures =
            failures.filter_map(|run| Some(format!("\n{}: {}", run_name(run), self.failure(run)?)));
        let formulas = self.first_line() + &failures.collect::<String>();
        let outcome = |passes: bool, unproven: bool| match (passes, unproven) {
            (true, _) => CheckVerdict::Pass,
            (false, true) => CheckVerdict::Unproven,
            (false, false) => CheckVerdict::Fail,
        };
        let kept_unproven = verdict.requirement == RequirementOutcome::NotProven;
        let is_unproven = matches!(self.agreement(), Agreement::Unproven | Agreement::Agrees);
        Judgement {
            file: self.name.clone(),
            title: study.title.clone(),
            passes: agrees && kept,
            cases: vec![
                Case::new("formulas", outcome(agrees, is_unproven), formulas),
                Case::new(VERDICT, outcome(kept, kept_unproven), message(&verdict)),
            ],
            warnings: self.file.warnings.clone(),
            remarks: self.file.remarks.clone(),
            hint: None,
            text: self.text(&lines.to_string(), verdict.requirement, screen),
            markdown: self.markdown(),
            json: self.record(&verdict, agrees && kept),
            verdict: lines,
            misses_limit: verdict.misses_limit(),
        }
    }

    fn text(&self, verdict: &str, requirement: RequirementOutcome, screen: &Screen) -> String {
        let tone = match self.agreement() {
            Agreement::Agrees => Tone::Good,
            Agreement::Disagrees => Tone::Bad,
            Agreement::Unproven | Agreement::Nothing => Tone::Doubtful,
        };
        let mut text = format!(
            "{}\n\n{}\n\n{verdict}\n\n",
            plain(&self.file.study.title),
            screen.toned(tone, &self.first_line())
        );
        for run in &self.runs {
            let difference = run.worst().map(|(_, mm)| signed_um(mm, 4));
            let difference = difference.map_or("nothing to compare".to_owned(), |um| {
                format!("simulated − model 3 up to {um} µm")
            });
            let outcome = match self.failure(run) {
                Some(reason) => format!("{}  {reason}", screen.toned(Tone::Bad, "FAIL")),
                None => {
                    let trouble = trouble_counts(run).map(|what| format!(" ({what})"));
                    screen.toned(Tone::Good, "ok") + &trouble.unwrap_or_default()
                }
            };
            let (name, poses) = (run_name(run), run.poses);
            let _ = writeln!(text, "{name}: {poses} poses, {difference}  {outcome}");
            let off = run.count(PoseVerdict::OffLine);
            if off > 0 && self.allows_off_line() {
                let _ = writeln!(
                    text,
                    "  {off} poses differ, as they touch off the line of action (allowed by the pair file)"
                );
            }
        }
        for reason in self.other_failures(requirement) {
            let _ = writeln!(text, "\nExit code 1: {reason}.");
        }
        screen.fold(&text)
    }

    /// The reasons why the pair fails although every run passes.
    fn other_failures(&self, requirement: RequirementOutcome) -> Vec<&'static str> {
        let mut reasons = Vec::new();
        if self.agreement() != Agreement::Agrees {
            return reasons;
        }
        if !self.is_proven {
            reasons.push("the two methods disagree");
        }
        match requirement {
            RequirementOutcome::NotMet => reasons.push("a limit of [require] is not met"),
            RequirementOutcome::NotProven => reasons.push("a limit of [require] is not proven"),
            RequirementOutcome::None | RequirementOutcome::Met => {}
        }
        reasons
    }

    /// Why a run fails; `None` where it passes.
    fn failure(&self, run: &RunTally) -> Option<String> {
        if run.passes(self.allows_off_line()) {
            return None;
        }
        let mut parts = Vec::new();
        let unproven = run.unproven;
        if let Some(first) = run.first_unproven.first() {
            parts.push(format!(
                "{unproven} of {} poses: unproven, first {}: {}",
                run.poses,
                pose_label(first),
                pose_doubts(first)
            ));
        }
        if run.compared == 0 && unproven < run.poses {
            parts.push(format!("nothing to compare: {}", without_value(run)));
        }
        let [above, below, off_line] =
            [PoseVerdict::Above, PoseVerdict::Below, PoseVerdict::OffLine]
                .map(|verdict| run.count(verdict));
        let (less, alone) = (run.compared_off_line, run.simulated_alone());
        let mut failing = vec![(above, "above the formula"), (below, "below the formula")];
        // Where nothing is compared, the line above states the reason.
        if !self.allows_off_line() && run.compared > 0 {
            failing.extend([
                (less, "off-line contact"),
                (alone, "off-line contact where model 3 has no value"),
                (off_line - less - alone, "jammed where model 3 has a value"),
            ]);
        }
        let failing = failing.into_iter().filter(|(count, _)| *count > 0);
        parts
            .extend(failing.map(|(count, what)| format!("{count} of {} poses: {what}", run.poses)));
        // A largest difference that agrees is not the failure.
        let worst = run.worst();
        let worst = worst.filter(|(pose, _)| pose.verdict != PoseVerdict::Agrees);
        let worst = worst.map_or(String::new(), |(pose, difference)| {
            format!(
                "; largest difference {} µm at {} (tolerance {} + bound {} µm)",
                signed_um(difference, 4),
                pose_label(pose),
                self.tolerance_um,
                um_ascii(pose.simulated.error_bound.unwrap_or(0.0), 4),
            )
        });
        Some(parts.join(", ") + &worst)
    }

    /// A table with one row per run.
    fn markdown(&self) -> String {
        let mut text = escape_markdown(&self.first_line());
        if self.allows_off_line() {
            text += " Contact off the line of action is allowed.";
        }
        text += &format!("\n\n{}", ComparedRow::columns().markdown(&self.rows()));
        text + "\nBacklash `j_wt` at the operating pitch circle; negative: interference. Off model 2 and 3: largest difference to the \
                involute and to the line-of-action formula; model 3 decides.\n\n"
    }

    fn rows(&self) -> Vec<ComparedRow> {
        let row = |run: &RunTally| ComparedRow {
            run: run.clone(),
            passed: run.passes(self.allows_off_line()),
            summary: run.summary(),
        };
        self.runs.iter().map(row).collect()
    }

    fn record(&self, verdict: &Verdict, passed: bool) -> serde_json::Value {
        json!({
            "file": self.name,
            "passed": passed,
            "pair": self.file.spec,
            "verdict": verdict_record(verdict),
            "extremes": extremes(verdict),
            "compare": {
                "text": self.first_line(),
                "tolerance_um": self.tolerance_um,
                "allow_off_line_contact": self.allows_off_line(),
            },
            "runs": list(&self.rows()),
        })
    }
}

/// A run compared with the formulas.
pub(crate) struct ComparedRow {
    run: RunTally,
    passed: bool,
    summary: Summary,
}

impl ComparedRow {
    /// The places of the least and the greatest backlash.
    fn ends(&self) -> [String; 2] {
        let [least, greatest] = extremes_at(&self.run);
        let at = |length, pose: Option<String>| match pose {
            Some(pose) => format!("{} at {pose}", um_ascii(length, 3)),
            None => NONE.to_owned(),
        };
        [at(self.summary.min, least), at(self.summary.max, greatest)]
    }

    fn off_line_of_action(&self) -> String {
        match self.summary.off_line_of_action {
            // Rounding only: show its magnitude, not 0.000.
            Some(length) if length < 1e-6 => power(length * 1e3, 1),
            length => um_ascii(length, 3),
        }
    }

    fn verdict(&self) -> String {
        let word = if self.passed { "ok" } else { "FAIL" };
        let verdict = format!("{} {word}", mark(self.passed));
        trouble_counts(&self.run).map_or(verdict.clone(), |what| format!("{verdict}; {what}"))
    }

    fn worst_mating(&self) -> Option<&Mating> {
        Some(self.run.worst()?.0.simulated.pose.mating())
    }

    /// The first unproven poses.
    fn unproven_poses(&self) -> Value {
        let poses = &self.run.first_unproven;
        let is_any = !poses.is_empty();
        Value::optional(is_any.then(|| poses.iter().map(unproven_pose).collect::<Vec<_>>()))
    }
}

row_type!(row: ComparedRow {
    "" Plain [heading(shown("run").left())] => run_name(&row.run);
    "center_distance_mm" Plain => row.run.assembly.center_distance();
    "material" Plain => row.run.material.name();
    "poses" Plain [heading(shown("poses"))] => row.run.poses;
    "" Plain [heading(shown("least j_wt µm"))] => row.ends()[0].clone();
    "" Plain [heading(shown("greatest j_wt µm"))] => row.ends()[1].clone();
    "" Plain [heading(shown("off model 2 µm"))] => um_ascii(row.summary.off_involute, 3);
    "" Plain [heading(shown("off model 3 µm"))] => row.off_line_of_action();
    "compared" Plain => row.run.compared;
    "passed" Plain => row.passed;
    "off_line" Plain [heading(shown("touch off the line of action"))] => row.run.count(PoseVerdict::OffLine);
    "below" Plain => row.run.count(PoseVerdict::Below);
    "above" Plain => row.run.count(PoseVerdict::Above);
    "max_deviation_um.involute" Plain => Value::um(row.summary.off_involute);
    "max_deviation_um.line_of_action" Plain => Value::um(row.summary.off_line_of_action);
    "worst" Plain => row.run.worst().map_or(Value::NULL, |_| Value::Absent);
    "worst.wheel_tooth" Plain => Value::optional(row.worst_mating().map(|mating| mating.wheel_tooth));
    "worst.pinion_tooth" Plain => Value::optional(row.worst_mating().map(|mating| mating.pinion_tooth));
    "worst.flank" Plain => Value::optional(row.worst_mating().map(|mating| mating.flank.name()));
    "worst.fraction" Plain => Value::optional(row.worst_mating().map(|mating| mating.fraction));
    "worst.difference_um" Plain => Value::optional(row.run.worst().map(|(_, mm)| mm * 1e3));
    "worst.error_bound_um" Plain => Value::optional(row.run.worst().map(|(pose, _)| Value::um(pose.simulated.error_bound)));
    "unproven" Plain => row.run.count(PoseVerdict::Unproven);
    "unproven_poses" Plain => row.unproven_poses();
    "" Plain [heading(shown("verdict").left())] => row.verdict();
});

fn run_name(run: &RunTally) -> String {
    format!(
        "a = {} mm, {}",
        stated_distance(run.assembly.center_distance()),
        run.material.words()
    )
}

/// The reason why poses have no backlash, or no formula to compare with.
fn without_value(run: &RunTally) -> String {
    let [_, without @ ..] = troubles(run);
    at_poses(run, &without).unwrap_or_else(|| "model 3 has no value at any pose".to_owned())
}

/// The number of poses with negative or no backlash, in words; `None` for zero.
fn trouble_counts(run: &RunTally) -> Option<String> {
    at_poses(run, &troubles(run))
}

/// Poses with negative backlash, and those without any by reason.
fn troubles(run: &RunTally) -> [(usize, &'static str); 4] {
    [
        (run.interfering, "interference"),
        (run.jammed, "jammed"),
        (run.out_of_mesh, "out of mesh"),
        (run.count(PoseVerdict::Unproven), "unproven"),
    ]
}

fn at_poses(run: &RunTally, parts: &[(usize, &str)]) -> Option<String> {
    let parts = parts.iter().filter(|(poses, _)| *poses > 0);
    let parts = parts.map(|(poses, what)| format!("{what} at {poses} of {} poses", run.poses));
    let parts: Vec<String> = parts.collect();
    (!parts.is_empty()).then(|| parts.join(", "))
}

/// An unproven pose. Where only an end of its bearing clearance is unproven, it has no `unproven`.
fn unproven_pose(pose: &ComparedPose) -> serde_json::Value {
    let mut value = json!({ "mating": pose.simulated.pose.mating().json() });
    if let Err(unproven) = &pose.simulated.found {
        value["unproven"] = unproven.json();
    }
    value["reason"] = json!(pose_doubts(pose));
    value
}
