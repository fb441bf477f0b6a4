//! Contact below the involute: by K (8), by form circle, and as found.

use super::{Check, Here, Verdict, percent, touch};
use crate::analysis::diagnosis::check::met;
use crate::analytic::limits;
use crate::contact::{Contact, ContactClass, ContactKind};
use crate::gear::ProfilePart;
use crate::gear::Side;
use crate::pair::Member;

impl Here<'_> {
    /// Poses in which something below `member`'s involute, its edge included, is touched.
    fn below(&self, member: Member) -> usize {
        let poses = self.runs.iter().flat_map(|run| &run.poses);
        poses
            .filter_map(|pose| pose.swept.proven())
            .filter(|found| {
                let sides = [(Side::Right, &found.right), (Side::Left, &found.left)];
                sides.into_iter().any(|(side, contact)| {
                    contact
                        .as_ref()
                        .is_some_and(|contact| self.is_below(member, side, contact))
                })
            })
            .count()
    }

    fn is_below(&self, member: Member, side: Side, contact: &Contact) -> bool {
        match touch(contact, member).curve {
            ProfilePart::Fillet | ProfilePart::Root => true,
            ProfilePart::Tip => false,
            // An undercut edge: the class knows, of one gear or the other.
            ProfilePart::Involute => {
                ContactClass::of(self.assembly, side, contact).kind == ContactKind::Edge
                    && touch(contact, member).radius <= self.gear(member).form_radius() + 1e-7
            }
        }
    }

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
        let reached = self
            .contacts()
            .map(|(_, contact)| touch(contact, member.mate()).radius);
        let measured = reached.reduce(f64::max);
        let measured = measured.map(|r| ((r - base) * (r + base)).max(0.0).sqrt());
        // K (8) is about the base circle: violated, it is borne out by contact below the involute.
        let verdict = match (met(margin), self.below(member)) {
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
        let below = self.below(member);
        let on_flank = self
            .contacts()
            .map(|(_, contact)| touch(contact, member).radius);
        let measured = on_flank.reduce(f64::min);
        let form = gear.form_radius();
        let analytic = limits::active_root_radius(self.assembly, member);
        let least = [analytic, measured].into_iter().flatten().reduce(f64::min);
        let poses = self.contact.poses();
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
        let below = self
            .contacts()
            .filter(|(side, contact)| self.is_below(member, *side, contact));
        let mut pairs = std::collections::HashSet::new();
        let below = below.inspect(|(_, c)| {
            pairs.insert((c.wheel.tooth, c.pinion.tooth));
        });
        let lowest = below.reduce(|lowest, next| {
            match touch(next.1, member).radius < touch(lowest.1, member).radius {
                true => next,
                false => lowest,
            }
        });
        lowest.map_or(String::new(), |(_, contact)| {
            format!(
                " by {} tooth pairs, lowest at wheel {} {}, pinion {} {}",
                pairs.len(),
                contact.wheel.tooth,
                contact.wheel.curve.name(),
                contact.pinion.tooth,
                contact.pinion.curve.name()
            )
        })
    }
}
