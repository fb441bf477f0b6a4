//! Backlash, undercut and contact ratio against their limits.

use super::context::{CheckContext, hundredths};
use crate::analysis::diagnosis::check::{Check, Verdict, met};
use crate::analysis::diagnosis::pose_evidence::place;
use crate::analysis::diagnosis::zero_distance::ZeroDistance;
use crate::analytic::limits;
use crate::contact::PoseClass;
use crate::gear::{Profile, ProfilePart, Side};
use crate::pair::Member;

/// Contact ratio below which teeth lose contact.
const LEAST_CONTACT_RATIO: f64 = 1.0;

impl CheckContext<'_> {
    pub(super) fn zero(&self, zero: Option<&ZeroDistance>) -> Check {
        let a = self.assembly.center_distance();
        let formula = limits::zero_backlash_distance(self.assembly);
        let outlines = zero.map(|zero| zero.distance);
        let margin = outlines.or(formula).map(|zero| a - zero);
        let mut details = Vec::new();
        let nominal = limits::nominal_zero_backlash_distance(self.assembly);
        details.extend(nominal.map(|nominal| ("nominal_thickness_mm", nominal)));
        details.extend(zero.map(|zero| ("of_poses_mm", zero.of_poses)));
        Check {
            formula,
            outlines,
            limit: Some(a),
            margin,
            verdict: Verdict::unless(margin.is_none_or(met), Verdict::Fail),
            details,
            note: {
                let of_nominal = nominal.map_or(String::new(), |nominal| {
                    format!("{nominal:.4} of nominal thickness")
                });
                let worst = zero.map_or(String::new(), |zero| {
                    let [right, left] = zero.teeth;
                    format!(
                        "; worst pose: {}; teeth {}·{} (right flanks) and {}·{} (left flanks)",
                        place(&zero.mating),
                        right.0,
                        right.1,
                        left.0,
                        left.1
                    )
                });
                of_nominal + &worst
            },
            ..Check::named(
                "zero_backlash_distance",
                "zero-backlash centre distance, K (17)",
            )
        }
    }

    /// K (12), (13): the part of a pitch that both teeth occupy; on the outlines, a pitch less the least backlash.
    pub(super) fn backlash(&self) -> Check {
        let pitch = limits::operating_pitch(self.assembly);
        let thickness = |member| limits::operating_thickness(self.assembly, member);
        let formula = thickness(Member::Wheel) + thickness(Member::Pinion);
        let least = self.evidence.least;
        let contact = &self.evidence.contact;
        let jammed = contact.of_class(|class| class == PoseClass::Jammed);
        let outlines = least.map(|least| pitch - least);
        let margin = pitch - outlines.map_or(formula, |outlines| outlines.max(formula));
        Check {
            formula: Some(formula),
            outlines,
            limit: Some(pitch),
            margin: Some(margin),
            verdict: Verdict::unless(met(margin) && jammed == 0, Verdict::Fail),
            details: Vec::from_iter(least.map(|least| ("least_j_wt_um", least * 1e3))),
            note: match jammed {
                0 => least.map_or(String::new(), |least| {
                    format!("least j_wt {} µm", hundredths(least))
                }),
                _ => format!(
                    "jammed in {jammed} of {} poses",
                    self.evidence.contact.poses()
                ),
            },
            ..Check::named(
                "backlash_condition",
                "both teeth within the pitch, K (12), (13)",
            )
        }
    }

    /// Distance of the fillet's tangent point outside the base circle along the line of action (design section 4).
    pub(super) fn undercut(&self, member: Member) -> Check {
        let gear = self.gear(member);
        let (basic_data, rack) = (gear.basic_data(), &gear.design().rack);
        let least = limits::least_shift_without_undercut(basic_data, rack);
        // r sin α_t − (h_0 + ρ sin α_n)/sin α_t is (x_E − x_E,least) m_n/sin α_t.
        let margin = (gear.generating_shift() - least) * basic_data.module()
            / basic_data.transverse_pressure_angle().sin();
        let profile = Profile::new(gear);
        let joint = |curve, t| profile.normal(curve, t, Side::Right);
        let (fillet, involute) = (
            joint(ProfilePart::Fillet, gear.fillet().end()),
            joint(ProfilePart::Involute, gear.form_roll()),
        );
        let edge = fillet.perp(&involute).abs().atan2(fillet.dot(&involute));
        let undercut = gear.is_undercut();
        Check {
            gear: Some(member),
            formula: Some(margin),
            outlines: Some(gear.base_radius() * gear.form_roll()),
            limit: Some(0.0),
            margin: Some(margin),
            verdict: Verdict::unless(met(margin) && !undercut, Verdict::Warn),
            details: vec![
                ("root_form_diameter_mm", 2.0 * gear.form_radius()),
                ("base_diameter_mm", 2.0 * gear.base_radius()),
                ("generating_shift_modules", gear.generating_shift()),
                ("least_shift_modules", least),
                ("edge_deg", edge.to_degrees()),
            ],
            note: if undercut {
                format!(
                    "undercut: form diameter {:.4} mm, profile kink of {:.2}°",
                    2.0 * gear.form_radius(),
                    edge.to_degrees()
                )
            } else {
                format!("form diameter {:.4} mm", 2.0 * gear.form_radius())
            },
            ..Check::named("undercut", "involute begins outside base circle")
        }
    }

    pub(super) fn contact_ratio(&self) -> Check {
        let formula = limits::contact_ratio(self.assembly);
        let outlines = limits::usable_contact_ratio(self.assembly);
        // The total contact ratio ε_γ = ε_α + ε_β must not fall below 1.
        let overlap = limits::overlap_ratio(self.assembly);
        let least = formula.min(outlines) + overlap;
        let nominal = limits::nominal_zero_backlash_distance(self.assembly)
            .and_then(|a| self.assembly.at(a).ok())
            .map(|nominal| limits::contact_ratio(&nominal));
        Check {
            formula: Some(formula),
            outlines: Some(outlines),
            limit: Some(LEAST_CONTACT_RATIO),
            margin: Some(least - LEAST_CONTACT_RATIO),
            unit: "1",
            verdict: Verdict::unless(met(least - LEAST_CONTACT_RATIO), Verdict::Fail),
            details: nominal
                .map(|nominal| ("at_nominal_zero_backlash_distance", nominal))
                .into_iter()
                .collect(),
            note: nominal.map_or(String::new(), |nominal| {
                let overlap = if overlap > 0.0 {
                    format!("; margin with overlap ratio {overlap:.4}")
                } else {
                    String::new()
                };
                format!("{nominal:.4} at the nominal zero-backlash centre distance{overlap}")
            }),
            ..Check::named("contact_ratio", "contact ratio; between real form circles")
        }
    }
}
