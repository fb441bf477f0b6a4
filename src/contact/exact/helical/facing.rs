//! Whether the pair of teeth at a place needs to be examined.
//!
//! Every pair of teeth that passes the line of centres along the face has about a dozen places, and almost none of them is the tightest. So
//! a cheap test comes first: is the pair tighter than the known contact, is a root land near enough to jam, or is its tip in the body of
//! the mate? The centres of sections are constant along the face, so both teeth are those of the measuring plane, twisted.

use super::turning::Place;
use crate::contact::Effort;
use crate::contact::exact::branch::search;
use crate::contact::exact::curves::Curves;
use crate::contact::exact::flank_problem::PosedFlanks;
use crate::contact::exact::lands::{land_on_land, without_lands};
use crate::contact::exact::placed::Placed;
use crate::contact::exact::shape::turn;
use crate::contact::gap::{MOST_NODES, Origin};
use crate::gear::ProfilePart;
use crate::pair::GearPair;

/// The limits that a pair of teeth has to exceed at a pose.
#[derive(Debug, Clone, Copy)]
pub(super) struct Floors {
    /// The gap, rad, above which the pair touches first.
    pub tighter: f64,
    /// The gap, rad, above which the pair can jam in its section if a root land touches.
    pub jams: f64,
    /// The distance from the free axis, mm, within which a tip is in the body of the free gear.
    pub solid: f64,
}

/// The teeth of a pose, twisted along the face.
pub(super) struct Facing<'a> {
    posed: &'a PosedFlanks<'a>,
    /// Twist of the locked and the free gear in the frame of `posed`, rad/mm.
    twists: [f64; 2],
    /// The pairs of curves to examine, except roots.
    curves: Curves,
}

impl<'a> Facing<'a> {
    /// The teeth of `posed`. Pairs of involutes are included only if line contact may be confined to the space between
    /// sections or absent (`short`); otherwise they are tightest in sections that are examined anyway.
    pub fn new(assembly: &GearPair, posed: &'a PosedFlanks<'a>, short: bool) -> Facing<'a> {
        let all = if short {
            Curves::ALL
        } else {
            Curves::ALL.without(ProfilePart::Involute, ProfilePart::Involute)
        };
        Facing {
            posed,
            twists: [assembly.locked(), assembly.free()]
                .map(|member| posed.twist(assembly, member)),
            curves: all.except(Curves::of(ProfilePart::Root)),
        }
    }

    /// Whether the pair of teeth at this place can be tighter than the known contact, or jam.
    pub fn may_be_tighter_or_jam(&self, at: &Place, floors: Floors, effort: &Effort) -> bool {
        let wound = |placed: Placed<'a>, twist: f64| Placed {
            direction: placed.direction * turn(twist * at.b),
            ..placed
        };
        let locked = wound(self.posed.locked(at.step), self.twists[0]);
        let free = wound(self.posed.free(at.step), self.twists[1]);
        effort.spend(1);
        if locked.least_land_radius() < floors.solid {
            return true;
        }
        let here = self.posed.origin_of(at.step);
        // Twist of the free tooth reduces the gap at which it faces the mate.
        let origin = Origin {
            about: here.about - self.twists[1] * at.b,
            ..here
        };
        let roots = Curves::of(ProfilePart::Root);
        let curves = self.curves.intersection(at.curves);
        [(roots, floors.jams), (curves, floors.tighter)]
            .into_iter()
            .any(|(curves, floor)| is_tighter([&locked, &free], origin, curves, floor, effort))
    }
}

/// Whether a gap of `curves` may exceed `floor`, rad.
fn is_tighter(
    [locked, free]: [&Placed; 2],
    origin: Origin,
    curves: Curves,
    floor: f64,
    effort: &Effort,
) -> bool {
    let on_lands = land_on_land(locked, free, origin, curves);
    if on_lands.is_some_and(|candidate| candidate.gap > floor) {
        return true;
    }
    let most = effort.left().min(MOST_NODES as u64) as usize;
    let mut left = most;
    let curves = without_lands(curves);
    let found = search(locked, free, origin, floor, curves, &mut left);
    effort.spend((most - left) as u64);
    // An undecided pair is examined.
    found.map_or(true, |found| found.is_some())
}
