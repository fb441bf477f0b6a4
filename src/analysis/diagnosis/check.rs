//! One check of a pair: by formula, on the outlines, against its limit.

use crate::analytic::limits;
use crate::pair::Member;

/// What a check says.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Verdict {
    /// The limit is kept.
    Pass,
    /// Kept, but not what is recommended; or the formula and the outlines disagree, and the outlines are kind.
    Warn,
    /// The value on the outlines is not proven, so that nobody knows whether the limit is kept.
    Unproven,
    /// The limit is not kept.
    Fail,
}

impl Verdict {
    /// `pass`, `warn`, `unproven` or `fail`.
    pub fn name(self) -> &'static str {
        match self {
            Verdict::Pass => "pass",
            Verdict::Warn => "warn",
            Verdict::Unproven => "unproven",
            Verdict::Fail => "fail",
        }
    }

    /// `otherwise` unless `kept`.
    pub(super) fn unless(kept: bool, otherwise: Verdict) -> Verdict {
        if kept { Verdict::Pass } else { otherwise }
    }
}

/// Whether a margin counts as kept: within [`limits::MET_WITHIN`].
pub(super) fn met(margin: f64) -> bool {
    margin >= -limits::MET_WITHIN
}

/// The name of a check.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct CheckName {
    /// Its name in results.
    pub id: &'static str,
    /// Its name for people.
    pub title: &'static str,
}

/// One check of one pair as assembled.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Check {
    /// Its name for programs.
    pub id: &'static str,
    /// Its name for people.
    pub title: &'static str,
    /// The gear in question, where the check is of one gear.
    pub gear: Option<Member>,
    /// By formula, in `unit`; `None` where it has no value.
    pub formula: Option<f64>,
    /// On the outlines, in `unit`; `None` where it has none or was not met.
    pub outlines: Option<f64>,
    /// What it is held against, in `unit`.
    pub limit: Option<f64>,
    /// How far the limit is kept, in `unit`; negative where it is not. Of the less favourable of the two values.
    pub margin: Option<f64>,
    /// `mm`, `m` (modules), `%`, or `1` for a pure number.
    pub unit: &'static str,
    /// What follows.
    pub verdict: Verdict,
    /// More numbers, each with its unit in its name.
    pub details: Vec<(&'static str, f64)>,
    /// A note: where, on which teeth.
    pub note: String,
    /// Why there is no value on the outlines, where poses that it needs are not proven.
    pub unproven: Option<String>,
}

impl Check {
    /// Its name.
    pub fn name(&self) -> CheckName {
        CheckName {
            id: self.id,
            title: self.title,
        }
    }

    /// The check with its value on the outlines not proven for this `reason`. A check that fails stays failed.
    pub(super) fn not_proven(self, reason: &str) -> Check {
        let unproven = Some(reason.to_owned());
        match self.verdict {
            Verdict::Fail => Check {
                note: if self.note.is_empty() {
                    "some poses are unproven".to_owned()
                } else {
                    format!("{}; some poses are unproven", self.note)
                },
                unproven,
                ..self
            },
            Verdict::Pass | Verdict::Warn | Verdict::Unproven => Check {
                outlines: None,
                margin: None,
                details: Vec::new(),
                verdict: Verdict::Unproven,
                note: "not proven to be kept".to_owned(),
                unproven,
                ..self
            },
        }
    }
}
