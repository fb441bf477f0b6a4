//! The quick path of flanks whose profiles deviate.
//!
//! [`super::search_free_proof`] holds for any convex flanks whose normals and curvatures it is told: of convex flanks the gap is greatest where
//! they have a common normal, or at a tip corner. Every half tooth lies within that of an *outer* gear: the one without profile deviations,
//! each flank turned out by its greatest deviation; at any radius the gap of two half teeth is at most that of the outer ones. So:
//!
//! 1. Pairs are taken in the order of their outer gaps on the line of action, until the outer gap is below one found.
//! 2. Of a pair of convex flanks, they touch where they have a common normal. A convex flank lies on one side of each of its tangents, and of every line
//!    through its tip corner within the corner's cone: where two flanks touch from outside along a tangent of both it divides them, so that
//!    their gap is nowhere greater. One such place is enough, however it was found: Newton's method finds it. Where it does not, and of flanks
//!    that are not convex, as measured ones are not, a search does, near the outer contact.
//! 3. With the free gear at the gap found no tip corner of the outer gears may stand in the outer mate, wider by as much as deviations vary,
//!    but on the mate's flank, of a pair that 1. and 2. have settled.
//!
//! A pose that one of these leaves open is searched, as are all of undercut gears. Where the outer gears touch and nothing deviates from them there, theirs is the answer: a
//! relief beyond the path of contact changes nothing.

use super::branch::search as search_pair;
use super::candidate::{CandidateContact, slope};
use super::curves::SearchExhausted;
use super::direct::{DirectSolver, Envelopes, Level, least_radius};
use super::flank_problem::{FlankProblem, PosedFlanks};
use super::lands::{land_on_land, without_lands};
use super::line::Line;
use super::placed::Placed;
use super::search;
use super::shape::{C, Sample, Shape};
use super::tightest::{TightestContacts, Touching};
use crate::contact::gap::{Arc, MOST_NODES, Meeting, greatest};
use crate::gear::{Osculating, ProfilePart, Side, smooth};
use crate::pair::{GearPair, Member};

/// A step this small, of a length, leaves its square: nothing.
const SETTLED: f64 = 1e-9;

/// Newton's method from an outer contact takes three or four.
const STEPS: u32 = 16;

/// How often at most the part of two flanks is doubled that is searched: to all of them from a thousandth.
const WIDENINGS: u32 = 11;

/// Pairs on the line of action at once: a contact ratio of eight.
const MOST_PAIRS: usize = 8;

/// What the quick path needs beside the gears' own teeth.
#[derive(Debug, Clone)]
pub(super) struct OuterGears {
    pair: GearPair,
    right: FlankProblem,
    left: FlankProblem,
    solver: DirectSolver,
    /// Whether every flank lies on one side of each of its tangents.
    is_convex: bool,
    /// How far the deviations of a flank vary, mm.
    range: f64,
    /// Whether deviations only take off: then the outer gears are those without any.
    is_cut_back: bool,
}

/// A pair of outer flanks on the line of action: its step, gap and rolls.
#[derive(Debug, Clone, Copy)]
struct OnLine {
    step: i64,
    gap: f64,
    rolls: (f64, f64),
}

impl OuterGears {
    /// Those of `assembly`; `None` where the outer gears need a search of their flanks themselves.
    pub fn new(assembly: &GearPair, problems: &[FlankProblem; 2]) -> Option<OuterGears> {
        let gears = [Member::Wheel, Member::Pinion].map(|member| assembly.gear(member));
        // Straight flanks have no outer gear, and without deviations none is needed. An undercut joint is a corner that is not looked at here.
        let undercut = gears.iter().any(|gear| gear.gear().is_undercut());
        if undercut || gears.iter().all(|gear| !gear.is_modified()) {
            return None;
        }
        let convex =
            |problem: &FlankProblem| problem.locked.is_convex() && problem.free.is_convex();
        let enclosing = |member: Member| assembly.gear(member).enclosing().ok();
        let ([wheel, _], one) = enclosing(Member::Wheel)?;
        let ([pinion, _], other) = enclosing(Member::Pinion)?;
        let distance = assembly.center_distance();
        let pair = GearPair::with_locked(wheel, pinion, distance, assembly.locked()).ok()?;
        let [right, left] = Side::BOTH.map(|side| FlankProblem::new(&pair, side));
        let range = one.max(other);
        // Both gears' points move by as much.
        let envelopes = Envelopes::with_room(&right, &pair, 4.0 * range);
        let solver = OuterGears::solver(&right, &pair, envelopes, problems)?;
        // Where a step is not searched for its open curves the outer gears' own proof says why.
        if !DirectSolver::new(&right, &pair, solver.envelopes.clone())?
            .proof
            .is_direct()
        {
            return None;
        }
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

    /// The same at another centre distance, that of `modified`.
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

    /// What is proven of both sides of `modified`; `None` where a search may be needed.
    fn solver(
        right: &FlankProblem,
        pair: &GearPair,
        envelopes: Envelopes,
        modified: &[FlankProblem; 2],
    ) -> Option<DirectSolver> {
        let of = |side: &FlankProblem| {
            let solver = DirectSolver::of(right, pair, envelopes.clone(), side)?;
            let proof = &solver.proof;
            let is_plain = proof.steep_arm.is_none() && !proof.tangents && !proof.turns_back;
            is_plain.then_some(solver)
        };
        // The outer half teeth of the left side mirror those of the right; the deviations need not.
        of(&modified[1]).and(of(&modified[0]))
    }

    /// The pair that touches first, by the quick path or the search.
    ///
    /// # Errors
    /// As [`search::touching`].
    pub fn touching(
        &self,
        posed: &PosedFlanks,
    ) -> Result<Option<Touching>, (i64, SearchExhausted)> {
        let outer = posed.of(match posed.problem.side {
            Side::Right => &self.right,
            Side::Left => &self.left,
        });
        let undeviating = || {
            self.is_cut_back
                .then(|| self.undeviating(posed, &outer))
                .flatten()
        };
        match undeviating().or_else(|| self.quick(posed, &outer)) {
            Some(touching) => Ok(Some(touching)),
            None => search::touching(posed),
        }
    }

    fn quick(&self, posed: &PosedFlanks, outer: &PosedFlanks) -> Option<Touching> {
        // Gaps count from the free tooth's own direction, which differs by its offset.
        let beyond = outer.free_offset - posed.free_offset;
        let mut pairs = [None; MOST_PAIRS];
        let count = self.on_line(outer, &mut pairs)?;
        let pairs = &mut pairs[..count];
        let gap = |pair: &Option<OnLine>| pair.map_or(f64::NEG_INFINITY, |pair| pair.gap);
        pairs.sort_by(|a, b| gap(b).total_cmp(&gap(a)));
        let mut tightest = TightestContacts::new(posed.problem);
        for pair in pairs.iter().flatten() {
            if pair.gap - beyond < tightest.level() {
                break;
            }
            let tangent = match self.is_convex {
                true => posed.flanks_touch(pair),
                false => None,
            };
            let found = match tangent {
                Some(candidate) => Some(candidate),
                None => self.flanks_within(posed, outer, pair, tightest.level())?,
            };
            if let Some(candidate) = found {
                tightest.offer(pair.step, candidate);
            }
        }
        if tightest.greatest() == f64::NEG_INFINITY {
            return None;
        }
        let settled = |step| pairs.iter().flatten().any(|pair| pair.step == step);
        self.on_tips(posed, outer, &mut tightest, settled)?;
        tightest.choose()
    }

    /// The greatest gap above `floor` of a pair's flanks, by branch and bound over as much of them as their outer gap leaves open; `None` where it
    /// is not settled.
    ///
    /// The outer gap falls from the contact on the line of action to either side: where it is below what was found between, so is all beyond.
    fn flanks_within(
        &self,
        posed: &PosedFlanks,
        outer: &PosedFlanks,
        pair: &OnLine,
        floor: f64,
    ) -> Option<Option<CandidateContact>> {
        let part = ProfilePart::Involute;
        let (locked, free) = (posed.locked(pair.step), posed.free(pair.step));
        let (outer_locked, outer_free) = (outer.locked(pair.step), outer.free(pair.step));
        let radius = |half: &Placed, roll: f64| half.at(part, roll).point.norm();
        let (low, high) = outer_locked.range(part);
        let (free_low, free_high) = outer_free.range(part);
        let free_radii = [free_low, free_high].map(|roll| radius(&outer_free, roll));
        let outer_gap = |roll: f64, rho: f64| {
            let start = pair.rolls.1.clamp(free_low, free_high);
            let mate = outer_free
                .curve(part)
                .invert(rho, [free_low, free_high], start);
            let on = ((&outer_locked, (part, roll)), (&outer_free, (part, mate)));
            CandidateContact::new(on.0, on.1, outer.origin, 0.0).gap
        };
        let beyond = outer.free_offset - posed.free_offset;
        // As far as two circles of the flanks' curvatures are apart by what the deviations vary.
        let arm = |half: &Placed, roll: f64| half.shape.base * roll.max(0.01);
        let arms = [
            arm(&outer_locked, pair.rolls.0),
            arm(&outer_free, pair.rolls.1),
        ];
        let away = (2.0 * self.range / (1.0 / arms[0] + 1.0 / arms[1])).sqrt();
        let mut width = away / arms[0];
        let mut nodes_left = MOST_NODES;
        for _ in 0..WIDENINGS {
            let ends = [pair.rolls.0 - width, pair.rolls.0 + width];
            let ends = ends.map(|roll| roll.clamp(low, high));
            // The lower end of a locked flank is farthest from the free axis.
            let radii = ends.map(|roll| radius(&outer_locked, roll));
            let (own_low, own_high) = locked.range(part);
            let from = |end: usize, own: f64, border: f64| match ends[end] == border {
                true => own,
                false => locked
                    .curve(part)
                    .invert(radii[end], [own_high, own_low], ends[end]),
            };
            let on_locked = (from(0, own_low, low), from(1, own_high, high));
            let (mate_low, mate_high) = free.range(part);
            let to = |rho: f64| {
                let start = pair.rolls.1.clamp(mate_low, mate_high);
                free.curve(part).invert(rho, [mate_low, mate_high], start)
            };
            // Where the flank itself ends it does so at another radius than the outer one.
            let reached = [radius(&locked, on_locked.0), radius(&locked, on_locked.1)];
            let on_free = (to(radii[1].min(reached[1])), to(radii[0].max(reached[0])));
            let (locked_arcs, free_arcs) = (arcs(&locked, on_locked), arcs(&free, on_free));
            let nodes = locked_arcs
                .iter()
                .flat_map(|arc| free_arcs.iter().map(move |free| (*arc, *free)));
            let found = greatest(nodes.collect(), posed.origin, floor, &mut nodes_left).ok()?;
            let level = found.map_or(floor, |found| found.gap);
            let is_closed = |end: usize| {
                ends[end] == [low, high][end]
                    || [radii[0] >= free_radii[1], radii[1] <= free_radii[0]][end]
                    || outer_gap(ends[end], radii[end]) - beyond <= level
            };
            if is_closed(0) && is_closed(1) {
                let candidate = |found: Meeting| {
                    let on = ((part, found.locked.1), (part, found.free.1));
                    CandidateContact::new((&locked, on.0), (&free, on.1), posed.origin, found.slack)
                };
                return Some(found.map(candidate));
            }
            width *= 2.0;
        }
        None
    }

    /// Outer pairs on the line of action; `None` where one does not settle, or there are too many.
    fn on_line(&self, outer: &PosedFlanks, pairs: &mut [Option<OnLine>]) -> Option<usize> {
        let variation = &self.solver.variation;
        let sum = outer.problem.sum();
        let (guess, start) = match variation.fixed {
            Some(line) => (0.0, line),
            None => {
                let guess = outer.gap(&variation.centred, &outer.pair(0));
                (guess, Line::new(outer.between(guess).0, sum)?)
            }
        };
        let error = (outer.gap(&start, &outer.pair(0)) - guess).abs();
        // A flank's contact moves along it by far less than this, rad, for any deviation; what moves farther is left open below.
        let plays = variation.plays(outer.problem, error);
        let plays = (plays.0 + 0.02, plays.1 + 0.02);
        let mut count = 0;
        for step in outer.steps_on(&start, plays) {
            let pair = outer.pair(step);
            let first = outer.gap(&start, &pair);
            let (gap, line) = match variation.moves {
                true => outer.settle(&pair, variation, first)?,
                false => (first, start),
            };
            *pairs.get_mut(count)? = Some(OnLine {
                step,
                gap,
                rolls: outer.rolls(&line, &pair),
            });
            count += 1;
        }
        Some(count)
    }

    /// Offers every tip corner that the outer gears do not show clear at the greatest gap so far, but on flanks of `settled` steps; `None`
    /// where one is left open.
    fn on_tips(
        &self,
        posed: &PosedFlanks,
        outer: &PosedFlanks,
        tightest: &mut TightestContacts,
        settled: impl Fn(i64) -> bool,
    ) -> Option<()> {
        let beyond = outer.free_offset - posed.free_offset;
        let level = Level::at(outer, tightest.greatest() + beyond);
        let open = self.solver.proof.open;
        let mut nodes_left = MOST_NODES;
        for step in outer.steps() {
            let [tips, joints] =
                [tip_corner, joint].map(|end| self.clear(outer, &level, step, end));
            if !open.is_empty() && (tips != [true; 2] || joints != [true; 2]) {
                let (locked, free) = (posed.locked(step), posed.free(step));
                let floor = tightest.level();
                let (curves, origin) = (without_lands(open), posed.origin);
                let found = search_pair(&locked, &free, origin, floor, curves, &mut nodes_left);
                let lands = land_on_land(&locked, &free, origin, open);
                for candidate in found.ok()?.into_iter().chain(lands) {
                    if tightest.admits(candidate.gap) {
                        tightest.offer(step, candidate);
                    }
                }
            }
            let clear = tips;
            let (locked_place, _) = outer.places(step);
            let far_corner = || outer.far_corner_reaches(&self.solver, locked_place);
            if self.solver.free_off > 0.0 && far_corner().is_some() {
                return None;
            }
            if clear == [true; 2] {
                continue;
            }
            // Of flanks that are not convex nothing but a search tells that their gap is greatest at an end.
            if !(self.is_convex || settled(step)) {
                return None;
            }
            let (locked, free) = (posed.locked(step), posed.free(step));
            let [locked_ends, free_ends] = [&locked, &free].map(|half| {
                let (form, tip) = half.range(ProfilePart::Involute);
                [form, tip].map(|t| half.at(ProfilePart::Involute, t).point.norm())
            });
            let proof = &self.solver.proof;
            let mut offer = |(x, y): ((ProfilePart, f64), (ProfilePart, f64))| {
                let candidate = CandidateContact::new((&locked, x), (&free, y), posed.origin, 0.0);
                if tightest.admits(candidate.gap) {
                    tightest.offer(step, candidate);
                }
            };
            let (part, fillet) = (ProfilePart::Involute, ProfilePart::Fillet);
            if !clear[0] {
                // The locked gear's tip is nearest to the free axis.
                let rho = locked_ends[1];
                let (low, high) = free.range(part);
                let tip = (part, locked.range(part).1);
                if (free_ends[0]..=free_ends[1]).contains(&rho) {
                    if !settled(step) {
                        let y = free.curve(part).invert(rho, [low, high], high);
                        rises(&locked, tip.1, &free, y, -1.0).then_some(())?;
                        offer((tip, (part, y)));
                    }
                } else if rho < free_ends[0] && settled(step) {
                    let least = proof.free_fillet?;
                    let end = free.shape.fillet_end;
                    let y = free
                        .curve(fillet)
                        .invert(rho, [least, end], 0.5 * (least + end));
                    offer((tip, (fillet, y)));
                } else {
                    return None;
                }
            }
            if !clear[1] {
                let rho = free_ends[1];
                let (low, high) = locked.range(part);
                let tip = (part, free.range(part).1);
                if (locked_ends[1]..=locked_ends[0]).contains(&rho) {
                    if !settled(step) {
                        let x = locked.curve(part).invert(rho, [high, low], high);
                        rises(&locked, x, &free, tip.1, 1.0).then_some(())?;
                        offer(((part, x), tip));
                    }
                } else if rho > locked_ends[0] && settled(step) {
                    let least = proof.locked_fillet?;
                    let end = locked.shape.fillet_end;
                    let x = locked
                        .curve(fillet)
                        .invert(rho, [end, least], 0.5 * (least + end));
                    offer(((fillet, x), tip));
                } else {
                    return None;
                }
            }
        }
        Some(())
    }

    /// Whether an end of the flanks of a step, of the locked and of the free half tooth, stands clear of the outer mate.
    fn clear(
        &self,
        outer: &PosedFlanks,
        level: &Level,
        step: i64,
        end: fn(&Shape) -> C,
    ) -> [bool; 2] {
        let envelopes = &self.solver.envelopes;
        let (locked_teeth, free_teeth) = (&outer.problem.locked, &outer.problem.free);
        let (locked_place, free_place) = outer.places(step);
        let toward = free_teeth.direction(free_place);
        let seen = level.direction * locked_teeth.direction(locked_place);
        let point = end(&locked_teeth.shape);
        let near = (level.centre + seen * point) * toward.conj();
        let beyond = || outer.locked(step).own_to_axis(point) > self.solver.outmost;
        let locked = envelopes.free.clears(near) || envelopes.free.is_beyond_tip(near) && beyond();
        let point = end(&free_teeth.shape);
        let near = (toward * point - level.centre) * seen.conj();
        let short = || outer.free(step).own_to_axis(point) < least_radius(&outer.locked(step));
        let over = || envelopes.locked.is_beyond_tip(near) && short();
        let free = level.is_ahead(near, seen) && (envelopes.locked.clears(near) || over());
        [locked, free]
    }

    /// The contact of the outer gears, where their flanks touch at places from which nothing deviates.
    fn undeviating(&self, posed: &PosedFlanks, outer: &PosedFlanks) -> Option<Touching> {
        let touching = super::direct::touching(outer, Some(&self.solver)).ok()??;
        let (locked, free) = (posed.locked(touching.step), posed.free(touching.step));
        let candidate = touching.candidate;
        let same = |half: &Placed, (part, roll): (ProfilePart, f64)| {
            part == ProfilePart::Involute && half.shape.is_undeviating(roll)
        };
        (same(&locked, candidate.locked) && same(&free, candidate.free)).then_some(touching)
    }
}

impl PosedFlanks<'_> {
    /// Where the flanks of a pair touch, from where the outer ones would: at a common tangent, or at a tip corner beyond which it lies. `None`
    /// where Newton's method finds none, or one below a flank's lower end.
    fn flanks_touch(&self, pair: &OnLine) -> Option<CandidateContact> {
        let (locked, free) = (self.locked(pair.step), self.free(pair.step));
        let ranges = [&locked, &free].map(|half| half.range(ProfilePart::Involute));
        let (mut x, mut y) = pair.rolls;
        let mut settled = false;
        for _ in 0..STEPS {
            let ((p, one), (q, other)) = (locked.flank(x)?, free.flank(y)?);
            let [at_x, at_y] = [Turning::new(&p, &one), Turning::new(&q, &other)];
            // Both at one radius, with opposite normals: where they are not on opposite sides nothing touches from outside.
            let rest = 0.5 * (p.point.norm_sqr() - q.point.norm_sqr());
            let w = p.point.conj() * p.normal * q.point * q.normal.conj();
            if !(w.re < 0.0) {
                return None;
            }
            let turn = (-w.im).atan2(-w.re);
            let determinant = at_y.along * at_x.turn - at_x.along * at_y.turn;
            let by =
                [&at_y, &at_x].map(|there| (rest * there.turn - turn * there.along) / determinant);
            x += by[0] / one.speed;
            y += by[1] / other.speed;
            if by[0].abs().max(by[1].abs()) < SETTLED * self.problem.distance {
                settled = true;
                break;
            }
        }
        let [(low, high), (free_low, free_high)] = ranges;
        // Not of NaN either.
        if !(settled && x >= low && y >= free_low) {
            return None;
        }
        let [over, free_over] = [x > high, y > free_high];
        // The gap is stationary along the flanks, not across them: both are put at one radius.
        let on = |half: &Placed, rho: f64, range: [f64; 2], start: f64| {
            half.curve(ProfilePart::Involute).invert(rho, range, start)
        };
        let radius = |half: &Placed, t: f64| half.at(ProfilePart::Involute, t).point.norm();
        let inward = [high, low];
        match (over, free_over) {
            (true, true) => return None,
            // Newton's last step left no more than its square.
            (false, false) => (),
            (true, false) => {
                (x, y) = (
                    high,
                    on(&free, radius(&locked, high), [free_low, free_high], y),
                )
            }
            (false, true) => (x, y) = (on(&locked, radius(&free, free_high), inward, x), free_high),
        }
        let candidate = CandidateContact::new(
            (&locked, (ProfilePart::Involute, x)),
            (&free, (ProfilePart::Involute, y)),
            self.origin,
            0.0,
        );
        if over || free_over {
            let towards = if over { -1.0 } else { 1.0 };
            let meets = (radius(&locked, x) - radius(&free, y)).abs() <= SETTLED;
            if !(meets && rises(&locked, x, &free, y, towards)) {
                return None;
            }
        }
        Some(candidate)
    }
}

fn tip_corner(shape: &Shape) -> C {
    shape.tip_corner()
}

fn joint(shape: &Shape) -> C {
    shape.joint
}

/// A stretch of a flank, cut at its edges.
fn arcs<'a>(half: &Placed<'a>, (low, high): (f64, f64)) -> Vec<Arc<'a>> {
    let curve = half.curve(ProfilePart::Involute);
    let arc = |(low, high)| Arc::new(curve, ProfilePart::Involute as usize, low, high);
    smooth(curve.curve.edges(), low, high).map(arc).collect()
}

/// Whether the gap of two flanks rises still at these rolls, towards greater radii (`towards` 1) or lesser ones (−1): over ln ρ its slope is
/// that of the locked flank less that of the free one.
fn rises(locked: &Placed, x: f64, free: &Placed, y: f64, towards: f64) -> bool {
    let slope_at = |half: &Placed, t: f64| slope(&half.at(ProfilePart::Involute, t));
    towards * (slope_at(locked, x) - slope_at(free, y)) > 0.0
}

/// How a step of a length along a flank changes half the square of the radius and the angle between normal and radius.
struct Turning {
    along: f64,
    turn: f64,
}

impl Turning {
    fn new(sample: &Sample, own: &Osculating) -> Turning {
        // P · i n and P · n.
        let z = sample.point.conj() * sample.normal;
        Turning {
            along: -z.im,
            turn: own.curvature - z.re / sample.point.norm_sqr(),
        }
    }
}
