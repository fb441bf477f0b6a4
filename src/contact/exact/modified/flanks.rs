//! The contact of the flanks of one pair of teeth.
//!
//! A convex flank is on one side of each of its tangents, and of every line through its tip corner within the corner's cone. If two flanks
//! touch from outside along a common tangent, that line divides them, so their gap is nowhere greater. One such place suffices, however it
//! is found: Newton's method finds it. Flanks that are not convex are searched.

use super::OuterPair;
use crate::contact::exact::candidate::{CandidateContact, slope};
use crate::contact::exact::flank_problem::PosedFlanks;
use crate::contact::exact::placed::PlacedHalf;
use crate::contact::exact::shape::CurvePoint;
use crate::gear::{Osculating, ProfilePart};

/// A step that ends Newton's method: its square is negligible.
const SETTLED: f64 = 1e-9;

/// Limit of Newton steps. From an outer contact three or four suffice.
const STEPS: u32 = 16;

/// The contact of the flanks of a pair, starting from that of the outer ones: at a common tangent, or at a tip
/// corner where the tangent lies past it. `None` if Newton's method finds none, or one below a flank's lower end.
pub(super) fn flank_contact(posed: &PosedFlanks, pair: &OuterPair) -> Option<CandidateContact> {
    let (locked, free) = (posed.locked(pair.step), posed.free(pair.step));
    let ranges = [&locked, &free].map(|half| half.range(ProfilePart::Involute));
    let (mut x, mut y) = pair.rolls;
    let mut settled = false;
    for _ in 0..STEPS {
        let ((p, one), (q, other)) = (locked.flank(x)?, free.flank(y)?);
        let [at_x, at_y] = [
            RollDerivatives::new(&p, &one),
            RollDerivatives::new(&q, &other),
        ];
        // Both points are at one radius with opposite normals. Unless the flanks are on opposite sides, nothing touches from outside.
        let rest = 0.5 * (p.point.norm_sqr() - q.point.norm_sqr());
        let w = p.point.conj() * p.normal * q.point * q.normal.conj();
        if !(w.re < 0.0) {
            return None;
        }
        let turn = (-w.im).atan2(-w.re);
        let determinant = at_y.along * at_x.turn - at_x.along * at_y.turn;
        let by = [&at_y, &at_x].map(|there| (rest * there.turn - turn * there.along) / determinant);
        x += by[0] / one.speed;
        y += by[1] / other.speed;
        if by[0].abs().max(by[1].abs()) < SETTLED * posed.problem.distance {
            settled = true;
            break;
        }
    }
    let [(low, high), (free_low, free_high)] = ranges;
    // This form also rejects NaN.
    if !(settled && x >= low && y >= free_low) {
        return None;
    }
    let [over, free_over] = [x > high, y > free_high];
    // The gap is stationary along the flanks but not across them, so both points are put at one radius.
    let on = |half: &PlacedHalf, rho: f64, range: [f64; 2], start: f64| {
        half.curve(ProfilePart::Involute).invert(rho, range, start)
    };
    let radius = |half: &PlacedHalf, t: f64| half.at(ProfilePart::Involute, t).point.norm();
    let inward = [high, low];
    match (over, free_over) {
        (true, true) => return None,
        // The last Newton step leaves only its square.
        (false, false) => (),
        (true, false) => {
            (x, y) = (
                high,
                on(&free, radius(&locked, high), [free_low, free_high], y),
            )
        }
        (false, true) => (x, y) = (on(&locked, radius(&free, free_high), inward, x), free_high),
    }
    let candidate = CandidateContact::new(
        (&locked, (ProfilePart::Involute, x)),
        (&free, (ProfilePart::Involute, y)),
        posed.origin_of(pair.step),
        0.0,
    );
    if over || free_over {
        let towards = if over { -1.0 } else { 1.0 };
        let meets = (radius(&locked, x) - radius(&free, y)).abs() <= SETTLED;
        if !(meets && rises(&locked, x, &free, y, towards)) {
            return None;
        }
    }
    Some(candidate)
}

/// Whether the gap of two flanks still rises at these rolls, towards greater radii (`towards` 1) or lesser ones (−1).
/// Over ln ρ its slope is that of the locked flank less that of the free one.
pub(super) fn rises(locked: &PlacedHalf, x: f64, free: &PlacedHalf, y: f64, towards: f64) -> bool {
    let slope_at = |half: &PlacedHalf, t: f64| slope(&half.at(ProfilePart::Involute, t));
    towards * (slope_at(locked, x) - slope_at(free, y)) > 0.0
}

/// Derivatives along a flank of half the squared radius and of the angle between normal and radius.
struct RollDerivatives {
    along: f64,
    turn: f64,
}

impl RollDerivatives {
    fn new(sample: &CurvePoint, own: &Osculating) -> RollDerivatives {
        // P · i n and P · n.
        let z = sample.point.conj() * sample.normal;
        RollDerivatives {
            along: -z.im,
            turn: own.curvature - z.re / sample.point.norm_sqr(),
        }
    }
}
