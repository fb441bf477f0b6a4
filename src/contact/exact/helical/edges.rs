//! Places along the face where an edge may touch tightest.
//!
//! An edge touches a fillet tightest at one position that is the same for all teeth ([`super::super::deepest`]). It fixes the turn of the
//! locked tooth, and with it `b`. Edges can also be tightest where two of them cross, at an intersection of their circles.
//!
//! **Very short paths of contact.** A pair of involutes may have line contact over a stretch between two sections, or
//! over none. The middle of a stretch represents it. Without a stretch, an edge of either involute touches the other:
//! on one side of the pitch point before the edges cross, on the other side after. The pair is tightest where they
//! cross, and perhaps nothing else touches anywhere. An eccentric free gear may reach its mate only by turning. If both
//! tip circles touch then, the tightest place is where a land ends on the line of centres.
//!
//! Each place belongs to one pair of teeth. The method of a section finds what touches there.

use super::roots::{tangent_rotations, tip_ends, tips_on_roots};
use super::turning::{Edge, FreeGear, Place, TwistedTeeth, crossing_places};
use crate::contact::Effort;
use crate::contact::exact::deepest::{DeepestTouch, deepest};
use crate::contact::exact::flank_problem::{FlankProblem, PosedFlanks};
use crate::contact::exact::line::Line;
use crate::contact::exact::shape::{C, HalfToothShape};
use crate::contact::exact::teeth::reduced;
use crate::pair::GearPair;
use std::f64::consts::PI;

/// Number of centre distances at which the room of a fillet is evaluated (tuned: runout of a hundredth of a module changes it little).
const STEPS_OF_DISTANCE: u32 = 8;

/// The gears whose fillet an edge can touch, and the other reasons to examine places.
#[derive(Debug, Clone, Copy)]
pub(super) struct Edges {
    on_locked: bool,
    on_free: bool,
    /// Whether tips can reach the mate's root, which can jam the pair ([`super::roots`]).
    pub jams: bool,
    /// Whether a pair of involutes may have line contact only between two sections, or nowhere.
    pub short: bool,
}

impl Edges {
    /// The edges of `assembly`, whose right-hand half teeth are those of `problem`. `None` if no tip reaches a fillet
    /// and paths of contact are not `short`.
    pub fn new(assembly: &GearPair, problem: &FlankProblem, short: bool) -> Option<Edges> {
        let off = problem.locked_off.norm() + problem.free_off.norm() + assembly.shift_bound();
        let nearest = assembly.center_distance() - off;
        let reached = |fillet: &HalfToothShape, tip: &HalfToothShape| {
            nearest - tip.tip_radius < fillet.form_radius()
        };
        let (locked, free) = (&problem.locked.shape, &problem.free.shape);
        let jams = |root: &HalfToothShape, tip: &HalfToothShape| {
            nearest - tip.tip_radius < root.root_radius
        };
        let edges = Edges {
            on_locked: reached(locked, free),
            on_free: reached(free, locked),
            jams: jams(locked, free) || jams(free, locked),
            short,
        };
        (edges.on_locked || edges.on_free || short).then_some(edges)
    }

    /// These edges without the fillets, if no tip touches a fillet as tightly as a pair on the line of action. The flanks of all teeth
    /// differ by `spread`, rad of the free gear, and centres move by `shift`, mm. `deepest` is the least `γ` of each fillet that a tip reaches.
    pub fn without_fillets(
        self,
        problem: &FlankProblem,
        deepest: [Option<f64>; 2],
        (spread, shift): (f64, f64),
    ) -> Option<Edges> {
        let shapes = [&problem.locked.shape, &problem.free.shape];
        let reached = [self.on_locked, self.on_free];
        let clear = (0..2).all(|k| {
            let room = || FilletRoom {
                fillet: shapes[k],
                tip: shapes[1 - k],
                per_free: problem.per_free_base * [shapes[1].base, shapes[0].base][k],
            };
            let off = problem.locked_off.norm() + problem.free_off.norm() + shift;
            let distances = [problem.distance - off, problem.distance + off];
            !reached[k] || deepest[k].is_some_and(|least| room().exceeds(spread, distances, least))
        });
        if clear && !self.jams {
            self.short.then_some(Edges {
                on_locked: false,
                on_free: false,
                ..self
            })
        } else {
            Some(self)
        }
    }

    /// Places on the face at a pose of the measuring plane, for the free gear's rotation in the frame of `posed`.
    pub fn places(
        &self,
        assembly: &GearPair,
        posed: &PosedFlanks,
        stands: FreeGear,
        effort: &Effort,
    ) -> Vec<Place> {
        let rotation = stands.rotation;
        let (locked, free) = (&posed.problem.locked.shape, &posed.problem.free.shape);
        let (c_l, c_f) = (posed.centre, posed.free_centre_at(rotation));
        let mut places = Vec::new();
        let teeth = [
            TwistedTeeth::locked(assembly, posed),
            TwistedTeeth::free(assembly, posed, rotation),
        ];
        let between = c_f - c_l;
        let distance = between.norm();
        if self.short
            && let Some(tooth) = middle_of_path(locked, free, distance)
        {
            places.extend(teeth[0].places(&Edge::middle(locked), between.arg() + tooth));
        }
        self.deepest_places(posed, &teeth, stands, &mut places);
        for (k, &(_, one)) in locked.corners().iter().enumerate() {
            for (l, &(_, other)) in free.corners().iter().enumerate() {
                // Crossing tips can be tightest only without a path of contact.
                if k > 0 || l > 0 || self.short {
                    let edges = [&Edge::corner(one), &Edge::corner(other)];
                    let places = (&mut places, effort);
                    crossing_places(posed, &teeth, edges, stands, places);
                }
            }
        }
        if self.short {
            tips_on_tips((assembly, posed), &teeth, stands, (&mut places, effort));
        }
        if self.jams {
            tips_on_roots((assembly, posed), &teeth, stands, (&mut places, effort));
        }
        places
    }

    /// Whether a tip can touch a fillet.
    pub fn in_fillets(&self) -> bool {
        self.on_locked || self.on_free
    }

    /// The steps and places, mm, at which edges touch fillets tightest at a pose of the measuring plane.
    pub fn deepest(
        &self,
        assembly: &GearPair,
        posed: &PosedFlanks,
        stands: FreeGear,
    ) -> impl Iterator<Item = (i64, f64)> + use<> {
        let teeth = [
            TwistedTeeth::locked(assembly, posed),
            TwistedTeeth::free(assembly, posed, stands.rotation),
        ];
        let mut places = Vec::new();
        self.deepest_places(posed, &teeth, stands, &mut places);
        places.into_iter().map(|place| (place.step, place.b))
    }

    /// Adds the places at which edges touch fillets tightest.
    fn deepest_places(
        &self,
        posed: &PosedFlanks,
        teeth: &[TwistedTeeth; 2],
        stands: FreeGear,
        places: &mut Vec<Place>,
    ) {
        let (locked, free) = (&posed.problem.locked.shape, &posed.problem.free.shape);
        let (c_l, c_f) = (posed.centre, posed.free_centre_at(stands.rotation));
        let between = c_f - c_l;
        let distance = between.norm();
        let mut take = |ahead, behind| tight_places(teeth, [ahead, behind], stands, places);
        if self.on_locked {
            for &(_, edge) in free.corners() {
                for touch in deepest(locked, distance, free.base, edge.norm()) {
                    let point = c_l + touch.point * between / distance;
                    take(
                        between.arg() + touch.tooth,
                        (point - c_f).arg() - edge.arg(),
                    );
                }
            }
        }
        if self.on_free {
            for &(_, edge) in locked.corners() {
                for touch in deepest(free, distance, locked.base, edge.norm()) {
                    let point = c_f - touch.point * between / distance;
                    take(
                        (point - c_l).arg() - edge.arg(),
                        between.arg() + PI + touch.tooth,
                    );
                }
            }
        }
    }
}

/// Adds the places on the face at which a locked and a free tooth have the directions `ahead` and `behind`, rad, unless
/// the free gear stops before.
fn tight_places(
    [locked, free]: &[TwistedTeeth; 2],
    [ahead, behind]: [f64; 2],
    stands: FreeGear,
    places: &mut Vec<Place>,
) {
    for step in locked.steps(ahead) {
        let b = locked.place(ahead, step);
        if stands.can_reach(reduced(behind - free.direction(b, step))) {
            places.extend(locked.on_face(step, b, 0.0));
        }
    }
}

/// A tip and its mate's fillet where they touch tightest, compared with the same teeth on the line of action. Neither
/// depends on the place along the face.
struct FilletRoom<'a> {
    fillet: &'a HalfToothShape,
    tip: &'a HalfToothShape,
    /// Ratio of the free gear's turn to the turn of the tip's gear.
    per_free: f64,
}

impl FilletRoom<'_> {
    /// Whether the tip has more room than `spread`, rad of the free gear, at each centre distance between the two
    /// given. `deepest_roll` is the least `γ` that it reaches.
    ///
    /// Let `ω` be the angle of a normal through the pitch point to the line of centres, and `r_w` the operating pitch radius of the tip's
    /// gear. That normal turns the gear by `cot ω/r_w` per mm of distance, the line of action by `tan α_w/r_w`. So between two evaluated
    /// distances the room changes by at most half a step times the greater of these. A fillet has at most one such touch.
    fn exceeds(&self, spread: f64, [nearest, farthest]: [f64; 2], deepest_roll: f64) -> bool {
        let (fillet, tip) = (self.fillet, self.tip);
        let sum = fillet.base + tip.base;
        let Some(line) = Line::new(C::from(nearest), sum) else {
            return false;
        };
        // On the line of action the tip must stay off the joint, and the joint must not be an edge: a touch would begin there.
        if fillet.corners().len() > 1
            || line.length - tip.base * tip.tip_roll <= fillet.base * fillet.form_roll
        {
            return false;
        }
        let pitch_radius = |distance: f64, base: f64| distance * base / sum;
        let sine = fillet.pitch_radius * deepest_roll.sin() / pitch_radius(farthest, fillet.base);
        let steepest = (1.0 - sine * sine).max(0.0).sqrt() / sine;
        let tangent = (farthest * farthest - sum * sum).sqrt() / sum;
        let per_mm = steepest.max(tangent) / pitch_radius(nearest, tip.base);
        let steps = if farthest > nearest {
            STEPS_OF_DISTANCE
        } else {
            0
        };
        let step = (farthest - nearest) / f64::from(steps.max(1));
        (0..=steps).all(|k| {
            let distance = nearest + step * f64::from(k);
            let rooms = deepest(fillet, distance, tip.base, tip.tip_radius);
            let mut rooms = rooms.map(|touch| self.beside_line(distance, touch));
            rooms.all(|room| (room - 0.5 * step * per_mm) * self.per_free > spread)
        })
    }

    /// Angle by which the tip's gear turns further to this touch than to the line of action, rad.
    fn beside_line(&self, distance: f64, touch: DeepestTouch) -> f64 {
        let (fillet, tip) = (self.fillet, self.tip);
        let Some(line) = Line::new(C::from(distance), fillet.base + tip.base) else {
            return f64::NEG_INFINITY;
        };
        let roll = line.angle + fillet.half_base - touch.tooth;
        let mate = (line.length - fillet.base * roll) / tip.base;
        let on_line = PI + line.angle - mate + tip.half_base;
        let corner = tip.corners()[0].1;
        reduced(on_line - ((touch.point - distance).arg() - corner.arg()))
    }
}

/// Direction of the locked tooth from the line of centres, rad, when a pair touches in the middle of its path of
/// contact; `None` without a path.
fn middle_of_path(locked: &HalfToothShape, free: &HalfToothShape, distance: f64) -> Option<f64> {
    let line = Line::new(C::from(distance), locked.base + free.base)?;
    let mate = |roll: f64| (line.length - free.base * roll) / locked.base;
    let from = locked.form_roll.max(mate(free.tip_roll));
    let to = locked.tip_roll.min(mate(free.form_roll));
    (from <= to).then_some(line.angle - 0.5 * (from + to) + locked.half_base)
}

/// Adds the places on the face where the tip lands of an eccentric free gear and its mate can touch as the gear turns.
/// Where both circles touch, they do so over the whole face on which both lands are on the line of centres: from the
/// end of one to the end of one. If no part of the face has both, they touch where such ends cross.
fn tips_on_tips(
    (assembly, posed): (&GearPair, &PosedFlanks),
    teeth: &[TwistedTeeth; 2],
    stands: FreeGear,
    (places, effort): (&mut Vec<Place>, &Effort),
) {
    let [locked, free] = tip_ends(posed);
    let Some(first_contact) = tangent_rotations(posed, locked[0].radius + free[0].radius) else {
        return;
    };
    for (k, one) in locked.iter().enumerate() {
        for (l, other) in free.iter().enumerate() {
            // The crossing of both near corners is found elsewhere.
            if k > 0 || l > 0 {
                crossing_places(posed, teeth, [one, other], stands, (places, effort));
            }
        }
    }
    for rotation in first_contact {
        let between = posed.free_centre_at(rotation) - posed.centre;
        let free_turning = TwistedTeeth::free(assembly, posed, rotation);
        for end in &locked {
            places.extend(teeth[0].places(end, between.arg()));
        }
        for end in &free {
            places.extend(free_turning.places(end, (-between).arg()));
        }
    }
}

#[cfg(test)]
mod tests;
