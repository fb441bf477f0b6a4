//! Where along the face edges of the teeth stand, and where two of them cross.

use crate::contact::Effort;
use crate::contact::exact::curves::Curves;
use crate::contact::exact::flank_problem::PosedFlanks;
use crate::contact::exact::placed::Placed;
use crate::contact::exact::shape::{C, HalfToothShape};
use crate::contact::exact::teeth::reduced;
use crate::pair::{GearPair, Member};
use std::f64::consts::PI;
use std::ops::RangeInclusive;

/// How near to a crossing of edges, as an angle of the locked tooth, rad: some hundred times what rounding leaves of its direction.
const BESIDE: f64 = 1e-13;

/// Rounding of a centre or a radius, in ulps of all of them.
const ROUNDING: f64 = 4.0;

/// A touch this far before the one that holds the free gear is looked at all the same, rad: a millionth of what teeth differ by.
const DOUBT: f64 = 1e-9;

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
            twist: Turning::twist(assembly, posed, member),
            ahead: 0.0,
            step: 0.0,
            offset: Box::new(|_| 0.0),
        }
    }

    /// How the teeth of a gear wind in the frame of `posed`, rad a mm along the axis.
    pub fn twist(assembly: &GearPair, posed: &PosedFlanks, member: Member) -> f64 {
        posed.mirror() * assembly.gear(member).gear().basic_data().twist()
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

    /// The places on the face at which `edge` of a tooth has `direction`, rad: of an end those on either side, for on which of them what ends
    /// there is met rounding would decide.
    pub fn places(&self, edge: &Edge, direction: f64) -> impl Iterator<Item = Place> {
        let sides: &[f64] = if edge.is_end {
            &[-BESIDE, BESIDE]
        } else {
            &[0.0]
        };
        let steps = self.steps(direction - (edge.beyond)(0));
        steps.flat_map(move |step| {
            let b = self.place(direction - (edge.beyond)(step), step);
            let near = sides.iter().map(move |beside| b + beside / self.twist);
            near.filter_map(move |b| self.on_face(step, b, 0.0))
        })
    }

    /// A place of a pair of teeth, if it is on the face.
    pub fn on_face(&self, step: i64, b: f64, doubt: f64) -> Option<Place> {
        let place = Place {
            step,
            b,
            doubt,
            curves: Curves::ALL,
        };
        (self.face[0]..=self.face[1]).contains(&b).then_some(place)
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
}

/// An edge that all teeth of a gear have at one radius, or the middle of their tips.
pub(super) struct Edge<'a> {
    /// From the gear's own centre, mm.
    pub radius: f64,
    /// Its angle from the centre line of the tooth of a step, rad.
    beyond: Box<dyn Fn(i64) -> f64 + 'a>,
    /// Whether a curve ends there.
    is_end: bool,
}

impl<'a> Edge<'a> {
    /// The middle of the tip land, on the centre line of the tooth.
    pub fn middle(shape: &HalfToothShape) -> Edge<'a> {
        Edge {
            is_end: false,
            ..Edge::corner(C::from(shape.tip_radius))
        }
    }

    /// The corner that stands at `point` of every half tooth.
    pub fn corner(point: C) -> Edge<'a> {
        let angle = point.arg();
        Edge {
            radius: point.norm(),
            beyond: Box::new(move |_| angle),
            is_end: true,
        }
    }

    /// Where the tip land ends that the half tooth of a step begins with.
    pub fn far(shape: &HalfToothShape, half: impl Fn(i64) -> Placed<'a> + 'a) -> Edge<'a> {
        Edge {
            radius: shape.tip_radius,
            beyond: Box::new(move |step| half(step).far.arg()),
            is_end: true,
        }
    }

    /// Where the root land ends: the next half tooth's begins there, which faces others.
    pub fn root_end(shape: &HalfToothShape, half: impl Fn(i64) -> Placed<'a> + 'a) -> Edge<'a> {
        Edge {
            radius: shape.root_radius,
            beyond: Box::new(move |step| -half(step).root_end),
            is_end: true,
        }
    }
}

/// A place on the face to look at.
#[derive(Debug, Clone, Copy)]
pub(super) struct Place {
    /// The pair of teeth that may touch there.
    pub step: i64,
    /// Mm.
    pub b: f64,
    /// How much farther a contact may hold the free gear at the place that is meant, rad: rounding left that unsure by so much more than is common.
    pub doubt: f64,
    /// The pairs of curves that may touch tightest there, beside roots, which are asked about everywhere.
    pub curves: Curves,
}

/// Where the free gear stands in the frame of a pose.
#[derive(Debug, Clone, Copy)]
pub(super) struct FreeGear {
    /// Rad.
    pub rotation: f64,
    /// Whether something touches there: what touches before does not matter.
    pub is_held: bool,
}

impl FreeGear {
    /// Whether it may come to stand so much `farther`, rad.
    pub(super) fn may_come(self, farther: f64) -> bool {
        !self.is_held || farther > -DOUBT
    }
}

/// Adds the places at which `edges` of a locked and of the free tooth that faces it cross, and those just beside them: on one side of a crossing
/// the edges pass each other, and on which rounding would decide.
///
/// Where the free gear stands then is not where it `stands`, and its eccentric axis not where that puts it: for each locked tooth both are settled in turn,
/// each step leaving a share `e_F/r_F` of the last, more where the circles hardly cross. A step to where they do not cross is halved.
pub(super) fn crossing_places(
    posed: &PosedFlanks,
    [locked, free]: &[Turning; 2],
    edges: [&Edge; 2],
    stands: FreeGear,
    (places, effort): (&mut Vec<Place>, &Effort),
) {
    let rotation = stands.rotation;
    let meets = |turned: f64| {
        let centres = [posed.centre, posed.free_centre_at(rotation + turned)];
        Crossing::new(centres, [edges[0].radius, edges[1].radius])
    };
    let beyond = [0, 1].map(|k| &edges[k].beyond);
    // An edge on the mate's involute, whose normal passes the locked axis at no more than the edge does: both gears' turn and the rolling between them.
    let bases = [&posed.problem.locked, &posed.problem.free].map(|teeth| teeth.shape.base);
    let per_turn = (edges[0].radius + bases[0]) / bases[1];
    // Of an eccentric free gear whose circle does not reach the mate's there, where it reaches farthest.
    let nearest = reduced((posed.centre * posed.problem.free_off.conj()).arg() - rotation);
    let Some((start, first)) = [0.0, nearest]
        .into_iter()
        .find_map(|turned| Some((turned, meets(turned)?)))
    else {
        return;
    };
    for (index, [ahead, behind]) in first.directions.into_iter().enumerate() {
        // That of the teeth themselves but for what flanks stand off their places.
        for step in locked.steps(ahead - beyond[0](0)) {
            let turned_to =
                |behind: f64, b: f64| reduced(behind - beyond[1](step) - free.direction(b, step));
            let mut b = locked.place(ahead - beyond[0](step), step);
            let mut turned = start;
            let mut next = turned_to(behind, b);
            for _ in 0..MOST_TURNS {
                effort.spend(1);
                if (next - turned).abs() <= BESIDE {
                    break;
                }
                match meets(next) {
                    Some(crossing) => {
                        let [ahead, behind] = crossing.directions[index];
                        turned = next;
                        b += reduced(ahead - beyond[0](step) - locked.direction(b, step))
                            / locked.twist;
                        next = turned_to(behind, b);
                    }
                    None => next = 0.5 * (turned + next),
                }
            }
            if !stands.may_come(next) || !b.is_finite() {
                continue;
            }
            let unsure = meets(turned).map_or(0.0, |crossing| crossing.unsure) / edges[0].radius;
            // As far beyond what rounding leaves of it as that comes to.
            let off = 2.0 * unsure;
            let beside = [-BESIDE, BESIDE, -off, off];
            for beside in &beside[..if unsure > BESIDE { 4 } else { 2 }] {
                let doubt = if beside.abs() > BESIDE {
                    per_turn * beside.abs()
                } else {
                    0.0
                };
                places.extend(locked.on_face(step, b + beside / locked.twist, doubt));
            }
        }
    }
}

/// Both intersections of two circles.
struct Crossing {
    /// Of each, seen from both centres, rad.
    directions: [[f64; 2]; 2],
    /// How far along the circles rounding may put them, mm: the less they overlap the farther.
    unsure: f64,
}

impl Crossing {
    fn new(centres: [C; 2], [one, other]: [f64; 2]) -> Option<Crossing> {
        let between = centres[1] - centres[0];
        let distance = between.norm();
        let overlap = one + other - distance;
        // No difference of large squares: circles that hardly overlap cross where that says.
        let short = overlap * (other + distance - one) / (2.0 * distance);
        let along = one - short;
        let square = short * (one + along);
        if !(square >= 0.0) {
            return None;
        }
        let unit = between / distance;
        let aside = square.sqrt();
        // `aside² = 2 ρ overlap`, `ρ = r_1 r_2/a`, where that is small.
        let rounding = ROUNDING * f64::EPSILON * (distance + one + other);
        let twice = 2.0 * one * other / distance * rounding;
        Some(Crossing {
            directions: [aside, -aside].map(|aside| {
                let point = centres[0] + unit * C::new(along, aside);
                centres.map(|centre| (point - centre).arg())
            }),
            unsure: (0.5 * twice / aside).min(twice.sqrt()),
        })
    }
}

#[cfg(test)]
pub(super) mod tests;
