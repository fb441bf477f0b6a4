//! The far flank of a locked tooth: the part past the far corner of its tip land, which a half tooth lacks.
//!
//! A free half tooth closes against the locked half tooth that it faces. It can close against that tooth's far flank instead, beside the tip
//! land: in gears of three or four teeth, and with its own tip on a tooth that points sideways ([`FarFlanks`]). The far flank is the mirror
//! image of the near one, turned so that its tip corner is the far corner.

use super::branch::arcs;
use super::candidate::CandidateContact;
use super::corner::{least_flank_radius, tip_arm};
use super::curves::SearchExhausted;
use super::flank_problem::PosedFlanks;
use super::placed::PlacedHalf;
use super::search::{SideFound, SideRequest};
use super::shape::C;
use super::tightest::FirstContact;
use crate::contact::body::FarFlanks;
use crate::contact::gap::{
    CurveContact, CurvePoint, LEAST_LEVEL, MOST_NODES, OpenPairs, PlacedCurve, common_normal,
    greatest, turn,
};
use crate::gear::ProfilePart;

/// Parts of a far half tooth that can touch. Its tip land belongs to the near half tooth, too.
const FAR_PARTS: [ProfilePart; 2] = [ProfilePart::Involute, ProfilePart::Fillet];

/// Parts of the free half tooth that touch a far one. In a jam, the far flank meets a root land. With three teeth it also meets the far corner
/// of a tip land.
const FREE_PARTS: [ProfilePart; 4] = [
    ProfilePart::Tip,
    ProfilePart::Involute,
    ProfilePart::Fillet,
    ProfilePart::Root,
];

/// The first contact: `found`, or a contact on the far flank of a locked tooth that comes before it.
#[inline]
pub(super) fn with_far_flanks(
    posed: &PosedFlanks,
    far_flanks: FarFlanks,
    found: Option<FirstContact>,
    request: SideRequest,
) -> SideFound {
    let Some(mut tightest) = found.filter(|_| far_flanks != FarFlanks::Clear) else {
        return Ok(found);
    };
    for step in posed.steps_of_whole_teeth() {
        if far_flanks == FarFlanks::BesideTips && !is_sideways(posed, step) {
            continue;
        }
        let floor = (tightest.greatest + posed.problem.tie).max(request.floor);
        if let Some(candidate) =
            far_contact(posed, step, (floor, tightest.candidate.normal), request)
                .map_err(|lost| (step, lost))?
        {
            tightest = FirstContact {
                step,
                greatest: candidate.gap,
                candidate,
            };
        }
    }
    Ok(Some(tightest))
}

/// Whether a normal of the step's far locked flank passes the free axis on its far side, and the free gear reaches that flank. The flank is
/// nearest to the axis where it turns back, or at its end.
pub(super) fn is_sideways(posed: &PosedFlanks, step: i64) -> bool {
    let locked = posed.locked(step);
    let mirrored = PlacedHalf {
        centre: locked.centre.conj(),
        direction: locked.far_direction().conj(),
        ..locked
    };
    let free = &posed.problem.free;
    let reach = free.shape.tip_radius + posed.problem.free_off.norm();
    // Less by a rounding: a flank that is nearly reached is also examined.
    tip_arm(&mirrored) <= 0.0 && least_flank_radius(&mirrored) * (1.0 - 1e-9) <= reach
}

/// The greatest gap of a step's free half tooth and the locked tooth's far half, if it exceeds `floor`. Curves without
/// a common radius have no gap, and those that a line with the unit `normal` divides at `floor` no greater one.
pub(super) fn far_contact(
    posed: &PosedFlanks,
    step: i64,
    (floor, normal): (f64, C),
    request: SideRequest,
) -> Result<Option<CandidateContact>, SearchExhausted> {
    let (locked, free) = (posed.locked(step), posed.free(step));
    let shape = locked.shape;
    let direction = locked.far_direction();
    let far = |part| PlacedCurve {
        mirrored: true,
        direction,
        ..locked.curve(part)
    };
    let origin = posed.origin_of(step);
    let [room, square_room] = locked.rounding(&free);
    let turned = origin.direction.conj() * turn(floor);
    // Further below, a gap could count as one a turn above.
    let is_known = floor - origin.about >= LEAST_LEVEL;
    let mates = FREE_PARTS.map(|part| (part, free.around(part)));
    let mut open = OpenPairs::default();
    for (part, own) in FAR_PARTS.into_iter().zip(shape.around()) {
        let around = own.mirrored().placed(locked.centre, direction);
        let mates = mates.iter().filter(|(_, mate)| {
            around.meets(mate, square_room)
                && !(is_known && around.is_behind(mate, turned, normal, room))
        });
        let mates = mates.flat_map(|&(mate, _)| arcs(free.curve(mate), mate, free.range(mate)));
        open.add_all(arcs(far(part), part, shape.range(part)), mates);
    }
    let most = request.effort.left().min(MOST_NODES as u64) as usize;
    let mut left = most;
    let part = |name: usize| ProfilePart::ALL[name];
    let found = greatest(&mut open, origin, floor, &mut left);
    request.effort.spend((most - left) as u64);
    let found: Option<CurveContact> =
        found.map_err(|(locked, free)| SearchExhausted(part(locked), part(free)))?;
    Ok(found.map(|found| {
        let on_locked = (part(found.locked.0), found.locked.1);
        let on_free = (part(found.free.0), found.free.1);
        let p: CurvePoint = far(on_locked.0).at(on_locked.1);
        let q = free.at(on_free.0, on_free.1);
        let turned = p.point * q.point.conj();
        let corners = [shape.is_corner(on_locked), free.is_corner(on_free)];
        let opposite = || -q.normal * turned / turned.norm();
        let (normal, slope) = common_normal(&p, &q, corners, opposite);
        CandidateContact {
            gap: origin.gap(turned),
            slack: found.slack,
            slope,
            locked: on_locked,
            free: on_free,
            point: p.point,
            normal,
        }
    }))
}
