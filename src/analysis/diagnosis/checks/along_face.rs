//! Deviations along the face: the places where teeth touch, the backlash that is lost, and the extent of what was measured.

use super::context::{CheckContext, hundredths, percent};
use crate::analysis::diagnosis::check::{Check, Verdict};
use crate::analysis::extremes::WIDTH;
use crate::contact::FacePlace;
use crate::gear::Side;
use crate::pair::{FaceDeviation, Member};

/// Lean of the axes, mm per mm, above which sections describe the teeth poorly.
const RECOMMENDED_LEAN: f64 = 5e-3;

/// Length of a face, mm, that no trace needs to cover: rounding of stated heights.
const COVERED_WITHIN: f64 = 1e-6;

/// The names of the shares of contacts: right flanks, then left flanks, each in the order of [`FacePlace::ALL`].
const SHARES: [[&str; 4]; 2] = [
    [
        "right_near_end_percent",
        "right_far_end_percent",
        "right_tip_edge_percent",
        "right_inside_percent",
    ],
    [
        "left_near_end_percent",
        "left_far_end_percent",
        "left_tip_edge_percent",
        "left_inside_percent",
    ],
];

impl CheckContext<'_> {
    /// The share of contacts at an end of the face.
    pub(super) fn edge_contact(&self) -> Check {
        let places = &self.evidence.places;
        let count = |side: Side, at: FacePlace| places[side.index()][at as usize];
        let all = |side: Side| places[side.index()].iter().sum::<usize>();
        let shares = Side::BOTH.into_iter().flat_map(|side| {
            let of = FacePlace::ALL.into_iter();
            of.map(move |at| {
                let name = SHARES[side.index()][at as usize];
                (name, percent(count(side, at), all(side)))
            })
        });
        let at_ends = |side| count(side, FacePlace::NearEnd) + count(side, FacePlace::FarEnd);
        let [right, left] = Side::BOTH.map(at_ends);
        let share = percent(right + left, all(Side::Right) + all(Side::Left));
        let words = |side: Side| {
            let found = FacePlace::ALL.into_iter().filter(|at| count(side, *at) > 0);
            let found = found.map(|at| {
                let share = percent(count(side, at), all(side));
                format!("{} {share:.0} %", at.words())
            });
            let found: Vec<String> = found.collect();
            format!("{} flanks: {}", side.name(), found.join(", "))
        };
        Check {
            outlines: Some(share),
            limit: Some(0.0),
            margin: Some(-share),
            unit: "%",
            verdict: Verdict::unless(
                right + left == 0 && !self.evidence.extreme_at_end,
                Verdict::Warn,
            ),
            details: shares.collect(),
            note: Side::BOTH.map(words).join("; "),
            ..Check::named("edge_contact", "contacts at an end of the face")
        }
    }

    /// The loss of the least backlash by all deviations along the face; `None` where a bracket does not hold.
    pub(super) fn face_use(&self) -> Option<Check> {
        let loss = self.face_loss?;
        let (all, without) = (loss.all?, loss.least_without?);
        let kinds = [
            (FaceDeviation::Lead, "lead_um", "lead"),
            (FaceDeviation::Wobble, "wobble_um", "wobble"),
            (FaceDeviation::Shafts, "shafts_um", "shafts"),
        ];
        let known = kinds.map(|(kind, key, name)| Some((kind, key, name, loss.by(kind)?)));
        let known: Vec<_> = known.into_iter().flatten().collect();
        let own = known.iter().filter(|(kind, ..)| self.assembly.has(*kind));
        let words: Vec<String> = own
            .map(|(.., name, loss)| format!("{name} {} µm", hundredths(*loss)))
            .collect();
        let details = known.iter().map(|(_, key, _, loss)| (*key, loss * 1e3));
        Some(Check {
            outlines: Some(all),
            limit: Some(without),
            margin: Some(without - all),
            verdict: Verdict::unless(without < 0.0 || all <= without, Verdict::Warn),
            details: details.collect(),
            note: words.join(", "),
            ..Check::named("face_use", "least backlash lost along the face")
        })
    }

    /// The part of the common face that a lead trace of a gear does not cover; `None` without traces.
    pub(super) fn lead_covers(&self, member: Member) -> Option<Check> {
        let [from, to] = self.assembly.gear(member).traced()?;
        let face = self.assembly.face();
        let missing = (from - face[0]).max(0.0) + (face[1] - to).max(0.0);
        Some(Check {
            gear: Some(member),
            formula: Some(missing),
            limit: Some(0.0),
            margin: Some(-missing),
            verdict: Verdict::unless(missing <= COVERED_WITHIN, Verdict::Warn),
            details: vec![("traced_from_mm", from), ("traced_to_mm", to)],
            note: if missing <= COVERED_WITHIN {
                String::new()
            } else {
                format!(
                    "traces from b = {from:.3} to {to:.3} mm, common face from {:.3} to {:.3} mm",
                    face[0], face[1]
                )
            },
            ..Check::named("lead_covers", "common face beyond the lead traces")
        })
    }

    /// The error of sections of leaning axes; `None` for parallel axes.
    pub(super) fn tilt(&self) -> Option<Check> {
        if !self.assembly.leans() {
            return None;
        }
        let lean = self.assembly.most_lean();
        // Both sides together, as j_wt.
        let left_out =
            2.0 * self.assembly.left_out() / self.assembly.operating_pressure_angle().cos();
        let margin = WIDTH - left_out;
        Some(Check {
            formula: Some(left_out),
            limit: Some(WIDTH),
            margin: Some(margin),
            verdict: Verdict::unless(margin >= 0.0 && lean <= RECOMMENDED_LEAN, Verdict::Warn),
            details: vec![("lean_rad", lean), ("left_out_um", left_out * 1e3)],
            note: format!("{:.4} µm at {lean:.1e} rad", left_out * 1e3),
            ..Check::named("tilt", "error of sections of leaning axes")
        })
    }
}
