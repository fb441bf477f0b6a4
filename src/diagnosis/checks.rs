//! Every check of a pair (design section 7), for each centre distance and material.

use super::check::{Check, Verdict, met};
use super::clearance::radial_clearance;
use super::contact_count::ContactCount;
use super::onset::{Onset, form_onset, non_involute_onset};
use super::zero_distance::{ZeroDistance, zero_distance};
use crate::analytic::limits;
use crate::compare::ComparedRun;
use crate::error::Error;
use crate::gear::{Curve, Gear, Profile, Side};
use crate::mesh::{Contact, ContactClass, ContactKind, PoseClass, Touch};
use crate::pair::{Assembly, Mating, Member};
use crate::study::{Material, Study};
use std::f64::consts::FRAC_PI_2;

/// Tip thickness below which a tooth is thought too sharp, modules (a rule of design offices; hardened teeth take more).
const LEAST_TIP: f64 = 0.2;
/// Contact ratio below which the teeth lose each other.
const LEAST_CONTACT_RATIO: f64 = 1.0;
const MEMBERS: [Member; 2] = [Member::Wheel, Member::Pinion];

/// All that is to be said of a study's pair.
#[derive(Debug, Clone, PartialEq)]
pub struct Diagnosis {
    /// Each centre distance and material, in the order of the study.
    pub groups: Vec<Group>,
    /// What touched over all runs.
    pub contact: ContactCount,
}

/// The pair at one centre distance and of one material.
#[derive(Debug, Clone, PartialEq)]
pub struct Group {
    /// As assembled.
    pub assembly: Assembly,
    /// Which thickness.
    pub material: Material,
    /// Every check.
    pub checks: Vec<Check>,
    /// What touched over its poses.
    pub contact: ContactCount,
    /// `a_0` measured: of the material, the same at each centre distance.
    pub zero: Option<ZeroDistance>,
    /// Onset of non-involute contact: of the material, the same at each centre distance.
    pub onset: Option<Onset>,
}

impl Diagnosis {
    /// The gravest verdict.
    pub fn verdict(&self) -> Verdict {
        let checks = self.groups.iter().flat_map(|group| &group.checks);
        checks
            .map(|check| check.verdict)
            .max()
            .unwrap_or(Verdict::Pass)
    }
}

/// Checks the pair of `study`, whose `runs` were simulated and compared.
///
/// `step` is called before each search over the poses of a material, with what is looked for.
///
/// # Errors
/// A contact that was lost.
pub fn diagnose(
    study: &Study,
    runs: &[ComparedRun],
    step: &mut dyn FnMut(&str) -> Result<(), Error>,
) -> Result<Diagnosis, Error> {
    let mut groups: Vec<Group> = Vec::new();
    let mut searched: Vec<(Material, Option<ZeroDistance>, Option<Onset>)> = Vec::new();
    let key = |run: &ComparedRun| (run.run.assembly.center_distance(), run.run.material);
    for runs_here in runs.chunk_by(|a, b| key(a) == key(b)) {
        let Some(first) = runs_here.first() else {
            continue;
        };
        let (assembly, material) = (&first.run.assembly, first.run.material);
        let known = searched.iter().find(|entry| entry.0 == material).copied();
        let (_, zero, onset) = match known {
            Some(known) => known,
            None => {
                let matings = matings(runs.iter().filter(|run| run.run.material == material));
                step("zero-backlash centre distance")?;
                let zero = zero_distance(assembly, &matings)?;
                step("onset of non-involute contact")?;
                let onset = non_involute_onset(assembly, &matings)?;
                searched.push((material, zero, onset));
                (material, zero, onset)
            }
        };
        step("radial clearance")?;
        let contact = ContactCount::sum(runs_here);
        let here = Here {
            assembly,
            runs: runs_here,
            contact: &contact,
            allow_off_line: study.allow_off_line_contact,
        };
        groups.push(Group {
            assembly: assembly.clone(),
            material,
            checks: here.checks(zero.as_ref(), onset.as_ref()),
            contact,
            zero,
            onset,
        });
    }
    Ok(Diagnosis {
        groups,
        contact: ContactCount::sum(runs),
    })
}

/// The matings of `runs`, each once, in order.
fn matings<'a>(runs: impl Iterator<Item = &'a ComparedRun>) -> Vec<Mating> {
    let mut met = std::collections::HashSet::new();
    let poses = runs.flat_map(|run| &run.poses);
    let matings = poses.map(|pose| *pose.swept.pose.mating());
    matings
        .filter(|m| met.insert((m.wheel_tooth, m.pinion_tooth, m.flank, m.fraction.to_bits())))
        .collect()
}

/// One pair as assembled, with what was found for it.
struct Here<'a> {
    assembly: &'a Assembly,
    runs: &'a [ComparedRun],
    contact: &'a ContactCount,
    allow_off_line: bool,
}

impl Here<'_> {
    fn checks(&self, zero: Option<&ZeroDistance>, onset: Option<&Onset>) -> Vec<Check> {
        let mut checks = Vec::new();
        checks.extend(MEMBERS.map(|member| self.clearance(member)));
        checks.extend(MEMBERS.map(|member| self.k_8(member)));
        checks.extend(MEMBERS.map(|member| self.form(member)));
        checks.push(self.onset(onset));
        checks.push(self.off_line());
        checks.push(self.zero(zero));
        checks.push(self.backlash());
        checks.extend(MEMBERS.map(|member| self.undercut(member)));
        checks.push(self.contact_ratio());
        checks.extend(MEMBERS.map(|member| self.tip(member)));
        checks
    }

    fn gear(&self, member: Member) -> &Gear {
        self.assembly.gear(member).gear()
    }

    fn module(&self) -> f64 {
        self.gear(Member::Wheel).toothing().module()
    }

    fn matings(&self) -> Vec<Mating> {
        matings(self.runs.iter())
    }

    /// Every contact of this pair that has a rotation to it.
    fn contacts(&self) -> impl Iterator<Item = (Side, &Contact)> {
        let poses = self.runs.iter().flat_map(|run| &run.poses);
        poses.flat_map(|pose| {
            let found = &pose.swept.lost_motion;
            let right = found.right.as_ref().map(|c| (Side::Right, c));
            right
                .into_iter()
                .chain(found.left.as_ref().map(|c| (Side::Left, c)))
        })
    }

    /// K (9), (10): `member`'s tip over its mate's root.
    fn clearance(&self, member: Member) -> Check {
        let module = self.module();
        let analytic = limits::radial_clearance(self.assembly, member);
        let found = radial_clearance(self.assembly, member, &self.matings());
        let least = found.map_or(analytic, |found| found.distance.min(analytic));
        let limit = limits::LEAST_CLEARANCE * module;
        let verdict = if !met(least - limit) {
            Verdict::Fail
        } else {
            Verdict::unless(
                met(least - limits::RECOMMENDED_CLEARANCE * module),
                Verdict::Warn,
            )
        };
        Check {
            id: "radial_clearance",
            title: "radial clearance of tip, K (9), (10)",
            gear: Some(member),
            analytic: Some(analytic),
            measured: found.map(|found| found.distance),
            limit: Some(limit),
            margin: Some(least - limit),
            unit: "mm",
            verdict,
            details: vec![
                ("least_modules", least / module),
                ("recommended_mm", limits::RECOMMENDED_CLEARANCE * module),
            ],
            note: found.map_or(String::new(), |found| {
                format!(
                    "{:.3} m; {} tooth {} beside {} tooth {}",
                    least / module,
                    member.name(),
                    found.tip_tooth,
                    member.mate().name(),
                    found.root_tooth
                )
            }),
        }
    }

    /// Poses in which something below `member`'s involute, its edge included, is touched.
    fn below(&self, member: Member) -> usize {
        let poses = self.runs.iter().flat_map(|run| &run.poses);
        poses
            .filter(|pose| {
                let found = &pose.swept.lost_motion;
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
            Curve::Fillet | Curve::Root => true,
            Curve::Tip => false,
            // An undercut edge: the class knows, of one gear or the other.
            Curve::Involute => {
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
    fn k_8(&self, member: Member) -> Check {
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
    fn form(&self, member: Member) -> Check {
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

    fn onset(&self, onset: Option<&Onset>) -> Check {
        let a = self.assembly.center_distance();
        let form = |member| form_onset(self.assembly, member);
        let analytic = form(Member::Wheel).max(form(Member::Pinion));
        let measured = onset.map(|onset| onset.distance);
        let margin = a - measured.unwrap_or(analytic);
        Check {
            id: "non_involute_onset",
            title: "centre distance of first non-involute contact",
            gear: None,
            analytic: Some(analytic),
            measured,
            limit: Some(a),
            margin: Some(margin),
            unit: "mm",
            verdict: match onset {
                Some(_) => Verdict::unless(met(margin), Verdict::Fail),
                None => Verdict::Pass,
            },
            details: vec![],
            note: onset.map_or("never".to_owned(), |onset| {
                format!("{} at {}", onset.class.name(), place(&onset.mating))
            }),
        }
    }

    fn off_line(&self) -> Check {
        let poses = self.contact.poses();
        let off = self.contact.of_class(|class| {
            !matches!(
                class,
                PoseClass::NoContact | PoseClass::Contact(ContactKind::Involute)
            )
        });
        let grave = self.contact.of_class(PoseClass::is_non_involute);
        let verdict = match (off, grave) {
            (0, _) => Verdict::Pass,
            (_, 0) => Verdict::Warn,
            _ if self.allow_off_line => Verdict::Warn,
            _ => Verdict::Fail,
        };
        let mut details = Vec::new();
        let mut note = String::new();
        if let Some(loss) = &self.contact.loss {
            details.extend([
                ("least_loss_um", loss.least * 1e3),
                ("mean_loss_um", loss.mean * 1e3),
                ("worst_loss_um", loss.worst.loss * 1e3),
            ]);
            if off > 0 {
                let worst = &loss.worst;
                note = format!(
                    "worst {:.3} µm lost at {}: {} of wheel {}, pinion {}",
                    worst.loss * 1e3,
                    place(worst.pose.mating()),
                    worst.class.name(),
                    worst.contact.wheel.tooth,
                    worst.contact.pinion.tooth
                );
            }
        }
        Check {
            id: "off_line_contact",
            title: "poses that touch off the line of action",
            gear: None,
            analytic: Some(0.0),
            measured: Some(percent(off, poses)),
            limit: Some(0.0),
            margin: Some(-percent(off, poses)),
            unit: "%",
            verdict,
            details,
            note,
        }
    }

    fn zero(&self, zero: Option<&ZeroDistance>) -> Check {
        let a = self.assembly.center_distance();
        let analytic = limits::zero_backlash_distance(self.assembly);
        let measured = zero.map(|zero| zero.distance);
        let margin = measured.or(analytic).map(|zero| a - zero);
        let mut details = Vec::new();
        let nominal = limits::nominal_zero_backlash_distance(self.assembly);
        details.extend(nominal.map(|nominal| ("nominal_thickness_mm", nominal)));
        details.extend(zero.map(|zero| ("of_poses_mm", zero.of_poses)));
        Check {
            id: "zero_backlash_distance",
            title: "zero-backlash centre distance, K (17)",
            gear: None,
            analytic,
            measured,
            limit: Some(a),
            margin,
            unit: "mm",
            verdict: Verdict::unless(margin.is_none_or(met), Verdict::Fail),
            details,
            note: zero.map_or(String::new(), |zero| {
                let [right, left] = zero.teeth;
                format!(
                    "worst pose {}: wheel, pinion {},{} right and {},{} left",
                    place(&zero.mating),
                    right.0,
                    right.1,
                    left.0,
                    left.1
                )
            }),
        }
    }

    /// K (12), (13): what both teeth take of a pitch; measured, a pitch less the least backlash.
    fn backlash(&self) -> Check {
        let pitch = limits::operating_pitch(self.assembly);
        let thickness = |member| limits::operating_thickness(self.assembly, member);
        let analytic = thickness(Member::Wheel) + thickness(Member::Pinion);
        let poses = || self.runs.iter().flat_map(|run| &run.poses);
        let least = poses()
            .filter_map(|pose| pose.swept.backlash)
            .reduce(f64::min);
        let jammed = self.contact.of_class(|class| class == PoseClass::Jammed);
        let measured = least.map(|least| pitch - least);
        let margin = pitch - measured.map_or(analytic, |measured| measured.max(analytic));
        Check {
            id: "backlash_condition",
            title: "both teeth within the pitch, K (12), (13)",
            gear: None,
            analytic: Some(analytic),
            measured,
            limit: Some(pitch),
            margin: Some(margin),
            unit: "mm",
            verdict: Verdict::unless(met(margin) && jammed == 0, Verdict::Fail),
            details: least
                .map(|least| ("least_j_wt_um", least * 1e3))
                .into_iter()
                .collect(),
            note: match jammed {
                0 => least.map_or(String::new(), |least| {
                    format!("least j_wt {:.3} µm", least * 1e3)
                }),
                _ => format!("jammed in {jammed} of {} poses", self.contact.poses()),
            },
        }
    }

    /// How far the fillet's tangency stands outside the base circle along the line of action (design section 4).
    fn undercut(&self, member: Member) -> Check {
        let gear = self.gear(member);
        let (toothing, rack) = (gear.toothing(), &gear.blank().rack);
        let least = limits::least_shift_without_undercut(toothing, rack);
        // r sin α − (h_0/sin α + ρ) is (x_E − x_E,least) m/sin α.
        let margin =
            (gear.generating_shift() - least) * toothing.module() / toothing.pressure_angle().sin();
        let profile = Profile::new(gear);
        let joint = |curve, t| profile.normal(curve, t, Side::Right);
        let (fillet, involute) = (
            joint(Curve::Fillet, gear.fillet().end()),
            joint(Curve::Involute, gear.form_roll()),
        );
        let edge = fillet.perp(&involute).abs().atan2(fillet.dot(&involute));
        let undercut = gear.fillet().end() < FRAC_PI_2 - toothing.pressure_angle();
        Check {
            id: "undercut",
            title: "involute begins outside base circle",
            gear: Some(member),
            analytic: Some(margin),
            measured: Some(gear.base_radius() * gear.form_roll()),
            limit: Some(0.0),
            margin: Some(margin),
            unit: "mm",
            verdict: Verdict::unless(met(margin) && !undercut, Verdict::Warn),
            details: vec![
                ("root_form_diameter_mm", 2.0 * gear.form_radius()),
                ("base_diameter_mm", 2.0 * gear.base_radius()),
                ("generating_shift_modules", gear.generating_shift()),
                ("least_shift_modules", least),
                ("edge_deg", edge.to_degrees()),
            ],
            note: match undercut {
                true => format!(
                    "undercut: form diameter {:.4} mm, edge of {:.2}°",
                    2.0 * gear.form_radius(),
                    edge.to_degrees()
                ),
                false => format!("form diameter {:.4} mm", 2.0 * gear.form_radius()),
            },
        }
    }

    fn contact_ratio(&self) -> Check {
        let analytic = limits::contact_ratio(self.assembly);
        let measured = limits::usable_contact_ratio(self.assembly);
        let least = analytic.min(measured);
        let nominal = limits::nominal_zero_backlash_distance(self.assembly)
            .and_then(|a| self.assembly.at(a).ok())
            .map(|nominal| limits::contact_ratio(&nominal));
        Check {
            id: "contact_ratio",
            title: "contact ratio; between real form circles",
            gear: None,
            analytic: Some(analytic),
            measured: Some(measured),
            limit: Some(LEAST_CONTACT_RATIO),
            margin: Some(least - LEAST_CONTACT_RATIO),
            unit: "1",
            verdict: Verdict::unless(met(least - LEAST_CONTACT_RATIO), Verdict::Fail),
            details: nominal
                .map(|nominal| ("at_nominal_zero_backlash_distance", nominal))
                .into_iter()
                .collect(),
            note: nominal.map_or(String::new(), |nominal| {
                format!("{nominal:.4} at the play-free distance of the drawing")
            }),
        }
    }

    /// Mean tooth by formula, thinnest tooth as built.
    fn tip(&self, member: Member) -> Check {
        let as_built = self.assembly.gear(member);
        let gear = as_built.gear();
        let analytic = limits::tip_thickness(gear);
        let widening = |tooth| {
            as_built.flank_offset(Side::Left, tooth) - as_built.flank_offset(Side::Right, tooth)
        };
        let teeth = 1..=gear.toothing().teeth();
        let thinnest = teeth.reduce(
            |thinnest, tooth| match widening(tooth) < widening(thinnest) {
                true => tooth,
                false => thinnest,
            },
        );
        let measured = thinnest.map(|tooth| analytic + gear.tip_radius() * widening(tooth));
        let least = measured.map_or(analytic, |measured| measured.min(analytic));
        let limit = LEAST_TIP * self.module();
        Check {
            id: "tip_thickness",
            title: "tip thickness; of the thinnest tooth",
            gear: Some(member),
            analytic: Some(analytic),
            measured,
            limit: Some(limit),
            margin: Some(least - limit),
            unit: "mm",
            verdict: Verdict::unless(met(least - limit), Verdict::Warn),
            details: vec![],
            note: thinnest
                .filter(|_| measured != Some(analytic))
                .map_or(String::new(), |tooth| format!("tooth {tooth}")),
        }
    }
}

fn touch(contact: &Contact, member: Member) -> Touch {
    match member {
        Member::Wheel => contact.wheel,
        Member::Pinion => contact.pinion,
    }
}

fn percent(part: usize, whole: usize) -> f64 {
    match whole {
        0 => 0.0,
        _ => 100.0 * part as f64 / whole as f64,
    }
}

/// A pose in a word: mating, flank, fraction.
fn place(mating: &Mating) -> String {
    format!(
        "{},{} {} +{:.4}",
        mating.wheel_tooth,
        mating.pinion_tooth,
        mating.flank.name(),
        mating.fraction
    )
}
