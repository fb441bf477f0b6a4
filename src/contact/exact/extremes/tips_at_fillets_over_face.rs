//! The room of tip corners and fillets of helical gears over their common face and a stretch of a mating.
//!
//! Between the ends of the face a corner touches tightest where the fillet's normal passes through the pitch point
//! ([`super::super::deepest`]). Let `G` be the free gear's further turn from the contact of the involutes to that touch. It depends only on
//! the distance `d` of the centres, and
//!
//! ```text
//! dG/dd = −sin α/r_bF + cot ω/r_wF,    r_wF = d r_bF/Σ,
//! ```
//!
//! from the changes of the contact on the line of action and of a contact with a normal at `ω` from the line of centres. Otherwise the
//! tightest touch is at an end of the face, in a section like any other.

use super::super::deepest::deepest;
use super::super::line::Line;
use super::super::path::InvolutePair;
use super::super::placed::Role;
use super::super::shape::{C, HalfToothShape};
use super::super::teeth::reduced;
use super::mesh_cycle::PosedSide;
use super::tip_at_fillet::TipAtFillet;

/// Rounds in which the free gear's own eccentricity converges: each leaves at most a hundredth.
const ROUNDS: usize = 6;

/// The touch between the ends of the face, at one end of a stretch.
#[derive(Debug, Clone, Copy)]
pub(super) struct InnerTouch {
    /// Angle of the locked half tooth there relative to the measuring plane, rad.
    pub turn: f64,
    /// The gap of the touch.
    pub gap: f64,
    pub distance: f64,
    /// `|dG/dd|` and a bound of its change with `d`.
    pub slope: f64,
    pub bend: f64,
}

/// The touch of `tip` at `step` for the centres of a pose, searched near the involutes' gap `near`, if there is one; `None` if that is
/// unknown, or there are several.
pub(super) fn inner_touch(
    posed: &PosedSide,
    step: i64,
    tip: &TipAtFillet,
    near: f64,
) -> Option<Option<InnerTouch>> {
    let flanks = &posed.flanks;
    let problem = flanks.problem;
    let (locked, free) = (&problem.locked.shape, &problem.free.shape);
    let (fillet, owner) = match tip.owner {
        Role::Free => (locked, free),
        Role::Locked => (free, locked),
    };
    // Without a tip radius of the tool nothing bounds the curvature of the fillet.
    if !(fillet.round > 0.0) {
        return None;
    }
    let pair = InvolutePair::new(flanks, step);
    let mut gap = near;
    let mut last = None;
    for _ in 0..ROUNDS {
        let (centres, _) = flanks.centre_vector(gap);
        let distance = centres.norm();
        let line = Line::new(centres, problem.sum())?;
        let on_line = pair.gap_on(problem, &line);
        let Some((at, farther, lean)) =
            touch((locked, free), (fillet, owner), tip.owner, distance)?
        else {
            return Some(None);
        };
        let settled = gap == on_line - farther;
        gap = on_line - farther;
        let alpha = (problem.sum() / distance).acos();
        let arm = distance * free.base / problem.sum() * lean.sin();
        let slope = -alpha.sin() * problem.per_free_base + lean.cos() / arm;
        // In the measuring plane it is at `λ − arg B`.
        let here = pair.locked_base + locked.half_base - centres.arg();
        last = Some(InnerTouch {
            turn: reduced(at - here),
            gap,
            distance,
            slope: slope.abs(),
            // The fillet's radius of curvature is at least half of the tool's tip radius at any helix angle; this takes four times that
            // curvature.
            bend: 8.0 / (fillet.round * arm.abs()) + tip.bend(distance),
        });
        if settled {
            break;
        }
    }
    Some(last)
}

/// The touch of undisturbed teeth `distance` apart: the angle of the locked half tooth, the free gear's further turn, and the angle of the
/// normal. `None` if there are several.
fn touch(
    (locked, free): (&HalfToothShape, &HalfToothShape),
    (fillet, owner): (&HalfToothShape, &HalfToothShape),
    whose: Role,
    distance: f64,
) -> Option<Option<(f64, f64, f64)>> {
    let corner = owner.corners()[0].1;
    let mut found = deepest(fillet, distance, owner.base, corner.norm());
    let Some(touch) = found.next() else {
        return Some(None);
    };
    if found.next().is_some() {
        return None;
    }
    // The fillet's centre at 0 and the edge's on +x: turned by half a turn if the fillet belongs to the locked gear.
    let edge = (touch.point - C::from(distance)).arg() - corner.arg();
    let (at, gap) = match whose {
        Role::Free => (touch.tooth, edge + std::f64::consts::PI),
        Role::Locked => (edge + std::f64::consts::PI, touch.tooth),
    };
    let at = reduced(at);
    let sum = locked.base + free.base;
    let line = Line::new(C::from(distance), sum)?;
    let on_line = (sum * line.angle - line.length - locked.base * (at - locked.half_base))
        / free.base
        + free.half_base;
    Some(Some((at, reduced(on_line - gap), touch.lean)))
}
