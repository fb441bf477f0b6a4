//! Whether a contact is where it is reported: on its curves and teeth, with its normal across both.

use super::half::{Ends, Half};
use super::stood::Frame;
use super::{Referee, Stood};
use gearlash::contact::{Contact, LostMotion, ToothPlace, Touch};
use gearlash::gear::{ProfilePart, Side};
use gearlash::pair::{GearPair, Member, Pose};
use nalgebra::Point2;
use std::rc::Rc;

/// Step off a curve that shows the direction of its normal, in modules.
const STEP: f64 = 1e-6;

/// A half tooth that a contact names.
struct Named {
    frame: Frame,
    half: Rc<Half>,
    ends: Ends,
}

impl Named {
    fn clearance(&self, point: Point2<f64>) -> f64 {
        let [x, y] = self.frame.seen([point.x, point.y]);
        self.half.clearance(x, y, self.ends).mm
    }
}

/// Contradictions in the teeth, curves, radii, points and normals of `found`.
pub fn named(assembly: &GearPair, pose: &Pose, found: &LostMotion) -> Vec<String> {
    let contacts = Side::BOTH.map(|side| Some((side, found.on(side)?)));
    let contacts = contacts.into_iter().flatten();
    let each = contacts.flat_map(|(side, contact)| of_side(assembly, pose, side, &contact));
    each.collect()
}

fn of_side(assembly: &GearPair, pose: &Pose, side: Side, contact: &Contact) -> Vec<String> {
    let rounding = Referee::new(assembly, pose, side).rounding(pose);
    let known = rounding + contact.error * assembly.gear(assembly.free()).reach();
    let module = assembly.gear(Member::Wheel).gear().basic_data().module();
    let step = (STEP * module).max(100.0 * known);
    let mut complaints = Vec::new();
    let mut slopes = Vec::new();
    for (member, touch, out) in [
        (Member::Wheel, contact.wheel, contact.normal),
        (Member::Pinion, contact.pinion, -contact.normal),
    ] {
        let stood = Stood::new(assembly, member);
        let rotation = match member == assembly.locked() {
            true => pose.locked_rotation(),
            false => contact.rotation,
        };
        let named = Named {
            frame: stood.frame(rotation, side, touch.tooth),
            half: stood.half(side, touch.tooth),
            ends: stood.ends(side, touch.tooth),
        };
        let mut complain = |what: &str, mm: f64| {
            complaints.push(format!("{side:?} {member:?}: {what}, {mm:.2e} mm"));
        };
        let off = named.clearance(contact.point);
        if !(off.abs() <= known) {
            complain("the point is off the half tooth named", off);
        }
        let [x, y] = named.frame.seen([contact.point.x, contact.point.y]);
        let off = x.hypot(y) - touch.radius;
        if !(off.abs() <= known) {
            complain("the radius is not that of the point", off);
        }
        let (tip, form, root) = (named.half.tip, named.half.form, named.half.root);
        let [low, high] = match touch.curve {
            ToothPlace::Tip => [tip, tip],
            ToothPlace::Involute => [form, tip],
            ToothPlace::Fillet => [root, form],
            ToothPlace::Root => [root, root],
            ToothPlace::Flank => [root, tip],
        };
        let off = (low - touch.radius).max(touch.radius - high);
        if !(off <= known) {
            complain("the curve named does not go there", off);
        }
        let [beyond, within] =
            [step, -step].map(|step| named.clearance(contact.point + out * step));
        if !(beyond >= -0.01 * step - known) {
            complain("the normal points into the metal", beyond);
        }
        slopes.push((beyond - within) / (2.0 * step));
    }
    // At a corner the normal is that of the curve it touches, so it belongs to one of both curves.
    let corner =
        |touch: &Touch| touch.curve == ProfilePart::Tip || touch.curve == ProfilePart::Root;
    let corners = corner(&contact.wheel) && corner(&contact.pinion);
    if !corners && !slopes.iter().any(|slope| (slope - 1.0).abs() <= 0.02) {
        complaints.push(format!("{side:?}: a normal of neither curve, {slopes:?}"));
    }
    if (contact.normal.norm() - 1.0).abs() > 1e-9 {
        complaints.push(format!("{side:?}: no unit normal"));
    }
    complaints
}
