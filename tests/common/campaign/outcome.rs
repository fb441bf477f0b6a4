//! The results of both methods and the certificate for one pose, and the faults among them.

use super::draw::Drawn;
use gearlash::contact::{
    Certifier, Contact, CutPair, ExactKernel, LostMotion, Method, PolygonDifference, PoseResult,
    Prover, Status, Touch, sweep,
};
use gearlash::error::Error;
use gearlash::gear::{Profile, ProfilePart, Side};
use gearlash::pair::{GearPair, Member, Pose};
use std::f64::consts::TAU;
use std::ops::ControlFlow;
use std::time::{Duration, Instant};

/// Distance from the form circle, mm, within which a contact is at the joint of involute and fillet.
const JOINT: f64 = 1e-6;

/// The timed methods: exact, polygon, certificate, proof by directions.
pub const METHODS: [&str; 4] = ["exact", "polygon", "certificate", "proof"];

/// Number of bounds by which a result is moved; then neither certificate nor prover may accept it.
const MOVED: f64 = 3.0;

/// The outcome of a pose.
pub enum Verdict {
    /// Both methods are within their bounds of each other, and the certificate confirms them.
    Confirmed(Agreement),
    /// One method gave up: the pose is unproven, not wrong.
    Unproven(String),
    /// They contradict each other.
    Fault(String),
}

/// Agreement of two methods.
#[derive(Default)]
pub struct Agreement {
    /// Greatest difference of a rotation, and both bounds together, µm of `j_wt`.
    pub difference_um: f64,
    pub bound_um: f64,
    /// Statuses that differ within their uncertainty.
    pub border: Option<&'static str>,
}

/// One pose, with its results.
pub struct Outcome {
    pub exact: Option<LostMotion>,
    pub verdict: Verdict,
    pub times: [Duration; 4],
    /// The reason why the exact result is left to the polygons, if the prover does not prove it.
    pub left_to_polygons: Option<&'static str>,
    /// Effort of the exact method, and its limit.
    pub effort: [u64; 2],
}

impl Outcome {
    /// The results for a pose; without the polygon method, certificate and proof alone judge a spur pose.
    pub fn new(drawn: &Drawn, cut: &CutPair, has_polygon_method: bool) -> Outcome {
        if drawn.assembly.is_helical() {
            return over_face(drawn, cut);
        }
        let assembly = &drawn.assembly;
        let pose = Pose::new(assembly, drawn.mating);
        let start = Instant::now();
        let kernel = ExactKernel::new(assembly);
        let exact = kernel.lost_motion(&pose);
        let exact_took = start.elapsed();
        let effort = kernel.effort(&pose);
        let start = Instant::now();
        let polygon = has_polygon_method.then(|| cut.refined_kernel(assembly).lost_motion(&pose));
        let polygon_took = start.elapsed();
        let start = Instant::now();
        let certifier = Certifier::new(cut.kernel(assembly));
        let certificate = match &exact {
            Ok(exact) => certifier.check(&pose, exact),
            Err(_) => Ok(()),
        };
        let certificate_took = start.elapsed();
        let prover = Prover::new(assembly, &kernel);
        let start = Instant::now();
        let proof = exact.as_ref().ok().map(|exact| prover.check(&pose, exact));
        let times = [exact_took, polygon_took, certificate_took, start.elapsed()];
        let moved = exact
            .as_ref()
            .ok()
            .and_then(|exact| accepts_moved(&drawn.assembly, &certifier, &prover, &pose, exact));
        let verdict = match (&exact, &polygon, certificate) {
            _ if moved.is_some() => Verdict::Fault(moved.unwrap_or_default()),
            (_, _, Err(error @ Error::CertificateFailed { .. })) => {
                let both = format!("exact   {exact:?}\npolygon {polygon:?}");
                Verdict::Fault(format!("{error}\n{both}"))
            }
            (Err(error), ..) => Verdict::Unproven(format!("exact: {error}")),
            (_, Some(Err(error)), _) => Verdict::Unproven(format!("polygon: {error}")),
            (_, _, Err(error)) => Verdict::Unproven(format!("certificate: {error}")),
            (Ok(exact), Some(Ok(polygon)), Ok(())) => judge(drawn, cut, exact, polygon),
            (Ok(_), None, Ok(())) => Verdict::Confirmed(Agreement::default()),
        };
        Outcome {
            exact: exact.ok(),
            verdict,
            times,
            effort,
            left_to_polygons: proof.and_then(Result::err),
        }
    }
}

/// The name of the certificate or the prover if it confirms a result that `prover` proves also after a move by [`MOVED`] of its own bounds.
fn accepts_moved(
    assembly: &GearPair,
    certifier: &Certifier,
    prover: &Prover,
    pose: &Pose,
    found: &LostMotion,
) -> Option<String> {
    if found.solid {
        return None;
    }
    let proof = prover.proof(pose, found).ok()?;
    for side in &proof.sides {
        let Some((open, touch)) = side.open.zip(side.touch) else {
            continue;
        };
        let contact = found.on(side.side)?;
        let arm = contact.point - assembly.axis(assembly.free());
        let lever = arm.perp(&contact.normal).abs();
        let turned = 1.0 + pose.locked_rotation().abs() + pose.free_rotation().abs();
        // Above the polygons' resolution and rounding.
        let resolution = 400.0 * f64::EPSILON * assembly.center_distance() * turned / lever;
        let bounds = [
            0.5 * (open - touch.closed).abs(),
            contact.error + resolution,
        ];
        for (judge, bound) in ["prover", "certificate"].into_iter().zip(bounds) {
            for by in [MOVED * bound, -MOVED * bound] {
                let mut moved = *found;
                let contact = match side.side {
                    Side::Right => &mut moved.right,
                    Side::Left => &mut moved.left,
                };
                contact.as_mut()?.rotation += by;
                let accepted = match judge {
                    "prover" => prover.check(pose, &moved).is_ok(),
                    // A certificate of a jam passes if the polygons find a jam too.
                    _ => found.status() != Status::Jammed && certifier.check(pose, &moved).is_ok(),
                };
                if accepted {
                    let name = side.side.name();
                    return Some(format!(
                        "the {judge} accepts the {name} contact moved by {by:e} rad: {found:?}, open {open}, {touch:?}"
                    ));
                }
            }
        }
    }
    None
}

/// Both rotations of both methods must be within the sum of both bounds, also for jammed poses. Statuses must be equal,
/// unless the difference is within the bounds. If teeth are in the mate's body at every rotation (`solid`) and both
/// methods report a jam, a tooth meets the mate several times. Then the reported contact has no meaning.
fn judge(drawn: &Drawn, cut: &CutPair, exact: &LostMotion, polygon: &LostMotion) -> Verdict {
    let assembly = &drawn.assembly;
    let fault =
        |what: String| Verdict::Fault(format!("{what}\nexact   {exact:?}\npolygon {polygon:?}"));
    let both_jammed = [exact, polygon].map(LostMotion::status) == [Status::Jammed; 2];
    let um = assembly.operating_pitch_radius(assembly.free()) * 1e3;
    let mut agreement = Agreement::default();
    for side in Side::BOTH {
        let name = side.name();
        match (exact.on(side), polygon.on(side)) {
            (None, None) => {}
            (Some(one), Some(other)) => {
                let turn = one.rotation - other.rotation;
                let apart = (turn - TAU * (turn / TAU).round()).abs();
                let bound = one.error + other.error;
                if !(apart <= bound) && both_jammed && (exact.solid || polygon.solid) {
                    agreement.border = Some("a tooth in the mate's body: other contacts");
                    return Verdict::Confirmed(agreement);
                }
                if !(apart <= bound) {
                    let (apart, bound) = (apart * um, bound * um);
                    return fault(format!(
                        "{name}: {apart:.3e} µm apart, both bounds together {bound:.3e} µm"
                    ));
                }
                agreement.difference_um = agreement.difference_um.max(apart * um);
                agreement.bound_um = agreement.bound_um.max(bound * um);
            }
            _ if loses_contact_nearby(drawn, cut) => {
                agreement.border = Some("contact or none");
                return Verdict::Confirmed(agreement);
            }
            _ => {
                return fault(format!(
                    "{name}: one method has a contact, the other has none"
                ));
            }
        }
    }
    agreement.border = match (exact.status(), polygon.status()) {
        (one, other) if one == other => None,
        // Rotations agree: lost motions of opposite sign are within the bounds of zero.
        (Status::Clear, _) | (_, Status::Clear) => Some("lost motion zero"),
        // Rotations agree, names do not.
        _ if begins_a_land(assembly, exact) || begins_a_land(assembly, polygon) => {
            Some("where a root land begins")
        }
        (one, other) => {
            let (one, other) = (one.name(), other.name());
            return fault(format!("the statuses differ: {one} and {other}"));
        }
    };
    Verdict::Confirmed(agreement)
}

/// Whether a tip circle reaches the centre of the mate's outline: jammed by definition, and rotations have no meaning.
pub fn reaches_the_centre(assembly: &GearPair) -> bool {
    Member::BOTH.into_iter().any(|one| {
        let (one, other) = (assembly.gear(one), assembly.gear(one.mate()));
        one.reach() + other.eccentricity() >= assembly.center_distance()
    })
}

/// Whether a contact is where a fillet ends and a root land begins: either name is right, and so is either status. A
/// tool without a flat leaves no land; then the names must be equal.
fn begins_a_land(assembly: &GearPair, found: &LostMotion) -> bool {
    let on = |member: Member, touch: &Touch| {
        let gear = assembly.gear(member).gear();
        let (start, end) = Profile::new(gear).range(ProfilePart::Root);
        touch.curve == ProfilePart::Fillet
            && (touch.radius - gear.root_radius()).abs() <= JOINT
            && (end - start) * gear.root_radius() > JOINT
    };
    let mut contacts = [found.right, found.left].into_iter().flatten();
    contacts.any(|contact| {
        let mut members = Member::BOTH.into_iter();
        members.any(|member| on(member, contact.touch(member)))
    })
}

/// Whether, within the rounding of the centre distance, a method finds a side both with contact and without. That
/// rounding is 1000 ulps, for some dozens of operations on lengths up to the distance. It concerns tips that graze each
/// other so closely that the distance as a number does not decide.
fn loses_contact_nearby(drawn: &Drawn, cut: &CutPair) -> bool {
    let here = &drawn.assembly;
    let a = here.center_distance();
    let sides = |scale: f64| -> Vec<[bool; 2]> {
        let Ok(beside) = here.at(a * (1.0 + scale * f64::EPSILON)) else {
            return vec![];
        };
        let pose = Pose::new(&beside, drawn.mating);
        let found = [
            ExactKernel::new(&beside).lost_motion(&pose),
            cut.refined_kernel(&beside).lost_motion(&pose),
        ];
        let found = found.into_iter().flatten();
        found
            .map(|m| [m.right.is_some(), m.left.is_some()])
            .collect()
    };
    let (nearer, farther) = (sides(-1e3), sides(1e3));
    // Both methods agree on either side of the border, and differ across it.
    let same = |all: &[[bool; 2]]| all.len() == 2 && all[0] == all[1];
    same(&nearer) && same(&farther) && nearer[0] != farther[0]
}

/// The curves of a contact, the locked gear's first.
pub fn combination(assembly: &GearPair, contact: &Contact) -> String {
    let name = |member: Member| {
        let touch = contact.touch(member);
        let form = assembly.gear(member).gear().form_radius();
        if (touch.radius - form).abs() <= JOINT {
            "joint"
        } else {
            touch.curve.name()
        }
    };
    format!("{} on {}", name(assembly.locked()), name(assembly.free()))
}

/// The results of both methods, and of exact method and certificate, for a helical pose. The times of the polygon
/// method and of the certificate include that of the exact method and of their kernels.
fn over_face(drawn: &Drawn, cut: &CutPair) -> Outcome {
    let assembly = &drawn.assembly;
    let pose = Pose::new(assembly, drawn.mating);
    let kernel = ExactKernel::new(assembly);
    let start = Instant::now();
    let exact = kernel.lost_motion(&pose);
    let took = start.elapsed();
    let by = |method| -> (PoseResult, Duration) {
        let start = Instant::now();
        let matings = [drawn.mating];
        let going_on = || ControlFlow::Continue(());
        let mut found = sweep(assembly, cut, method, &matings, 0.0, &going_on)
            .expect("what is of one pose is in its result");
        (found.remove(0), start.elapsed())
    };
    let (both, both_took) = by(Method::Both);
    let (certified, certified_took) = by(Method::Checked);
    Outcome {
        verdict: match &exact {
            Err(error) => Verdict::Unproven(format!("exact: {error}")),
            Ok(_) => judge_over_face(drawn, &both, &certified),
        },
        exact: exact.ok(),
        times: [took, both_took, certified_took, Duration::ZERO],
        left_to_polygons: None,
        effort: kernel.effort(&pose),
    }
}

/// Faults are a failed certificate, and methods that differ by more than both bounds or in status. If effort ends a
/// method, the pose is unproven.
fn judge_over_face(drawn: &Drawn, both: &PoseResult, certified: &PoseResult) -> Verdict {
    let um = drawn.assembly.operating_pitch_radius(drawn.assembly.free()) * 1e3;
    if let Err(unproven) = &certified.found {
        let reason = format!("certificate: {}", unproven.reason);
        return if reason.contains("effort") {
            Verdict::Unproven(reason)
        } else {
            Verdict::Fault(reason)
        };
    }
    let mut agreement = Agreement::default();
    match &both.found {
        Ok(found) => {
            if let Some(PolygonDifference::Value(mm)) = both.polygon_difference {
                agreement.difference_um = mm.abs() * 1e3;
            }
            agreement.bound_um = found.error().unwrap_or(0.0) * um;
            Verdict::Confirmed(agreement)
        }
        Err(unproven) if unproven.reason.starts_with("the exact") => {
            Verdict::Fault(unproven.reason.clone())
        }
        Err(unproven) => Verdict::Unproven(unproven.reason.clone()),
    }
}
