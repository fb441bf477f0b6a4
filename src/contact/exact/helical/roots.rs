//! Places along the face where the tip of a tooth can reach its mate's root.
//!
//! Tips are deepest on the line of centres. The root of an eccentric free gear approaches a tip land as the gear turns. Where both circles
//! touch, the contact is equally tight over the stretch on which both lands are on the line of centres. An end of a land bounds that
//! stretch on either side. Outside it an end of the tip land touches, later with growing distance from that line, until the root land ends.

use super::turning::{Edge, FreeGear, Place, TwistedTeeth, crossing_places};
use crate::contact::Effort;
use crate::contact::exact::curves::CurvePairs;
use crate::contact::exact::flank_problem::PosedFlanks;
use crate::gear::ProfilePart;
use crate::pair::GearPair;

/// Adds the places on the face where the tip of a tooth can reach the mate's root. They are where both lands end
/// together, if the free gear can turn there, and where the tip or root of a pair is on the line of centres.
pub(super) fn tips_on_roots(
    (assembly, posed): (&GearPair, &PosedFlanks),
    teeth: &[TwistedTeeth; 2],
    stands: FreeGear,
    (places, effort): (&mut Vec<Place>, &Effort),
) {
    let (locked, free) = (&posed.problem.locked.shape, &posed.problem.free.shape);
    let ends = tip_ends(posed);
    let middles = [locked, free].map(|shape| Edge::middle(shape));
    let roots = [
        Edge::root_end(locked, |step| posed.locked(step)),
        Edge::root_end(free, |step| posed.free(step)),
    ];
    // Contacts on the mate's flank are tightest elsewhere. While nothing stops the free gear, any curve may touch here.
    let curves = if stands.is_held {
        CurvePairs::of(ProfilePart::Tip).intersection(CurvePairs::of(ProfilePart::Fillet))
    } else {
        CurvePairs::ALL
    };
    let deep = |place: Place| Place { curves, ..place };
    let tips_at = |which: usize, teeth: &TwistedTeeth, direction: f64, places: &mut Vec<Place>| {
        for tip in ends[which].iter().chain([&middles[which]]) {
            places.extend(teeth.places(tip, direction).map(deep));
        }
    };
    for which in 0..2 {
        let root = &roots[1 - which];
        for tip in &ends[which] {
            let edges = if which == 0 { [tip, root] } else { [root, tip] };
            crossing_places(posed, teeth, edges, stands, (places, effort));
        }
        let first_contact = tangent_rotations(posed, middles[which].radius + root.radius);
        let rotations = std::iter::once(stands.rotation).chain(first_contact.into_iter().flatten());
        for rotation in rotations {
            let between = posed.free_centre_at(rotation) - posed.centre;
            let teeth = [
                TwistedTeeth::locked(assembly, posed),
                TwistedTeeth::free(assembly, posed, rotation),
            ];
            let towards = [between.arg(), (-between).arg()];
            tips_at(which, &teeth[which], towards[which], places);
            let root = teeth[1 - which].places(root, towards[1 - which]);
            places.extend(root.map(deep));
        }
    }
    // The free gear is solid about its axis at every rotation; the centre of its outline is elsewhere.
    let off = posed.problem.free_off.norm();
    if off > 0.0 && posed.centre.norm() - locked.tip_radius < free.root_radius - off {
        tips_at(0, &teeth[0], (-posed.centre).arg(), places);
    }
}

/// Both ends of the tip lands of the locked and the free gear.
pub(super) fn tip_ends<'a>(posed: &'a PosedFlanks<'a>) -> [[Edge<'a>; 2]; 2] {
    let (locked, free) = (&posed.problem.locked.shape, &posed.problem.free.shape);
    [
        [
            Edge::corner(locked.tip_corner()),
            Edge::far(locked, |step| posed.locked(step)),
        ],
        [
            Edge::corner(free.tip_corner()),
            Edge::far(free, |step| posed.free(step)),
        ],
    ]
}

/// Rotations of the free gear at which circles about both outline centres touch; `sum` is the sum of their radii. See
/// [`super::super::lands`].
pub(super) fn tangent_rotations(posed: &PosedFlanks, sum: f64) -> Option<[f64; 2]> {
    let (locked, free) = (posed.centre, posed.problem.free_off);
    let (far, off) = (locked.norm(), free.norm());
    let cos = ((far - sum) * (far + sum) + off * off) / (2.0 * far * off);
    let beside = (cos.abs() <= 1.0).then(|| cos.acos())?;
    let towards = (locked * free.conj()).arg();
    Some([towards + beside, towards - beside])
}
