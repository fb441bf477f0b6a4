//! A locked tip land on a free involute: two convex curves that may touch between the land's corners.
//!
//! The land is an arc of the circle of radius `r_a` about `C_L`: an involute of no base circle, each of whose points
//! has the same centre of curvature. So the contact normal is the tangent from `C_L` to the free base circle, and of the equations
//! of [`super::line`] with `r_bL = 0`
//!
//! ```text
//! T = √(|B|² − r_b²),    r_b ξ = T − r_a,    μ − ψ_b = arg B + acos(r_b/|B|) − ξ
//! ```
//!
//! is left: where both outlines are centred one roll for all teeth. With an eccentric free gear `B` depends on the gap,
//! and Newton's method solves it as there. The curves are both convex, so that along them
//! the gap has this one maximum; where there is none, it is greatest at an end: a corner of either tip.

use super::candidate::CandidateContact;
use super::flank_problem::PosedFlanks;
use super::line::Line;
use super::shape::C;
use super::tightest::TightestContacts;
use crate::gear::ProfilePart;

/// After a step this small, rad, one more ends in rounding.
const SETTLED: f64 = 1e-9;

/// Where a locked land would touch a free involute, if both went on.
struct Tangent {
    gap: f64,
    roll: f64,
    /// Direction from the locked outline's centre to the contact.
    normal: C,
}

impl PosedFlanks<'_> {
    /// Offers every contact of a locked tip land between its corners with a free involute.
    pub(super) fn on_tangents(&self, eccentric: bool, tightest_contacts: &mut TightestContacts) {
        let free_shape = &self.problem.free.shape;
        let Some(start) = self.tangent_line(0.0) else {
            return;
        };
        if !eccentric && !self.is_on_involute(self.roll_on(&start)) {
            return;
        }
        for step in self.steps() {
            let Some(found) = self.tangent(step, &start, eccentric) else {
                continue;
            };
            if !self.is_on_involute(found.roll) || !tightest_contacts.admits(found.gap) {
                continue;
            }
            let locked = self.locked(step);
            let (far, corner) = (locked.far, locked.shape.corners()[0].1);
            let seen = found.normal * locked.direction.conj();
            if seen.re * locked.shape.tip_radius < far.re.min(corner.re) {
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
                (&self.free(step), (ProfilePart::Involute, roll)),
            );
            let candidate = CandidateContact::new(on.0, on.1, self.origin_of(step), 0.0);
            if tightest_contacts.admits(candidate.gap) {
                tightest_contacts.offer(step, candidate);
            }
        }
    }

    /// The tangent from the locked outline's centre to the free base circle, the free gear turned by `gap`.
    fn tangent_line(&self, gap: f64) -> Option<Line> {
        Line::new(self.between(gap).0, self.problem.free.shape.base)
    }

    fn roll_on(&self, line: &Line) -> f64 {
        (line.length - self.problem.locked.shape.tip_radius) * self.problem.per_free_base
    }

    fn is_on_involute(&self, roll: f64) -> bool {
        let free_shape = &self.problem.free.shape;
        roll >= free_shape.form_roll && roll <= free_shape.tip_roll
    }

    /// `None` where the line does not settle: the base circle reaches the land's centre.
    fn tangent(&self, step: i64, start: &Line, eccentric: bool) -> Option<Tangent> {
        let problem = self.problem;
        let base = problem.free.shape.base;
        let own = self.pair(step).free_base;
        let gap_on = |line: &Line| line.angle - self.roll_on(line) - own;
        let mut gap = gap_on(start);
        let mut line = *start;
        if eccentric {
            let mut settled = false;
            // Two or three steps: |dG/dμ| ≤ e/r_b < 1. What one leaves is of its square.
            for _ in 0..60 {
                let (between, rate) = self.between(gap);
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
        let along = C::new(base, line.length) / line.between.norm_sqr();
        // The involute's normal is −iE, the land's the opposite.
        let e = line.between * along;
        Some(Tangent {
            gap,
            roll: self.roll_on(&line),
            normal: C::new(-e.im, e.re),
        })
    }
}
