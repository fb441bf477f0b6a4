//! Branch and bound over any pair of curves: slow, and right for plain reasons.
//!
//! Two half teeth are put where the pose puts them, positions counted from the
//! free gear's axis. Points `P` of the locked and `Q` of the free one meet when
//! `|P| = |Q| = ρ`, at the free gear's rotation `arg(P · conj Q)`, the *gap*;
//! the right side's contact is the greatest gap. A node is a pair of arcs. With
//! `σ = ρ dθ/dρ = tan ψ`, `ψ` the angle between tangent and radius, the gap over
//! `ln ρ` has the slope `σ_locked − σ_free`. So:
//!
//! - a node whose radii do not overlap, or whose greatest gap is below one already found, is empty;
//! - where both arcs rise or fall in `ρ` and their `ψ` do not overlap, the gap is monotone: its
//!   greatest value stands at an end of the common radii, and one evaluation settles the node;
//! - where they do overlap the gap exceeds that at one radius by at most (slope) × (length in ln ρ):
//!   second order in the arc's length, so a smooth maximum is closed after a few dozen nodes;
//! - anything else is cut in two.
//!
//! All bounds come from the distance and turn of the curve from its middle ([`super::shape::Shape::spread`]);
//! nothing is assumed of the curves' shape.

use super::candidate::CandidateContact;
use super::curves::{Curves, SearchExhausted};
use super::placed::{Placed, invert};
use super::shape::C;
use crate::gear::ProfilePart;
use std::f64::consts::{FRAC_PI_2, PI};

/// Nodes of one side of a pose, over all its pairs, after which its contact counts as lost. A node takes some 0.3 µs:
/// both sides together stay below 0.1 s.
pub(super) const MOST_NODES: usize = 150_000;

/// Arcs seen under so small an angle, rad, are one point: a few units in the last place of a parameter of order 1. (A finer
/// one is never reached where arcs cannot be cut any more.)
const FINEST: f64 = 16.0 * f64::EPSILON;

/// A piece of a curve and what is known of it.
#[derive(Debug, Clone, Copy)]
struct Arc {
    curve: ProfilePart,
    low: f64,
    high: f64,
    middle: C,
    /// Distance from the middle within which it lies.
    reach: f64,
    /// Angle within which it is seen from the axis, to either side of the middle.
    swing: f64,
    radii: (f64, f64),
    /// Bounds of `ψ` where the arc is monotone in `ρ`, and whether `ρ` rises with the parameter.
    slope: Option<(f64, f64, bool)>,
}

impl Arc {
    fn new(placed: &Placed, curve: ProfilePart, low: f64, high: f64) -> Arc {
        let sample = placed.at(curve, 0.5 * (low + high));
        let (reach, bend) = placed.shape.spread(curve, low, high);
        let radius = sample.point.norm();
        let swing = if reach < radius {
            (reach / radius).asin()
        } else {
            PI
        };
        // z = tangent/radius direction; of its two senses the one of rising ρ.
        let z = C::i() * sample.normal * sample.point.conj();
        let psi = (z.im * z.re.signum()).atan2(z.re.abs());
        let play = bend + swing;
        let mut arc = Arc {
            curve,
            low,
            high,
            middle: sample.point,
            reach,
            swing,
            radii: (radius - reach, radius + reach),
            slope: None,
        };
        if low == high {
            arc.slope = Some((0.0, 0.0, true));
        } else if psi.abs() + play < FRAC_PI_2 {
            let ends = [low, high].map(|t| placed.at(curve, t).point.norm());
            arc.radii = (ends[0].min(ends[1]), ends[0].max(ends[1]));
            arc.slope = Some((psi - play, psi + play, ends[0] <= ends[1]));
        }
        arc
    }

    fn middle_parameter(&self) -> f64 {
        0.5 * (self.low + self.high)
    }

    /// Whether a parameter lies between its ends.
    fn can_be_cut(&self) -> bool {
        let middle = self.middle_parameter();
        self.low < middle && middle < self.high
    }

    fn cut(&self, placed: &Placed) -> [Arc; 2] {
        let middle = self.middle_parameter();
        [
            Arc::new(placed, self.curve, self.low, middle),
            Arc::new(placed, self.curve, middle, self.high),
        ]
    }

    /// The parameter at radius `rho` of a monotone arc; at or beyond an end, that end.
    fn at_radius(&self, placed: &Placed, rho: f64, rising: bool) -> f64 {
        let (inner, outer) = if rising {
            (self.low, self.high)
        } else {
            (self.high, self.low)
        };
        if rho <= self.radii.0 {
            inner
        } else if rho >= self.radii.1 {
            outer
        } else {
            let middle = 0.5 * (inner + outer);
            invert(placed, self.curve, rho, [inner, outer], middle)
        }
    }
}

/// The greatest gap of two half teeth over `curves`, if it reaches `floor`.
///
/// `origin` is the free gear's direction from which gaps count, so that they are small angles; `nodes_left`,
/// of which it takes what it needs.
pub(super) fn search(
    locked: &Placed,
    free: &Placed,
    origin: C,
    floor: f64,
    curves: Curves,
    nodes_left: &mut usize,
) -> Result<Option<CandidateContact>, SearchExhausted> {
    let mut best: Option<CandidateContact> = None;
    let mut level = floor;
    let mut nodes = Vec::new();
    let frees = ProfilePart::ALL.map(|curve| whole_free_arc(free, curve));
    for (locked_arc, row) in ProfilePart::ALL.into_iter().zip(curves.0) {
        if row == [false; 4] || !locked.has(locked_arc) {
            continue;
        }
        let (low, high) = locked.range(locked_arc);
        let arc = Arc::new(locked, locked_arc, low, high);
        let free_arc = frees.iter().zip(row).filter(|(_, wanted)| *wanted);
        nodes.extend(free_arc.filter_map(|(free, _)| Some((arc, (*free)?))));
    }
    while let Some((locked_arc, free_arc)) = nodes.pop() {
        if *nodes_left == 0 {
            return Err(SearchExhausted(locked_arc.curve, free_arc.curve));
        }
        *nodes_left -= 1;
        let inner = locked_arc.radii.0.max(free_arc.radii.0);
        let outer = locked_arc.radii.1.min(free_arc.radii.1);
        let play = locked_arc.swing + free_arc.swing;
        let middle_gap = (locked_arc.middle * free_arc.middle.conj() * origin).arg();
        if inner > outer || (play < PI && middle_gap + play <= level) {
            continue;
        }
        let mut record = |t: f64, u: f64, slack: f64| {
            let candidate = CandidateContact::new(
                (locked, (locked_arc.curve, t)),
                (free, (free_arc.curve, u)),
                origin,
                slack,
            );
            if candidate.gap > level {
                level = candidate.gap;
                best = Some(candidate);
            }
            candidate.gap
        };
        if let (Some(a), Some(b)) = (locked_arc.slope, free_arc.slope) {
            let mut meet = |rho: f64, slack: f64| {
                record(
                    locked_arc.at_radius(locked, rho, a.2),
                    free_arc.at_radius(free, rho, b.2),
                    slack,
                )
            };
            if a.0 >= b.1 {
                meet(outer, 0.0);
                continue;
            }
            if a.1 <= b.0 {
                meet(inner, 0.0);
                continue;
            }
            let slope = (a.1.tan() - b.0.tan()).max(b.1.tan() - a.0.tan());
            let rise = slope * (outer - inner) / inner;
            let gap = meet(0.5 * (inner + outer), f64::EPSILON);
            if gap + rise <= level + f64::EPSILON {
                continue;
            }
        } else if play <= FINEST || !(locked_arc.can_be_cut() || free_arc.can_be_cut()) {
            record(
                locked_arc.middle_parameter(),
                free_arc.middle_parameter(),
                play,
            );
            continue;
        }
        if !free_arc.can_be_cut() || locked_arc.can_be_cut() && locked_arc.reach >= free_arc.reach {
            nodes.extend(locked_arc.cut(locked).map(|arc| (arc, free_arc)));
        } else {
            nodes.extend(free_arc.cut(free).map(|arc| (locked_arc, arc)));
        }
    }
    Ok(best)
}

/// The whole of one curve of the free gear, if it has any length. About its own centre a land has one radius, on which
/// only its end farthest clockwise can touch: of the tip land the corner (which ends the involute
/// too), of the root land the middle of the space.
fn whole_free_arc(free: &Placed, curve: ProfilePart) -> Option<Arc> {
    if !free.has(curve) {
        return None;
    }
    let (low, high) = free.range(curve);
    if free.centre != C::ZERO {
        return Some(Arc::new(free, curve, low, high));
    }
    match curve {
        ProfilePart::Tip => None,
        ProfilePart::Root => Some(Arc::new(free, curve, high, high)),
        _ => Some(Arc::new(free, curve, low, high)),
    }
}
