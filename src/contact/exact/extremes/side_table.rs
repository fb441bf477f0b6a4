//! Tables of one side: bounds of the room in each part of a pitch, and the flank offsets of every place.

use super::super::line::Line;
use super::super::path::InvolutePair;
use super::super::shape::C;
use super::super::teeth::Teeth;
use super::mesh_cycle::{CycleSide, PARTS, PosedSide};
use super::rolls::{RollsOnLine, StepRoom};
use crate::gear::involute;
use crate::pair::overlap_half_angle;
use std::ops::Range;

/// Tables of one side of a cycle.
#[derive(Debug)]
pub(super) struct SideTable {
    /// `r δ_L` and `δ_F` by place, continued by `pad` places at both ends.
    locked: Vec<f64>,
    free: Vec<f64>,
    pad: i64,
    /// Places of step 0 at the start of the cycle; the locked one falls by `sense` with each mating.
    first: [i64; 2],
    sense: i64,
    /// Steps whose half teeth are in reach somewhere in a pitch.
    steps: Range<i64>,
    /// Steps that can be the tightest, with their least room beside the line of action: that of their involutes, and that of a tip corner
    /// and a fillet.
    pub open: [Vec<(i64, f64, f64)>; PARTS],
    /// The steps decided by involutes and their ends, and those whose tip corners can reach fillets.
    pub plain: [Vec<(i64, f64)>; PARTS],
    pub at_fillets: [Vec<(i64, StepRoom)>; PARTS],
    /// Whether a tip corner on a fillet can have no more room than a pair on the line of action. It need not have less than
    /// [`SideTable::plain`] gives its involutes.
    pub may_be_below_form: bool,
    /// Steps that stay on the line of action, for each part of a pitch.
    pub on_line_throughout: [Vec<i64>; PARTS],
    /// `ρ`.
    pub nominal: f64,
    /// `κ`: 0 where base pitches are equal.
    pub per_step: f64,
    /// Greatest relative error, for two steps on the line of action, of their difference in `r δ_L + δ_F + κ s` as their difference in room
    /// ([`CycleSide::room_error`]).
    pub room_error: f64,
    /// Greatest difference of the rooms of two steps on the line of action, over all flanks and the steps that can be the tightest.
    pub spread: f64,
    /// Greatest distance of `r δ_L + δ_F + κ (s + sense f)` from the middle of `r δ_L + δ_F`, over those steps throughout a pitch. If the
    /// steps `s` reach further to one side than to the other, it is more than half of their difference.
    pub level: f64,
}

impl SideTable {
    /// The tables of a side that is `posed` at the start of the cycle.
    pub fn new(side: &CycleSide, posed: &PosedSide) -> SideTable {
        let problem = side.problem;
        let steps = steps(side, posed.flanks.ahead);
        let pad = steps.start.abs().max(steps.end.abs());
        let ratio = problem.locked.shape.base * problem.per_free_base;
        let padded = |teeth: &Teeth, by: f64| -> Vec<f64> {
            let count = teeth.count();
            let places = -pad..count + pad;
            places
                .map(|place| by * teeth.half(place.rem_euclid(count) as usize).offset)
                .collect()
        };
        let places = posed.flanks.places(0);
        let mut table = SideTable {
            locked: padded(&problem.locked, ratio),
            free: padded(&problem.free, 1.0),
            pad,
            first: [places.0 as i64, places.1 as i64],
            sense: side.sense as i64,
            steps: steps.clone(),
            open: std::array::from_fn(|_| Vec::new()),
            plain: std::array::from_fn(|_| Vec::new()),
            at_fillets: std::array::from_fn(|_| Vec::new()),
            may_be_below_form: false,
            on_line_throughout: std::array::from_fn(|_| Vec::new()),
            nominal: 0.0,
            per_step: problem.per_step,
            room_error: side.room_error(),
            spread: 0.0,
            level: 0.0,
        };
        let [low, high] = table.ends();
        // One more step, for the change within a pitch.
        let reach = (steps.end - steps.start + 1) as f64;
        let spread = high - low + table.per_step.abs() * reach;
        table.spread = spread * (1.0 + table.room_error);
        let farthest = steps.start.abs().max((steps.end - 1).abs()) + 1;
        table.level = 0.5 * (high - low) + table.per_step.abs() * farthest as f64;
        let Some(line) = Line::new(C::from(problem.distance), problem.sum()) else {
            return table;
        };
        let pair = InvolutePair::new(&posed.flanks, 0);
        table.nominal = posed.room(pair.gap_on(problem, &line)) - table.off(table.places(0), 0);
        let spread = table.spread;
        let rolls = RollsOnLine::new(side, &line, posed.flanks.ahead, spread);
        for part in 0..PARTS {
            let on_line_throughout = steps
                .clone()
                .filter(|step| rolls.is_on_line_throughout(*step, part));
            table.on_line_throughout[part] = on_line_throughout.collect();
            // A step with more room than any pair on the line of action can have is never the tightest.
            let limit = if table.on_line_throughout[part].is_empty() {
                f64::INFINITY
            } else {
                spread
            };
            let found = steps.clone();
            let found = found.map(|step| (step, rolls.of(step, part, limit)));
            let found: Vec<(i64, StepRoom)> = found.collect();
            table.may_be_below_form |= found.iter().any(|(_, part)| part.at_fillets() <= limit);
            let open = || found.iter().filter(|(_, part)| part.least() <= limit);
            table.open[part] = open()
                .map(|(step, part)| (*step, part.beside, part.at_fillets()))
                .collect();
            for (step, found) in open() {
                if found.least() < found.beside {
                    table.at_fillets[part].push((*step, *found))
                } else {
                    table.plain[part].push((*step, found.beside))
                }
            }
        }
        table
    }

    /// Places of step 0 at a mating.
    pub fn places(&self, mating: u64) -> [i64; 2] {
        let counts = [&self.locked, &self.free].map(|offsets| offsets.len() as i64 - 2 * self.pad);
        let on = [-self.sense, self.sense];
        [0, 1].map(|k| {
            let turned = (mating % counts[k] as u64) as i64;
            (self.first[k] + on[k] * turned).rem_euclid(counts[k])
        })
    }

    /// `r δ_L + δ_F + κ s` of a step.
    pub fn off(&self, [locked, free]: [i64; 2], step: i64) -> f64 {
        self.locked[(self.pad + locked + step) as usize]
            + self.free[(self.pad + free - step) as usize]
            + self.per_step * step as f64
    }

    /// Writes the offset of every step to `offsets`, for [`SideTable::offset_among`].
    pub fn all_offsets(&self, places: [i64; 2], offsets: &mut Vec<f64>) {
        offsets.clear();
        offsets.extend(self.steps.clone().map(|step| self.off(places, step)));
    }

    /// The offset of a step among `offsets`, those of all steps.
    #[inline]
    pub fn offset_among(&self, offsets: &[f64], step: i64) -> f64 {
        offsets[(step - self.steps.start) as usize]
    }

    /// `κ sense f` at both ends of a part.
    pub fn drifts(&self, part: usize) -> [f64; 2] {
        let drift = self.per_step * self.sense as f64;
        [part, part + 1].map(|end| drift * end as f64 / PARTS as f64)
    }

    /// Greatest difference between the contact of a tip corner with a fillet and that of its involute, rad; `None` if none comes near.
    pub fn deepest(&self) -> Option<f64> {
        let each = self
            .at_fillets
            .iter()
            .flatten()
            .filter_map(|(_, part)| part.at_fillet);
        let each = each.flatten().filter(|tip| tip.is_finite()).map(f64::abs);
        each.reduce(f64::max)
    }

    /// Whether all matings are equal: no flank deviates, and no clearance of a tip depends on the centre distance.
    pub fn is_uniform(&self) -> bool {
        let alike = |offsets: &[f64]| offsets.iter().all(|off| *off == offsets[0]);
        let has_tips_at_fillets = self.at_fillets.iter().any(|steps| !steps.is_empty());
        !has_tips_at_fillets && alike(&self.locked) && alike(&self.free)
    }

    /// Lower bound of `r δ_L + δ_F + κ (s + sense f)` of any step.
    pub fn lowest(&self) -> f64 {
        self.middle() - self.level
    }

    /// Least room of any step beside the line of action, rad, if that is negative: of a tip corner in a fillet; 0 otherwise.
    pub fn deepest_tip(&self) -> f64 {
        let open = self.open.iter().flatten();
        let each = open.map(|(_, beside, at_fillets)| beside.min(*at_fillets));
        each.fold(0.0, f64::min)
    }

    /// Whether at every pose some step is on the line of action.
    pub fn is_always_on_line(&self) -> bool {
        self.on_line_throughout
            .iter()
            .all(|steps| !steps.is_empty())
    }

    /// Lower bound of the free gear's turn, rad, from the contact of endless involutes to that with the far flank of the same locked tooth
    /// ([`FarFlanks`]). `None` if the axes are too near for a bound.
    ///
    /// The normal at a far contact passes the free axis on its far side. `ξ` is the point's roll and `λ` the angle of the locked tooth. `d` is
    /// the distance of the outlines' centres, and `ψ` the half angle of the far flank at its base. Then `λ + ψ − ξ ≤ −acos(r_bL/d)`. At the
    /// tip `ξ − ψ = atan ξ_a − ψ_a`. No far corner is nearer to the centre line than `ψ_a − τ`, so `λ ≤ atan ξ_a + ψ_a + τ − acos(r_bL/d)`.
    /// The gap on the line of action falls as `λ` grows, and as `d` does. At the far contact, the free tooth's gap is the
    /// angle of a point inside both tip circles and the tooth's half angle there. The point is at least `√(d² − r_bL²) − r_bL ξ_a` away from
    /// the free axis.
    ///
    /// An eccentric free outline moves by up to `e Δ` on the turn `Δ` between the two gaps. That turns the frame of its centres and the line
    /// of action by less than `6 e Δ/r_bF`.
    ///
    /// [`FarFlanks`]: crate::contact::body::FarFlanks
    pub fn before_far_flanks(&self, side: &CycleSide) -> Option<f64> {
        let problem = side.problem;
        let (locked, free) = (&problem.locked.shape, &problem.free.shape);
        let off = side.off[0] + side.off[1];
        let nearest = problem.distance - off;
        let line = Line::new(C::from(problem.distance + off), problem.sum())?;
        let half_tip = locked.half_base - involute::inv_of_roll(locked.tip_roll);
        let far =
            (0..problem.locked.count() as usize).map(|place| problem.locked.half(place).far.arg());
        let thin = far.fold(0.0, |thin: f64, far| thin.max(half_tip - far));
        let angle = locked.tip_roll.atan() + half_tip + thin - (locked.base / nearest).acos();
        let pair = InvolutePair {
            locked_base: angle - locked.half_base,
            free_base: -free.half_base,
        };
        let point = overlap_half_angle(free.tip_radius, locked.tip_radius, nearest).unwrap_or(0.0);
        let from_axis =
            (nearest * nearest - locked.base * locked.base).sqrt() - locked.base * locked.tip_roll;
        let half = if from_axis >= free.form_radius() {
            free.half_base
                - involute::inv_of_roll(involute::roll_at(
                    from_axis.min(free.tip_radius),
                    free.base,
                ))
        } else {
            problem.free.pitch
        };
        let later = pair.gap_on(problem, &line) - point - half;
        let later = later * (1.0 - 6.0 * side.off[1] * problem.per_free_base);
        later.is_finite().then_some(later)
    }

    fn ends(&self) -> [f64; 2] {
        let ends = |offsets: &[f64]| {
            let fold = |(low, high): (f64, f64), off: &f64| (low.min(*off), high.max(*off));
            offsets
                .iter()
                .fold((f64::INFINITY, f64::NEG_INFINITY), fold)
        };
        let (locked, free) = (ends(&self.locked), ends(&self.free));
        [locked.0 + free.0, locked.1 + free.1]
    }

    pub fn middle(&self) -> f64 {
        let [low, high] = self.ends();
        0.5 * (low + high)
    }
}

/// Steps whose locked half tooth can reach the free gear somewhere in a pitch, and on the face.
pub(super) fn steps(side: &CycleSide, ahead: f64) -> Range<i64> {
    let problem = side.problem;
    let Some((low, high)) = problem.window else {
        return 0..0;
    };
    let beyond = ahead + side.sense * problem.locked.pitch;
    let [least, most] = side.turns;
    let (first, last) = (ahead.min(beyond) + least, ahead.max(beyond) + most);
    let from = ((low - last) * problem.per_pitch).floor() as i64;
    let to = ((high - first) * problem.per_pitch).ceil() as i64;
    // A wide helical face can have more steps than there are teeth.
    if least < most {
        return from..to + 1;
    }
    let half = (problem.locked.count() - 1) / 2;
    from.max(-half)..to.min(half + 1) + 1
}
