//! Whether a reported pair of contacts is right.

use super::Referee;
use super::whole::{overlap, overlap_everywhere};
use gearlash::contact::{LostMotion, Status};
use gearlash::gear::Side;
use gearlash::pair::{GearPair, Member, Pose};

/// Pitches of the free gear to examine on the open side of a contact, and on either side without one. Deviations and
/// eccentricities of a third of a pitch are included; anything further from the nominal rotation faces other teeth.
const PITCHES: f64 = 1.5;

/// Contradictions to `found`: overlap where a contact is more open by its bound or further, none where it is more closed, and a contact not claimed;
/// metal in metal in the middle of a clear pose, or a solid pose free at some rotation. A tip over the mate's axis must jam.
pub fn against(assembly: &GearPair, pose: &Pose, found: &LostMotion) -> Vec<String> {
    let reach = |member: Member| {
        assembly.gear(member).reach() + assembly.gear(member.mate()).eccentricity()
    };
    if reach(Member::Wheel).max(reach(Member::Pinion)) >= assembly.center_distance() {
        // The mate's shaft blocks it, which is in neither outline.
        return match found.status() {
            Status::Jammed => vec![],
            _ => vec!["a tip reaches over the mate's axis, yet it is not jammed".to_owned()],
        };
    }
    if found.solid && !overlap_everywhere(assembly, pose) {
        return vec!["called solid, but free at some rotation".to_owned()];
    }
    let mut complaints = Vec::new();
    for side in Side::BOTH {
        let referee = Referee::new(assembly, pose, side);
        let name = side.name();
        let rounding = referee.rounding(pose);
        let Some(contact) = found.on(side) else {
            let own = referee.contact(pose.free_rotation(), PITCHES);
            // By less than rounding: tips that graze.
            if let Some(own) = own.filter(|own| referee.deepest(*own) < -rounding) {
                complaints.push(format!("{name}: none claimed, there is one at {own}"));
            }
            continue;
        };
        let at = |more_open: f64| contact.rotation + referee.opening() * more_open;
        let over = |more_open: f64| referee.least(at(more_open)) < -rounding;
        let early = over(contact.error) || referee.open_steps(contact.error, PITCHES).any(over);
        // With a wide bound the closed end can be past all contacts; some rotation within it must overlap.
        let within = (0..40).map(|k| -contact.error * 0.5f64.powi(k));
        let mut within = within.chain([0.0]);
        let late = within.all(|more_open| referee.least(at(more_open)) > rounding);
        if early || late {
            let what = if early {
                "overlap before"
            } else {
                "nothing touches at"
            };
            complaints.push(format!("{name}: {what} {contact:?}"));
        }
    }
    if found.status() == Status::Clear {
        complaints.extend(in_the_middle(assembly, pose, found));
    }
    complaints
}

/// The overlap in the middle of a clear pose's lost motion, if any.
fn in_the_middle(assembly: &GearPair, pose: &Pose, found: &LostMotion) -> Option<String> {
    let (right, left) = found.right.zip(found.left)?;
    let middle = 0.5 * (right.rotation + left.rotation);
    let deep = overlap(assembly, pose, middle);
    let rounding = Referee::new(assembly, pose, Side::Right).rounding(pose);
    let known = (right.error + left.error) * assembly.gear(assembly.free()).reach();
    (deep > rounding + known).then(|| format!("clear, but {deep:.2e} mm overlap in the middle"))
}
