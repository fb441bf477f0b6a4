//! A locked tip land on a free involute: two convex curves that can touch between the land's corners.
//!
//! The land is an arc of radius `r_a` about `C_L`. It is like an involute without a base circle: every point has the
//! same centre of curvature. So the contact normal is the tangent from `C_L` to the free base circle. With `r_bL = 0`
//! the equations of [`super::line`] reduce to
//!
//! ```text
//! T = √(|B|² − r_b²),    r_b ξ = T − r_a,    μ − ψ_b = arg B + acos(r_b/|B|) − ξ
//! ```
//!
//! If both outlines are centred, one roll holds for all teeth. With an eccentric free gear `B` depends on the gap, and
//! Newton's method solves it as there. Both curves are convex, so the gap has only this one maximum along them. Without
//! it, the gap is greatest at a corner of either tip.

use super::candidate::CandidateContact;
use super::flank_problem::{FlankProblem, PosedFlanks};
use super::line::Line;
use super::path::InvolutePair;
use super::shape::{C, HalfToothShape};
use super::tightest::TightestContacts;
use crate::contact::gap::dot;
use crate::gear::ProfilePart;

/// Step, rad, after which one more ends in rounding.
const SETTLED: f64 = 1e-9;

/// The contact of a locked land with a free involute, both extended.
struct Tangent {
    gap: f64,
    roll: f64,
    /// Direction from the locked outline's centre to the contact.
    normal: C,
}

/// Offers every contact of a locked tip land between its corners with a free involute.
pub(super) fn offer_land_tangents(
    posed: &PosedFlanks,
    is_eccentric: bool,
    tightest_contacts: &mut TightestContacts,
) {
    let free_shape = &posed.problem.free.shape;
    let Some(start) = tangent_line(posed, 0.0) else {
        return;
    };
    if !is_eccentric && !is_on_involute(free_shape, roll_on(posed.problem, &start)) {
        return;
    }
    // As `B` moves by up to `2e`, a line turns by at most that over its least length.
    let moved = 2.0 * posed.problem.free_off.norm_sqr().sqrt();
    let base = free_shape.base;
    let nearest = (start.between.norm_sqr().sqrt() - moved).max(base);
    let turned = moved / ((nearest - base) * (nearest + base)).sqrt();
    for step in posed.steps() {
        let locked = posed.locked(step);
        let (far, corner) = (locked.far, locked.shape.corners()[0].1);
        let is_past = |normal: C, turned: f64| {
            let along = dot(normal, locked.direction) + turned;
            along * locked.shape.tip_radius < far.re.min(corner.re)
        };
        if is_past(normal(&start, base), turned) {
            continue;
        }
        let Some(found) = tangent(posed, step, &start, is_eccentric) else {
            continue;
        };
        if !is_on_involute(free_shape, found.roll) || !tightest_contacts.admits(found.gap) {
            continue;
        }
        let seen = found.normal * locked.direction.conj();
        if is_past(found.normal, 0.0) {
            continue;
        }
        let (far, corner) = locked.range(ProfilePart::Tip);
        let t = -seen.arg();
        if t < far || t > corner {
            continue;
        }
        let roll = found.roll.clamp(free_shape.form_roll, free_shape.tip_roll);
        let on = (
            (&locked, (ProfilePart::Tip, t)),
            (&posed.free(step), (ProfilePart::Involute, roll)),
        );
        let candidate = CandidateContact::new(on.0, on.1, posed.origin_of(step), 0.0);
        if tightest_contacts.admits(candidate.gap) {
            tightest_contacts.offer(step, candidate);
        }
    }
}

/// The tangent from the locked outline's centre to the free base circle, the free gear turned by `gap`.
fn tangent_line(posed: &PosedFlanks, gap: f64) -> Option<Line> {
    Line::new(posed.centre_vector(gap).0, posed.problem.free.shape.base)
}

/// Roll of the free involute at the contact on `line`.
fn roll_on(problem: &FlankProblem, line: &Line) -> f64 {
    (line.length - problem.locked.shape.tip_radius) * problem.per_free_base
}

fn is_on_involute(free_shape: &HalfToothShape, roll: f64) -> bool {
    roll >= free_shape.form_roll && roll <= free_shape.tip_roll
}

/// The contact of the extended land and involute of a step; `None` if the line does not settle, because the base circle reaches the land's
/// centre.
fn tangent(posed: &PosedFlanks, step: i64, start: &Line, is_eccentric: bool) -> Option<Tangent> {
    let problem = posed.problem;
    let base = problem.free.shape.base;
    let own = InvolutePair::new(posed, step).free_base;
    let gap_on = |line: &Line| line.angle - roll_on(problem, line) - own;
    let mut gap = gap_on(start);
    let mut line = *start;
    if is_eccentric {
        let mut settled = false;
        // Two or three steps: |dG/dμ| ≤ e/r_b < 1. Each leaves its square.
        for _ in 0..60 {
            let (between, rate) = posed.centre_vector(gap);
            line = Line::new(between, base)?;
            let slope = line.slope(rate, base) * problem.per_free_base;
            let change = (gap_on(&line) - gap) / (1.0 - slope);
            gap += change;
            if settled {
                break;
            }
            settled = change.abs() <= SETTLED;
        }
        if !settled {
            return None;
        }
    }
    Some(Tangent {
        gap,
        roll: roll_on(problem, &line),
        normal: normal(&line, base),
    })
}

/// The land's normal at the end of a tangent to the free base circle. The involute's normal there is −iE, the land's the opposite.
fn normal(line: &Line, base: f64) -> C {
    let e = line.between * (C::new(base, line.length) / line.between.norm_sqr());
    C::i() * e
}
