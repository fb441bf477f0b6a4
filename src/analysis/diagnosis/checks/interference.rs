//! Contact below the involute: by K (8), by form circle, and as simulated.

use super::context::{CheckContext, percent};
use crate::analysis::diagnosis::check::{Check, Verdict, met};
use crate::analytic::limits;
use crate::contact::Touch;
use crate::gear::ProfilePart;
use crate::pair::Member;

impl CheckContext<'_> {
    /// The formula's verdict, confirmed by the outlines or not.
    fn confirmed(margin: f64, below: usize) -> Verdict {
        match (met(margin), below) {
            (true, 0) => Verdict::Pass,
            (false, 0) => Verdict::Warn,
            (_, _) => Verdict::Fail,
        }
    }

    /// K (8): how far the mate's tip reaches along the line of action towards `member`'s base circle.
    pub(super) fn k_8(&self, member: Member) -> Check {
        let mate = self.gear(member.mate());
        let limit = limits::base_tangent(self.assembly);
        let margin = limits::non_involute_margin(self.assembly, member);
        let base = mate.base_radius();
        let outlines = self.evidence.touched(member.mate()).greatest;
        let outlines = outlines.map(|r| ((r - base) * (r + base)).max(0.0).sqrt());
        // K (8) concerns the base circle: contact below the involute confirms its violation.
        let verdict = match (met(margin), self.evidence.touched(member).below) {
            (true, _) => Verdict::Pass,
            (false, 0) => Verdict::Warn,
            (false, _) => Verdict::Fail,
        };
        Check {
            gear: Some(member),
            formula: Some(limits::tip_tangent(mate)),
            outlines,
            limit: Some(limit),
            margin: Some(margin),
            verdict,
            note: match (met(margin), verdict) {
                (false, Verdict::Warn) => {
                    "violated, yet no pose touches below the involute: undercut has removed that metal, or another pair binds first"
                        .to_owned()
                }
                _ => String::new(),
            },
            ..Check::named("non_involute_k8", "mate's tip within base tangent, K (8)")
        }
    }

    /// The check of the real form circle, as radii on `member`.
    pub(super) fn form(&self, member: Member) -> Check {
        let gear = self.gear(member);
        let margin = limits::form_margin(self.assembly, member);
        let touched = self.evidence.touched(member);
        let (below, outlines) = (touched.below, touched.least);
        let form = gear.form_radius();
        let formula = limits::active_root_radius(self.assembly, member);
        let least = [formula, outlines].into_iter().flatten().reduce(f64::min);
        let poses = self.evidence.contact.poses();
        Check {
            gear: Some(member),
            formula,
            outlines,
            limit: Some(form),
            margin: least.map(|least| least - form),
            verdict: CheckContext::confirmed(margin, below),
            details: vec![
                ("form_margin_on_line_of_action_mm", margin),
                ("poses_below_percent", percent(below, poses)),
            ],
            note: self.touched_in(member, poses),
            ..Check::named(
                "non_involute_form",
                "lowest contact above form circle (radii)",
            )
        }
    }

    /// The number of `poses` with contact on `member` below its involute or on its undercut edge, and the lowest such
    /// contact; empty without any.
    fn touched_in(&self, member: Member, poses: usize) -> String {
        let touched = self.evidence.touched(member);
        let Some(lowest) = &touched.lowest else {
            return String::new();
        };
        let touch = lowest.touch(member);
        let on_edge = touch.curve == ProfilePart::Involute;
        let place = if on_edge {
            "on the undercut edge, at the form circle,"
        } else {
            "below the involute"
        };
        let curve = |touch: Touch| {
            if on_edge {
                format!("{}", touch.tooth)
            } else {
                format!("{} {}", touch.tooth, touch.curve.name())
            }
        };
        format!(
            "touched {place} in {} of {poses} poses by {} tooth pairs, lowest at wheel {}, pinion {}",
            touched.below,
            touched.pairs.len(),
            curve(lowest.wheel),
            curve(lowest.pinion)
        )
    }
}
