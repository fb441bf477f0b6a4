//! Contact below the involute: by K (8), by form circle, and as found.

use super::here::{Here, percent};
use crate::analysis::diagnosis::check::{Check, Verdict, met};
use crate::analytic::limits;
use crate::pair::Member;

impl Here<'_> {
    /// The formula's verdict borne out by the outlines, or not.
    fn borne_out(margin: f64, below: usize) -> Verdict {
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
        let measured = self.seen.touched(member.mate()).greatest;
        let measured = measured.map(|r| ((r - base) * (r + base)).max(0.0).sqrt());
        // K (8) is about the base circle: violated, it is borne out by contact below the involute.
        let verdict = match (met(margin), self.seen.touched(member).below) {
            (true, _) => Verdict::Pass,
            (false, 0) => Verdict::Warn,
            (false, _) => Verdict::Fail,
        };
        Check {
            unproven: None,
            id: "non_involute_k8",
            title: "mate's tip within base tangent, K (8)",
            gear: Some(member),
            analytic: Some(limits::tip_tangent(mate)),
            measured,
            limit: Some(limit),
            margin: Some(margin),
            unit: "mm",
            verdict,
            details: vec![],
            note: match (met(margin), verdict) {
                (false, Verdict::Warn) => {
                    "violated, yet no pose touches below the involute: undercut has removed that metal, or another pair binds first"
                        .to_owned()
                }
                _ => String::new(),
            },
        }
    }

    /// The same against the real form circle, as radii on `member`.
    pub(super) fn form(&self, member: Member) -> Check {
        let gear = self.gear(member);
        let margin = limits::form_margin(self.assembly, member);
        let touched = self.seen.touched(member);
        let (below, measured) = (touched.below, touched.least);
        let form = gear.form_radius();
        let analytic = limits::active_root_radius(self.assembly, member);
        let least = [analytic, measured].into_iter().flatten().reduce(f64::min);
        let poses = self.seen.contact.poses();
        Check {
            unproven: None,
            id: "non_involute_form",
            title: "lowest contact above form circle (radii)",
            gear: Some(member),
            analytic,
            measured,
            limit: Some(form),
            margin: least.map(|least| least - form),
            unit: "mm",
            verdict: Here::borne_out(margin, below),
            details: vec![
                ("form_margin_on_line_of_action_mm", margin),
                ("poses_below_percent", percent(below, poses)),
            ],
            note: match below {
                0 => String::new(),
                _ => format!(
                    "touched below the involute in {below} of {poses} poses{}",
                    self.where_below(member)
                ),
            },
        }
    }

    /// Teeth in the contact nearest to `member`'s root.
    fn where_below(&self, member: Member) -> String {
        let touched = self.seen.touched(member);
        touched.lowest.map_or(String::new(), |contact| {
            format!(
                " by {} tooth pairs, lowest at wheel {} {}, pinion {} {}",
                touched.pairs.len(),
                contact.wheel.tooth,
                contact.wheel.curve.name(),
                contact.pinion.tooth,
                contact.pinion.curve.name()
            )
        })
    }
}
