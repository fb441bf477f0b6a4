//! One check of a pair: its value by formula and on the outlines, and its limit.

use crate::analytic::limits;
use crate::pair::Member;

/// The outcome of a check.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum CheckVerdict {
    /// The limit is met.
    Pass,
    /// The limit is met, but not the recommendation; or formula and outlines disagree, and the outlines are favourable.
    Warn,
    /// The value on the outlines is unproven, so the outcome is unknown.
    Unproven,
    /// The limit is not met.
    Fail,
}

impl CheckVerdict {
    /// `pass`, `warn`, `unproven` or `fail`.
    pub fn name(self) -> &'static str {
        match self {
            CheckVerdict::Pass => "pass",
            CheckVerdict::Warn => "warn",
            CheckVerdict::Unproven => "unproven",
            CheckVerdict::Fail => "fail",
        }
    }

    /// `Pass` if `kept`, otherwise the other verdict.
    pub(super) fn unless(kept: bool, otherwise: CheckVerdict) -> CheckVerdict {
        if kept { CheckVerdict::Pass } else { otherwise }
    }
}

/// Whether a margin counts as met: within [`limits::MET_WITHIN`].
pub(super) fn met(margin: f64) -> bool {
    margin >= -limits::MET_WITHIN
}

/// The name of a check.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct CheckName {
    /// Its name in results.
    pub id: &'static str,
    /// Its name for readers.
    pub title: &'static str,
}

/// One check of one pair as assembled.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Check {
    /// Its name for programs.
    pub id: &'static str,
    /// Its name for readers.
    pub title: &'static str,
    /// The gear, if the check concerns one gear.
    pub gear: Option<Member>,
    /// The value by formula, in `unit`; `None` without a value.
    pub formula: Option<f64>,
    /// The value on the outlines, in `unit`; `None` without a value or if it did not occur.
    pub outlines: Option<f64>,
    /// The limit, in `unit`.
    pub limit: Option<f64>,
    /// Distance from the limit, in `unit`, for the less favourable value; negative if the limit is missed.
    pub margin: Option<f64>,
    /// `mm`, `m` (modules), `%`, or `1` for a pure number.
    pub unit: &'static str,
    /// The outcome.
    pub verdict: CheckVerdict,
    /// Further numbers, each with its unit in its name.
    pub details: Vec<(&'static str, f64)>,
    /// A note: where, on which teeth.
    pub note: String,
    /// The reason why there is no value on the outlines, if poses that it needs are unproven.
    pub unproven: Option<String>,
}

impl Check {
    /// A check in mm that passes, still without values.
    pub(super) fn named(id: &'static str, title: &'static str) -> Check {
        Check {
            id,
            title,
            gear: None,
            formula: None,
            outlines: None,
            limit: None,
            margin: None,
            unit: "mm",
            verdict: CheckVerdict::Pass,
            details: Vec::new(),
            note: String::new(),
            unproven: None,
        }
    }

    /// Its name.
    pub fn name(&self) -> CheckName {
        CheckName {
            id: self.id,
            title: self.title,
        }
    }

    /// The check with an unproven value on the outlines, for this `reason`. A failed check stays failed.
    pub(super) fn not_proven(self, reason: &str) -> Check {
        let unproven = Some(reason.to_owned());
        match self.verdict {
            CheckVerdict::Fail => Check {
                note: if self.note.is_empty() {
                    "some poses are unproven".to_owned()
                } else {
                    format!("{}; some poses are unproven", self.note)
                },
                unproven,
                ..self
            },
            CheckVerdict::Pass | CheckVerdict::Warn | CheckVerdict::Unproven => Check {
                outlines: None,
                margin: None,
                details: Vec::new(),
                verdict: CheckVerdict::Unproven,
                note: "not proven to be kept".to_owned(),
                unproven,
                ..self
            },
        }
    }
}
