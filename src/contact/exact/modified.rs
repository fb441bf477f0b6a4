//! The quick method for flanks whose profiles deviate.
//!
//! [`super::search_free_proof`] holds for any convex flanks with given normals and curvatures: their gap is greatest at a common normal or
//! at a tip corner. Every half tooth lies within that of an *outer* gear. An outer gear has no profile deviations, but each flank is turned
//! out by its greatest deviation. At any radius the gap of two half teeth is at most that of the outer ones. So:
//!
//! 1. The method takes pairs in the order of their outer gaps on the line of action, until the outer gap is below a gap
//!    already found.
//! 2. Convex flanks touch at a common normal or at a tip corner ([`flanks`]). If that fails, or flanks are not convex (as
//!    measured ones), bounds of their deviation settle the contact ([`heights`]). If those fail, a search over all pairs of
//!    their pieces does ([`pieces`]).
//! 3. With the free gear at the gap found, no tip corner of the outer gears may be inside the outer mate, enlarged by the
//!    variation of the deviations. The only exception is the mate's flank, in a pair settled by 1. and 2.
//!
//! A pose that stays open is searched, as are all poses of undercut gears. If the outer gears touch where nothing
//! deviates from them, their contact is the result: a relief outside the path of contact changes nothing.

mod flanks;
mod heights;
pub(super) mod pieces;

use super::branch::search as search_pair;
use super::candidate::CandidateContact;
use super::direct::{AtRotation, DirectSolver, Envelopes, far_corner_reaches};
use super::flank_problem::{FlankProblem, PosedFlanks};
use super::lands::{land_on_land, without_lands};
use super::path::{InvolutePair, settle, start_line, steps_on};
use super::placed::{PlacedHalf, Role};
use super::search::{self, SideFound, SideRequest};
use super::shape::{C, HalfToothShape};
use super::tightest::{FirstContact, TightestContacts};
use crate::contact::Effort;
use crate::contact::gap::MOST_NODES;
use crate::gear::{ProfilePart, Side};
use crate::numeric::rank;
use crate::pair::{GearPair, Member};
use flanks::{flank_contact, rises};
use heights::greatest_gap_by_heights;
use pieces::greatest_gap_of_flanks;

/// Limit of pairs on the line of action at once: a contact ratio of eight.
const MOST_PAIRS: usize = 8;

/// The data of the quick method besides the teeth of the gears.
#[derive(Debug, Clone)]
pub(super) struct OuterGears {
    pair: GearPair,
    right: FlankProblem,
    left: FlankProblem,
    solver: DirectSolver,
    /// Whether every flank is on one side of each of its tangents.
    is_convex: bool,
    /// Variation of the deviations of a flank, mm.
    range: f64,
    /// Whether deviations only remove metal. Then the outer gears are those without deviations.
    is_cut_back: bool,
}

/// A pair of outer flanks on the line of action: its step, gap and rolls.
#[derive(Debug, Clone, Copy)]
struct OuterPair {
    step: i64,
    gap: f64,
    rolls: (f64, f64),
}

/// The gears that enclose those of `assembly`, and the greatest variation of the deviations of a flank, mm. `None` for teeth that cannot be built.
fn enclosing(assembly: &GearPair) -> Option<(GearPair, f64)> {
    let of = |member: Member| assembly.gear(member).enclosing([0.0; 2]).ok();
    let ([wheel, _], one) = of(Member::Wheel)?;
    let ([pinion, _], other) = of(Member::Pinion)?;
    let distance = assembly.center_distance();
    let pair = GearPair::with_locked(wheel, pinion, distance, assembly.locked()).ok()?;
    Some((pair, one.max(other)))
}

impl OuterGears {
    /// The outer gears of `assembly`; `None` if their flanks need a search themselves.
    pub fn new(assembly: &GearPair, problems: &[FlankProblem; 2]) -> Option<OuterGears> {
        let gears = Member::BOTH.map(|member| assembly.gear(member));
        // Straight flanks have no outer gear, and without deviations none is needed. The corner of an undercut joint is not covered here.
        let undercut = gears.iter().any(|gear| gear.gear().is_undercut());
        if undercut || gears.iter().all(|gear| !gear.is_modified()) {
            return None;
        }
        let convex =
            |problem: &FlankProblem| problem.locked.is_convex() && problem.free.is_convex();
        let (pair, range) = enclosing(assembly)?;
        let [right, left] = Side::BOTH.map(|side| FlankProblem::new(&pair, side));
        // The points of both gears move by this.
        let envelopes = Envelopes::new(&right, &pair, 4.0 * range);
        let solver = OuterGears::solver(&right, &pair, envelopes, problems)?;
        Some(OuterGears {
            pair,
            right,
            left,
            solver,
            is_convex: problems.iter().all(convex),
            range,
            is_cut_back: !gears.iter().any(|gear| gear.stands_out()),
        })
    }

    /// The outer gears in another section, `pair`, which turns their eccentricities, and by leads their flanks.
    pub fn turned(&self, pair: &GearPair) -> Option<OuterGears> {
        let [right, left] = if pair.has_leads() {
            let (pair, _) = enclosing(pair)?;
            Side::BOTH.map(|side| FlankProblem::new(&pair, side))
        } else {
            [&self.right, &self.left].map(|problem| problem.turned(pair))
        };
        Some(OuterGears {
            right,
            left,
            ..self.clone()
        })
    }

    /// The outer gears at the centre distance of `modified`.
    pub fn at(&self, modified: &[FlankProblem; 2]) -> Option<OuterGears> {
        let center_distance = modified[0].distance;
        let pair = self.pair.at(center_distance).ok()?;
        let [right, left] = [&self.right, &self.left].map(|problem| problem.at(&pair));
        let envelopes = self.solver.envelopes.clone();
        let solver = OuterGears::solver(&right, &pair, envelopes, modified)?;
        Some(OuterGears {
            pair,
            right,
            left,
            solver,
            is_cut_back: self.is_cut_back,
            is_convex: self.is_convex,
            range: self.range,
        })
    }

    /// The solver for both sides of `modified`; `None` if a search may be needed.
    fn solver(
        right: &FlankProblem,
        pair: &GearPair,
        envelopes: Envelopes,
        modified: &[FlankProblem; 2],
    ) -> Option<DirectSolver> {
        let of = |side: &FlankProblem| {
            let solver = DirectSolver::new(right, pair, envelopes.clone(), side)?;
            let proof = &solver.proof;
            let is_plain = proof.steep_arm.is_none() && !proof.tangents && !proof.turns_back;
            is_plain.then_some(solver)
        };
        // The proof of the outer gears decides which open curves of a step are not searched.
        let outer = DirectSolver::new(right, pair, envelopes.clone(), right)?;
        // The outer half teeth of the left side mirror those of the right; the deviations can differ.
        let both = of(&modified[1]).and(of(&modified[0]));
        both.filter(|_| outer.proof.is_direct())
    }

    /// The first contact, by the quick method or the search.
    pub fn first_contact(&self, posed: &PosedFlanks, request: SideRequest) -> SideFound {
        let outer = posed.of(match posed.problem.side {
            Side::Right => &self.right,
            Side::Left => &self.left,
        });
        let of_outer_gears = || {
            self.is_cut_back
                .then(|| self.contact_of_outer_gears(posed, &outer, request.effort))
                .flatten()
        };
        match of_outer_gears().or_else(|| self.without_search(posed, &outer, request.effort)) {
            Some(first_contact) => Ok(Some(first_contact)),
            None => search::first_contact(posed, request),
        }
    }

    fn without_search(
        &self,
        posed: &PosedFlanks,
        outer: &PosedFlanks,
        effort: &Effort,
    ) -> Option<FirstContact> {
        // Gaps count from the free tooth's own direction, which differs by its offset.
        let beyond = outer.free_offset - posed.free_offset;
        let mut pairs = [None; MOST_PAIRS];
        let count = self.pairs_on_line(outer, &mut pairs)?;
        let pairs = &mut pairs[..count];
        let gap = |pair: &Option<OuterPair>| pair.map_or(f64::NEG_INFINITY, |pair| pair.gap);
        pairs.sort_by_cached_key(|pair| rank(-gap(pair)));
        let mut tightest = TightestContacts::new(posed.problem);
        for pair in pairs.iter().flatten() {
            if pair.gap - beyond < tightest.least_tied_gap() {
                break;
            }
            let tangent = if self.is_convex {
                flank_contact(posed, pair)
            } else {
                None
            };
            let found = match tangent {
                Some(candidate) => Some(candidate),
                None => {
                    let (floor, guess) = (tightest.least_tied_gap(), pair.gap - beyond);
                    greatest_gap_of_flanks(posed, pair.step, floor, guess, effort)?
                }
            };
            if let Some(candidate) = found {
                tightest.offer(pair.step, candidate);
            }
        }
        if tightest.greatest() == f64::NEG_INFINITY {
            return None;
        }
        let settled = |step| pairs.iter().flatten().any(|pair| pair.step == step);
        self.offer_tips((posed, outer), &mut tightest, settled, effort)?;
        tightest.choose()
    }

    /// Outer pairs on the line of action; `None` if one does not settle, or there are too many.
    fn pairs_on_line(&self, outer: &PosedFlanks, pairs: &mut [Option<OuterPair>]) -> Option<usize> {
        let variation = &self.solver.variation;
        let (start, plays) = start_line(outer, variation)?;
        // Any deviation moves a flank's contact along it by far less than this, rad; a larger move stays open below.
        let plays = (plays.0 + 0.02, plays.1 + 0.02);
        let mut count = 0;
        for step in steps_on(outer, &start, plays) {
            let pair = InvolutePair::new(outer, step);
            let first = pair.gap_on(outer.problem, &start);
            let (gap, line) = if variation.moves {
                settle(outer, &pair, variation, first)?
            } else {
                (first, start)
            };
            *pairs.get_mut(count)? = Some(OuterPair {
                step,
                gap,
                rolls: pair.rolls_on(outer.problem, &line),
            });
            count += 1;
        }
        Some(count)
    }

    /// Offers every tip corner that the outer gears do not show clear at the greatest gap so far, except on flanks of
    /// `settled` steps. `None` if one stays open.
    fn offer_tips(
        &self,
        (posed, outer): (&PosedFlanks, &PosedFlanks),
        tightest: &mut TightestContacts,
        settled: impl Fn(i64) -> bool,
        effort: &Effort,
    ) -> Option<()> {
        let beyond = outer.free_offset - posed.free_offset;
        let gears = AtRotation::at(outer, tightest.greatest() + beyond);
        let open = self.solver.proof.open;
        let mut nodes_left = effort.left().min(MOST_NODES as u64) as usize;
        for step in outer.steps() {
            let tips = self.ends_are_clear(outer, &gears, step, tip_corner);
            let stands_in = |end| self.ends_are_clear(outer, &gears, step, end) != [true; 2];
            if !open.is_empty() && (tips != [true; 2] || stands_in(joint)) {
                let (locked, free) = (posed.locked(step), posed.free(step));
                let floor = tightest.least_tied_gap();
                let (curves, origin) = (without_lands(open), posed.origin_of(step));
                let before = nodes_left;
                let found = search_pair(&locked, &free, origin, floor, curves, &mut nodes_left);
                effort.spend((before - nodes_left) as u64);
                let lands = land_on_land(&locked, &free, origin, open);
                for candidate in found.ok()?.into_iter().chain(lands) {
                    if tightest.admits(candidate.gap) {
                        tightest.offer(step, candidate);
                    }
                }
            }
            let (locked_place, _) = outer.places(step);
            let far_corner = || far_corner_reaches(outer, &self.solver, locked_place);
            if self.solver.free_off > 0.0 && far_corner().is_some() {
                return None;
            }
            let mut settled = settled(step);
            if tips != [true; 2] && !(settled || self.is_convex) {
                // If flanks are not convex, only their heights prove that the gap is greatest at an end.
                if let Some(found) =
                    greatest_gap_by_heights(posed, step, tightest.least_tied_gap(), 0.0)?
                {
                    tightest.offer(step, found);
                }
                settled = true;
            }
            for (tip, is_clear) in [Role::Locked, Role::Free].into_iter().zip(tips) {
                if !is_clear && let Some(candidate) = self.tip_contact(posed, step, tip, settled)? {
                    tightest.offer(step, candidate);
                }
            }
        }
        Some(())
    }

    /// The contact of a tip corner with the mate's flank or fillet. `Some(None)` on the flank of a `settled` step; `None` if it stays open.
    fn tip_contact(
        &self,
        posed: &PosedFlanks,
        step: i64,
        tip: Role,
        settled: bool,
    ) -> Option<Option<CandidateContact>> {
        let (locked, free) = (posed.locked(step), posed.free(step));
        let proof = &self.solver.proof;
        // From root to tip, radii about the free axis fall on a locked half tooth and rise on a free one.
        let (half, mate, least, inward) = match tip {
            Role::Locked => (&locked, &free, proof.free_fillet, false),
            Role::Free => (&free, &locked, proof.locked_fillet, true),
        };
        let (flank, fillet) = (ProfilePart::Involute, ProfilePart::Fillet);
        let bracket = |low: f64, high: f64| if inward { [high, low] } else { [low, high] };
        let radius = |half: &PlacedHalf, roll: f64| half.at(flank, roll).point.norm();
        let corner = half.range(flank).1;
        let rho = radius(half, corner);
        let (form, top) = mate.range(flank);
        // Negative past the mate's tip; positive on its flank; below its form circle less than at the form point.
        let sense = if inward { -1.0 } else { 1.0 };
        let above_form = sense * (rho - radius(mate, form));
        let below_tip = sense * (radius(mate, top) - rho);
        let on_mate = if above_form >= 0.0 && below_tip >= 0.0 {
            if settled {
                return Some(None);
            }
            let met = mate.curve(flank).invert(rho, bracket(form, top), top);
            let (x, y) = match tip {
                Role::Locked => (corner, met),
                Role::Free => (met, corner),
            };
            rises(&locked, x, &free, y, -sense).then_some(())?;
            (flank, met)
        } else if above_form < 0.0 && settled {
            let (least, end) = (least?, mate.shape.fillet_end);
            let start = 0.5 * (least + end);
            (
                fillet,
                mate.curve(fillet).invert(rho, bracket(least, end), start),
            )
        } else {
            return None;
        };
        let (x, y) = match tip {
            Role::Locked => ((flank, corner), on_mate),
            Role::Free => (on_mate, (flank, corner)),
        };
        Some(Some(CandidateContact::new(
            (&locked, x),
            (&free, y),
            posed.origin_of(step),
            0.0,
        )))
    }

    /// Whether an end of the flanks of a step is clear of the outer mate: the locked end and the free end.
    fn ends_are_clear(
        &self,
        outer: &PosedFlanks,
        gears: &AtRotation,
        step: i64,
        end: fn(&HalfToothShape) -> C,
    ) -> [bool; 2] {
        let envelopes = &self.solver.envelopes;
        let (locked_teeth, free_teeth) = (&outer.problem.locked, &outer.problem.free);
        let (locked_place, free_place) = outer.places(step);
        let toward = free_teeth.half(free_place).direction;
        let seen = gears.direction * locked_teeth.half(locked_place).direction;
        let point = end(&locked_teeth.shape);
        let near = (gears.centre + seen * point) * toward.conj();
        let beyond = || outer.locked(step).own_to_axis(point) > self.solver.outmost;
        let locked = envelopes.free.clears(near) || envelopes.free.is_beyond_tip(near) && beyond();
        let point = end(&free_teeth.shape);
        let near = (toward * point - gears.centre) * seen.conj();
        let short = || outer.free(step).own_to_axis(point) < outer.locked(step).least_land_radius();
        let over = || envelopes.locked.is_beyond_tip(near) && short();
        let free = gears.is_ahead(near, seen) && (envelopes.locked.clears(near) || over());
        [locked, free]
    }

    /// The contact of the outer gears, if both flanks touch where nothing deviates.
    fn contact_of_outer_gears(
        &self,
        posed: &PosedFlanks,
        outer: &PosedFlanks,
        effort: &Effort,
    ) -> Option<FirstContact> {
        // Both gaps count from one place.
        if outer.free_offset != posed.free_offset {
            return None;
        }
        let request = SideRequest {
            effort,
            floor: f64::NEG_INFINITY,
        };
        let first_contact =
            super::direct::first_contact(outer, Some(&self.solver), request).ok()??;
        let (locked, free) = (
            posed.locked(first_contact.step),
            posed.free(first_contact.step),
        );
        let candidate = first_contact.candidate;
        let same = |half: &PlacedHalf, (part, roll): (ProfilePart, f64)| {
            part == ProfilePart::Involute && half.shape.is_undeviating(roll)
        };
        (same(&locked, candidate.locked) && same(&free, candidate.free)).then_some(first_contact)
    }
}

fn tip_corner(shape: &HalfToothShape) -> C {
    shape.tip_corner()
}

fn joint(shape: &HalfToothShape) -> C {
    shape.joint
}
