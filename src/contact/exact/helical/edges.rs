//! Where along the face an edge may touch a fillet tightest.
//!
//! Where an edge touches a fillet tightest ([`super::super::deepest`]) is common to all teeth; the turn of the locked tooth, and
//! with it `b`, follows. Where two edges cross, the tightest may stand as well: both circles' intersection says where.
//!
//! These are places to look at: a section's own method finds what touches there.

use crate::contact::exact::deepest::deepest;
use crate::contact::exact::flank_problem::{FlankProblem, PosedFlanks};
use crate::contact::exact::shape::{C, Shape};
use crate::contact::exact::teeth::reduced;
use crate::pair::{GearPair, Member};
use std::f64::consts::PI;

/// Of which gear a fillet may be touched.
#[derive(Debug, Clone, Copy)]
pub(super) struct Edges {
    on_locked: bool,
    on_free: bool,
    /// Whether tips may come to the mate's root, which may jam the pair.
    jams: bool,
}

impl Edges {
    /// `None` where no tip of `assembly`, whose right-hand half teeth are those of `problem`, comes to a fillet.
    pub fn new(assembly: &GearPair, problem: &FlankProblem) -> Option<Edges> {
        let off = problem.locked_off.norm() + problem.free_off.norm();
        let nearest = assembly.center_distance() - off;
        let reached = |fillet: &Shape, tip: &Shape| nearest - tip.tip_radius < fillet.form_radius();
        let (locked, free) = (&problem.locked.shape, &problem.free.shape);
        let jams = |root: &Shape, tip: &Shape| nearest - tip.tip_radius < root.root_radius;
        let edges = Edges {
            on_locked: reached(locked, free),
            on_free: reached(free, locked),
            jams: jams(locked, free) || jams(free, locked),
        };
        (edges.on_locked || edges.on_free).then_some(edges)
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
        let turning = Turning::locked(assembly, posed);
        let mut take = |direction: f64| turning.places(direction, &mut places);
        let between = c_f - c_l;
        let distance = between.norm();
        for &(_, edge) in free.corners() {
            if self.on_locked {
                for touch in deepest(locked, distance, free.base, edge.norm()) {
                    take(between.arg() + touch.tooth);
                }
            }
            for &(_, other) in locked.corners() {
                for point in crossings((c_l, other.norm()), (c_f, edge.norm())) {
                    take((point - c_l).arg() - other.arg());
                }
            }
        }
        if self.on_free {
            for &(_, edge) in locked.corners() {
                for touch in deepest(free, distance, locked.base, edge.norm()) {
                    let point = c_f - touch.point * between / distance;
                    take((point - c_l).arg() - edge.arg());
                }
            }
        }
        places
    }
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
        let ahead = reduced(direction - self.ahead);
        let ends = [from, to].map(|b| (ahead - self.twist * b) / self.step);
        let (low, high) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
        // A pitch more: flanks may stand off their places.
        for step in (low - 1.0).floor() as i64..=(high + 1.0).ceil() as i64 {
            let b = (ahead - step as f64 * self.step - (self.offset)(step)) / self.twist;
            if (from..=to).contains(&b) {
                places.push(b);
            }
        }
    }
}

/// Both intersections of two circles.
fn crossings(one: (C, f64), other: (C, f64)) -> Vec<C> {
    let between = other.0 - one.0;
    let distance = between.norm();
    let along = (distance * distance + one.1 * one.1 - other.1 * other.1) / (2.0 * distance);
    let square = one.1 * one.1 - along * along;
    if !(square >= 0.0) {
        return Vec::new();
    }
    let unit = between / distance;
    let aside = square.sqrt();
    vec![
        one.0 + unit * C::new(along, aside),
        one.0 + unit * C::new(along, -aside),
    ]
}
