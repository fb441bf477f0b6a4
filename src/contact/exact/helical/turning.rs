//! Places along the face where edges of the teeth have a given direction, and where two edges cross.

use crate::contact::Effort;
use crate::contact::exact::curves::CurvePairs;
use crate::contact::exact::flank_problem::PosedFlanks;
use crate::contact::exact::placed::PlacedHalf;
use crate::contact::exact::shape::{C, HalfToothShape};
use crate::contact::exact::teeth::reduced;
use crate::pair::GearPair;
use std::f64::consts::PI;
use std::ops::RangeInclusive;

/// Angle of the locked tooth from a crossing of edges to the places just beside it, rad: about a hundred roundings.
const BESIDE: f64 = 1e-13;

/// Rounding of a centre or a radius, in ulps of their sum.
const ROUNDING: f64 = 4.0;

/// Contacts that touch up to this much earlier, rad, are still examined: a millionth of the differences between teeth.
const DOUBT: f64 = 1e-9;

/// Limit of steps to settle the free gear's rotation at a crossing. Four to six are usual; a few dozen where tip circles barely cross.
const MOST_TURNS: usize = 100;

/// The directions of one gear's teeth along the face, in the frame of a pose.
pub(super) struct TwistedTeeth<'a> {
    pub face: [f64; 2],
    /// Twist along the axis, rad/mm.
    twist: f64,
    /// Direction of the tooth of step 0 in the measuring plane, without deviations, rad.
    ahead: f64,
    /// Angle from one step to the next, rad.
    step: f64,
    /// Angular offset of a step's flank from its place, rad.
    offset: Box<dyn Fn(i64) -> f64 + 'a>,
}

impl<'a> TwistedTeeth<'a> {
    pub fn locked(assembly: &GearPair, posed: &'a PosedFlanks) -> TwistedTeeth<'a> {
        TwistedTeeth {
            face: assembly.face(),
            twist: posed.twist(assembly, assembly.locked()),
            ahead: PI + posed.ahead,
            step: posed.problem.locked.pitch,
            offset: Box::new(|step| posed.problem.locked.half(posed.places(step).0).offset),
        }
    }

    pub fn free(assembly: &GearPair, posed: &'a PosedFlanks, rotation: f64) -> TwistedTeeth<'a> {
        TwistedTeeth {
            face: assembly.face(),
            twist: posed.twist(assembly, assembly.free()),
            ahead: rotation + posed.free_angle(),
            step: -posed.problem.free.pitch,
            offset: Box::new(|step| posed.problem.free.half(posed.places(step).1).offset),
        }
    }

    /// The places on the face at which `edge` of a tooth has `direction`, rad. Around an end of a curve it gives a
    /// place on either side, because rounding would decide which side is met.
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
            curves: CurvePairs::ALL,
        };
        (self.face[0]..=self.face[1]).contains(&b).then_some(place)
    }

    /// Steps whose centre lines can have `direction` on the face.
    pub fn steps(&self, direction: f64) -> RangeInclusive<i64> {
        let ahead = reduced(direction - self.ahead);
        let ends = self.face.map(|b| (ahead - self.twist * b) / self.step);
        let (low, high) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
        // One pitch more, for the offsets of flanks.
        (low - 1.0).floor() as i64..=(high + 1.0).ceil() as i64
    }

    /// Place at which the centre line of a step has `direction`, mm.
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

    /// The corner at `point` of every half tooth.
    pub fn corner(point: C) -> Edge<'a> {
        let angle = point.arg();
        Edge {
            radius: point.norm(),
            beyond: Box::new(move |_| angle),
            is_end: true,
        }
    }

    /// The far end of the tip land of each half tooth.
    pub fn far(shape: &HalfToothShape, half: impl Fn(i64) -> PlacedHalf<'a> + 'a) -> Edge<'a> {
        Edge {
            radius: shape.tip_radius,
            beyond: Box::new(move |step| half(step).far.arg()),
            is_end: true,
        }
    }

    /// The end of the root land, where the half tooth begins that faces other teeth.
    pub fn root_end(shape: &HalfToothShape, half: impl Fn(i64) -> PlacedHalf<'a> + 'a) -> Edge<'a> {
        Edge {
            radius: shape.root_radius,
            beyond: Box::new(move |step| -half(step).root_end),
            is_end: true,
        }
    }
}

/// A place on the face to examine.
#[derive(Debug, Clone, Copy)]
pub(super) struct Place {
    /// The pair of teeth that can touch there.
    pub step: i64,
    /// Along the face, mm.
    pub b: f64,
    /// Uncertainty, rad, of how far a contact at this place lets the free gear turn, beyond the usual rounding.
    pub doubt: f64,
    /// The pairs of curves that can touch tightest there. Roots are always examined too.
    pub curves: CurvePairs,
}

/// The rotation of the free gear in the frame of a pose.
#[derive(Debug, Clone, Copy)]
pub(super) struct FreeGear {
    /// Rad.
    pub rotation: f64,
    /// Whether a contact stops it there. Earlier contacts do not matter then.
    pub is_held: bool,
}

impl FreeGear {
    /// Whether it can turn further by `farther`, rad.
    pub(super) fn can_reach(self, farther: f64) -> bool {
        !self.is_held || farther > -DOUBT
    }
}

/// Adds the places at which `edges` of a locked tooth and of its facing free tooth cross, and those just beside them.
/// On one side of a crossing the edges pass each other; rounding would decide which side.
///
/// There the free gear has another rotation than in `stands`, and its eccentric axis another direction. For each locked
/// tooth an iteration settles both. Each step leaves a share `e_F/r_F` of the last, or more where the circles barely
/// cross. A step beyond the crossing is halved.
pub(super) fn crossing_places(
    posed: &PosedFlanks,
    [locked, free]: &[TwistedTeeth; 2],
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
    // An edge on the mate's involute: its normal passes the locked axis no further out than the edge. This counts the
    // turn of both gears and the rolling between them.
    let bases = [&posed.problem.locked, &posed.problem.free].map(|teeth| teeth.shape.base);
    let per_turn = (edges[0].radius + bases[0]) / bases[1];
    // If the eccentric circle does not reach the mate's there, start where it reaches furthest.
    let nearest = reduced((posed.centre * posed.problem.free_off.conj()).arg() - rotation);
    let Some((start, first)) = [0.0, nearest]
        .into_iter()
        .find_map(|turned| Some((turned, meets(turned)?)))
    else {
        return;
    };
    for (index, [ahead, behind]) in first.directions.into_iter().enumerate() {
        // The step of the teeth themselves, except for the offsets of flanks.
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
            if !stands.can_reach(next) || !b.is_finite() {
                continue;
            }
            let uncertainty =
                meets(turned).map_or(0.0, |crossing| crossing.uncertainty) / edges[0].radius;
            // Twice the rounding of the crossing.
            let off = 2.0 * uncertainty;
            let beside = [-BESIDE, BESIDE, -off, off];
            for beside in &beside[..if uncertainty > BESIDE { 4 } else { 2 }] {
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
    /// Direction of each from both centres, rad.
    directions: [[f64; 2]; 2],
    /// Uncertainty of their position along the circles, mm. It grows as the overlap shrinks.
    uncertainty: f64,
}

impl Crossing {
    fn new(centres: [C; 2], [one, other]: [f64; 2]) -> Option<Crossing> {
        let between = centres[1] - centres[0];
        let distance = between.norm();
        let overlap = one + other - distance;
        // Without a difference of large squares, so that circles that barely overlap cross in the right place.
        let short = overlap * (other + distance - one) / (2.0 * distance);
        let along = one - short;
        let square = short * (one + along);
        if !(square >= 0.0) {
            return None;
        }
        let unit = between / distance;
        let aside = square.sqrt();
        // `aside² = 2 ρ overlap` with `ρ = r_1 r_2/a`, where it is small.
        let rounding = ROUNDING * f64::EPSILON * (distance + one + other);
        let twice = 2.0 * one * other / distance * rounding;
        Some(Crossing {
            directions: [aside, -aside].map(|aside| {
                let point = centres[0] + unit * C::new(along, aside);
                centres.map(|centre| (point - centre).arg())
            }),
            uncertainty: (0.5 * twice / aside).min(twice.sqrt()),
        })
    }
}

#[cfg(test)]
pub(super) mod tests;
