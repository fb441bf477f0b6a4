//! Whether a claimed pair of contacts holds.

use super::Referee;
use super::whole::{overlap, overlap_everywhere};
use gearlash::contact::{LostMotion, Status};
use gearlash::gear::Side;
use gearlash::pair::{GearPair, Member, Pose};
use std::f64::consts::TAU;

/// Pitches of the free gear looked at on the open side of a contact, and on either side where none is claimed: what is
/// farther from the nominal rotation, deviations and eccentricities of a third of a pitch and all, faces other teeth.
const PITCHES: f64 = 1.5;

/// Brute force's own contacts, right and left.
pub fn contacts(assembly: &GearPair, pose: &Pose) -> [Option<f64>; 2] {
    Side::BOTH.map(|side| Referee::new(assembly, pose, side).contact(pose.free_rotation(), PITCHES))
}

/// What speaks against `found`, empty when nothing does.
///
/// At a rotation more open than claimed by the error bound nothing may overlap by more than rounding, nor farther open; as
/// much more closed something must, or be as near as rounding. Where no contact is claimed there must be none. In the
/// middle of the lost motion of a clear pose no metal stands in the other gear's. Of a pose called solid metal must
/// stand in metal wherever the free gear is turned. Where a tip reaches over the mate's axis every pose must be jammed.
pub fn against(assembly: &GearPair, pose: &Pose, found: &LostMotion) -> Vec<String> {
    let reach = |member: Member| {
        assembly.gear(member).reach() + assembly.gear(member.mate()).eccentricity()
    };
    if reach(Member::Wheel).max(reach(Member::Pinion)) >= assembly.center_distance() {
        // The mate's shaft, which is in neither outline, stands in the way.
        return match found.status() {
            Status::Jammed => vec![],
            _ => vec!["a tip reaches over the mate's axis, yet it is not jammed".to_owned()],
        };
    }
    if found.solid && !overlap_everywhere(assembly, pose) {
        return vec!["called solid, but free at some rotation".to_owned()];
    }
    let um = assembly.operating_pitch_radius(assembly.free()) * 1e3;
    let mut complaints = Vec::new();
    for (side, contact) in [(Side::Right, found.right), (Side::Left, found.left)] {
        let referee = Referee::new(assembly, pose, side);
        let name = side.name();
        let rounding = referee.rounding(pose);
        let Some(contact) = contact else {
            if let Some(own) = referee.contact(pose.free_rotation(), PITCHES) {
                // By less than rounding: tips that graze.
                if referee.deepest(own) < -rounding {
                    complaints.push(format!("{name}: none claimed, there is one at {own}"));
                }
            }
            continue;
        };
        let at = |more_open: f64| contact.rotation + referee.opening() * more_open;
        let over = |more_open: f64| referee.least(at(more_open)) < -rounding;
        let early = over(contact.error) || referee.open_steps(contact.error, PITCHES).any(over);
        // Of a wide bound the closed end may lie beyond all that touches: somewhere within it must.
        let within = (0..40).map(|k| -contact.error * 0.5f64.powi(k));
        let late = within
            .chain([0.0])
            .all(|more_open| referee.least(at(more_open)) > rounding);
        if !early && !late {
            continue;
        }
        let own = referee.contact(pose.free_rotation(), PITCHES);
        let off = own.map(|own| {
            let turn = contact.rotation - own;
            referee.opening() * (turn - TAU * (turn / TAU).round()) * um
        });
        let what = if early {
            "overlap before it"
        } else {
            "nothing touches there"
        };
        complaints.push(format!(
            "{name}: {what}; claimed {:.9} rad, {off:?} µm more open than brute force, bound {:.2e} µm, clearance there {:.2e} mm",
            contact.rotation,
            contact.error * um,
            referee.least(contact.rotation),
        ));
    }
    if found.status() == Status::Clear {
        complaints.extend(in_the_middle(assembly, pose, found));
    }
    complaints
}

/// What stands in the way in the middle of a clear pose's lost motion.
fn in_the_middle(assembly: &GearPair, pose: &Pose, found: &LostMotion) -> Option<String> {
    let (right, left) = found.right.zip(found.left)?;
    let middle = 0.5 * (right.rotation + left.rotation);
    let deep = overlap(assembly, pose, middle);
    let rounding = Referee::new(assembly, pose, Side::Right).rounding(pose);
    let known = (right.error + left.error) * assembly.gear(assembly.free()).reach();
    (deep > rounding + known).then(|| format!("clear, but {deep:.2e} mm overlap in the middle"))
}
