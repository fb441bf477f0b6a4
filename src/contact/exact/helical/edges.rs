//! Where along the face an edge may touch tightest.
//!
//! Where an edge touches a fillet tightest ([`super::super::deepest`]) is common to all teeth; the turn of the locked tooth, and
//! with it `b`, follows. Where two edges cross, the tightest may stand as well: both circles' intersection says where.
//!
//! **Of pairs with next to no path of contact** a pair of involutes may touch on the line of action over a stretch of the face that falls
//! between two sections, or over none. A stretch is held by its middle. Without one an edge of either involute touches the other,
//! at normals on one side of the pitch point before the edges cross and on the other side after: where they cross the pair is tightest.
//!
//! These are places to look at: a section's own method finds what touches there.

use crate::contact::exact::deepest::{DeepestTouch, deepest};
use crate::contact::exact::flank_problem::{FlankProblem, PosedFlanks};
use crate::contact::exact::line::Line;
use crate::contact::exact::shape::{C, Shape};
use crate::contact::exact::teeth::reduced;
use crate::pair::{GearPair, Member};
use std::f64::consts::PI;
use std::ops::RangeInclusive;

/// How near to a crossing of edges, as an angle of the locked tooth, rad: some hundred times what rounding leaves of its direction.
const BESIDE: f64 = 1e-13;

/// A touch this far before the one that holds the free gear is looked at all the same, rad: a millionth of what teeth differ by.
const DOUBT: f64 = 1e-9;

/// Steps in which the free gear's rotation at a crossing is settled, at most (four to six are usual, some dozens where tip circles hardly cross).
const MOST_TURNS: usize = 100;

/// Distances of the outlines' centres at which the room of a fillet is looked at (tuned: runout of a hundredth of a module changes it little).
const STEPS_OF_DISTANCE: u32 = 8;

/// Of which gear a fillet may be touched.
#[derive(Debug, Clone, Copy)]
pub(super) struct Edges {
    on_locked: bool,
    on_free: bool,
    /// Whether tips may come to the mate's root, which may jam the pair.
    jams: bool,
    /// Whether a pair of involutes may touch on the line of action between two sections only, or nowhere on it.
    short: bool,
}

impl Edges {
    /// `None` where no tip of `assembly`, whose right-hand half teeth are those of `problem`, comes to a fillet, and paths of contact are not
    /// `short`.
    pub fn new(assembly: &GearPair, problem: &FlankProblem, short: bool) -> Option<Edges> {
        let off = problem.locked_off.norm() + problem.free_off.norm();
        let nearest = assembly.center_distance() - off;
        let reached = |fillet: &Shape, tip: &Shape| nearest - tip.tip_radius < fillet.form_radius();
        let (locked, free) = (&problem.locked.shape, &problem.free.shape);
        let jams = |root: &Shape, tip: &Shape| nearest - tip.tip_radius < root.root_radius;
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
        match clear && !self.jams {
            true => self.short.then_some(Edges {
                on_locked: false,
                on_free: false,
                ..self
            }),
            false => Some(self),
        }
    }

    /// Places on the face, mm, at a pose of the measuring plane with the free gear at `rotation`, rad, in the frame of `posed`.
    pub fn places(&self, assembly: &GearPair, posed: &PosedFlanks, rotation: f64) -> Vec<f64> {
        let (locked, free) = (&posed.problem.locked.shape, &posed.problem.free.shape);
        let (c_l, c_f) = (posed.centre, posed.free_centre_at(rotation));
        let mut places = Vec::new();
        if self.jams {
            // Tips are deepest on the line of centres.
            let [locked, free] = [
                Turning::locked(assembly, posed),
                Turning::free(assembly, posed, rotation),
            ];
            locked.places((c_f - c_l).arg(), &mut places);
            free.places((c_l - c_f).arg(), &mut places);
        }
        let turnings = [
            Turning::locked(assembly, posed),
            Turning::free(assembly, posed, rotation),
        ];
        let between = c_f - c_l;
        let distance = between.norm();
        if self.short
            && let Some(tooth) = middle_of_path(locked, free, distance)
        {
            turnings[0].places(between.arg() + tooth, &mut places);
        }
        let mut take = |ahead, behind| tight_places(&turnings, [ahead, behind], &mut places);
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
                    crossing_places(posed, &turnings, [one, other], rotation, &mut places);
                }
            }
        }
        places
    }
}

/// Adds the places on the face, mm, at which a locked and a free tooth have the directions `ahead` and `behind`, rad, if the free gear may come
/// there: if it does not stop before.
fn tight_places([locked, free]: &[Turning; 2], [ahead, behind]: [f64; 2], places: &mut Vec<f64>) {
    let [from, to] = locked.face;
    for step in locked.steps(ahead) {
        let b = locked.place(ahead, step);
        let mate = free.step_near(behind, b);
        let farther = reduced(behind - free.direction(b, mate));
        if (from..=to).contains(&b) && farther > -DOUBT {
            places.push(b);
        }
    }
}

/// A tip and its mate's fillet, where they touch tightest along the face, beside the same teeth on the line of action: neither depends on where
/// along the face a section stands.
struct FilletRoom<'a> {
    fillet: &'a Shape,
    tip: &'a Shape,
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
fn middle_of_path(locked: &Shape, free: &Shape, distance: f64) -> Option<f64> {
    let line = Line::new(C::from(distance), locked.base + free.base)?;
    let mate = |roll: f64| (line.length - free.base * roll) / locked.base;
    let from = locked.form_roll.max(mate(free.tip_roll));
    let to = locked.tip_roll.min(mate(free.form_roll));
    (from <= to).then_some(line.angle - 0.5 * (from + to) + locked.half_base)
}

/// How the teeth of one gear stand along the face, in the frame of a pose.
struct Turning<'a> {
    face: [f64; 2],
    /// Rad a mm along the axis.
    twist: f64,
    /// Direction of the tooth of step 0 in the measuring plane, undisturbed, rad.
    ahead: f64,
    /// From one step to the next, rad.
    step: f64,
    /// What the flank of a step stands turned beyond its place, rad.
    offset: Box<dyn Fn(i64) -> f64 + 'a>,
}

impl<'a> Turning<'a> {
    fn new(assembly: &GearPair, posed: &PosedFlanks, member: Member) -> Turning<'a> {
        Turning {
            face: assembly.face(),
            twist: posed.mirror() * assembly.gear(member).gear().basic_data().twist(),
            ahead: 0.0,
            step: 0.0,
            offset: Box::new(|_| 0.0),
        }
    }

    fn locked(assembly: &GearPair, posed: &'a PosedFlanks) -> Turning<'a> {
        Turning {
            ahead: PI + posed.ahead,
            step: posed.problem.locked.pitch,
            offset: Box::new(|step| posed.locked_offset_at(step)),
            ..Turning::new(assembly, posed, assembly.locked())
        }
    }

    fn free(assembly: &GearPair, posed: &'a PosedFlanks, rotation: f64) -> Turning<'a> {
        Turning {
            ahead: rotation + posed.free_angle(),
            step: -posed.problem.free.pitch,
            offset: Box::new(|step| posed.free_offset_at(step)),
            ..Turning::new(assembly, posed, assembly.free())
        }
    }

    /// Adds the places on the face, mm, at which a tooth's centre line has `direction`, rad.
    fn places(&self, direction: f64, places: &mut Vec<f64>) {
        let [from, to] = self.face;
        for step in self.steps(direction) {
            let b = self.place(direction, step);
            if (from..=to).contains(&b) {
                places.push(b);
            }
        }
    }

    /// Steps whose centre lines may have `direction` on the face.
    fn steps(&self, direction: f64) -> RangeInclusive<i64> {
        let ahead = reduced(direction - self.ahead);
        let ends = self.face.map(|b| (ahead - self.twist * b) / self.step);
        let (low, high) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
        // A pitch more: flanks may stand off their places.
        (low - 1.0).floor() as i64..=(high + 1.0).ceil() as i64
    }

    /// Where the centre line of a step has `direction`, mm.
    fn place(&self, direction: f64, step: i64) -> f64 {
        let ahead = reduced(direction - self.ahead);
        (ahead - step as f64 * self.step - (self.offset)(step)) / self.twist
    }

    /// Direction of the centre line of a step at `b`, rad.
    fn direction(&self, b: f64, step: i64) -> f64 {
        self.ahead + step as f64 * self.step + (self.offset)(step) + self.twist * b
    }

    /// The step whose centre line is nearest to `direction` at `b`, if flanks stood at their places.
    fn step_near(&self, direction: f64, b: f64) -> i64 {
        (reduced(direction - self.ahead - self.twist * b) / self.step).round() as i64
    }
}

/// Adds the places at which the corners `edges` of a locked and a free tooth cross, and those just beside them: on one side of a crossing
/// the corners pass each other, and on which rounding would decide.
///
/// Where the free gear stands then is not `rotation`, and its eccentric axis not where that puts it: for each locked tooth both are settled in turn,
/// each step leaving a share `e_F/r_F` of the last, more where the circles hardly cross.
fn crossing_places(
    posed: &PosedFlanks,
    [locked, free]: &[Turning; 2],
    edges: [C; 2],
    rotation: f64,
    places: &mut Vec<f64>,
) {
    let [from, to] = locked.face;
    let radii = edges.map(|edge| edge.norm());
    let meets = |rotation: f64| {
        let centres = [posed.centre, posed.free_centre_at(rotation)];
        let points = crossings((centres[0], radii[0]), (centres[1], radii[1]));
        points.map(|points| {
            points.map(|point| [0, 1].map(|k| (point - centres[k]).arg() - edges[k].arg()))
        })
    };
    let Some(points) = meets(rotation) else {
        return;
    };
    for (index, [ahead, behind]) in points.into_iter().enumerate() {
        for step in locked.steps(ahead) {
            let mut b = locked.place(ahead, step);
            let mate = free.step_near(behind, b);
            let mut turned = 0.0;
            for _ in 0..MOST_TURNS {
                let Some([ahead, behind]) = meets(rotation + turned).map(|points| points[index])
                else {
                    b = f64::NAN;
                    break;
                };
                b += reduced(ahead - locked.direction(b, step)) / locked.twist;
                let last = turned;
                turned = reduced(behind - free.direction(b, mate));
                if (turned - last).abs() <= BESIDE {
                    break;
                }
            }
            if turned < -DOUBT {
                continue;
            }
            let beside = BESIDE / locked.twist;
            let near = [b - beside, b, b + beside].into_iter();
            places.extend(near.filter(|b| (from..=to).contains(b)));
        }
    }
}

/// Both intersections of two circles.
fn crossings(one: (C, f64), other: (C, f64)) -> Option<[C; 2]> {
    let between = other.0 - one.0;
    let distance = between.norm();
    let along = (distance * distance + one.1 * one.1 - other.1 * other.1) / (2.0 * distance);
    let square = one.1 * one.1 - along * along;
    if !(square >= 0.0) {
        return None;
    }
    let unit = between / distance;
    let aside = square.sqrt();
    Some([aside, -aside].map(|aside| one.0 + unit * C::new(along, aside)))
}
