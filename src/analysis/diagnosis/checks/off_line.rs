//! Contact off the line of action: from which centre distance on, in which poses, and its cost.

use super::context::{CheckContext, hundredths, percent};
use crate::analysis::diagnosis::check::{Check, Verdict, met};
use crate::analysis::diagnosis::onset::{Onset, form_onset};
use crate::analysis::diagnosis::pose_evidence::place;
use crate::analytic::limits;
use crate::contact::PoseClass;
use crate::pair::Member;

impl CheckContext<'_> {
    pub(super) fn onset(&self, onset: Option<&Onset>) -> Check {
        let a = self.assembly.center_distance();
        let form = |member| form_onset(self.assembly, member);
        let formula = form(Member::Wheel).max(form(Member::Pinion));
        let outlines = onset.map(|onset| onset.distance);
        let margin = a - outlines.unwrap_or(formula);
        Check {
            formula: Some(formula),
            outlines,
            limit: Some(a),
            margin: Some(margin),
            verdict: match onset {
                Some(_) => Verdict::unless(met(margin), Verdict::Fail),
                None => Verdict::Pass,
            },
            note: onset.map_or("never".to_owned(), |onset| {
                format!("{}, {}", onset.class.name(), place(&onset.mating))
            }),
            ..Check::named(
                "non_involute_onset",
                "centre distance of first non-involute contact",
            )
        }
    }

    pub(super) fn off_line(&self) -> Check {
        let poses = self.evidence.contact.poses();
        let off = self.evidence.contact.off_line;
        let grave = self.evidence.contact.of_class(PoseClass::is_non_involute);
        let verdict = match (off, grave) {
            (0, _) => Verdict::Pass,
            (_, 0) => Verdict::Warn,
            _ if self.allow_off_line => Verdict::Warn,
            _ => Verdict::Fail,
        };
        let mut details = Vec::new();
        let mut note = String::new();
        if let Some(loss) = &self.evidence.contact.loss {
            details.extend([
                ("least_loss_um", loss.least * 1e3),
                ("mean_loss_um", loss.mean * 1e3),
                ("worst_loss_um", loss.worst.loss * 1e3),
            ]);
        }
        let worst = self.evidence.contact.worst_off_line.as_ref();
        if let Some(worst) = worst.filter(|worst| worst.loss > limits::MET_WITHIN) {
            note = format!(
                "worst {} µm lost, {}: {} of wheel tooth {}, pinion tooth {}",
                hundredths(worst.loss),
                place(worst.pose.mating()),
                worst.class.name(),
                worst.contact.wheel.tooth,
                worst.contact.pinion.tooth
            );
        }
        Check {
            formula: Some(0.0),
            outlines: Some(percent(off, poses)),
            limit: Some(0.0),
            margin: Some(-percent(off, poses)),
            unit: "%",
            verdict,
            details,
            note,
            ..Check::named(
                "off_line_contact",
                "poses that touch off the line of action",
            )
        }
    }
}
