//! Whether the pair of teeth at a place needs to be examined.
//!
//! Every pair of teeth that passes the line of centres along the face has about a dozen places, and almost none of them is the tightest. So
//! a cheap test comes first: is the pair tighter than the known contact, is a root land near enough to jam, or is its tip in the body of
//! the mate? The centres of sections are constant along the face, so both teeth are those of the measuring plane, twisted.

use super::turning::Place;
use crate::contact::Effort;
use crate::contact::exact::branch::search;
use crate::contact::exact::candidate::CandidateContact;
use crate::contact::exact::curves::{CurvePairs, SearchExhausted};
use crate::contact::exact::flank_problem::PosedFlanks;
use crate::contact::exact::lands::{land_on_land, without_lands};
use crate::contact::exact::placed::PlacedHalf;
use crate::contact::exact::shape::turn;
use crate::contact::gap::{MOST_NODES, Origin};
use crate::gear::ProfilePart;
use crate::pair::GearPair;

/// The limits that a pair of teeth has to exceed at a pose.
#[derive(Debug, Clone, Copy)]
pub(super) struct GapLimits {
    /// The gap, rad, above which the pair touches first.
    pub tighter: f64,
    /// The gap, rad, above which the pair can jam in its section if a root land touches.
    pub jams: f64,
    /// The distance from the free axis, mm, within which a tip is in the body of the free gear.
    pub solid: f64,
}

/// Tells which places of the face need to be examined at a pose.
pub(super) struct PlaceFilter<'a> {
    posed: &'a PosedFlanks<'a>,
    /// Twist of the locked and the free gear in the frame of `posed`, rad/mm.
    twists: [f64; 2],
    /// The pairs of curves to examine, except roots.
    curves: CurvePairs,
}

impl<'a> PlaceFilter<'a> {
    /// The teeth of `posed`. Pairs of involutes are included only if line contact may be confined to the space between
    /// sections or absent (`short`); otherwise they are tightest in sections that are examined anyway.
    pub fn new(assembly: &GearPair, posed: &'a PosedFlanks<'a>, short: bool) -> PlaceFilter<'a> {
        let all = if short {
            CurvePairs::ALL
        } else {
            CurvePairs::ALL.without(ProfilePart::Involute, ProfilePart::Involute)
        };
        PlaceFilter {
            posed,
            twists: [assembly.locked(), assembly.free()]
                .map(|member| posed.twist(assembly, member)),
            curves: all.except(CurvePairs::of(ProfilePart::Root)),
        }
    }

    /// Whether the pair of teeth at this place can be tighter than the known contact, or jam.
    pub fn may_be_tighter_or_jam(&self, at: &Place, floors: GapLimits, effort: &Effort) -> bool {
        let turns = self.twists.map(|twist| twist * at.b);
        let teeth = TurnedTeeth::new(self.posed, at.step, turns);
        effort.spend(1);
        if teeth.locked.least_land_radius() < floors.solid {
            return true;
        }
        let roots = CurvePairs::of(ProfilePart::Root);
        let curves = self.curves.intersection(at.curves);
        [(roots, floors.jams), (curves, floors.tighter)]
            .into_iter()
            .any(|(curves, floor)| teeth.may_be_tighter(curves, floor, effort))
    }
}

/// A locked and a free half tooth, turned about the centres of their outlines.
pub(super) struct TurnedTeeth<'a> {
    locked: PlacedHalf<'a>,
    free: PlacedHalf<'a>,
    origin: Origin,
}

impl<'a> TurnedTeeth<'a> {
    /// The teeth of a step of `posed`, turned by `turns`, rad.
    pub fn new(posed: &PosedFlanks<'a>, step: i64, turns: [f64; 2]) -> TurnedTeeth<'a> {
        let turned = |placed: PlacedHalf<'a>, by: f64| PlacedHalf {
            direction: placed.direction * turn(by),
            ..placed
        };
        let origin = posed.origin_of(step);
        TurnedTeeth {
            locked: turned(posed.locked(step), turns[0]),
            free: PlacedHalf {
                centre: posed.free_centre * posed.origin,
                ..turned(posed.free(step), turns[1])
            },
            // A turn of the free tooth reduces the gap at which it faces the mate.
            origin: Origin {
                about: origin.about - turns[1],
                ..origin
            },
        }
    }

    /// Whether a gap of `curves` may exceed `floor`, rad.
    fn may_be_tighter(&self, curves: CurvePairs, floor: f64, effort: &Effort) -> bool {
        let on_lands = land_on_land(&self.locked, &self.free, self.origin, curves);
        if on_lands.is_some_and(|candidate| candidate.gap > floor) {
            return true;
        }
        // An undecided pair is examined.
        let found = self.search(without_lands(curves), floor, effort);
        found.map_or(true, |found| found.is_some())
    }

    /// The tightest contact in which a fillet takes part, if its gap exceeds `floor`, rad. An undecided one is left out.
    pub fn in_fillets(&self, floor: f64, effort: &Effort) -> Option<CandidateContact> {
        let roots = CurvePairs::of(ProfilePart::Root);
        let curves = CurvePairs::of(ProfilePart::Fillet).except(roots);
        self.search(curves, floor, effort).ok().flatten()
    }

    fn search(
        &self,
        curves: CurvePairs,
        floor: f64,
        effort: &Effort,
    ) -> Result<Option<CandidateContact>, SearchExhausted> {
        let most = effort.left().min(MOST_NODES as u64) as usize;
        let mut left = most;
        let found = search(
            &self.locked,
            &self.free,
            self.origin,
            floor,
            curves,
            &mut left,
        );
        effort.spend((most - left) as u64);
        found
    }
}
