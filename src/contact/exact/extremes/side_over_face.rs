//! One side of a cell of pairs that deviate along the face: bounds of its tightness, pair by pair of teeth.
//!
//! **Above.** A pair of teeth is never tighter than its endless involutes, whose tightness over a cell is concave up to a small constant
//! ([`Separation`]): their values at both ends, raised by it, bound it by a line. In the section at `b` the leads add `Σ δ(b)` along the
//! base tangent. Where a tip of roll `ξ_a` is passed by `ω`, the direction of the endless touch leaves
//!
//! ```text
//! r_b (ξ_a (1 − cos ω) + ω − sin ω)
//! ```
//!
//! of room. `ω` is linear in `b`, and least at an end of the cell. So a pair adds at most the greatest value over the face of `Σ δ(b)`
//! less the room of both tips. Between knots of the leads that is concave, or bounded by a chord where the leads are hollow; its tangents at
//! two places bound its maximum. A side is bounded by the line between the greatest values of all pairs at either end.
//!
//! **Below.** The pair that touches in the middle, in its section, bounds the side by the chord between its values at both ends, less the
//! same constant.
//!
//! **Leaning axes** ([`LeaningFrame`]). In the section at `b` the centres are displaced by `b` times their leans. Twist and leads are those at
//! the heights of the point of contact. Along the face the tightness of endless involutes is a parabola, which three sections give at either
//! end of a cell, up to its third derivative. That is at most `3 (θ D/T)³/T²`, with the lean `θ`, the distance `D` of the centres and the
//! length `T` of the line. Over a cell a wobble `t` turns with its gear. At the distance `Q` of the contact from the axis it bends the
//! tightness by `tan β_b t (Q + 2 r_b)` per square of the turn.
//!
//! A tip corner that is passed by `ω` stands `r_b ξ_a ω` inside of the line, at another height than the line's point. By its twist that adds
//! `g ω` to its tightness.

use super::mesh_cycle::PosedSide;
use super::passed_tip::PassedTip;
use super::side_stretch::SideStretch;
use crate::contact::exact::helical::most_moved;
use crate::contact::exact::leaning::LeaningFrame;
use crate::contact::exact::separation::{NearStart, Separation};
use crate::contact::gap::dot;
use crate::contact::lost_motion::Contact;
use crate::gear::AsBuilt;
use crate::numeric::{bisect, rank};
use crate::pair::{FacingTeeth, GearPair, Member};
use std::ops::Range;

/// Effort of a pair of teeth in a cell, nodes (tuned: 1 µs).
const STEP: u64 = 3;

/// Effort of the sections of a pair of leaning axes in a cell, nodes (tuned: 4 µs).
const LEANING_STEP: u64 = 12;

/// Steps to the maximum of a stretch between knots: each at least halves the bracket, and its square is what remains.
const STEPS: usize = 14;

/// Excess of a bound over the bracket's tangents at which a maximum is close enough, mm.
const CLOSE: f64 = 1e-10;

/// Parts of the face in which corners on fillets are bounded, a pitch of twist (tuned).
const PARTS_A_PITCH: f64 = 4.0;

/// Least distance from the middle of the face, mm, of the sections from which the effect of a lean is taken.
const LEAST_HALF_FACE: f64 = 1e-3;

/// Factor of the bounds of leaning axes for their products with eccentricities and with each other.
pub(super) const HIGHER_ORDERS: f64 = 1.5;

/// Greatest deviations of both gears together, mm; 0 where profiles do not deviate.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct ProfileDeviations {
    /// Amount of any profile deviations and leads.
    pub moved: f64,
    /// Profile deviations of a tip corner and the fillet of its mate.
    pub of_corner: f64,
}

impl ProfileDeviations {
    pub fn new(assembly: &GearPair) -> ProfileDeviations {
        if !assembly.is_modified() {
            return ProfileDeviations::default();
        }
        let [fillet, tip] = assembly.gear(Member::Wheel).end_deviations();
        let [mate_fillet, mate_tip] = assembly.gear(Member::Pinion).end_deviations();
        ProfileDeviations {
            moved: most_moved(assembly),
            of_corner: (tip + mate_fillet).max(mate_tip + fillet),
        }
    }
}

/// A bound of the tightness of a side over a cell, rad of the free gear beyond nominal.
#[derive(Debug, Clone, Copy)]
pub(super) struct SideBound {
    /// Values at both ends, between which it is a line.
    pub ends: [f64; 2],
    /// Rest that no narrower cell excludes.
    pub open: f64,
}

/// A pair of teeth in a cell.
pub(super) struct PairInCell {
    pub step: i64,
    /// Its endless involutes at both ends.
    pub found: [Separation; 2],
    /// Bound on what its tightness rises above the chord between both ends, rad.
    pub bend: f64,
}

/// One side of a cell.
pub(super) struct FaceSideCell<'a> {
    pub assembly: &'a GearPair,
    pub deviations: ProfileDeviations,
    /// Where axes lean: the frames at both ends.
    pub leaning: Option<[LeaningFrame; 2]>,
    /// Lines of action at both ends, from which touches are searched.
    pub starts: [NearStart; 2],
    /// The cell in the measuring plane.
    pub plane: SideStretch<'a>,
}

impl<'a> FaceSideCell<'a> {
    /// Steps whose locked tooth can reach the mate in some section.
    pub fn steps(&self) -> Range<i64> {
        let over = |end: &PosedSide| end.flanks.steps_over(self.plane.side.turns);
        let [one, other] = self.plane.ends.each_ref().map(over);
        let more = i64::from(self.leaning.is_some());
        one.start.min(other.start) - more..one.end.max(other.end) + more
    }

    pub fn members(&self) -> [Member; 2] {
        [self.assembly.locked(), self.assembly.free()]
    }

    pub fn bases(&self) -> [f64; 2] {
        let problem = self.plane.side.problem;
        [problem.locked.shape.base, problem.free.shape.base]
    }

    fn tip_rolls(&self) -> [f64; 2] {
        let problem = self.plane.side.problem;
        [&problem.locked, &problem.free].map(|teeth| teeth.shape.tip_roll)
    }

    pub fn twists(&self) -> [f64; 2] {
        let flanks = &self.plane.ends[0].flanks;
        self.members()
            .map(|member| flanks.twist(self.assembly, member))
    }

    /// Turn of the locked and of the free gear over the cell, rad.
    pub fn turns(&self) -> [f64; 2] {
        self.plane.plays().map(|play| play / 1.2)
    }

    /// Bound on what a pair's tightness rises above the chord between its ends, or falls below it, rad.
    pub fn bend(&self, found: &[Separation; 2]) -> Option<f64> {
        Some(self.plane.bend(found)? / 8.0 + self.plane.rounding())
    }

    /// The endless involutes of a step at both ends of the cell.
    pub fn endless(&self, step: i64) -> [Separation; 2] {
        [0, 1].map(|k| {
            let flanks = &self.plane.ends[k].flanks;
            Separation::endless_near(flanks, step, [0.0; 2], &self.starts[k])
        })
    }

    /// Tightness of a pair with `found` at both ends of the cell, rad.
    pub fn tightness(&self, found: &[Separation; 2]) -> [f64; 2] {
        [0, 1].map(|k| -self.plane.ends[k].room(found[k].gap))
    }

    /// Its pairs; `None` where one has no line of action.
    pub fn pairs(&self) -> Option<Vec<PairInCell>> {
        let mut pairs = Vec::new();
        for step in self.steps() {
            self.plane.effort.spend(STEP);
            let found = self.endless(step);
            if !found.iter().all(|one| one.touches) {
                return None;
            }
            let bend = self.bend(&found)?;
            pairs.push(PairInCell { step, found, bend });
        }
        Some(pairs)
    }

    /// An upper bound of the side's tightness over its `pairs`. Where profiles deviate, their flanks are no tighter than `flanks` at both ends.
    pub fn above(&self, mut pairs: Vec<PairInCell>, flanks: Option<[f64; 2]>) -> Option<SideBound> {
        let mut most = flanks.unwrap_or([f64::NEG_INFINITY; 2]);
        let mut open = 0.0f64;
        // Pairs far from their tips are likely to be tightest. They come first.
        let passed = |PairInCell { found, .. }: &PairInCell| {
            let beyond =
                |k: usize| found[0].rolls()[k].max(found[1].rolls()[k]) - self.tip_rolls()[k];
            beyond(0).max(beyond(1))
        };
        pairs.sort_by_cached_key(|pair| rank(passed(pair)));
        for PairInCell { step, found, bend } in pairs {
            let line = self.tightness(&found).map(|own| own + bend);
            let pair = PairOverFace::new(self, step, &found)?;
            let [from, to] = pair.face;
            if from > to {
                // No section has the teeth of both gears.
                continue;
            }
            let simple = pair.simple(pair.face);
            // `open` is the greatest open rest of the pairs so far. `most` must also cover what this pair leaves open beyond it.
            let more = pair.at_fillet(pair.face) + (pair.open - open).max(0.0);
            if (0..2).all(|k| line[k] + simple[k] + more <= most[k]) {
                continue;
            }
            if flanks.is_none() {
                let floors = [0, 1].map(|k| most[k] - line[k]);
                let greatest = match self.leaning {
                    Some(_) => [0, 1].map(|k| pair.greatest(k, floors[k])),
                    None => [pair.greatest(0, floors[0].min(floors[1])); 2],
                };
                for k in 0..2 {
                    most[k] = most[k].max(line[k] + greatest[k]);
                }
            }
            self.add_fillets(step, &pair, line, &mut most);
            open = open.max(pair.open);
        }
        let omitted_error = self.assembly.section_error_bound() / self.bases()[1];
        Some(SideBound {
            ends: most,
            open: open + omitted_error,
        })
    }

    /// Raises `most`, the bounds at both ends of the cell, by those of corners of a pair on fillets. A corner on a fillet has at least its
    /// clearance more room than the endless involutes, which have `line` in the measuring plane.
    fn add_fillets(&self, step: i64, pair: &PairOverFace, line: [f64; 2], most: &mut [f64; 2]) {
        let [from, to] = pair.face;
        let twist = self.twists()[0];
        let pitches = (to - from) * twist.abs() / self.plane.side.problem.locked.pitch;
        let parts = (PARTS_A_PITCH * pitches).ceil().max(1.0);
        let at = |part: f64| from + (to - from) * (part / parts);
        for part in 0..parts as u32 {
            let part = [at(f64::from(part)), at(f64::from(part) + 1.0)];
            let more = pair.at_fillet(part);
            let simple = pair.simple(part);
            let top = [0, 1].map(|k| line[k] + simple[k] + more);
            let enough = (top[0] - most[0]).max(top[1] - most[1]);
            if enough > 0.0 {
                let turns = part.map(|b| twist * b);
                let turns = [turns[0].min(turns[1]), turns[0].max(turns[1])];
                let beside = (pair.turned, self.assembly.shift_bound());
                let clearance = self.plane.least_clearance(step, enough, turns, beside);
                for k in 0..2 {
                    most[k] = most[k].max(top[k] - clearance);
                }
            }
        }
    }

    /// A lower bound of the side's tightness, from the pair of `contact` in its section.
    pub fn below(&self, contact: &Contact) -> Option<SideBound> {
        let flanks = &self.plane.ends[0].flanks;
        let teeth = self.members().map(|member| contact.touch(member).tooth);
        let step = self.steps().find(|step| flanks.numbers(*step) == teeth)?;
        let found = [
            self.touch(0, step, contact.section)?,
            self.touch(1, step, contact.section)?,
        ];
        if !found.iter().all(|one| one.touches) {
            return None;
        }
        let mut bend = self.bend(&found)?;
        let mut open = 0.0;
        if self.leaning.is_some() {
            let teeth = flanks.facing_teeth(self.assembly, step);
            bend += self.heights_bend(&teeth, &found);
            open = self.other_contact(&found, 0.0);
        }
        Some(SideBound {
            ends: self.tightness(&found).map(|own| own - bend),
            open,
        })
    }

    /// The touch of a step in the section at `b` at an end of the cell.
    fn touch(&self, end: usize, step: i64, b: f64) -> Option<Separation> {
        let posed = &self.plane.ends[end];
        let teeth = posed.flanks.facing_teeth(self.assembly, step);
        let (bases, twists, near) = (self.bases(), self.twists(), posed.nominal_gap());
        let leads = teeth.leads(b);
        let turns = [0, 1].map(|k| twists[k] * b - leads[k] / bases[k]);
        let Some(frames) = &self.leaning else {
            return Some(Separation::turned(&posed.flanks, step, near, turns));
        };
        self.plane.effort.spend(LEANING_STEP);
        let start = &self.starts[end];
        let (here, _, touch) = frames[end].undisturbed(&posed.flanks, (step, b), turns, start)?;
        let turns = [0, 1].map(|k| {
            let lead = teeth.leads(b + touch.heights[k])[k];
            twists[k] * b + touch.turns[k] - lead / bases[k]
        });
        Some(Separation::near(&here, step, turns, start))
    }

    /// The gears, locked and free.
    fn gears(&self) -> [&'a AsBuilt; 2] {
        self.members().map(|member| self.assembly.gear(member))
    }

    /// `tan β_b`.
    fn wound(&self) -> f64 {
        let gear = self.assembly.gear(Member::Wheel).gear();
        gear.basic_data().base_helix_angle().tan()
    }

    /// Bound on the distance of a pair's points on the line from both axes over the face, mm.
    fn reaches(&self, found: &[Separation; 2]) -> [f64; 2] {
        let (bases, twists) = (self.bases(), self.twists());
        let [from, to] = self.assembly.face();
        [0, 1].map(|k| {
            let rolls = found.each_ref().map(|one| one.rolls()[k].abs());
            let roll = rolls[0].max(rolls[1]) + twists[k].abs() * from.abs().max(to.abs());
            bases[k] * (1.0 + roll * roll).sqrt()
        })
    }

    /// Length of the line of action, mm.
    pub fn line_length(&self, found: &[Separation; 2]) -> f64 {
        let bases = self.bases();
        let [one, other] = found[0].rolls();
        bases[0] * one + bases[1] * other
    }

    /// Bound on what turning leans bend the tightness of a pair on the line over the cell, rad.
    fn lean_bend(&self, found: &[Separation; 2]) -> f64 {
        let (bases, turns, off) = (self.bases(), self.turns(), self.plane.side.off);
        let (gears, reach) = (self.gears(), self.reaches(found));
        let lean = self.assembly.lean_bound();
        // The contact moves along the line as the locked gear's base circle.
        let way = bases[0] * turns[0];
        let wobble = |k: usize| gears[k].wobble() * turns[k] * (reach[k] * turns[k] + 2.0 * way);
        let line = (off[0] * turns[0] + off[1] * turns[1]) * turns[0] / self.line_length(found);
        let by_line = lean * (reach[0] + reach[1]) * line;
        let turned = turns[0] + turns[1];
        let stretched = lean * lean * (reach[0] + reach[1]) * turned * turned;
        let all = self.wound() * (wobble(0) + wobble(1) + by_line) + stretched;
        HIGHER_ORDERS * all / 8.0 / bases[1]
    }

    /// Bound on what the heights of a pair's contact bend its tightness over the cell, rad.
    fn heights_bend(&self, teeth: &FacingTeeth, found: &[Separation; 2]) -> f64 {
        let (gears, turns) = (self.gears(), self.turns());
        let lean = self.assembly.lean_bound();
        // A height leaves its chord by less than half of its greatest change.
        let way = (gears[0].reach() * turns[0]).max(gears[1].reach() * turns[1]);
        let height = 0.6 * lean * way;
        let most = self.assembly.height_bound();
        let [from, to] = self.assembly.face();
        let [one, other] = teeth.steepest([from - most, to + most]);
        let by_leads = HIGHER_ORDERS * (one + other) * height / self.bases()[1];
        if found.iter().all(|one| one.is_on_line(self.plane.plays())) {
            return by_leads + self.lean_bend(found);
        }
        let by_twist = 2.0 * (self.wound() + lean) * height;
        by_leads + HIGHER_ORDERS * by_twist / self.bases()[1]
    }

    /// Bound on the effect of a free gear that leans as at the contact of the pair nearest to the line of centres, rad: not as at that of
    /// `found`, with teeth turned by up to `turned`, rad.
    fn other_contact(&self, found: &[Separation; 2], turned: f64) -> f64 {
        let apart = [0, 1].map(|k| {
            let end = &self.plane.ends[k];
            let nearest = Separation::endless_near(&end.flanks, 0, [0.0; 2], &self.starts[k]);
            (found[k].gap - nearest.gap).abs() + turned
        });
        let [from, to] = self.assembly.face();
        let shift = from.abs().max(to.abs()) + self.wound() * self.reaches(found)[1];
        let lean = HIGHER_ORDERS * self.gears()[1].wobble();
        lean * shift * apart[0].max(apart[1]) / self.bases()[1]
    }

    /// The touch of the endless involutes of a step in the section at `b` of leaning axes at an end of the cell, without leads.
    fn on_line(&self, frame: &LeaningFrame, end: usize, step: i64, b: f64) -> Option<LeaningPair> {
        let posed = &self.plane.ends[end];
        let (here, bases, twists) = (frame.at(&posed.flanks, b), self.bases(), self.twists());
        let turns = twists.map(|twist| twist * b);
        let start = &self.starts[end];
        let found = Separation::endless_near(&here, step, turns, start);
        if !found.touches {
            return None;
        }
        let touch = frame.touch(b, &here, &found, start);
        let (rolls, [locked, free]) = (found.rolls(), touch.turns);
        let direction = found.direction_turned(start, 0.0);
        let leans = frame.leans(found.gap_turned(start));
        // Towards the locked gear's tangent point; towards that of the free gear is opposite.
        let winding = |k: usize| bases[k] * twists[k] * dot(leans[k], -direction);
        Some(LeaningPair {
            gap: found.gap + found.by_turn[0] * locked + found.by_turn[1] * free,
            rolls: [rolls[0] - locked, rolls[1] + bases[0] / bases[1] * locked],
            heights: touch.heights,
            turned: locked.abs() + free.abs(),
            winding: winding(0) + winding(1),
        })
    }
}

pub(super) fn start(posed: &PosedSide) -> NearStart {
    NearStart::new(&posed.flanks, posed.nominal_gap())
}

/// A pair of endless involutes in a section of leaning axes.
struct LeaningPair {
    gap: f64,
    rolls: [f64; 2],
    /// Heights of the contact over the section, mm.
    heights: [f64; 2],
    /// Turn of both teeth by the lean at most, rad.
    turned: f64,
    /// Tightness along the base tangent, mm per mm, that a contact gains by standing nearer to the locked axis, along the radius of its
    /// tangent point. Nearer to the free axis it loses as much.
    winding: f64,
}

/// A pair of teeth over the face: what leads and leans add to its tightness, less the room of its tips.
struct PairOverFace<'a> {
    teeth: FacingTeeth<'a>,
    /// Both ends of the sections in which the teeth face each other, mm.
    face: [f64; 2],
    /// Knots of both leads on it, ascending, with its ends.
    knots: Vec<f64>,
    /// Greatest profile deviation of a corner and a fillet that touch, mm.
    of_corner: f64,
    /// Turn of both teeth by leads, leans and profile deviations at most, rad.
    turned: f64,
    tips: [PassedTip; 2],
    /// Least and greatest arm by which a tightness along the base tangent turns the free gear, mm.
    arms: [f64; 2],
    /// Rotation that leans add at both ends of the cell: factors of the powers of `b`, rad.
    leaning: [[f64; 3]; 2],
    /// Bounds on the rotation that leans add beside it, rad: one that narrower cells exclude, and one that they do not.
    bend: f64,
    open: f64,
}

impl<'a> PairOverFace<'a> {
    /// The pair of a step, with `found` in the measuring plane at both ends of the cell; `None` without a line of action.
    fn new(
        cell: &FaceSideCell<'a>,
        step: i64,
        found: &[Separation; 2],
    ) -> Option<PairOverFace<'a>> {
        let problem = cell.plane.side.problem;
        let teeth = cell.plane.ends[0].flanks.facing_teeth(cell.assembly, step);
        let face = cell.assembly.face();
        let shapes = [&problem.locked.shape, &problem.free.shape];
        let twists = cell.twists();
        // Between the ends a roll leaves its chord by less than the eccentricities turn the line.
        // A gap of the free gear turns by the leads of both, over either base circle.
        let ranges = teeth.teeth.map(|(gear, tooth)| {
            let own = gear.lead_curve(problem.side, tooth);
            own.map_or(0.0, |curve| curve.range())
        });
        let ranges = ranges[0] + ranges[1] + cell.deviations.moved;
        let turned = ranges / shapes[0].base.min(shapes[1].base);
        let plays = cell.plane.plays();
        // The line turns by less than a fifth of the gears, as [`SideStretch::plays`] allows.
        let off = if cell.plane.side.off == [0.0; 2] {
            0.0
        } else {
            plays[0] - plays[0] / 1.2
        };
        // A free gear that leads turn moves the line by its eccentricity.
        let play = off + cell.plane.side.off[1] * turned / cell.line_length(found);
        // Leads of the locked tooth move the contact along the line.
        let by_lead = [1.0 / shapes[0].base, -1.0 / shapes[1].base];
        let tips = [0, 1].map(|k| {
            let roll = found[0].rolls()[k].min(found[1].rolls()[k]);
            PassedTip {
                base: shapes[k].base,
                roll: shapes[k].tip_roll,
                excess: roll - shapes[k].tip_roll - play,
                rate: -twists[k],
                by_lead: by_lead[k],
                pull: 0.0,
                share: 0.0,
                play: play + 1.2 * plays[k],
                form: shapes[k].form_roll,
                below: 0.0,
            }
        });
        let arms = found.each_ref().map(|one| -shapes[1].base / one.by_turn[1]);
        let arm = cell.plane.side.off[1] * (plays[1] + turned);
        let pair = PairOverFace {
            knots: Vec::new(),
            teeth,
            face,
            of_corner: cell.deviations.of_corner,
            turned,
            tips,
            arms: [arms[0].min(arms[1]) - arm, arms[0].max(arms[1]) + arm],
            leaning: [[0.0; 3]; 2],
            bend: 0.0,
            open: 0.0,
        };
        let mut pair = match &cell.leaning {
            Some(frames) => pair.with_leans(cell, frames, step, found)?,
            None => pair,
        };
        let section = |k, height| pair.teeth.section_of(k, height);
        pair.knots = pair.teeth.knots(pair.face, section);
        let passed = pair.tips.iter().filter(|tip| tip.pull < 0.0);
        let mut places: Vec<f64> = passed
            .flat_map(|tip| {
                let at = |b: f64| tip.beyond(b, pair.teeth.leads(b)[0]);
                pair.knots
                    .windows(2)
                    .filter_map(move |ends| zero(at, [ends[0], ends[1]]))
            })
            .collect();
        pair.knots.append(&mut places);
        pair.knots.sort_unstable_by(f64::total_cmp);
        Some(pair)
    }

    /// This pair with leaning axes, which have `frames` at both ends of the cell.
    fn with_leans(
        mut self,
        cell: &FaceSideCell<'a>,
        frames: &[LeaningFrame; 2],
        step: i64,
        found: &[Separation; 2],
    ) -> Option<PairOverFace<'a>> {
        cell.plane.effort.spend(LEANING_STEP);
        let (assembly, bases) = (cell.assembly, cell.bases());
        let [from, to] = self.face;
        let (middle, half) = (0.5 * (from + to), (0.5 * (to - from)).max(LEAST_HALF_FACE));
        let places = [middle - half, middle, middle + half];
        let mut sections = Vec::with_capacity(6);
        for (end, frame) in frames.iter().enumerate() {
            for b in places {
                sections.push(cell.on_line(frame, end, step, b)?);
            }
        }
        let of = |end: usize, place: usize| &sections[3 * end + place];
        self.leaning = [0, 1].map(|end| {
            let [v, w, x] = [0, 1, 2].map(|place| of(end, place).gap - found[end].gap);
            let (rate, curve) = (
                0.5 * (x - v) / half,
                0.5 * (x - 2.0 * w + v) / (half * half),
            );
            [
                w - middle * (rate - curve * middle),
                rate - 2.0 * curve * middle,
                curve,
            ]
        });
        // The line through the values at both ends of the face: its value at 0, and its rate.
        let line = |v: f64, x: f64| {
            let rate = 0.5 * (x - v) / half;
            [v - rate * places[0], rate]
        };
        let heights = [0, 1].map(|k| {
            let mean = |place: usize| 0.5 * (of(0, place).heights[k] + of(1, place).heights[k]);
            line(mean(0), mean(2))
        });
        // Heights beside these lines.
        let beside = [0, 1].map(|k| {
            let each = (0..6).map(|j| {
                let own = heights[k][0] + heights[k][1] * places[j % 3];
                (sections[j].heights[k] - own).abs()
            });
            1.1 * each.fold(0.0, f64::max)
        });
        let own = heights.map(|[at_0, rate]| [at_0, 1.0 + rate]);
        self.teeth = self.teeth.with_heights(own);
        let members = cell.members();
        self.face = [0, 1].map(|which| {
            let ends = [0, 1].map(|k| {
                let own = assembly.own_face(members[k])[which];
                let beyond = if which == 0 { -beside[k] } else { beside[k] };
                self.teeth.section_of(k, own) + beyond
            });
            if which == 0 {
                ends[0].max(ends[1])
            } else {
                ends[0].min(ends[1])
            }
        });
        let steepest = self.teeth.steepest(self.face);
        let by_leads = steepest[0] * beside[0] + steepest[1] * beside[1];
        self.bend = cell.lean_bend(found) + HIGHER_ORDERS * by_leads / bases[1];
        let lean = assembly.lean_bound();
        let length = cell.line_length(found);
        let slope = lean * assembly.center_distance() / length;
        // A cubic leaves the parabola through three of its points by a sixth of its third derivative times 2 h³/(3 √3).
        let third = 3.0 * slope.powi(3) / (length * length) * half.powi(3) / 15.5;
        // As much again for the heights along the line.
        self.open = 2.0 * HIGHER_ORDERS * third / bases[1] + cell.other_contact(found, self.turned);
        let most = |value: fn(&LeaningPair) -> f64| {
            sections.iter().map(value).fold(f64::NEG_INFINITY, f64::max)
        };
        let wobbles = cell.gears().map(|gear| gear.wobble());
        let turns = cell.turns();
        let turning = wobbles[0] * turns[0] + wobbles[1] * turns[1] + lean * slope * half / length;
        // The corners of the locked and of the free tip stand nearer to their axes than the line.
        let windings = [most(|one| one.winding), most(|one| -one.winding)];
        for (k, tip) in self.tips.iter_mut().enumerate() {
            let least = [0, 1, 2].map(|place| of(0, place).rolls[k].min(of(1, place).rolls[k]));
            let [at_0, rate] = line(least[0], least[2]);
            let sag = (0.5 * (least[0] + least[2]) - least[1]).max(0.0);
            let play = found[0].rolls()[k].min(found[1].rolls()[k]) - tip.roll - tip.excess;
            tip.excess = at_0 - tip.roll - play - 1.1 * sag;
            tip.rate = rate;
            let arm = tip.base * tip.roll;
            let gain = windings[k]
                + HIGHER_ORDERS * cell.wound() * turning
                + lean * (steepest[0] + steepest[1] + lean);
            let outward = (1.0 + tip.roll * tip.roll).sqrt() / tip.roll;
            tip.share = (HIGHER_ORDERS * cell.wound() * lean * outward).min(1.0);
            if gain > 0.0 {
                // The roll beyond it may be greater by `play`: more by that or by all that the corner gains.
                let more = (arm * gain * play).min(0.5 * HIGHER_ORDERS * arm * gain * gain);
                self.open += more / self.arms[0];
            }
            tip.pull = -arm * gain;
            tip.below = HIGHER_ORDERS * tip.base * tip.form.abs() * windings[0].max(windings[1]);
        }
        self.turned += 1.1 * most(|one| one.turned);
        Some(self)
    }

    /// Bounds on the rotation at both ends of the cell over a part of the face, rad, without the room of tips.
    fn simple(&self, part: [f64; 2]) -> [f64; 2] {
        let lead = self.teeth.lead_sum_bound(part) + self.of_corner;
        let arm = if lead > 0.0 {
            self.arms[0]
        } else {
            self.arms[1]
        };
        self.leaning
            .map(|leaning| lead / arm + greatest_of(leaning, part) + self.bend)
    }

    /// Bound on the rotation, rad, that a lean adds where a corner touches a fillet in a part of the face.
    fn at_fillet(&self, part: [f64; 2]) -> f64 {
        let more = self.tips.iter().map(|tip| {
            let passed = part.map(|b| tip.excess + tip.rate * b);
            let [least, most] = [passed[0].min(passed[1]), passed[0].max(passed[1])];
            let passed = most + tip.play + self.turned;
            let below = tip.form - (tip.roll + least - self.turned);
            -tip.pull.min(0.0) * passed.max(0.0) + tip.below * below.max(0.0)
        });
        more.sum::<f64>() / self.arms[0]
    }

    /// Bound on the rotation at an end of the cell, rad, or `floor` if that is greater.
    fn greatest(&self, end: usize, floor: f64) -> f64 {
        let along = |arm: f64| {
            let parabola = self.leaning[end].map(|factor| factor * arm);
            self.greatest_along(parabola, (floor - self.bend) * arm) / arm
        };
        let [least, most] = self.arms;
        let found = along(least);
        let found = if least == most {
            found
        } else {
            found.max(along(most))
        };
        found + self.bend
    }

    /// The room that both tips leave at `b` with these leads and their rates, and its rate.
    fn room(&self, b: f64, [lead, rate]: [f64; 2]) -> [f64; 2] {
        let mut room = [0.0; 2];
        for tip in &self.tips {
            let [own, closing] = tip.room(tip.beyond(b, lead));
            room[0] += own;
            room[1] += closing * (tip.rate + tip.by_lead * rate);
        }
        room
    }

    /// Greatest second derivative of the room of tips by leads of the locked tooth, which bend with one of `bends` between two places, mm per
    /// mm²: their rolls beyond the ends bend.
    fn most_hollow(&self, ends: [f64; 2], [least, most]: [f64; 2]) -> f64 {
        let leads = ends.map(|b| self.teeth.leads(b)[0]);
        let hollow = |tip: &PassedTip| {
            let beyond = [0, 1].map(|k| tip.beyond(ends[k], leads[k]));
            let beyond = beyond[0].max(beyond[1]).clamp(0.0, 1.0) * 1.01;
            let bend = (-tip.by_lead * least).max(-tip.by_lead * most).max(0.0);
            bend * tip.base * (tip.roll + beyond) * beyond
        };
        self.tips.iter().map(hollow).sum()
    }

    /// SideBound of `Σ δ(b)` and a parabola, mm, less the room of the tips, over the face, or `floor` if that is greater.
    fn greatest_along(&self, parabola: [f64; 3], floor: f64) -> f64 {
        let [from, to] = self.face;
        let [at_0, rate, curve] = parabola;
        if from == to {
            let along = at_0 + from * (rate + from * curve);
            let [locked, free] = self.teeth.leads_and_rates(from);
            return locked[0] + free[0] + along - self.room(from, locked)[0];
        }
        let mut most = floor;
        let mut open = vec![&self.knots[..]];
        while let Some(knots) = open.pop() {
            let part = [knots[0], knots[knots.len() - 1]];
            if knots.len() == 2 {
                most = most.max(self.greatest_between(parabola, part, most));
            } else if self.most_between(parabola, part) > most {
                let middle = knots.len() / 2;
                open.extend([&knots[middle..], &knots[..=middle]]);
            }
        }
        most
    }

    /// A quick bound between two places.
    fn most_between(&self, parabola: [f64; 3], part: [f64; 2]) -> f64 {
        self.teeth.lead_sum_bound(part) + greatest_of(parabola, part) - self.least_room(part)
    }

    /// The room of both tips in a part of the face is no less, mm.
    fn least_room(&self, part: [f64; 2]) -> f64 {
        let of = |tip: &PassedTip| {
            let ends = part.map(|b| tip.excess + tip.rate * b);
            let [least, most] = [ends[0].min(ends[1]), ends[0].max(ends[1])];
            let [own, _] = tip.room(least - self.turned);
            own - tip.pull * (least - self.turned).max(0.0)
                + (tip.pull * (most + self.turned).max(0.0)).min(0.0)
        };
        self.tips.iter().map(of).sum()
    }

    /// The bound between two knots. It is not refined once it is no more than `floor`.
    fn greatest_between(
        &self,
        [at_0, rate, curve]: [f64; 3],
        [from, to]: [f64; 2],
        floor: f64,
    ) -> f64 {
        // Just inside, where each lead is one cubic.
        let beside = 1e-9 * (to - from);
        let [low, high] = [from + beside, to - beside];
        let bends = self.teeth.second_derivative_bounds([low, high]);
        let most = bends[0][1] + bends[1][1] + 2.0 * curve;
        // The hollow part is filled up to its chord.
        let hollow = (most + self.most_hollow([from, to], bends[0])).max(0.0);
        let at = |b: f64| {
            let inside = b.clamp(low, high);
            let [locked, free] = self.teeth.leads_and_rates(inside);
            let [room, closing] = self.room(inside, locked);
            let filled = 0.5 * hollow * (inside - from) * (to - inside);
            let filling = 0.5 * hollow * (from + to - 2.0 * inside);
            let along = at_0 + inside * (rate + inside * curve);
            let slope = locked[1] + free[1] + (rate + 2.0 * inside * curve) + filling - closing;
            let value = locked[0] + free[0] + along + filled - room;
            (value + (b - inside) * slope, slope)
        };
        let (mut a, mut b) = ((from, at(from)), (to, at(to)));
        if a.1.1 <= 0.0 {
            return a.1.0;
        }
        if b.1.1 >= 0.0 {
            return b.1.0;
        }
        // Where the tangents of both ends cross.
        let crossing = |a: (f64, (f64, f64)), b: (f64, (f64, f64))| {
            let (x, (value, rate)) = a;
            let (y, (other, falling)) = b;
            let cross = (other - value + rate * x - falling * y) / (rate - falling);
            value + rate * (cross.clamp(x, y) - x)
        };
        let mut bound = crossing(a, b);
        for _ in 0..STEPS {
            if bound <= floor || bound - a.1.0.max(b.1.0) < CLOSE {
                break;
            }
            let middle = 0.5 * (a.0 + b.0);
            let found = (middle, at(middle));
            if found.1.1 > 0.0 {
                a = found;
            } else {
                b = found;
            }
            bound = crossing(a, b);
        }
        bound
    }
}

/// SideBound of the parabola with these coefficients, the constant first, between two places.
fn greatest_of([at_0, rate, curve]: [f64; 3], part: [f64; 2]) -> f64 {
    let [one, other] = part.map(|b| rate * b + curve * b * b);
    // It rises above its chord by a quarter of the square of its width at most.
    let width = part[1] - part[0];
    at_0 + one.max(other) + (-0.25 * curve * width * width).max(0.0)
}

/// The place between two others at which `value` is 0, if its sign differs there.
fn zero(value: impl Fn(f64) -> f64, [from, to]: [f64; 2]) -> Option<f64> {
    let is_below = value(from) < 0.0;
    let differs = (value(to) < 0.0) != is_below;
    differs.then(|| bisect(from, to, 0.0, |b| (value(b) < 0.0) == is_below)[0])
}
