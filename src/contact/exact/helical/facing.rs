//! Whether a pair of teeth has to be looked at.
//!
//! All teeth that pass the line of centres along the face have places to look at, a dozen each, and next to none of them is the tightest. So the pair
//! of teeth that a place belongs to is asked first: whether it is tighter there than what is known, whether a root land is near enough to jam, or
//! whether its tip stands in the body of the mate. The centres of sections do not wind, so that both teeth are those of the measuring plane, wound.

use super::turning::{Place, Turning};
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

/// What is known of a pose: what a pair of teeth has to come to more.
#[derive(Debug, Clone, Copy)]
pub(super) struct Floors {
    /// The gap, rad, above which it touches first.
    pub tighter: f64,
    /// The gap, rad, above which it may jam in its section, if a root land touches.
    pub jams: f64,
    /// The distance from the free axis, mm, within which a tip stands in the body of the free gear.
    pub solid: f64,
}

/// The teeth of a pose, which wind along the face.
pub(super) struct Facing<'a> {
    posed: &'a PosedFlanks<'a>,
    /// Of the locked and of the free gear, rad a mm, in the frame of `posed`.
    twists: [f64; 2],
    /// The pairs of curves that are asked about, but roots.
    curves: Curves,
}

impl<'a> Facing<'a> {
    /// The teeth of `posed`; both involutes are asked about where pairs touch on the line of action between sections only, or nowhere (`short`):
    /// else they are tightest in sections that are looked at anyway.
    pub fn new(assembly: &GearPair, posed: &'a PosedFlanks<'a>, short: bool) -> Facing<'a> {
        let all = if short {
            Curves::ALL
        } else {
            Curves::ALL.without(ProfilePart::Involute, ProfilePart::Involute)
        };
        Facing {
            posed,
            twists: [assembly.locked(), assembly.free()]
                .map(|member| Turning::twist(assembly, posed, member)),
            curves: all.but(Curves::of(ProfilePart::Root)),
        }
    }

    /// Whether the pair of teeth there may change what is known: tighten it, or jam.
    pub fn may_hold(&self, at: &Place, floors: Floors, effort: &Effort) -> bool {
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
        // Wound on by so much, the free tooth faces the mate at a gap of so much less.
        let origin = Origin {
            about: here.about - self.twists[1] * at.b,
            ..here
        };
        let roots = Curves::of(ProfilePart::Root);
        let curves = self.curves.among(at.curves);
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
    // What is not settled is looked at.
    found.map_or(true, |found| found.is_some())
}
