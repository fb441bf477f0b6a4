//! Every check of one assembled pair, from the evidence of its poses and the searched distances.

use crate::analysis::diagnosis::check::{Check, CheckVerdict, met};
use crate::analysis::diagnosis::clearance::least_over;
use crate::analysis::diagnosis::onset::{Onset, first_form_onset};
use crate::analysis::diagnosis::pose_evidence::{PoseEvidence, pose_in_words};
use crate::analysis::diagnosis::zero_distance::ZeroDistance;
use crate::analysis::extremes::WIDTH;
use crate::analysis::face_loss::FaceLoss;
use crate::analytic::limits;
use crate::contact::{FacePlace, PoseClass, Touch, first_least};
use crate::error::{Error, Tick};
use crate::gear::{Gear, Profile, ProfilePart, Side};
use crate::pair::{FaceDeviation, GearPair, Mating, Member};

/// Tip thickness below which a tooth counts as too sharp, modules (a rule of design offices; hardened teeth need more).
const LEAST_TIP: f64 = 0.2;

/// Contact ratio below which teeth lose contact.
const LEAST_CONTACT_RATIO: f64 = 1.0;

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

/// The result of a search over poses, if any; or the reason why it is unproven.
pub type Searched<T> = Result<Option<T>, String>;

/// The state of a check whose value is a searched distance.
pub(super) enum LimitState<T> {
    /// The limit is known to be met without a search.
    Kept,
    /// The limit is known to be missed without a search.
    Missed,
    /// The result of the search.
    Found(Searched<T>),
}

impl<T> LimitState<T> {
    /// The result of the search; nothing without one.
    pub fn found(self) -> Searched<T> {
        match self {
            LimitState::Found(found) => found,
            LimitState::Kept | LimitState::Missed => Ok(None),
        }
    }
}

/// One assembled pair with the evidence of its poses and its searched distances.
pub(super) struct CheckContext<'a> {
    pub assembly: &'a GearPair,
    pub evidence: &'a PoseEvidence,
    /// Loss of the least by deviations along the face; `None` if unknown or for a pair without any.
    pub face_loss: Option<FaceLoss>,
    pub allow_off_line: bool,
    /// Whether to skip tips that are clear of all roots in any direction.
    pub skip_clear_tips: bool,
    /// The starts of the pitches over which the clearance of the tips is searched.
    pub pitches: &'a dyn Fn() -> Result<Vec<Mating>, Error>,
    pub zero: LimitState<ZeroDistance>,
    pub onset: LimitState<Onset>,
}

impl CheckContext<'_> {
    /// Every check, except those known to be met.
    pub fn checks(&self, tick: &Tick) -> Result<Vec<Check>, Error> {
        let doubt = PoseEvidence::doubt([self.evidence]);
        let of_poses = |check: Check| match &doubt {
            Some(reason) => check.not_proven(reason),
            None => check,
        };
        let mut checks = Vec::new();
        let look = |member: &Member| !self.skip_clear_tips || !self.is_surely_clear(*member);
        for member in Member::BOTH.into_iter().filter(look) {
            checks.push(self.clearance(member, &(self.pitches)()?, tick)?);
        }
        checks.extend(Member::BOTH.map(|member| of_poses(self.k_8(member))));
        checks.extend(Member::BOTH.map(|member| of_poses(self.form(member))));
        checks.extend(of(&self.onset, |onset| self.onset(onset)));
        checks.push(of_poses(self.off_line()));
        checks.extend(of(&self.zero, |zero| self.zero(zero)));
        checks.push(of_poses(self.backlash()));
        checks.extend(Member::BOTH.map(|member| self.undercut(member)));
        checks.push(self.contact_ratio());
        checks.extend(Member::BOTH.map(|member| self.tip(member)));
        if self.assembly.deviates_along_face() {
            checks.push(of_poses(self.edge_contact()));
            checks.extend(self.face_use());
            let covers = Member::BOTH.map(|member| self.lead_covers(member));
            checks.extend(covers.into_iter().flatten());
            checks.extend(self.tilt());
        }
        Ok(checks)
    }

    fn gear(&self, member: Member) -> &Gear {
        self.assembly.gear(member).gear()
    }

    fn module(&self) -> f64 {
        self.gear(Member::Wheel).basic_data().module()
    }

    /// Whether `member`'s tips meet the limit for any position of the teeth and any direction of the eccentricities.
    fn is_surely_clear(&self, member: Member) -> bool {
        let off = |member| self.assembly.gear(member).eccentricity();
        let least = self.assembly.radial_clearance(member);
        let least = least - off(member) - off(member.mate());
        met(least - limits::LEAST_CLEARANCE * self.module())
    }

    /// K (9), (10): `member`'s tip over its mate's root, over one pitch from each of `pitches`.
    fn clearance(&self, member: Member, pitches: &[Mating], tick: &Tick) -> Result<Check, Error> {
        let module = self.module();
        let formula = self.assembly.radial_clearance(member);
        let (off, found) = if self.assembly.is_helical() {
            // Along the face the eccentricities have all directions to a tooth: take the worst.
            let off = Member::BOTH.map(|member| self.assembly.gear(member).eccentricity());
            (off, None)
        } else {
            let found = least_over(self.assembly, member, pitches, tick)?;
            ([0.0; 2], found)
        };
        let outlines = match found {
            Some(found) => Some(found.distance),
            None => (off[0] + off[1] > 0.0).then_some(formula - off[0] - off[1]),
        };
        let least = outlines.map_or(formula, |outlines| outlines.min(formula));
        let limit = limits::LEAST_CLEARANCE * module;
        let verdict = if !met(least - limit) {
            CheckVerdict::Fail
        } else {
            CheckVerdict::unless(
                met(least - limits::RECOMMENDED_CLEARANCE * module),
                CheckVerdict::Warn,
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
                    CheckVerdict::Pass | CheckVerdict::Unproven => String::new(),
                    CheckVerdict::Warn => format!(
                        ", below the {} recommended ({:.4} mm)",
                        limits::RECOMMENDED_CLEARANCE,
                        limits::RECOMMENDED_CLEARANCE * module
                    ),
                    CheckVerdict::Fail => {
                        format!(", below the limit of {}", limits::LEAST_CLEARANCE)
                    }
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
    fn tip(&self, member: Member) -> Check {
        let as_built = self.assembly.gear(member);
        let gear = as_built.gear();
        let formula = limits::tip_thickness(gear);
        let widening = |tooth| {
            as_built.flank_offset(Side::Left, tooth) - as_built.flank_offset(Side::Right, tooth)
        };
        let teeth = 1..=gear.basic_data().teeth();
        let thinnest = first_least(teeth.map(|tooth| (tooth, widening(tooth), 0.0)));
        let leaning = limits::tip_helix_cos(gear);
        let thicker = |tooth| gear.tip_radius() * widening(tooth) * leaning;
        let outlines = thinnest.map(|tooth| formula + thicker(tooth));
        let least = outlines.map_or(formula, |outlines| outlines.min(formula));
        let limit = LEAST_TIP * self.module();
        Check {
            gear: Some(member),
            formula: Some(formula),
            outlines,
            limit: Some(limit),
            margin: Some(least - limit),
            verdict: CheckVerdict::unless(met(least - limit), CheckVerdict::Warn),
            note: thinnest
                .filter(|_| outlines != Some(formula))
                .map_or(String::new(), |tooth| format!("tooth {tooth}")),
            ..Check::named("tip_thickness", "tip thickness; of the thinnest tooth")
        }
    }

    /// K (8): how far the mate's tip reaches along the line of action towards `member`'s base circle.
    fn k_8(&self, member: Member) -> Check {
        let mate = self.gear(member.mate());
        let limit = limits::base_tangent(self.assembly);
        let margin = limits::non_involute_margin(self.assembly, member);
        let base = mate.base_radius();
        let outlines = self.evidence.touched(member.mate()).greatest;
        let outlines = outlines.map(|r| ((r - base) * (r + base)).max(0.0).sqrt());
        // K (8) concerns the base circle: contact below the involute confirms its violation.
        let verdict = match (met(margin), self.evidence.touched(member).below) {
            (true, _) => CheckVerdict::Pass,
            (false, 0) => CheckVerdict::Warn,
            (false, _) => CheckVerdict::Fail,
        };
        Check {
            gear: Some(member),
            formula: Some(limits::tip_tangent(mate)),
            outlines,
            limit: Some(limit),
            margin: Some(margin),
            verdict,
            note: if verdict == CheckVerdict::Warn {
                "violated, yet no pose touches below the involute: undercut has removed that metal, or another pair binds first"
                    .to_owned()
            } else {
                String::new()
            },
            ..Check::named("non_involute_k8", "mate's tip within base tangent, K (8)")
        }
    }

    /// The check of the real form circle, as radii on `member`.
    fn form(&self, member: Member) -> Check {
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
            // Contact below the involute confirms the formula.
            verdict: match below {
                0 => CheckVerdict::unless(met(margin), CheckVerdict::Warn),
                _ => CheckVerdict::Fail,
            },
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

    fn onset(&self, onset: Option<&Onset>) -> Check {
        let a = self.assembly.center_distance();
        let formula = first_form_onset(self.assembly);
        let outlines = onset.map(|onset| onset.distance);
        let margin = a - outlines.unwrap_or(formula);
        Check {
            formula: Some(formula),
            outlines,
            limit: Some(a),
            margin: Some(margin),
            verdict: match onset {
                Some(_) => CheckVerdict::unless(met(margin), CheckVerdict::Fail),
                None => CheckVerdict::Pass,
            },
            note: onset.map_or("never".to_owned(), |onset| {
                format!("{}, {}", onset.class.name(), pose_in_words(&onset.mating))
            }),
            ..Check::named(
                "non_involute_onset",
                "centre distance of first non-involute contact",
            )
        }
    }

    fn off_line(&self) -> Check {
        let poses = self.evidence.contact.poses();
        let off = self.evidence.contact.off_line;
        let grave = self.evidence.contact.of_class(PoseClass::is_non_involute);
        let verdict = match (off, grave) {
            (0, _) => CheckVerdict::Pass,
            (_, 0) => CheckVerdict::Warn,
            _ if self.allow_off_line => CheckVerdict::Warn,
            _ => CheckVerdict::Fail,
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
                hundredths(worst.loss * 1e3),
                pose_in_words(worst.pose.mating()),
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

    fn zero(&self, zero: Option<&ZeroDistance>) -> Check {
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
            verdict: CheckVerdict::unless(margin.is_none_or(met), CheckVerdict::Fail),
            details,
            note: {
                let of_nominal = nominal.map_or(String::new(), |nominal| {
                    format!("{nominal:.4} of nominal thickness")
                });
                let worst = zero.map_or(String::new(), |zero| {
                    let [right, left] = zero.teeth;
                    format!(
                        "; worst pose: {}; teeth {}·{} (right flanks) and {}·{} (left flanks)",
                        pose_in_words(&zero.mating),
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
    fn backlash(&self) -> Check {
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
            verdict: CheckVerdict::unless(met(margin) && jammed == 0, CheckVerdict::Fail),
            details: Vec::from_iter(least.map(|least| ("least_j_wt_um", least * 1e3))),
            note: match jammed {
                0 => least.map_or(String::new(), |least| {
                    format!("least j_wt {} µm", hundredths(least * 1e3))
                }),
                _ => format!("jammed in {jammed} of {} poses", contact.poses()),
            },
            ..Check::named(
                "backlash_condition",
                "both teeth within the pitch, K (12), (13)",
            )
        }
    }

    /// Distance of the fillet's tangent point outside the base circle along the line of action.
    fn undercut(&self, member: Member) -> Check {
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
            verdict: CheckVerdict::unless(met(margin) && !undercut, CheckVerdict::Warn),
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

    fn contact_ratio(&self) -> Check {
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
            verdict: CheckVerdict::unless(met(least - LEAST_CONTACT_RATIO), CheckVerdict::Fail),
            details: Vec::from_iter(nominal.map(|at| ("at_nominal_zero_backlash_distance", at))),
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

    /// The share of contacts at an end of the face.
    fn edge_contact(&self) -> Check {
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
            verdict: CheckVerdict::unless(
                right + left == 0 && !self.evidence.extreme_at_end,
                CheckVerdict::Warn,
            ),
            details: shares.collect(),
            note: Side::BOTH.map(words).join("; "),
            ..Check::named("edge_contact", "contacts at an end of the face")
        }
    }

    /// The loss of the least backlash by all deviations along the face; `None` where a bracket does not hold.
    fn face_use(&self) -> Option<Check> {
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
            .map(|(.., name, loss)| format!("{name} {} µm", hundredths(loss * 1e3)))
            .collect();
        let details = known.iter().map(|(_, key, _, loss)| (*key, loss * 1e3));
        let sections = self.evidence.least_sections;
        let binds = sections.map(|sections| {
            let [right, left] = sections.map(hundredths);
            format!("; least at {right} mm (right), {left} mm (left) from the measuring plane")
        });
        Some(Check {
            outlines: Some(all),
            limit: Some(without),
            margin: Some(without - all),
            verdict: CheckVerdict::unless(without < 0.0 || all <= without, CheckVerdict::Warn),
            details: details.collect(),
            note: words.join(", ") + &binds.unwrap_or_default(),
            ..Check::named("face_use", "least backlash lost along the face")
        })
    }

    /// The part of the common face that a lead trace of a gear does not cover; `None` without traces.
    fn lead_covers(&self, member: Member) -> Option<Check> {
        let [from, to] = self.assembly.gear(member).traced()?;
        let face = self.assembly.face();
        let missing = (from - face[0]).max(0.0) + (face[1] - to).max(0.0);
        Some(Check {
            gear: Some(member),
            formula: Some(missing),
            limit: Some(0.0),
            margin: Some(-missing),
            verdict: CheckVerdict::unless(missing <= COVERED_WITHIN, CheckVerdict::Warn),
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
    fn tilt(&self) -> Option<Check> {
        if !self.assembly.leans() {
            return None;
        }
        let lean = self.assembly.lean_bound();
        // Both sides together, as j_wt.
        let left_out = 2.0 * self.assembly.section_error_bound()
            / self.assembly.operating_pressure_angle().cos();
        let margin = WIDTH - left_out;
        let is_kept = margin >= 0.0 && lean <= RECOMMENDED_LEAN;
        Some(Check {
            formula: Some(left_out),
            limit: Some(WIDTH),
            margin: Some(margin),
            verdict: CheckVerdict::unless(is_kept, CheckVerdict::Warn),
            details: vec![("lean_rad", lean), ("left_out_um", left_out * 1e3)],
            note: format!("{:.4} µm at {lean:.1e} rad", left_out * 1e3),
            ..Check::named("tilt", "error of sections of leaning axes")
        })
    }
}

/// The check of a searched distance: `of_found` of its result; `None` if the limit is known to be met.
fn of<T>(known: &LimitState<T>, of_found: impl Fn(Option<&T>) -> Check) -> Option<Check> {
    match known {
        LimitState::Kept => None,
        LimitState::Missed => Some(Check {
            verdict: CheckVerdict::Fail,
            ..of_found(None)
        }),
        LimitState::Found(Ok(found)) => Some(of_found(found.as_ref())),
        LimitState::Found(Err(reason)) => Some(of_found(None).not_proven(reason)),
    }
}

fn percent(part: usize, whole: usize) -> f64 {
    match whole {
        0 => 0.0,
        _ => 100.0 * part as f64 / whole as f64,
    }
}

/// A number with two decimals, never `-0.00`.
fn hundredths(value: f64) -> String {
    let text = format!("{value:.2}");
    match text.as_str() {
        "-0.00" => "0.00".to_owned(),
        _ => text,
    }
}
