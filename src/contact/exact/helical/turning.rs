//! Where along the face edges of the teeth stand, and where two of them cross.

use crate::contact::Effort;
use crate::contact::exact::flank_problem::PosedFlanks;
use crate::contact::exact::placed::Placed;
use crate::contact::exact::shape::{C, HalfToothShape};
use crate::contact::exact::teeth::reduced;
use crate::pair::{GearPair, Member};
use std::f64::consts::PI;
use std::ops::RangeInclusive;

/// How near to a crossing of edges, as an angle of the locked tooth, rad: some hundred times what rounding leaves of its direction.
const BESIDE: f64 = 1e-13;

/// A touch this far before the one that holds the free gear is looked at all the same, rad: a millionth of what teeth differ by.
pub(super) const DOUBT: f64 = 1e-9;

/// Steps in which the free gear's rotation at a crossing is settled, at most (four to six are usual, some dozens where tip circles hardly cross).
const MOST_TURNS: usize = 100;

/// How the teeth of one gear stand along the face, in the frame of a pose.
pub(super) struct Turning<'a> {
    pub face: [f64; 2],
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

    pub fn locked(assembly: &GearPair, posed: &'a PosedFlanks) -> Turning<'a> {
        Turning {
            ahead: PI + posed.ahead,
            step: posed.problem.locked.pitch,
            offset: Box::new(|step| posed.locked_offset_at(step)),
            ..Turning::new(assembly, posed, assembly.locked())
        }
    }

    pub fn free(assembly: &GearPair, posed: &'a PosedFlanks, rotation: f64) -> Turning<'a> {
        Turning {
            ahead: rotation + posed.free_angle(),
            step: -posed.problem.free.pitch,
            offset: Box::new(|step| posed.free_offset_at(step)),
            ..Turning::new(assembly, posed, assembly.free())
        }
    }

    /// Adds the places on the face, mm, at which `edge` of a tooth has `direction`, rad, and those just beside them: on which side of its end a
    /// land is met rounding would decide.
    pub fn places(&self, edge: &Edge, direction: f64, places: &mut Vec<f64>) {
        let [from, to] = self.face;
        let beside = BESIDE / self.twist;
        for step in self.steps(direction - (edge.beyond)(0)) {
            let b = self.place(direction - (edge.beyond)(step), step);
            let near = [b - beside, b, b + beside].into_iter();
            places.extend(near.filter(|b| (from..=to).contains(b)));
        }
    }

    /// Steps whose centre lines may have `direction` on the face.
    pub fn steps(&self, direction: f64) -> RangeInclusive<i64> {
        let ahead = reduced(direction - self.ahead);
        let ends = self.face.map(|b| (ahead - self.twist * b) / self.step);
        let (low, high) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
        // A pitch more: flanks may stand off their places.
        (low - 1.0).floor() as i64..=(high + 1.0).ceil() as i64
    }

    /// Where the centre line of a step has `direction`, mm.
    pub fn place(&self, direction: f64, step: i64) -> f64 {
        let ahead = reduced(direction - self.ahead);
        (ahead - step as f64 * self.step - (self.offset)(step)) / self.twist
    }

    /// Direction of the centre line of a step at `b`, rad.
    pub fn direction(&self, b: f64, step: i64) -> f64 {
        self.ahead + step as f64 * self.step + (self.offset)(step) + self.twist * b
    }

    /// The step whose centre line is nearest to `direction` at `b`, if flanks stood at their places.
    pub fn step_near(&self, direction: f64, b: f64) -> i64 {
        (reduced(direction - self.ahead - self.twist * b) / self.step).round() as i64
    }
}

/// An edge that all teeth of a gear have at one radius.
pub(super) struct Edge<'a> {
    /// From the gear's own centre, mm.
    pub radius: f64,
    /// Its angle from the centre line of the tooth of a step, rad.
    beyond: Box<dyn Fn(i64) -> f64 + 'a>,
}

impl<'a> Edge<'a> {
    /// The corner that stands at `point` of every half tooth.
    pub fn corner(point: C) -> Edge<'a> {
        let angle = point.arg();
        Edge {
            radius: point.norm(),
            beyond: Box::new(move |_| angle),
        }
    }

    /// Where the tip land ends that the half tooth of a step begins with.
    pub fn far(shape: &HalfToothShape, half: impl Fn(i64) -> Placed<'a> + 'a) -> Edge<'a> {
        Edge {
            radius: shape.tip_radius,
            beyond: Box::new(move |step| half(step).far.arg()),
        }
    }

    /// Where the root land ends: the next half tooth's begins there, which faces others.
    pub fn root_end(shape: &HalfToothShape, half: impl Fn(i64) -> Placed<'a> + 'a) -> Edge<'a> {
        Edge {
            radius: shape.root_radius,
            beyond: Box::new(move |step| -half(step).root_end),
        }
    }
}

/// Adds the places at which `edges` of a locked and of a free tooth cross, and those just beside them: on one side of a crossing
/// the edges pass each other, and on which rounding would decide.
///
/// Where the free gear stands then is not `rotation`, and its eccentric axis not where that puts it: for each locked tooth both are settled in turn,
/// each step leaving a share `e_F/r_F` of the last, more where the circles hardly cross.
pub(super) fn crossing_places(
    posed: &PosedFlanks,
    [locked, free]: &[Turning; 2],
    edges: [&Edge; 2],
    rotation: f64,
    (places, effort): (&mut Vec<f64>, &Effort),
) {
    let [from, to] = locked.face;
    let meets = |rotation: f64| {
        let centres = [posed.centre, posed.free_centre_at(rotation)];
        let [one, other] = [0, 1].map(|k| (centres[k], edges[k].radius));
        let points = crossings(one, other);
        points.map(|points| points.map(|point| centres.map(|centre| (point - centre).arg())))
    };
    let Some(points) = meets(rotation) else {
        return;
    };
    let beyond = [0, 1].map(|k| &edges[k].beyond);
    for (index, [ahead, behind]) in points.into_iter().enumerate() {
        // That of the teeth themselves but for what flanks stand off their places.
        for step in locked.steps(ahead - beyond[0](0)) {
            let ahead = ahead - beyond[0](step);
            let mut b = locked.place(ahead, step);
            let mate = free.step_near(behind - beyond[1](0), b);
            let mut turned = 0.0;
            for _ in 0..MOST_TURNS {
                effort.spend(1);
                let Some([ahead, behind]) = meets(rotation + turned).map(|points| points[index])
                else {
                    b = f64::NAN;
                    break;
                };
                b += reduced(ahead - beyond[0](step) - locked.direction(b, step)) / locked.twist;
                let last = turned;
                turned = reduced(behind - beyond[1](mate) - free.direction(b, mate));
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

#[cfg(test)]
pub(super) mod tests;
