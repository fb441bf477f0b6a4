//! Where along the face an edge may touch tightest.
//!
//! Where an edge touches a fillet tightest ([`super::super::deepest`]) is common to all teeth; the turn of the locked tooth, and
//! with it `b`, follows. Where two edges cross, the tightest may stand as well: both circles' intersection says where.
//!
//! **Of pairs with next to no path of contact** a pair of involutes may touch on the line of action over a stretch of the face that falls
//! between two sections, or over none. A stretch is held by its middle. Without one an edge of either involute touches the other,
//! at normals on one side of the pitch point before the edges cross and on the other side after: where they cross the pair is tightest, and
//! nothing else may touch anywhere. An eccentric free gear may come to its mate only as it turns: where both tip circles touch then, the tightest stands
//! where a land ends on the line of centres.
//!
//! These are places to look at, each of one pair of teeth: a section's own method finds what touches there.

use super::roots::{tangent_rotations, tip_ends, tips_on_roots};
use super::turning::{Edge, FreeGear, Place, Turning, crossing_places};
use crate::contact::Effort;
use crate::contact::exact::deepest::{DeepestTouch, deepest};
use crate::contact::exact::flank_problem::{FlankProblem, PosedFlanks};
use crate::contact::exact::line::Line;
use crate::contact::exact::shape::{C, HalfToothShape};
use crate::contact::exact::teeth::reduced;
use crate::pair::GearPair;
use std::f64::consts::PI;

/// Distances of the outlines' centres at which the room of a fillet is looked at (tuned: runout of a hundredth of a module changes it little).
const STEPS_OF_DISTANCE: u32 = 8;

/// Of which gear a fillet may be touched.
#[derive(Debug, Clone, Copy)]
pub(super) struct Edges {
    on_locked: bool,
    on_free: bool,
    /// Whether tips may come to the mate's root, which may jam the pair ([`super::roots`]).
    pub jams: bool,
    /// Whether a pair of involutes may touch on the line of action between two sections only, or nowhere on it.
    pub short: bool,
}

impl Edges {
    /// `None` where no tip of `assembly`, whose right-hand half teeth are those of `problem`, comes to a fillet, and paths of contact are not
    /// `short`.
    pub fn new(assembly: &GearPair, problem: &FlankProblem, short: bool) -> Option<Edges> {
        let off = problem.locked_off.norm() + problem.free_off.norm();
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

    /// The same without fillets where no tip touches one as tight as a pair touches that is on the line of action, flanks of all teeth
    /// differing by `spread`, rad of the free gear, and `deepest`, the least `γ` of the locked and of the free fillet that a tip reaches.
    pub fn without_fillets(
        self,
        problem: &FlankProblem,
        deepest: [Option<f64>; 2],
        spread: f64,
    ) -> Option<Edges> {
        let shapes = [&problem.locked.shape, &problem.free.shape];
        let reached = [self.on_locked, self.on_free];
        let clear = (0..2).all(|k| {
            let room = || FilletRoom {
                fillet: shapes[k],
                tip: shapes[1 - k],
                per_free: problem.per_free_base * [shapes[1].base, shapes[0].base][k],
            };
            let off = problem.locked_off.norm() + problem.free_off.norm();
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

    /// Places on the face at a pose of the measuring plane, with the free gear as it stands in the frame of `posed`.
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
        let turnings = [
            Turning::locked(assembly, posed),
            Turning::free(assembly, posed, rotation),
        ];
        let between = c_f - c_l;
        let distance = between.norm();
        if self.short
            && let Some(tooth) = middle_of_path(locked, free, distance)
        {
            places.extend(turnings[0].places(&Edge::middle(locked), between.arg() + tooth));
        }
        let mut take =
            |ahead, behind| tight_places(&turnings, [ahead, behind], stands, &mut places);
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
        for (k, &(_, one)) in locked.corners().iter().enumerate() {
            for (l, &(_, other)) in free.corners().iter().enumerate() {
                // Both tips cross where a pair is tightest only without a path of contact.
                if k > 0 || l > 0 || self.short {
                    let edges = [&Edge::corner(one), &Edge::corner(other)];
                    let places = (&mut places, effort);
                    crossing_places(posed, &turnings, edges, stands, places);
                }
            }
        }
        if self.short {
            tips_on_tips((assembly, posed), &turnings, stands, (&mut places, effort));
        }
        if self.jams {
            tips_on_roots((assembly, posed), &turnings, stands, (&mut places, effort));
        }
        places
    }
}

/// Adds the places on the face, mm, at which a locked and a free tooth have the directions `ahead` and `behind`, rad, if the free gear may come
/// there: if it does not stop before.
fn tight_places(
    [locked, free]: &[Turning; 2],
    [ahead, behind]: [f64; 2],
    stands: FreeGear,
    places: &mut Vec<Place>,
) {
    for step in locked.steps(ahead) {
        let b = locked.place(ahead, step);
        if stands.may_come(reduced(behind - free.direction(b, step))) {
            places.extend(locked.on_face(step, b, 0.0));
        }
    }
}

/// A tip and its mate's fillet, where they touch tightest along the face, beside the same teeth on the line of action: neither depends on where
/// along the face a section stands.
struct FilletRoom<'a> {
    fillet: &'a HalfToothShape,
    tip: &'a HalfToothShape,
    /// Rad of the free gear a rad of the gear whose tip it is.
    per_free: f64,
}

impl FilletRoom<'_> {
    /// Whether the tip has more room than `spread`, rad of the free gear, at any of `distances` of the outlines' centres; `deepest` is the least `γ`
    /// that it reaches.
    ///
    /// A normal that passes the pitch point at the lean `ω` from the line of centres turns the tip's gear by `cot ω/r_w` a mm of distance, `r_w`
    /// that gear's operating pitch radius; the line of action by `tan α_w/r_w`. So between the distances that are looked at the room changes by half
    /// a step of them times the greater at most. A fillet has one such touch or none.
    fn exceeds(&self, spread: f64, [nearest, farthest]: [f64; 2], deepest_roll: f64) -> bool {
        let (fillet, tip) = (self.fillet, self.tip);
        let sum = fillet.base + tip.base;
        let Some(line) = Line::new(C::from(nearest), sum) else {
            return false;
        };
        // On the line of action the tip must not come to the joint, nor the joint be an edge: a touch would begin there.
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
        let step = (farthest - nearest) / f64::from(STEPS_OF_DISTANCE);
        (0..=STEPS_OF_DISTANCE).all(|k| {
            let distance = nearest + step * f64::from(k);
            let rooms = deepest(fillet, distance, tip.base, tip.tip_radius);
            let mut rooms = rooms.map(|touch| self.beside_line(distance, touch));
            rooms.all(|room| (room - 0.5 * step * per_mm) * self.per_free > spread)
        })
    }

    /// How much farther than on the line of action the tip's gear turns to this touch, rad.
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

/// Where the locked tooth stands, seen from the line of the centres, rad, when a pair touches in the middle of its path of contact; `None`
/// without a path.
fn middle_of_path(locked: &HalfToothShape, free: &HalfToothShape, distance: f64) -> Option<f64> {
    let line = Line::new(C::from(distance), locked.base + free.base)?;
    let mate = |roll: f64| (line.length - free.base * roll) / locked.base;
    let from = locked.form_roll.max(mate(free.tip_roll));
    let to = locked.tip_roll.min(mate(free.form_roll));
    (from <= to).then_some(line.angle - 0.5 * (from + to) + locked.half_base)
}

/// Adds the places on the face, mm, where the tip lands of an eccentric free gear and its mate may touch as the free gear comes nearer in turning:
/// where both circles touch they do so all over the face where both lands are on the line of centres, from an end of one to an end of one,
/// and where no part of it has both, where such ends cross.
fn tips_on_tips(
    (assembly, posed): (&GearPair, &PosedFlanks),
    turnings: &[Turning; 2],
    stands: FreeGear,
    (places, effort): (&mut Vec<Place>, &Effort),
) {
    let [locked, free] = tip_ends(posed);
    let Some(touching) = tangent_rotations(posed, locked[0].radius + free[0].radius) else {
        return;
    };
    for (k, one) in locked.iter().enumerate() {
        for (l, other) in free.iter().enumerate() {
            // Both near corners are among all others.
            if k > 0 || l > 0 {
                crossing_places(posed, turnings, [one, other], stands, (places, effort));
            }
        }
    }
    for rotation in touching {
        let between = posed.free_centre_at(rotation) - posed.centre;
        let free_turning = Turning::free(assembly, posed, rotation);
        for end in &locked {
            places.extend(turnings[0].places(end, between.arg()));
        }
        for end in &free {
            places.extend(free_turning.places(end, (-between).arg()));
        }
    }
}

#[cfg(test)]
mod tests;
