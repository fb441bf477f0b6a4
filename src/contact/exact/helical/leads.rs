//! Places along the face where teeth with lead deviations touch tightest.
//!
//! In the section at `b` a tooth is that of the measuring plane, turned by its twist and by `−δ(b)/r_b`. The gap of a pair on the
//! line of action is a constant plus `Σ δ(b)/r_bF`. A tip corner touches beyond that stretch, and without leads the gap falls concavely
//! there. So between two knots of the leads, where `Σ δ` is straight or crowned, the gap is concave along the face. It is greatest at a knot,
//! at an end of the face, or where its rate `∂μ/∂λ λ' + ∂μ/∂φ φ'` vanishes. [`Separation`] has the gap and both derivatives, for involutes
//! and their ends. It is asked from the stretch on the line outwards, because far beyond it two teeth do not face each other. A pair whose
//! endless involutes cannot reach the known gap is left out.
//!
//! A tip that passes the form circle of its mate touches the fillet there, and leads move the place at which it is tightest ([`deepest`]).
//! The gap of a fillet is searched in each section ([`TurnedTeeth`]), from the end of the stretch on the line and from that place outwards.
//!
//! [`deepest`]: super::super::deepest
//!
//! Where axes lean, the centres of a section move along the face and its flanks turn by what [`crate::pair::section_at`] derives;
//! [`LeaningFrame::rates`] has the rates of both.

use super::place_filter::TurnedTeeth;
use crate::contact::Effort;
use crate::contact::exact::candidate::CandidateContact;
use crate::contact::exact::flank_problem::PosedFlanks;
use crate::contact::exact::leaning::{LeaningFrame, LeaningTouch};
use crate::contact::exact::path::InvolutePair;
use crate::contact::exact::separation::{InvoluteArc, NearStart, Separation};
use crate::contact::exact::shape::{C, turn};
use crate::gear::ProfilePart;
use crate::numeric::rank;
use crate::pair::{FacingTeeth, GearPair};

/// Effort of one evaluation of a pair, nodes (tuned: 0.2 µs).
const EVALUATION: u64 = 1;

/// Distance from a knot at which the rate beside it is taken, as a part of the stretch between knots.
const BESIDE: f64 = 1e-7;

/// Distance, mm, within which two places are the same. A rate between knots is taken a little beside them.
const AT_KNOT: f64 = 1e-6;

/// Parts in which a stretch is examined where the leads are hollow, so that the gap may have several maxima (tuned).
const HOLLOW_PARTS: usize = 8;

/// First step outwards from the stretch on the line, as a part of the rest of a stretch between knots (tuned).
const FIRST_STEP: f64 = 1.0 / 64.0;

/// Greatest effect of a flank's move on the gap of a fillet, against an involute's. Where an edge touches a fillet tightest, the normal
/// passes the pitch point and the effect is that on an involute. The arms differ beside that place (tuned: twice is more than occurs).
pub(super) const MOST_BY_ARMS: f64 = 2.0;

/// Least change of a room by the gap, as a part of the free base radius, of a pair that can be the tightest.
const LEAST_ARM: f64 = 0.5;

/// Roll, rad, beyond the end of an involute that is still on the line of action: some roundings.
const ON_LINE: f64 = 1e-12;

/// Limit of steps to the maximum of a stretch. Six to twelve are usual.
const MOST_STEPS: usize = 60;

/// Limit of steps along a line of action, of which two are usual.
const STEPS_ON_LINE: usize = 4;

/// Gap, rad, by which two places are equally tight: some roundings.
const ROUNDED: f64 = 4e-15;

/// Gap, rad, by which a step to a maximum may still change it: rounding.
const SETTLED: f64 = 1e-15;

/// [`SETTLED`] for leaning axes. It is a millionth of what their sections leave out, or less.
const SETTLED_LEANING: f64 = 1e-14;

/// The teeth of one side of a pose over the common face.
pub(super) struct AlongFace<'a> {
    assembly: &'a GearPair,
    posed: &'a PosedFlanks<'a>,
    /// Twist of the locked and the free gear in the frame of `posed`, rad/mm.
    twists: [f64; 2],
    /// The line of action in the measuring plane, from which touches are searched.
    start: NearStart,
    /// The pair of step 0 on it, with endless involutes.
    first: Separation,
    first_pair: InvolutePair,
    /// The locked and the free involute.
    arcs: [InvoluteArc; 2],
    /// Where axes lean: how the frame changes along the face.
    leaning: Option<LeaningFrame>,
    /// Changes of the gap on the line of action at both ends of the face by the moves of the centres, rad.
    centred: [f64; 2],
    /// Bound of the lean's effect on a gap of the face, mm along the base tangent.
    most_leaning: f64,
    bounds: FaceBounds,
    effort: &'a Effort<'a>,
}

/// Bounds over the face that hold for all teeth of both gears.
#[derive(Debug, Clone, Copy)]
pub(super) struct FaceBounds {
    /// Greatest move of both flanks of a pair by leads, leans and profile deviations, mm along the base tangent.
    pub most_moved: f64,
    /// Greatest sum of the leads of any right flanks, and of any left ones, over the face, less that in the measuring plane, mm.
    pub most_lead: [f64; 2],
    /// Greatest change of both leads of a pair by the heights of contacts between leaning axes, mm.
    pub lead_change: f64,
    /// Whether tips can touch fillets.
    pub in_fillets: bool,
}

/// A stretch between knots, in several parts where the leads are hollow, and the sums of the leads at its ends and between them, mm.
fn parts<'a>(
    teeth: &'a FacingTeeth<'a>,
    [from, to]: [f64; 2],
) -> impl Iterator<Item = ([f64; 2], [f64; 3])> + use<'a> {
    let leads = |[from, to]: [f64; 2]| [from, 0.5 * (from + to), to].map(|b| teeth.lead_sum(b));
    let whole = leads([from, to]);
    let sag = 0.5 * (whole[0] + whole[2]) - whole[1];
    // Above rounding of the leads.
    let count = if sag > 1e-12 { HOLLOW_PARTS } else { 1 };
    let at = move |part: usize| from + (to - from) * (part as f64 / count as f64);
    (0..count).map(move |part| {
        let ends = [at(part), at(part + 1)];
        (ends, if count == 1 { whole } else { leads(ends) })
    })
}

/// A pair of teeth with endless involutes in the measuring plane.
#[derive(Debug, Clone, Copy)]
pub(super) struct EndlessPair {
    step: i64,
    gap: f64,
    rolls: [f64; 2],
    /// As [`PairOfTeeth::window`].
    window: [f64; 2],
}

/// A pair of teeth, and its step.
struct PairOfTeeth<'a> {
    step: i64,
    teeth: FacingTeeth<'a>,
    /// The stretch of the face on which it is on the line of action, mm; without one, the place nearest to it.
    window: [f64; 2],
    /// Whether it is on the line of action there, up to the slight turns by leads at its ends.
    is_on_line: bool,
    /// The sections in which it may touch in a fillet.
    fillets: Fillets,
    /// Bound of its gap without leads and leans.
    most: f64,
    /// Bound of the gap of its involutes with leans and without leads.
    most_without_leads: f64,
}

/// Sections in which a touch in a fillet is searched.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Fillets {
    None,
    /// Where an involute touches at its form circle.
    BelowForm,
    All,
}

/// The gap of a pair in the section at `b`, and its rate along the face, rad/mm.
#[derive(Debug, Clone, Copy)]
struct GapInSection {
    b: f64,
    gap: f64,
    rate: f64,
    /// Heights at which the teeth touch, as [`FacingTeeth::with_heights`].
    heights: [[f64; 2]; 2],
}

/// The touch of a pair in a section.
struct Touch {
    gap: f64,
    /// Change of the gap by a turn of the locked and of the free tooth.
    by_turn: [f64; 2],
    /// Rate of the gap by the moves of both centres along the face, rad per mm.
    moving: f64,
    /// Rates of both leads at the heights of the point, mm per mm.
    lead_rates: [f64; 2],
    /// Where axes lean: the touch from which heights count.
    leaning: Option<(Separation, LeaningTouch)>,
}

/// Change of the gap of a `contact` by a turn of the locked and of the free tooth about the centres of their outlines. The points of both teeth
/// keep one speed along the normal.
fn by_turn(posed: &PosedFlanks, contact: &CandidateContact) -> [f64; 2] {
    let arm = |centre: C| ((contact.point - centre).conj() * contact.normal).im;
    let about = arm(C::ZERO);
    let free_centre = posed.free_centre * turn(contact.gap);
    [arm(posed.centre) / about, -arm(free_centre) / about]
}

impl<'a> AlongFace<'a> {
    /// The teeth of `posed` in the measuring plane of `assembly`, where `nominal` is the gap at the nominal rotation.
    pub fn new(
        assembly: &'a GearPair,
        posed: &'a PosedFlanks<'a>,
        nominal: f64,
        bounds: FaceBounds,
        effort: &'a Effort<'a>,
    ) -> AlongFace<'a> {
        let members = [assembly.locked(), assembly.free()];
        let gears = members.map(|member| assembly.gear(member));
        let wound = gears[0].gear().basic_data().base_helix_angle().tan();
        let reach = gears[0].reach() + gears[1].reach();
        effort.spend(EVALUATION);
        let first = Separation::endless(posed, 0, nominal);
        let near = if first.touches { first.gap } else { nominal };
        let start = NearStart::new(posed, near);
        let leaning = LeaningFrame::new(assembly, posed);
        let centred = assembly.face().map(|b| match &leaning {
            None => 0.0,
            Some(leaning) => {
                effort.spend(EVALUATION);
                let here = leaning.at(posed, b);
                Separation::endless_near(&here, 0, [0.0; 2], &start).gap - first.gap
            }
        });
        AlongFace {
            assembly,
            posed,
            twists: members.map(|member| posed.twist(assembly, member)),
            start,
            centred,
            first,
            first_pair: InvolutePair::new(posed, 0),
            arcs: InvoluteArc::both(posed.problem),
            leaning,
            most_leaning: assembly.shift_bound() + assembly.lean_bound() * wound * reach,
            bounds,
            effort,
        }
    }

    /// The pair of a step with endless involutes; that of step 0 tells it to first order. The second order is that of the free gear's
    /// eccentricity times the square of pitch deviations, below a tie.
    fn endless(&self, step: i64) -> EndlessPair {
        let (first, bases) = (&self.first, self.bases());
        let (own, other) = (&self.first_pair, InvolutePair::new(self.posed, step));
        let turns = [
            other.locked_base - own.locked_base,
            other.free_base - own.free_base,
        ];
        let turned = -(bases[0] * turns[0] + bases[1] * turns[1]) / first.turning;
        let rolls = first.rolls();
        let rolls = [rolls[0] - turns[0], rolls[1] - turned - turns[1]];
        EndlessPair {
            step,
            gap: first.gap + turned,
            rolls,
            window: self.on_line(rolls),
        }
    }

    /// The gap of a pair whose involutes end, about.
    fn about(&self, pair: &EndlessPair) -> f64 {
        let rolls = self.rolls_at(pair.rolls, pair.window[0]);
        pair.gap - self.room(rolls) / self.bases()[1]
    }

    /// The places, mm, at which a pair is tightest and its gap exceeds `floor`, the tightest first. Ties within `tie` are included. `deepest`
    /// has the steps and places at which edges touch fillets tightest without leads and leans. The second result is the tightest gap, or
    /// `floor`. `steps` are those of [`AlongFace::steps`].
    pub fn places(
        &self,
        steps: &[(EndlessPair, f64)],
        floor: f64,
        tie: f64,
        deepest: impl Iterator<Item = (i64, f64)>,
    ) -> (Vec<f64>, f64) {
        let (mut found, mut best) = (Vec::new(), floor);
        let mut examine = |pair: &PairOfTeeth<'a>, best: &mut f64| {
            for (ends, most) in self.stretches(pair, *best - tie) {
                if most <= *best - tie {
                    break;
                }
                if let Some(look) = self.greatest(pair, ends) {
                    *best = best.max(look.gap);
                    found.push((pair.step, look));
                }
            }
        };
        let leads = self.bounds.most_lead[self.posed.problem.side.index()];
        let heights = self.of_moves(2.0 * self.bounds.lead_change);
        let more = self.of_moves(leads) + heights;
        // Pairs of spur gears with one lead each differ by a constant along their line: by no more than their bounds.
        let are_alike = self.assembly.has_one_lead() && !self.assembly.is_helical();
        let mut alike = f64::INFINITY;
        for (endless, most) in steps {
            if self.is_plain() && most + more.min(alike) <= best - tie {
                continue;
            }
            let pair = self.pair(endless, *most, floor - tie);
            // Involutes do not tell where flanks touch whose profiles deviate: see [`super::profiles`].
            if !self.assembly.is_modified() || pair.fillets != Fillets::None {
                let before = best;
                examine(&pair, &mut best);
                if are_alike && best > before && self.is_on_line(endless) {
                    alike = best - most + heights + self.of_moves(self.second_order());
                }
            }
        }
        for pair in deepest.filter_map(|(step, b)| self.pair_at(step, b, floor)) {
            examine(&pair, &mut best);
        }
        found.retain(|(_, look)| look.gap >= best - tie && look.gap > floor);
        // The greatest gap first, of equal ones the nearest.
        found.sort_by_cached_key(|(_, look)| rank(look.b.abs()));
        found.sort_by_cached_key(|(_, look)| rank(-look.gap));
        let mut places: Vec<f64> = found.iter().map(|(_, look)| look.b).collect();
        // A place at a knot is found from either side of it.
        places.dedup_by(|other, one| (*other - *one).abs() <= AT_KNOT);
        // The place nearest to the measuring plane is reported among equally tight ones.
        if !floor.is_finite() && self.leaning.is_none() {
            let [from, to] = self.assembly.face();
            let plane = 0f64.clamp(from, to);
            let ties = |step: i64| {
                let endless = self.endless(step);
                let pair = self.pair(&endless, self.most_without_leads(&endless), floor);
                // Endless involutes touch no later.
                let leads = self.of_moves(pair.teeth.lead_sum(plane));
                let is_known = self.is_plain() && endless.gap + leads < best - tie;
                let touch = (!is_known).then(|| self.touch(&pair, plane)).flatten();
                touch.is_some_and(|touch| touch.gap >= best - ROUNDED)
            };
            if places.first() != Some(&plane) && found.iter().any(|(step, _)| ties(*step)) {
                places = vec![plane];
            }
        }
        (places, best)
    }

    /// Places of the locked teeth of those `steps` that can be as tight as `floor` in any section, or become so by turns that leave leans out.
    /// `None`: perhaps all.
    pub fn near(&self, steps: &[(EndlessPair, f64)], floor: f64) -> Option<Vec<usize>> {
        if !self.is_plain() {
            return None;
        }
        let leads = self.bounds.most_lead[self.posed.problem.side.index()];
        let more = self.of_moves(leads + 2.0 * self.bounds.most_moved);
        let near = steps.iter().filter(|(_, most)| most + more > floor);
        Some(
            near.map(|(pair, _)| self.posed.places(pair.step).0)
                .collect(),
        )
    }

    /// Bound of the gap of a pair of involutes over the face, without leads.
    ///
    /// The gap falls beyond the stretch on the line of action, and along it it is linear but for the second order of the leans. Off the line
    /// the ends of the involutes leave room in the direction of the line. Heights turn no flank of spur gears.
    fn most_without_leads(&self, pair: &EndlessPair) -> f64 {
        let room = self.least_room(self.rolls_at(pair.rolls, pair.window[0]));
        // An edge at the form circle can stand beyond the endless involute.
        let turning = if room > 0.0 {
            self.posed.problem.most_turning()
        } else {
            LEAST_ARM * self.bases()[1]
        };
        let apart = pair.gap - room / turning;
        let is_spur = !self.assembly.is_helical();
        let leaning = self.leaning.as_ref();
        let Some(leaning) = leaning.filter(|_| is_spur || self.is_on_line(pair)) else {
            return apart + self.of_moves(self.most_leaning);
        };
        let [from, to] = self.assembly.face();
        let [low, high] = self.centred;
        let at_end = |b: f64| {
            let share = if to > from {
                (b - from) / (to - from)
            } else {
                0.0
            };
            let turns =
                leaning.turns_on_line(self.rolls_at(pair.rolls, b), &self.first, &self.start);
            let by_turn = self.first.by_turn;
            low + share * (high - low) + turns[0] * by_turn[0] + turns[1] * by_turn[1]
        };
        let most = if is_spur {
            low.max(high)
        } else {
            at_end(pair.window[0]).max(at_end(pair.window[1]))
        };
        apart + most.min(self.of_moves(self.most_leaning)) + self.of_moves(self.second_order())
    }

    /// Bound of the second order of the leans along a line of action, mm along the base tangent.
    ///
    /// Centres that move by `m` across the line, of the length `T`, bend the gap by `m²/(2T)`, and turn the line by `m/T`, which moves heights
    /// by as much again. Four times that are taken for both gears.
    fn second_order(&self) -> f64 {
        4.0 * self.most_leaning * self.most_leaning / self.first.line_length()
    }

    /// Whether a pair is on the line of action at both ends of its stretch. Spur gears may leave it there by leads.
    fn is_on_line(&self, pair: &EndlessPair) -> bool {
        let is_spur = self.twists == [0.0; 2];
        let play = if is_spur {
            self.most_turned()
        } else {
            -ON_LINE
        };
        let at = |b: f64| self.are_on_arcs(self.rolls_at(pair.rolls, b), play);
        pair.window.into_iter().all(at)
    }

    /// Room that involutes with ends have more than endless ones with these rolls, mm.
    fn room(&self, rolls: [f64; 2]) -> f64 {
        self.arcs[0].room(rolls[0]) + self.arcs[1].room(rolls[1])
    }

    /// Least room of involutes with ends beyond that of endless ones, mm, where leads and leans turn teeth that have these rolls. It is that at
    /// an end of what they turn.
    fn least_room(&self, rolls: [f64; 2]) -> f64 {
        let turned = self.most_turned();
        let room = [0, 1].map(|k| {
            let arc = &self.arcs[k];
            arc.room(rolls[k] - turned).min(arc.room(rolls[k] + turned))
        });
        room[0] + room[1]
    }

    /// Whether no touch is beside the involutes and their ends.
    fn is_plain(&self) -> bool {
        !self.bounds.in_fillets && !self.assembly.is_modified()
    }

    /// Change of a gap by moves of both flanks, mm along the base tangent. A gap of an eccentric free gear changes by up to a little more than
    /// on a fixed line.
    fn of_moves(&self, moves: f64) -> f64 {
        let (base, off) = (self.bases()[1], self.posed.problem.free_off.norm());
        (moves + off / (base - off) * moves.abs()) / base
    }

    /// The steps whose gap may exceed `floor`, those first that are likely to be tightest, with the bounds of their gaps without leads.
    pub fn steps(&self, floor: f64) -> Vec<(EndlessPair, f64)> {
        if !self.first.touches {
            return Vec::new();
        }
        let turns = self.assembly.face().map(|b| self.twists[0] * b);
        let steps = self.posed.steps_over(turns);
        let mut pairs: Vec<EndlessPair> = steps.map(|step| self.endless(step)).collect();
        let level = self.level(&pairs).max(floor);
        pairs.retain(|pair| self.can_reach(pair, level));
        pairs.sort_by_cached_key(|pair| rank(-self.about(pair)));
        let bounded = |pair| (pair, self.most_without_leads(&pair));
        pairs.into_iter().map(bounded).collect()
    }

    /// Rolls at `b`, mm, of a pair that has these in the measuring plane.
    fn rolls_at(&self, rolls: [f64; 2], b: f64) -> [f64; 2] {
        [0, 1].map(|k| rolls[k] - self.twists[k] * b)
    }

    /// Whether rolls are on both involutes.
    fn are_on_arcs(&self, rolls: [f64; 2], play: f64) -> bool {
        (0..2).all(|k| self.arcs[k].holds(rolls[k], play))
    }

    /// A gap that one of `pairs` reaches: that of the tightest on the line of action somewhere on the face, without what its leads may take.
    fn level(&self, pairs: &[EndlessPair]) -> f64 {
        // Leads and leans change rolls by less.
        let play = 2.0 * self.most_turned();
        let gaps = pairs.iter().filter_map(|pair| {
            let [from, to] = pair.window;
            let middle = self.rolls_at(pair.rolls, 0.5 * (from + to));
            self.are_on_arcs(middle, play).then_some(pair.gap)
        });
        gaps.fold(f64::NEG_INFINITY, f64::max) - 2.0 * self.bounds.most_moved / self.bases()[1]
    }

    /// Whether the gap of a pair may exceed `level`: false if the direction of the line of action keeps its teeth apart there.
    fn can_reach(&self, pair: &EndlessPair, level: f64) -> bool {
        if !self.is_plain() || !level.is_finite() {
            return true;
        }
        let rolls = [pair.rolls[0], pair.rolls[1] + (pair.gap - level)];
        let rolls = self.rolls_at(rolls, pair.window[0]);
        // Turns of the teeth move either of them by no more than this along the line.
        let room = self.room(rolls) + (level - pair.gap) * self.first.turning;
        room <= 2.0 * self.bounds.most_moved
    }

    /// The pair of a step, whose involutes have no greater gap than `most_without_leads`. Fillets are left out where its gap cannot exceed
    /// `floor`.
    fn pair(&self, pair: &EndlessPair, most_without_leads: f64, floor: f64) -> PairOfTeeth<'a> {
        let &EndlessPair {
            step,
            gap: endless,
            rolls,
            window,
            ..
        } = pair;
        let teeth = self.posed.facing_teeth(self.assembly, step);
        if self.is_plain() && self.are_on_arcs(self.rolls_at(rolls, window[0]), -ON_LINE) {
            return PairOfTeeth {
                step,
                teeth,
                window,
                is_on_line: self.is_on_line(pair),
                fillets: Fillets::None,
                most: endless,
                most_without_leads,
            };
        }
        // The gap of a pair falls along the face beyond its line: it is tightest in the section nearest to it.
        let turns = self.twists.map(|twist| twist * window[0]);
        self.effort.spend(EVALUATION);
        let nearest = Separation::near(self.posed, step, turns, &self.start);
        let most = if nearest.touches {
            nearest.gap + self.beside(&teeth, &nearest)
        } else {
            endless
        };
        let turned = self.most_moved(&teeth) * self.per_moved();
        let is_below_form = |found: &Separation| !found.touches || found.is_below_form(turned);
        let mut most = most.min(endless);
        let mut fillets = Fillets::None;
        // From the end of the line on, the gap of a fillet falls. A pair with a line on the face is as tight at that end.
        let may_be_below_form = || {
            most + self.most_in_fillets(&teeth) > floor
                && self.assembly.face().iter().any(|b| {
                    let turns = self.twists.map(|twist| twist * b);
                    self.effort.spend(EVALUATION);
                    let found = Separation::near(self.posed, step, turns, &self.start);
                    is_below_form(&found)
                })
        };
        if self.bounds.in_fillets && (is_below_form(&nearest) || may_be_below_form()) {
            fillets = Fillets::BelowForm;
            let contact = TurnedTeeth::new(self.posed, step, turns).in_fillets(most, self.effort);
            most = contact.map_or(most, |contact| contact.gap);
        }
        PairOfTeeth {
            step,
            teeth,
            window,
            is_on_line: false,
            fillets,
            most,
            most_without_leads: most_without_leads.min(most + self.of_moves(self.most_leaning)),
        }
    }

    /// The pair of a step that touches in a fillet, tightest at `b`, mm, without leads and leans; `None` if its gap cannot exceed `floor`.
    fn pair_at(&self, step: i64, b: f64, floor: f64) -> Option<PairOfTeeth<'a>> {
        let teeth = self.posed.facing_teeth(self.assembly, step);
        let turned = TurnedTeeth::new(self.posed, step, self.twists.map(|twist| twist * b));
        let contact = turned.in_fillets(floor - self.most_in_fillets(&teeth), self.effort)?;
        Some(PairOfTeeth {
            step,
            teeth,
            window: [b; 2],
            is_on_line: false,
            fillets: Fillets::All,
            most: contact.gap,
            most_without_leads: contact.gap + self.of_moves(self.most_leaning),
        })
    }

    /// Greatest change of the gap of a touch in a fillet by leads and leans, rad.
    fn most_in_fillets(&self, teeth: &FacingTeeth) -> f64 {
        MOST_BY_ARMS * self.most_moved(teeth) / self.bases()[1]
    }

    /// Turn of both teeth by 1 mm along the base tangent, rad.
    fn per_moved(&self) -> f64 {
        let bases = self.bases();
        1.0 / bases[0] + 1.0 / bases[1]
    }

    /// Bound on the turn of both teeth of any pair by leads, leans and profile deviations, rad.
    fn most_turned(&self) -> f64 {
        self.bounds.most_moved * self.per_moved()
    }

    /// Base radii of the locked and the free gear, mm.
    fn bases(&self) -> [f64; 2] {
        let problem = self.posed.problem;
        [problem.locked.shape.base, problem.free.shape.base]
    }

    /// Greatest move of both flanks of these teeth by leads, leans and profile deviations, mm along the base tangent.
    fn most_moved(&self, teeth: &FacingTeeth) -> f64 {
        if !self.assembly.is_modified() {
            return self.bounds.most_moved;
        }
        let leads = teeth.teeth.map(|(gear, tooth)| {
            let curve = gear.lead_curve(teeth.side, tooth);
            curve.map_or(0.0, |curve| curve.range())
        });
        let profiles = teeth.teeth.map(|(gear, tooth)| {
            let flank = gear.modification(teeth.side, tooth);
            let range = gear.profile(teeth.side, tooth).range(ProfilePart::Involute);
            let own = flank.map_or([0.0; 2], |curve| curve.bounds(range.0, range.1)[0]);
            own[0].abs().max(own[1].abs())
        });
        leads[0] + leads[1] + self.most_leaning + profiles[0] + profiles[1]
    }

    /// Greatest loss, by leads and leans, of the room of the tips that a pair has passed in `nearest`, rad: they turn its teeth.
    fn beside(&self, teeth: &FacingTeeth, nearest: &Separation) -> f64 {
        let bases = self.bases();
        let turned = self.most_moved(teeth) * self.per_moved();
        let (rolls, on) = (nearest.rolls(), nearest.rolls_on_arcs());
        // The room of a tip passed by ω grows with ω at most by √(1 + ξ²) ω.
        let passed = [0, 1].map(|k| {
            let beyond = (rolls[k] - on[k]).abs() + turned;
            bases[k] * (1.0 + on[k] * on[k]).sqrt() * beyond * turned
        });
        2.0 * (passed[0] + passed[1]) / bases[1]
    }

    /// The stretch of the face, mm, on which a pair with these rolls in the measuring plane is on the line of action, up to the slight turns
    /// by leads. Without one, the place nearest to it.
    fn on_line(&self, rolls: [f64; 2]) -> [f64; 2] {
        let face = self.assembly.face();
        let shapes = [
            &self.posed.problem.locked.shape,
            &self.posed.problem.free.shape,
        ];
        let mut window = [f64::NEG_INFINITY, f64::INFINITY];
        let rolls = rolls.into_iter().zip(shapes).zip(self.twists);
        // Spur gears have the same rolls in every section.
        for ((roll, shape), twist) in rolls.filter(|(_, twist)| *twist != 0.0) {
            let ends = [shape.lowest_roll(), shape.tip_roll].map(|end| (roll - end) / twist);
            window[0] = window[0].max(ends[0].min(ends[1]));
            window[1] = window[1].min(ends[0].max(ends[1]));
        }
        let [from, to] = window;
        let middle = (0.5 * (from + to)).clamp(face[0], face[1]);
        if from <= to {
            [from, to].map(|end| end.clamp(face[0], face[1]))
        } else {
            [middle; 2]
        }
    }

    /// Stretches of the face between knots of both leads of a step in which its gap may exceed `floor`, with their bounds of it, the greatest
    /// first.
    fn stretches(&self, pair: &PairOfTeeth<'a>, floor: f64) -> Vec<([f64; 2], f64)> {
        let problem = self.posed.problem;
        let shapes = [&problem.locked.shape, &problem.free.shape];
        // An edge at the form circle stands beyond the endless involute.
        let is_bound = shapes.iter().all(|shape| shape.corners().len() == 1);
        let bounded = |(ends, leads): ([f64; 2], [f64; 3])| {
            if !is_bound {
                return (ends, f64::INFINITY);
            }
            if pair.fillets != Fillets::None {
                return (ends, pair.most + self.most_in_fillets(&pair.teeth));
            }
            // A crown between the ends rises above their chord by a quarter of the rise of twice the middle.
            let [from, middle, to] = leads;
            let bend = (middle - 0.5 * (from + to)).max(0.0);
            let most = from.max(to).max(middle) + bend + 2.0 * self.bounds.lead_change;
            (ends, pair.most_without_leads + self.of_moves(most))
        };
        // Leans move the ends of the face: far pairs are left out before that is known.
        if is_bound && pair.fillets == Fillets::None {
            let leads = pair.teeth.lead_sum_bound(self.assembly.face());
            let leads = self.of_moves(leads + 2.0 * self.bounds.lead_change);
            if pair.most_without_leads + leads <= floor {
                return Vec::new();
            }
        }
        let face = self.own_face(pair, pair.window);
        let ends = [self.assembly.locked(), self.assembly.free()]
            .map(|member| self.assembly.own_face(member));
        let section = |k: usize, place: f64| {
            // Ends of the teeth are ends of the face.
            if self.leaning.is_none() || ends[k].contains(&place) {
                place
            } else {
                self.section_of(pair, k, place)
            }
        };
        let knots = pair.teeth.knots(face, section);
        let all = knots.windows(2).map(|ends| [ends[0], ends[1]]);
        let parts = all.flat_map(|ends| parts(&pair.teeth, ends));
        let bounded = parts.map(bounded).filter(|(_, most)| *most > floor);
        let mut bounded: Vec<([f64; 2], f64)> = bounded.collect();
        bounded.sort_by_cached_key(|(_, most)| rank(-most));
        bounded
    }

    /// Turns of both teeth by twist and `leads`, mm, at `b`, mm, without heights, rad.
    fn turns(&self, b: f64, leads: [f64; 2]) -> [f64; 2] {
        let bases = self.bases();
        [0, 1].map(|k| self.twists[k] * b - leads[k] / bases[k])
    }

    /// The gap of a step at `b`, mm; `None` where the teeth do not face each other.
    fn gap_in_section(&self, pair: &PairOfTeeth, b: f64) -> Option<GapInSection> {
        let (found, bases) = (self.touch(pair, b)?, self.bases());
        let rate = |rates: [f64; 2]| {
            let by_turns = [0, 1].map(|k| found.by_turn[k] * rates[k]);
            found.moving + by_turns[0] + by_turns[1]
        };
        let plain = [0, 1].map(|k| self.twists[k] - found.lead_rates[k] / bases[k]);
        let (mut turning, mut heights) = (plain, [[0.0, 1.0]; 2]);
        if let (Some(leaning), Some((undisturbed, there))) = (&self.leaning, &found.leaning) {
            let turned = [plain[0], plain[1] + rate(plain)];
            let rates = leaning.rates(undisturbed, &self.start, there, turned);
            for (k, [rising, more]) in rates.into_iter().enumerate() {
                turning[k] += more - found.lead_rates[k] * rising / bases[k];
            }
            heights = there.heights_along(b, rates);
        }
        Some(GapInSection {
            b,
            gap: found.gap,
            rate: rate(turning),
            heights,
        })
    }

    /// The touch of a pair in the section at `b`, mm; `None` where its teeth do not face each other.
    fn touch(&self, pair: &PairOfTeeth, b: f64) -> Option<Touch> {
        self.effort.spend(EVALUATION);
        let (step, bases) = (pair.step, self.bases());
        let plain = pair.teeth.leads_and_rates(b);
        let turns = self.turns(b, plain.map(|[lead, _]| lead));
        let Some(leaning) = &self.leaning else {
            let found = Separation::near(self.posed, step, turns, &self.start);
            return self.touch_of(pair, self.posed, turns, &found, plain, None);
        };
        // As in a section, heights are those of the touch before they turn the teeth, of involutes and their ends.
        let (here, undisturbed, there) =
            leaning.undisturbed(self.posed, (step, b), turns, &self.start)?;
        let teeth = pair
            .teeth
            .with_heights(there.heights.map(|height| [height, 1.0]));
        let jets = teeth.leads_and_rates(b);
        let more = [0, 1].map(|k| there.turns[k] - (jets[k][0] - plain[k][0]) / bases[k]);
        let turns = [0, 1].map(|k| turns[k] + more[k]);
        let found = undisturbed
            .turned_further(more, self.posed.problem.free_off.norm())
            .unwrap_or_else(|| {
                let start = self.start.at(&undisturbed);
                Separation::near(&here, step, turns, &start)
            });
        self.touch_of(pair, &here, turns, &found, jets, Some((undisturbed, there)))
    }

    /// The touch of a pair whose involutes touch as `found`, in a fillet where one is tighter. The teeth of the section are `here`, turned by
    /// `turns`, rad.
    fn touch_of(
        &self,
        pair: &PairOfTeeth,
        here: &PosedFlanks,
        turns: [f64; 2],
        found: &Separation,
        leads: [[f64; 2]; 2],
        leaning: Option<(Separation, LeaningTouch)>,
    ) -> Option<Touch> {
        let is_searched = match pair.fillets {
            Fillets::None => false,
            Fillets::BelowForm => {
                let play = if self.assembly.is_modified() {
                    self.most_moved(&pair.teeth) * self.per_moved()
                } else {
                    0.0
                };
                found.touches && found.is_below_form(play)
            }
            Fillets::All => true,
        };
        let floor = if found.touches && !self.assembly.is_modified() {
            found.gap
        } else {
            f64::NEG_INFINITY
        };
        let teeth = is_searched.then(|| TurnedTeeth::new(here, pair.step, turns));
        let contact = teeth.and_then(|teeth| teeth.in_fillets(floor, self.effort));
        let (gap, by_turn, moving) = match &contact {
            Some(contact) => (
                contact.gap,
                by_turn(here, contact),
                self.moving_in_fillets(contact),
            ),
            None if found.touches && !self.assembly.is_modified() => {
                let moving = self.leaning.as_ref();
                let moving = moving.map_or(0.0, |leaning| leaning.rate(found, &self.start));
                (found.gap, found.by_turn, -moving / found.turning)
            }
            None => return None,
        };
        Some(Touch {
            gap,
            by_turn,
            moving,
            lead_rates: leads.map(|[_, rate]| rate),
            leaning,
        })
    }

    /// Rate of the gap of a `contact` in a fillet by the moves of both centres along the face, rad per mm.
    fn moving_in_fillets(&self, contact: &CandidateContact) -> f64 {
        let Some(leaning) = &self.leaning else {
            return 0.0;
        };
        let moves = leaning.moves(turn(contact.gap));
        let about = (contact.point.conj() * contact.normal).im;
        (moves.conj() * contact.normal).re / about
    }

    /// Both ends of the face of a pair, mm, where the teeth of both gears are in the section where they touch. Heights are those at the places
    /// `at`: near them the ends are exact.
    fn own_face(&self, pair: &PairOfTeeth<'a>, at: [f64; 2]) -> [f64; 2] {
        let face = self.assembly.face();
        if self.leaning.is_none() {
            return face;
        }
        let members = [self.assembly.locked(), self.assembly.free()];
        let first = self.heights(pair, at[0]);
        let second = if at[0] == at[1] {
            first
        } else {
            self.heights(pair, at[1])
        };
        [0, 1].map(|which| {
            let own = members.map(|member| self.assembly.own_face(member)[which]);
            let Some(heights) = [first, second][which] else {
                return face[which];
            };
            let ends = [0, 1].map(|k| heights.section_of(k, own[k]));
            if which == 0 {
                ends[0].max(ends[1])
            } else {
                ends[0].min(ends[1])
            }
        })
    }

    /// The teeth of a pair with the heights at which they touch in the section at `b`, mm; `None` where they do not face each other or axes are
    /// parallel.
    fn heights(&self, pair: &PairOfTeeth<'a>, b: f64) -> Option<FacingTeeth<'a>> {
        let leaning = self.leaning.as_ref()?;
        self.effort.spend(EVALUATION);
        let turns = self.turns(b, pair.teeth.leads(b));
        let (_, found, touch) =
            leaning.undisturbed(self.posed, (pair.step, b), turns, &self.start)?;
        let gap_rate = found.by_turn[0] * self.twists[0] + found.by_turn[1] * self.twists[1];
        let turning = [self.twists[0], self.twists[1] + gap_rate];
        let rates = leaning.rates(&found, &self.start, &touch, turning);
        Some(pair.teeth.with_heights(touch.heights_along(b, rates)))
    }

    /// The section, mm, in which a pair touches at the height `own`, mm, of the gear `k`.
    fn section_of(&self, pair: &PairOfTeeth<'a>, k: usize, own: f64) -> f64 {
        let heights = self.heights(pair, own);
        heights.map_or(own, |heights| heights.section_of(k, own))
    }

    /// The greatest gap of a step over a stretch in which it is concave, found from the part of the stretch nearest to its window. `None`
    /// where the teeth do not face each other.
    ///
    /// Leaning axes bend it the other way where a contact leaves the line: its height begins to move at another rate. So it is followed from a
    /// little inside each end of the window to the middle, and from a little outside each end outwards.
    fn greatest(&self, pair: &PairOfTeeth, [from, to]: [f64; 2]) -> Option<GapInSection> {
        // Sections of knots of leaning axes are known to some roundings of heights.
        let least = if self.leaning.is_some() { AT_KNOT } else { 0.0 };
        let beside = (BESIDE * (to - from)).max(least.min(0.25 * (to - from)));
        let inside = |b: f64| b.clamp(from + beside, to - beside);
        let [start, end] = pair.window.map(inside);
        if let Some(b) = self.where_leads_are_greatest(pair, [start, end]) {
            return self.gap_in_section(pair, b);
        }
        // An end of the window outside of the stretch is no end of the line.
        let play = self.play_of_ends();
        let play_at = |own: f64, end: f64| if own == end { play } else { 0.0 };
        let plays = [play_at(pair.window[0], start), play_at(pair.window[1], end)];
        let middle = 0.5 * (start + end);
        let inner = [(start + plays[0]).min(middle), (end - plays[1]).max(middle)];
        let look = |b: f64| self.gap_in_section(pair, b);
        let on_line =
            (pair.is_on_line && inner[0] < inner[1]).then(|| self.greatest_on_line(pair, inner));
        let (left, right) = if let Some(on_line) = on_line.flatten() {
            // A place beside an end of the face may be beyond it.
            let is_left = on_line.b == inner[0] && on_line.rate <= 0.0;
            let is_right = on_line.b == inner[1] && on_line.rate >= 0.0;
            let outwards = |border: f64| self.greatest_outwards(pair, on_line, border, beside);
            let left = is_left.then(|| outwards(from));
            let right = is_right.then(|| outwards(to));
            (left, right.or((!is_left).then_some(on_line)))
        } else {
            let low = look(inner[0])?;
            let high = if inner[1] == inner[0] {
                low
            } else {
                look(inner[1])?
            };
            let middle = if self.leaning.is_some() && inner[0] < inner[1] {
                look(middle)?
            } else if low.rate > 0.0 {
                high
            } else {
                low
            };
            let left = if low.rate <= 0.0 {
                Some(self.greatest_outwards(pair, low, from, beside))
            } else {
                (middle.rate < 0.0).then(|| self.greatest_between(low, middle, &look))
            };
            let right = if high.rate >= 0.0 {
                Some(self.greatest_outwards(pair, high, to, beside))
            } else {
                (middle.rate >= 0.0).then(|| self.greatest_between(middle, high, &look))
            };
            (left, right)
        };
        let ends = [(start, -plays[0], from), (end, plays[1], to)];
        let beyond = ends.map(|(end, play, border)| {
            let outer = (play != 0.0).then(|| self.gap_in_section(pair, inside(end + play)));
            let outer = outer.flatten().filter(|outer| outer.rate * play > 0.0);
            outer.map(|outer| self.greatest_outwards(pair, outer, border, beside))
        });
        let found = [left, right].into_iter().chain(beyond).flatten();
        found.reduce(|one, other| if other.gap > one.gap { other } else { one })
    }

    /// The greatest gap of a step between two places, both included, between which it is on the line of action. There the gap is linear but for
    /// the leads and the second order of leans: what leads leave of the rate in one section is about that of the others. `None` where the leads
    /// are hollow, or where the second order counts, as leads make up for leans.
    fn greatest_on_line(&self, pair: &PairOfTeeth, [from, to]: [f64; 2]) -> Option<GapInSection> {
        let turning = self.first.turning;
        let mut at = self.gap_in_section(pair, 0.5 * (from + to))?;
        for _ in 0..STEPS_ON_LINE {
            let teeth = pair.teeth.with_heights(at.heights);
            let by_leads = |b: f64| {
                let jets = teeth.leads_and_rates(b);
                [0, 1].map(|k| (jets[0][k] + jets[1][k]) / turning)
            };
            let smooth = at.rate - by_leads(at.b)[1];
            let of_line = |b: f64| {
                let [lead, rate] = by_leads(b);
                GapInSection {
                    b,
                    gap: lead + smooth * (b - at.b),
                    rate: smooth + rate,
                    heights: at.heights,
                }
            };
            let [low, middle, high] = [from, 0.5 * (from + to), to].map(of_line);
            if middle.rate > low.rate || high.rate > middle.rate {
                return None;
            }
            let b = if low.rate <= 0.0 {
                from
            } else if high.rate >= 0.0 {
                to
            } else {
                self.greatest_between(low, high, &|b| Some(of_line(b))).b
            };
            if b == at.b || (at.rate * (b - at.b)).abs() < self.settled() {
                return Some(at);
            }
            at = self.gap_in_section(pair, b)?;
        }
        None
    }

    /// The place inside a stretch at which the sum of both leads is greatest, if the teeth are on the line of action there. The gap of a pair
    /// on the line is a function of that sum alone.
    fn where_leads_are_greatest(&self, pair: &PairOfTeeth, [start, end]: [f64; 2]) -> Option<f64> {
        if !self.is_plain() || self.leaning.is_some() {
            return None;
        }
        let base = self.bases()[1];
        let leads = |b: f64| {
            let [locked, free] = pair.teeth.leads_and_rates(b);
            let [gap, rate] = [0, 1].map(|k| (locked[k] + free[k]) / base);
            GapInSection {
                b,
                gap,
                rate,
                heights: [[0.0, 1.0]; 2],
            }
        };
        let (low, high) = (leads(start), leads(end));
        if !(low.rate > 0.0 && high.rate < 0.0) {
            return None;
        }
        let b = self.greatest_between(low, high, &|b| Some(leads(b))).b;
        let rolls = self.rolls_at(self.endless(pair.step).rolls, b);
        let is_on = self.are_on_arcs(rolls, self.most_turned());
        is_on.then_some(b)
    }

    /// Bound on how far leads and leans move the ends of a window of leaning helical gears, mm. It is 0 for parallel axes, where the gap has no
    /// bend there, and for spur gears, whose windows end with the face.
    fn play_of_ends(&self) -> f64 {
        let turned = self.most_turned();
        match self.leaning {
            Some(_) if self.assembly.is_helical() => {
                turned / self.twists[0].abs().min(self.twists[1].abs())
            }
            _ => 0.0,
        }
    }

    /// The greatest gap of a step outwards from `last`, from which it rises to a maximum or up to the `border`.
    fn greatest_outwards(
        &self,
        pair: &PairOfTeeth,
        mut last: GapInSection,
        border: f64,
        beside: f64,
    ) -> GapInSection {
        let outwards = (border - last.b).signum();
        let mut way = FIRST_STEP * (border - last.b).abs();
        loop {
            let left = (border - last.b).abs();
            if left <= 2.0 * beside {
                // Heights bend beyond the line, so an end of the face is found again there. The border may also be a knot near it.
                let [low, high] = self.own_face(pair, [border; 2]);
                let play = 2.0 * self.assembly.height_bound();
                let is_near = |end: &f64| (border - end).abs() <= play;
                let ends = [low, high].into_iter().filter(is_near);
                let inside = Some(border).filter(|border| (low..=high).contains(border));
                let found = ends.chain(inside);
                let found = found.filter_map(|b| self.gap_in_section(pair, b));
                let best = found.reduce(|one, other| if other.gap > one.gap { other } else { one });
                return best.unwrap_or(last);
            }
            let b = last.b + outwards * way.min(left - beside);
            let Some(next) = self.gap_in_section(pair, b) else {
                // Too far out.
                way *= 0.5;
                if way < beside {
                    return last;
                }
                continue;
            };
            if next.rate * outwards <= 0.0 {
                let (low, high) = if outwards > 0.0 {
                    (last, next)
                } else {
                    (next, last)
                };
                return self.greatest_between(low, high, &|b| self.gap_in_section(pair, b));
            }
            last = next;
            way *= 2.0;
        }
    }

    /// Gap, rad, by which a step to a maximum may still change it.
    fn settled(&self) -> f64 {
        if self.leaning.is_some() {
            SETTLED_LEANING
        } else {
            SETTLED
        }
    }

    /// The greatest gap between two places, from which it rises inwards.
    fn greatest_between(
        &self,
        mut low: GapInSection,
        mut high: GapInSection,
        look: &dyn Fn(f64) -> Option<GapInSection>,
    ) -> GapInSection {
        let settled = self.settled();
        // Regula falsi, halving the rate of an end that stays twice (Illinois).
        let mut rates = [low.rate, high.rate];
        let mut last_moved = None;
        for _ in 0..MOST_STEPS {
            // The rate falls by this much per mm, and the gap rises from either end by half its square over it.
            let rate = low.rate.abs().min(high.rate.abs());
            if (high.b - low.b) * rate * rate < settled * (low.rate - high.rate) {
                break;
            }
            let share = rates[0] / (rates[0] - rates[1]);
            let b = low.b + (high.b - low.b) * share.clamp(0.01, 0.99);
            let Some(next) = look(b) else {
                break;
            };
            let moved = usize::from(next.rate <= 0.0);
            if last_moved == Some(moved) {
                rates[1 - moved] *= 0.5;
            }
            rates[moved] = next.rate;
            last_moved = Some(moved);
            if moved == 0 {
                low = next;
            } else {
                high = next;
            }
        }
        if low.gap >= high.gap { low } else { high }
    }
}
