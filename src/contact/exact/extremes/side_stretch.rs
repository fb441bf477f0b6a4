//! Bounds of the room of one side over a stretch of a mating, pair by pair of half teeth.

use super::super::path::InvolutePair;
use super::super::separation::{InvoluteArc, Separation};
use super::clearance::{HALVINGS, LinesAtDistances, tip_clearance};
use super::corner_path;
use super::fillet::{self, BorderTouch, OnFillet};
use super::mesh_cycle::{CycleSide, FaceEnd, PARTS, PosedSide};
use super::rolls::PIECE;
use super::room::{self, LinePiece, PairRoom};
use super::table::{BesideLine, OpenStep};
use super::tip_at_fillet::{FARTHEST, TipAtFillet};
use super::tips_at_fillets_over_face::{InnerTouch, inner_touch};
use crate::contact::Effort;

/// Effort of the room of a step, nodes (tuned: 4000 cells of an ordinary pair take about 20 ms).
const STEP: u64 = 12;

/// Effort of the room between a tip corner and a fillet, nodes (tuned).
const TIP_AT_FILLET: u64 = 8;

/// Effort of one evaluation of the path of a tip corner past a fillet, nodes.
const LOOK: u64 = 2;

/// Effort of finding a tip corner on a fillet at both ends of a stretch, nodes.
const ON_FILLET: u64 = 30;

/// Angles of a locked half tooth and distances of the outlines' centres over a cell.
pub(super) struct PlacesOverCell {
    pub at: f64,
    pub play: f64,
    distances: (f64, f64),
}

/// One side over a stretch of a mating.
pub(super) struct SideStretch<'a> {
    /// Fractions of the pitch at its ends.
    pub stretch: [f64; 2],
    pub side: &'a CycleSide<'a>,
    /// The sides in the measuring plane at the ends of the cell.
    pub ends: [PosedSide<'a>; 2],
    /// The sides in the sections at both ends of helical gears' common face, at the start of the mating.
    pub faces: Vec<FaceEnd<'a>>,
    /// Budget of the cycle.
    pub effort: &'a Effort<'a>,
}

impl<'a> SideStretch<'a> {
    /// Width of the stretch, pitches.
    pub fn width(&self) -> f64 {
        self.stretch[1] - self.stretch[0]
    }

    /// Change of the rolls over the stretch: that of the pitches, plus a small effect of the eccentricities.
    pub fn plays(&self) -> [f64; 2] {
        let problem = self.side.problem;
        [problem.locked.pitch, problem.free.pitch].map(|pitch| 1.2 * pitch * self.width())
    }

    pub fn rounding(&self) -> f64 {
        let problem = self.side.problem;
        2.0 * problem.rounding(problem.free.shape.base, 1.0)
    }

    /// Turn of the locked gear over the stretch, rad.
    fn angle(&self) -> f64 {
        self.side.problem.locked.pitch * self.width()
    }

    pub fn bend(&self, found: &[Separation; 2]) -> Option<f64> {
        let [a, b] = found
            .each_ref()
            .map(|one| one.bend(self.plays(), self.side.off));
        Some(a?.max(b?) * self.angle() * self.angle())
    }

    /// The room of a pair that stays on the line of action over the cell; `None` if it may leave the line. At the ends of the cell, `found` has
    /// its separations and `ends` the sides.
    fn room_on_line(&self, ends: &[PosedSide; 2], found: &[Separation; 2]) -> Option<PairRoom> {
        let bends = self.side.on_line?;
        let angle = self.angle();
        let turned = bends.turn * angle;
        let plays = [turned, turned + bends.second * angle * angle / 8.0];
        if !found.iter().all(|one| one.is_on_line(plays)) {
            return None;
        }
        let room = [0, 1].map(|k| ends[k].room(found[k].gap));
        let rates = [0, 1].map(|k| ends[k].rate(found[k].slope) * self.width());
        let third = bends.third * angle.powi(3);
        Some(PairRoom::smooth(room, rates, third, self.rounding()))
    }

    /// The room of a pair with `found` at both ends of the cell; `ends` are the sides there.
    fn convex(
        &self,
        ends: &[PosedSide; 2],
        found: &[Separation; 2],
        bend: f64,
        touches: bool,
    ) -> PairRoom {
        let room = [0, 1].map(|k| ends[k].room(found[k].gap) - self.rounding());
        let rates = [0, 1].map(|k| ends[k].rate(found[k].slope) * self.width());
        PairRoom::convex(room, rates, bend, touches)
    }

    /// Bounds of the room of each of `steps`: that of its involutes, and that of a corner and a fillet.
    pub fn rooms(&self, steps: impl Iterator<Item = OpenStep>) -> Vec<PairRoom> {
        let mut rooms = Vec::with_capacity(8);
        let mut at_fillets = Vec::new();
        for step in steps {
            if !self.faces.is_empty() {
                self.effort.spend(2 * STEP);
                let found = self.add_over_face(step, &mut rooms);
                if step.has_tips_at_fillets {
                    self.add_tips(step, &mut rooms, |tip, rooms| {
                        self.add_tip_over_face(step, tip, &found, rooms)
                    });
                }
                continue;
            }
            self.effort.spend(STEP);
            let found = self.add_involutes(step, &mut rooms);
            if step.has_tips_at_fillets {
                at_fillets.push((step, found.map(|found| found.gap)));
            }
        }
        if !at_fillets.is_empty() {
            self.add_tips_of_spur_gears(&at_fillets, &mut rooms);
        }
        rooms
    }

    /// Adds the room of tip corners that can touch fillets before the involutes touch, for spur gears.
    fn add_tips_of_spur_gears(
        &self,
        at_fillets: &[(OpenStep, [f64; 2])],
        rooms: &mut Vec<PairRoom>,
    ) {
        let above = room::lines_above(rooms);
        for (step, near) in at_fillets {
            self.add_tips(*step, rooms, |tip, rooms| {
                if !above.is_empty() && self.is_clear(step.step, tip, &above) {
                    return true;
                }
                let room = self.on_fillet(&self.ends, step.step, tip, *near);
                rooms.extend(room);
                room.is_some()
            });
        }
    }

    /// Whether the corner of `tip` at `step` is clear of the fillet while the side has the room of a broken line.
    fn is_clear(&self, step: i64, tip: &TipAtFillet, line: &[LinePiece]) -> bool {
        let problem = self.side.problem;
        let angle = self.ends[0].angle_to(&self.ends[1]);
        let need = self.rounding() * problem.free.shape.base;
        // The line is that far above the room of the pair's own involutes, which is among `line`.
        let found = self.endless_separations(step);
        let opening = self.bend(&found).unwrap_or(f64::INFINITY) / 4.0 + 2.0 * self.rounding();
        let mate = self.side.mate(tip.owner);
        line.iter().all(|piece| {
            let [first, last] = [0, 1].map(|k| self.ends[k].gap(piece.room[k] + self.rounding()));
            let rate = (last - first) / angle;
            let path = |at: f64| {
                self.effort.spend(LOOK);
                let flanks = self.ends[0].flanks.turned_on(at * angle);
                let gap = first + at * (last - first);
                OnFillet::new(flanks, step, tip.owner).path(gap, rate)
            };
            let [from, to] = piece.over;
            let over = (0.5 * (from + to), 0.5 * (to - from));
            corner_path::is_clear_over(over, angle, mate, tip.deepest, (need, opening), &path)
        })
    }

    /// Adds the room of the involutes and their ends of spur gears, and returns their separations.
    fn add_involutes(
        &self,
        OpenStep { step, beside, .. }: OpenStep,
        rooms: &mut Vec<PairRoom>,
    ) -> [Separation; 2] {
        let found = separations(&self.ends, step);
        if let Some(room) = self.room_on_line(&self.ends, &found) {
            rooms.push(room);
            return found;
        }
        // Endless involutes have no more room, except by the part below the form rolls. The table knows how much less they have.
        let problem = self.side.problem;
        let endless = self.endless_separations(step);
        let forms = InvoluteArc::both(problem).map(|arc| arc.form);
        let greatest_deficit = endless[0].greatest_deficit(&endless[1], self.plays(), forms);
        let prolonged = self
            .endless(&endless, beside.max(-greatest_deficit))
            .within(None);
        rooms.push(match self.room_beside_line(&self.ends, &found) {
            Some(room) => room.above(prolonged),
            None => prolonged,
        });
        found
    }

    /// Bounds of the room of all steps, from that of `line.step` on the line of action; `None` without a bound of its curvature.
    pub fn of_all(&self, line: BesideLine) -> Option<PairRoom> {
        self.effort.spend(STEP / 2);
        let found = self.endless_separations(line.step);
        let room = self.room_on_line(&self.ends, &found)?;
        Some(room.between(line.least, line.most))
    }

    /// A bound `more` above the room of endless involutes, which have `found` at both ends of the cell.
    fn endless(&self, found: &[Separation; 2], more: f64) -> PairRoom {
        let smooth = self.room_on_line(&self.ends, found);
        let room = smooth.or_else(|| self.room_beside_line(&self.ends, found));
        room.map_or(PairRoom::straight([f64::NEG_INFINITY; 2]), |mut room| {
            room.lower(-more);
            room
        })
    }

    /// The separations of a step's endless involutes at both ends of the cell.
    pub fn endless_separations(&self, step: i64) -> [Separation; 2] {
        self.ends
            .map(|end| Separation::endless(&end.flanks, step, end.nominal_gap()))
    }

    /// The room of involutes that may leave the line of action between the ends; `None` without a bound of its curvature.
    fn room_beside_line(&self, ends: &[PosedSide; 2], found: &[Separation; 2]) -> Option<PairRoom> {
        let touches = found.iter().all(|one| one.touches);
        Some(self.convex(ends, found, self.bend(found)?, touches))
    }

    /// Adds the room of the involutes of helical gears over their whole common face.
    ///
    /// On the line of action the room is equal in every section. Outside the stretch on the line it grows along the face (see
    /// [`super::super::helical`]). So a pair that leaves the line has the room of one end of the face.
    fn add_over_face(
        &self,
        OpenStep { step, beside, .. }: OpenStep,
        rooms: &mut Vec<PairRoom>,
    ) -> [Separation; 2] {
        let found = self.endless_separations(step);
        let [a, b] = found.each_ref().map(|one| self.on_line(one));
        let [least, most] = self.side.turns;
        // Allows the contact stretch of either end to move over the cell.
        let play = self.plays()[0];
        let off = a[0].min(b[0]) - play > most || a[1].max(b[1]) + play < least;
        let on = [a, b]
            .iter()
            .all(|[from, to]| from.max(least) <= to.min(most));
        let room = self.endless(&found, beside.min(0.0));
        let endless = if on { room } else { room.within(None) };
        if on {
            rooms.push(endless);
            return found;
        }
        // The end of the face nearer to the stretch is the tighter one.
        let middle = 0.25 * (a[0] + a[1] + b[0] + b[1]);
        let far = |face: &&FaceEnd| (face.turn - middle).abs();
        let nearest = self
            .faces
            .iter()
            .min_by(|one, other| far(one).total_cmp(&far(other)));
        let at_end = nearest.and_then(|face| {
            let ends = self.stretch.map(|at| face.posed.after(at));
            let found = separations(&ends, step + face.steps);
            let on_line = self.room_on_line(&ends, &found);
            on_line.or_else(|| self.room_beside_line(&ends, &found))
        });
        if !off || at_end.is_none() {
            rooms.push(endless);
        }
        rooms.extend(at_end);
        found
    }

    /// Angles of the locked teeth, relative to the measuring plane, in the sections where `endless` involutes touch on the line of action,
    /// rad: from, to.
    fn on_line(&self, endless: &Separation) -> [f64; 2] {
        let problem = self.side.problem;
        let (locked, free) = (&problem.locked.shape, &problem.free.shape);
        let [roll, free_roll] = endless.rolls();
        let ratio = free.base / locked.base;
        [
            (roll - locked.tip_roll).max(ratio * (free.form_roll - free_roll)),
            (roll - locked.form_roll).min(ratio * (free.tip_roll - free_roll)),
        ]
    }

    /// Adds the room of each tip corner that can come near a fillet: by `near` if that has a result, otherwise by a bound over all poses.
    fn add_tips(
        &self,
        OpenStep { step, enough, .. }: OpenStep,
        rooms: &mut Vec<PairRoom>,
        near: impl Fn(&TipAtFillet, &mut Vec<PairRoom>) -> bool,
    ) {
        let (ends, rounding) = (&self.ends, self.rounding());
        let places = self.places(ends, step);
        let less = |clearance: f64| {
            let found = self.endless_separations(step);
            let slack = self.bend(&found).unwrap_or(f64::INFINITY) / 8.0 + rounding;
            [0, 1].map(|k| ends[k].room(found[k].gap) - (slack - clearance))
        };
        for tip in &self.side.tips_at_fillets {
            let clearance = self.clearance(&places, tip, enough, self.side.turns);
            if clearance >= enough {
                continue;
            }
            if !near(tip, rooms) {
                rooms.push(PairRoom::straight(less(clearance)));
            }
        }
    }

    /// Additional room of `tip` against endless involutes, rad, over sections with the least and the greatest of `turns` of the locked teeth,
    /// rad; exact where less than `enough`.
    fn clearance(
        &self,
        places: &PlacesOverCell,
        tip: &TipAtFillet,
        enough: f64,
        [from, to]: [f64; 2],
    ) -> f64 {
        let problem = self.side.problem;
        let lines = LinesAtDistances::new(places.distances, problem.sum());
        let enough = self.side.clearance_for(enough);
        // Over a face: the piece of turn with the least room.
        let pieces = (to - from) / problem.locked.pitch * PARTS as f64 / PIECE;
        let pieces = pieces.ceil().max(1.0);
        let half = 0.5 * (to - from) / pieces;
        let play = places.play + half;
        let turned = (0..pieces as u64).map(|piece| from + (2 * piece + 1) as f64 * half);
        let there = turned.map(|turned| places.at + turned);
        let there = there.filter(|at| tip.may_be_below_form(*at, play));
        let clearance = there.map(|at| match &lines {
            Some(lines) => {
                self.effort.spend(TIP_AT_FILLET);
                let [a, b] = tip_clearance(tip, (at, play), lines, enough, HALVINGS);
                a.min(b)
            }
            None => f64::NEG_INFINITY,
        });
        let found = clearance.fold(f64::INFINITY, f64::min);
        // Deeper corners may be at other distances than `places`.
        if found < -FARTHEST {
            f64::NEG_INFINITY
        } else {
            self.side.certain_clearance(found)
        }
    }

    /// Least additional room of all tip corners on fillets at `step` against endless involutes, rad, over sections with the least and the
    /// greatest of `turns` of the locked teeth; exact where less than `enough`. Teeth are turned by up to `turned` rad, and centres
    /// displaced by up to `shift` mm.
    pub fn least_clearance(
        &self,
        step: i64,
        enough: f64,
        turns: [f64; 2],
        (turned, shift): (f64, f64),
    ) -> f64 {
        let places = self.places(&self.ends, step);
        let (least, most) = places.distances;
        let places = PlacesOverCell {
            play: places.play + turned + 2.0 * shift / self.side.problem.distance,
            distances: self.side.possible((least - shift, most + shift)),
            ..places
        };
        let clearances = self.side.tips_at_fillets.iter();
        let clearances = clearances.map(|tip| self.clearance(&places, tip, enough, turns));
        clearances.fold(f64::INFINITY, f64::min)
    }

    /// Approximate gaps of the involutes of a section with the sides `ends`.
    pub fn gaps(&self, ends: &[PosedSide; 2], step: i64) -> [f64; 2] {
        separations(ends, step).map(|found| found.gap)
    }

    /// The room of a tip corner and a fillet in one section with the sides `ends`, searched near the gaps `near`.
    pub fn on_fillet(
        &self,
        ends: &[PosedSide; 2],
        step: i64,
        tip: &TipAtFillet,
        near: [f64; 2],
    ) -> Option<PairRoom> {
        let (rounding, angle) = (self.rounding(), self.angle());
        self.effort.spend(ON_FILLET);
        let corners = ends.map(|end| OnFillet::new(end.flanks, step, tip.owner));
        let bounds = fillet::bounds(corners, near, angle, tip.deepest)?;
        let bend = bounds.bend * angle * angle;
        let room = |found: [BorderTouch; 2]| [0, 1].map(|k| ends[k].room(found[k].gap));
        let rates = [0, 1].map(|k| ends[k].rate(bounds.clear[k].slope) * self.width());
        let clear = room(bounds.clear).map(|room| room - rounding);
        let clear = PairRoom::convex(clear, rates, bend, false);
        let most = bounds
            .inside
            .map(|inside| room(inside).map(|room| room + bend / 8.0 + rounding));
        Some(clear.within(most))
    }

    /// Direction of the locked half tooth of a step from the line of the outlines' centres.
    pub fn places(&self, ends: &[PosedSide; 2], step: i64) -> PlacesOverCell {
        let side = self.side;
        let problem = side.problem;
        let places = ends.map(|end| {
            let (between, _) = end.flanks.centre_vector(end.nominal_gap());
            let at =
                InvolutePair::new(&end.flanks, step).locked_base + problem.locked.shape.half_base;
            (at - between.arg(), between.norm())
        });
        // The free gear's way from the rotation of `between` to the touch of the involutes, and to that of a corner and a fillet.
        let rooms = ends.map(|end| {
            let near = end.nominal_gap();
            end.room(Separation::endless(&end.flanks, step, near).gap)
        });
        let away = rooms[0].abs().max(rooms[1].abs()) + 1.5 * FARTHEST;
        let off = side.off[0] * problem.locked.pitch * self.width()
            + side.off[1] * (problem.free.pitch * self.width() + away);
        PlacesOverCell {
            at: 0.5 * (places[0].0 + places[1].0),
            play: 0.5 * (places[0].0 - places[1].0).abs() + 2.0 * off / problem.distance,
            distances: side.possible((
                places[0].1.min(places[1].1) - off,
                places[0].1.max(places[1].1) + off,
            )),
        }
    }

    /// Adds the rooms of `tip` at `step`, whose endless involutes have `found` at both ends of the stretch; `false` if they are unknown.
    fn add_tip_over_face(
        &self,
        step: OpenStep,
        tip: &TipAtFillet,
        found: &[Separation; 2],
        rooms: &mut Vec<PairRoom>,
    ) -> bool {
        let mut own = Vec::new();
        for face in &self.faces {
            let ends = self.stretch.map(|at| face.posed.after(at));
            let there = step.step + face.steps;
            let places = self.places(&ends, there);
            if tip.may_be_below_form(places.at, places.play) {
                let near = self.gaps(&ends, there);
                let Some(room) = self.on_fillet(&ends, there, tip, near) else {
                    return false;
                };
                own.push(room);
            }
        }
        let ends = [0, 1].map(|k| inner_touch(&self.ends[k], step.step, tip, found[k].gap));
        match ends {
            [Some(None), Some(None)] => {}
            [Some(Some(a)), Some(Some(b))] => {
                let [from, to] = self.side.turns;
                let play = (a.turn - b.turn).abs() + self.plays()[0];
                let (low, high) = (a.turn.min(b.turn), a.turn.max(b.turn));
                if high + play >= from && low - play <= to {
                    let slack = self.slack([a, b], found);
                    let room = [(0, a), (1, b)].map(|(k, touch)| self.ends[k].room(touch.gap));
                    let lower = PairRoom::straight(room.map(|room| room - slack));
                    let all = low - play >= from && high + play <= to;
                    let upper = room.map(|room| room + slack);
                    own.push(lower.within(all.then_some(upper)));
                }
            }
            _ => return false,
        }
        rooms.append(&mut own);
        true
    }

    /// Greatest difference of the room of [`InnerTouch`]es from the straight line between both ends, rad.
    fn slack(&self, touches: [InnerTouch; 2], found: &[Separation; 2]) -> f64 {
        let [a, b] = touches;
        let problem = self.side.problem;
        let angles = [problem.locked.pitch, problem.free.pitch].map(|pitch| pitch * self.width());
        // The distance is a sine of each eccentricity.
        let bent: f64 = [0, 1]
            .map(|k| self.side.off[k] * angles[k] * angles[k] / 8.0)
            .iter()
            .sum();
        let moved = (a.distance - b.distance).abs() + bent;
        let bend = a.bend.max(b.bend);
        let slope = a.slope.max(b.slope) + bend * moved;
        let involutes = self.bend(found).unwrap_or(f64::INFINITY) / 8.0;
        involutes + bend * moved * moved / 8.0 + slope * bent + self.rounding()
    }
}

/// The separations of the half teeth of a step, at both ends of a stretch.
fn separations(ends: &[PosedSide; 2], step: i64) -> [Separation; 2] {
    ends.map(|end| Separation::new(&end.flanks, step, end.nominal_gap()))
}
