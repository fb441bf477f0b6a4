//! The results of both methods and the certificate for one pose, and the faults among them.

use super::draw::Drawn;
use gearlash::contact::{
    Certifier, Contact, CutPair, ExactKernel, LostMotion, Method, PoseResult, Prover, Status,
    Touch, sweep,
};
use gearlash::error::Error;
use gearlash::error::go_on;
use gearlash::gear::{Profile, ProfilePart, Side};
use gearlash::pair::{GearPair, Member, Pose};
use std::f64::consts::TAU;

/// Distance from the form circle, mm, within which a contact is at the joint of involute and fillet.
const JOINT: f64 = 1e-6;

/// Number of bounds by which a result is moved; then neither certificate nor prover may accept it.
const MOVED: f64 = 3.0;

/// The outcome of a pose.
pub enum Verdict {
    /// Both methods are within their bounds of each other, and the certificate confirms them; or statuses differ within their uncertainty, and why.
    Confirmed(Option<&'static str>),
    /// One method gave up: the pose is unproven, not wrong.
    Unproven(String),
    /// They contradict each other.
    Fault(String),
}

/// One pose, with its results.
pub struct Outcome {
    pub exact: Option<LostMotion>,
    pub verdict: Verdict,
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
        let kernel = ExactKernel::new(assembly);
        let exact = kernel.lost_motion(&pose);
        let polygon = has_polygon_method.then(|| cut.refined_kernel(assembly).lost_motion(&pose));
        let certifier = Certifier::new(cut.kernel(assembly));
        let certificate = exact.as_ref().map(|exact| certifier.check(&pose, exact));
        let certificate = certificate.unwrap_or(Ok(()));
        let prover = Prover::new(assembly, &kernel);
        let found = exact.as_ref().ok();
        let proof = found.map(|exact| prover.check(&pose, exact));
        let moved =
            found.and_then(|exact| accepts_moved(assembly, &certifier, &prover, &pose, exact));
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
            (Ok(_), None, Ok(())) => Verdict::Confirmed(None),
        };
        Outcome {
            exact: exact.ok(),
            verdict,
            effort: kernel.effort(&pose),
            left_to_polygons: proof.and_then(Result::err),
        }
    }
}

/// `found` with another contact on a side.
pub fn with_contact(found: &LostMotion, side: Side, contact: Option<Contact>) -> LostMotion {
    let mut found = *found;
    match side {
        Side::Right => found.right = contact,
        Side::Left => found.left = contact,
    }
    found
}

pub fn turned(contact: Contact, by: f64) -> Contact {
    let rotation = contact.rotation + by;
    Contact {
        rotation,
        ..contact
    }
}

/// `angle` without whole turns.
pub fn without_turns(angle: f64) -> f64 {
    angle - TAU * (angle / TAU).round()
}

/// A contradiction of two results: a side with one contact, or rotations apart by more than both bounds and `more` rad.
pub fn differ(one: &LostMotion, other: &LostMotion, more: f64) -> Option<String> {
    Side::BOTH.into_iter().find_map(|side| {
        let known = match (one.on(side), other.on(side)) {
            (None, None) => return None,
            (Some(one), Some(other)) => {
                let off = one.rotation - other.rotation;
                // The last term is the rounding of an angle of this many turns.
                let bound = one.error + other.error + more + 1e-14 * (off / TAU).round().abs();
                without_turns(off).abs() <= bound
            }
            _ => false,
        };
        (!known).then(|| format!("{side:?}: {one:?}\nbut {other:?}"))
    })
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
        let turns = 1.0 + pose.locked_rotation().abs() + pose.free_rotation().abs();
        // Above the polygons' resolution and rounding.
        let resolution = 400.0 * f64::EPSILON * assembly.center_distance() * turns / lever;
        let proven = 0.5 * (open - touch.closed).abs();
        let bounds = [proven, contact.error + resolution];
        for (judge, bound) in ["prover", "certificate"].into_iter().zip(bounds) {
            for by in [MOVED * bound, -MOVED * bound] {
                let contact = found.on(side.side)?;
                let moved = with_contact(found, side.side, Some(turned(contact, by)));
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

/// Both rotations of both methods must agree within the sum of their bounds, and statuses unless the difference is within the bounds. Where both report
/// a jam in the mate's body (`solid`), a tooth meets the mate several times, and the contact has no meaning.
fn judge(drawn: &Drawn, cut: &CutPair, exact: &LostMotion, polygon: &LostMotion) -> Verdict {
    let assembly = &drawn.assembly;
    let statuses = [exact, polygon].map(LostMotion::status);
    if let Some(what) = differ(exact, polygon, 0.0) {
        let one_alone = |side| exact.on(side).is_some() != polygon.on(side).is_some();
        let is_solid = statuses == [Status::Jammed; 2] && (exact.solid || polygon.solid);
        return match Side::BOTH.into_iter().any(one_alone) {
            true if loses_contact_nearby(drawn, cut) => Verdict::Confirmed(Some("contact or none")),
            false if is_solid => {
                Verdict::Confirmed(Some("a tooth in the mate's body: other contacts"))
            }
            _ => Verdict::Fault(what),
        };
    }
    Verdict::Confirmed(match statuses {
        [one, other] if one == other => None,
        // Rotations agree: lost motions of opposite sign are within the bounds of zero.
        [Status::Clear, _] | [_, Status::Clear] => Some("lost motion zero"),
        // Rotations agree, names do not.
        _ if begins_a_land(assembly, exact) || begins_a_land(assembly, polygon) => {
            Some("where a root land begins")
        }
        _ => return Verdict::Fault(format!("{statuses:?}: {exact:?}\npolygon {polygon:?}")),
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

/// Whether a method finds a side both with contact and without within the rounding of the centre distance, 1000 ulps for dozens of operations: tips
/// graze so closely that the distance as a number does not decide.
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
        let touched = |one: LostMotion| Side::BOTH.map(|side| one.on(side).is_some());
        found.into_iter().flatten().map(touched).collect()
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

/// The results of both methods, and of exact method and certificate, for a helical pose.
fn over_face(drawn: &Drawn, cut: &CutPair) -> Outcome {
    let assembly = &drawn.assembly;
    let pose = Pose::new(assembly, drawn.mating);
    let kernel = ExactKernel::new(assembly);
    let exact = kernel.lost_motion(&pose);
    let by = |method| -> PoseResult {
        let found = sweep(assembly, cut, method, &[drawn.mating], 0.0, &go_on);
        found.unwrap().remove(0)
    };
    Outcome {
        verdict: match &exact {
            Err(error) => Verdict::Unproven(format!("exact: {error}")),
            Ok(_) => judge_over_face(by(Method::Both), by(Method::Checked)),
        },
        exact: exact.ok(),
        left_to_polygons: None,
        effort: kernel.effort(&pose),
    }
}

/// Faults are a failed certificate, and methods that differ by more than both bounds or in status. If effort ends a method, the pose is unproven.
fn judge_over_face(both: PoseResult, certified: PoseResult) -> Verdict {
    if let Err(unproven) = certified.found {
        let reason = format!("certificate: {}", unproven.reason);
        return match reason.contains("effort") {
            true => Verdict::Unproven(reason),
            false => Verdict::Fault(reason),
        };
    }
    match both.found {
        Ok(_) => Verdict::Confirmed(None),
        Err(unproven) if unproven.reason.starts_with("the exact") => {
            Verdict::Fault(unproven.reason)
        }
        Err(unproven) => Verdict::Unproven(unproven.reason),
    }
}
