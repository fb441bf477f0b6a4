//! Checks of radial clearance and of tips.

use super::context::CheckContext;
use crate::analysis::diagnosis::check::{Check, Verdict, met};
use crate::analysis::diagnosis::clearance::least_over;
use crate::analytic::limits;
use crate::error::{Error, Tick};
use crate::gear::Side;
use crate::pair::{Mating, Member};

/// Tip thickness below which a tooth counts as too sharp, modules (a rule of design offices; hardened teeth need more).
const LEAST_TIP: f64 = 0.2;

impl CheckContext<'_> {
    /// Whether `member`'s tips meet the limit for any position of the teeth and any direction of the eccentricities.
    pub(super) fn is_surely_clear(&self, member: Member) -> bool {
        let off = |member| self.assembly.gear(member).eccentricity();
        let least = self.assembly.radial_clearance(member);
        let least = least - off(member) - off(member.mate());
        met(least - limits::LEAST_CLEARANCE * self.module())
    }

    /// K (9), (10): `member`'s tip over its mate's root, over one pitch from each of `pitches`.
    pub(super) fn clearance(
        &self,
        member: Member,
        pitches: &[Mating],
        tick: &Tick,
    ) -> Result<Check, Error> {
        let module = self.module();
        let formula = self.assembly.radial_clearance(member);
        // Along the face of helical gears the eccentricities have all directions to a tooth: take the worst.
        let off = if self.assembly.is_helical() {
            Member::BOTH.map(|member| self.assembly.gear(member).eccentricity())
        } else {
            [0.0; 2]
        };
        let found = if self.assembly.is_helical() {
            None
        } else {
            least_over(self.assembly, member, pitches, tick)?
        };
        let outlines = match found {
            Some(found) => Some(found.distance),
            None => (off[0] + off[1] > 0.0).then_some(formula - off[0] - off[1]),
        };
        let least = outlines.map_or(formula, |outlines| outlines.min(formula));
        let limit = limits::LEAST_CLEARANCE * module;
        let verdict = if !met(least - limit) {
            Verdict::Fail
        } else {
            Verdict::unless(
                met(least - limits::RECOMMENDED_CLEARANCE * module),
                Verdict::Warn,
            )
        };
        Ok(Check {
            gear: Some(member),
            formula: Some(formula),
            outlines,
            limit: Some(limit),
            margin: Some(least - limit),
            verdict,
            details: vec![
                ("least_modules", least / module),
                ("recommended_mm", limits::RECOMMENDED_CLEARANCE * module),
            ],
            note: {
                let missed = match verdict {
                    Verdict::Pass | Verdict::Unproven => String::new(),
                    Verdict::Warn => format!(
                        ", below the {} recommended ({:.4} mm)",
                        limits::RECOMMENDED_CLEARANCE,
                        limits::RECOMMENDED_CLEARANCE * module
                    ),
                    Verdict::Fail => format!(", below the limit of {}", limits::LEAST_CLEARANCE),
                };
                let teeth = found.map_or(String::new(), |found| {
                    format!(
                        "; {} tooth {} beside {} tooth {}",
                        member.name(),
                        found.tip_tooth,
                        member.mate().name(),
                        found.root_tooth
                    )
                });
                format!("{:.4} module{missed}{teeth}", least / module)
            },
            ..Check::named("radial_clearance", "radial clearance of tip, K (9), (10)")
        })
    }

    /// Mean tooth by formula, thinnest tooth as built.
    pub(super) fn tip(&self, member: Member) -> Check {
        let as_built = self.assembly.gear(member);
        let gear = as_built.gear();
        let formula = limits::tip_thickness(gear);
        let widening = |tooth| {
            as_built.flank_offset(Side::Left, tooth) - as_built.flank_offset(Side::Right, tooth)
        };
        let teeth = 1..=gear.basic_data().teeth();
        let thinnest = teeth.reduce(|thinnest, tooth| {
            if widening(tooth) < widening(thinnest) {
                tooth
            } else {
                thinnest
            }
        });
        let leaning = limits::tip_helix_cos(gear);
        let outlines =
            thinnest.map(|tooth| formula + gear.tip_radius() * widening(tooth) * leaning);
        let least = outlines.map_or(formula, |outlines| outlines.min(formula));
        let limit = LEAST_TIP * self.module();
        Check {
            gear: Some(member),
            formula: Some(formula),
            outlines,
            limit: Some(limit),
            margin: Some(least - limit),
            verdict: Verdict::unless(met(least - limit), Verdict::Warn),
            note: thinnest
                .filter(|_| outlines != Some(formula))
                .map_or(String::new(), |tooth| format!("tooth {tooth}")),
            ..Check::named("tip_thickness", "tip thickness; of the thinnest tooth")
        }
    }
}
