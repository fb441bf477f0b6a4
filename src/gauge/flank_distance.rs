//! The distance of a point of the measuring plane from a flank.
//!
//! The sections of a helical flank turn by `t` per mm along the face. In the section `b` the point `p(b)` is nearest to
//! a point `c`, at the distance `d(b)`. The distance of the flank is the least `D = √(d² + b²)`. Turning moves `p` by
//! `t ẑ × p`, so `(D²)'/2 = b − t (c − p)·(ẑ × p)`. Along an involute this is linear in `b`, because its arm `n·(ẑ ×
//! p)` is the base radius. The gradient of `D` within the plane is `(c − p)/D`.

use super::workpiece::{Place, Workpiece};
use crate::gear::Side;
use nalgebra::{Point2, UnitComplex, Vector2};

/// Sections on each side of the measuring plane that are compared before the search for the nearest. For an involute one would suffice.
const SECTIONS: i32 = 3;
/// Limit of steps towards the nearest section: alternately false position and halving.
const MOST_STEPS: usize = 60;
/// Accuracy of the section, in parts of √(bound · distance): its square enters the distance.
const SECTION: f64 = 0.1;

/// One flank of a tooth: its side, tooth and rotation in the measuring plane, in the frame of the point.
#[derive(Debug, Clone, Copy)]
pub(super) struct OneFlank {
    pub side: Side,
    pub tooth: u32,
    pub turn: UnitComplex<f64>,
}

/// The nearest point of a flank.
#[derive(Debug, Clone, Copy)]
pub(super) struct Nearest {
    /// Place in the frame of the half tooth.
    pub place: Place,
    /// Position of its section from the measuring plane, mm.
    pub section: f64,
    /// Distance, mm.
    pub distance: f64,
    /// Gradient of the distance within the measuring plane.
    pub gradient: Vector2<f64>,
}

/// The point of `flank` that is nearest to `point` of the measuring plane.
pub(super) fn nearest(work: &Workpiece, flank: &OneFlank, point: Point2<f64>) -> Nearest {
    let twist = work.as_built.gear().basic_data().twist();
    // Also returns half the slope of D² along the face.
    let in_section = |b: f64| {
        let turn = if b == 0.0 {
            flank.turn
        } else {
            UnitComplex::new(twist * b) * flank.turn
        };
        let (place, within) = work.nearest(flank.side, flank.tooth, turn.inverse() * point);
        let foot = turn * place.at;
        let away = point - foot;
        let distance = if b == 0.0 { within } else { within.hypot(b) };
        let nearest = Nearest {
            place,
            section: b,
            distance,
            gradient: away / distance,
        };
        let turning = Vector2::new(-foot.y, foot.x);
        (nearest, b - twist * away.dot(&turning))
    };
    let plane = in_section(0.0);
    if twist == 0.0 {
        return plane.0;
    }
    // Points further along the face are not nearer than the one in the plane.
    let apart = plane.0.distance / f64::from(SECTIONS);
    let others = (-SECTIONS..=SECTIONS).filter(|&step| step != 0);
    let others = others.map(|step| in_section(f64::from(step) * apart));
    let mut best = others.fold(plane, |best, one| {
        if one.0.distance < best.0.distance {
            one
        } else {
            best
        }
    });
    let close = SECTION * (work.bound() * best.0.distance).sqrt();
    let at = |best: &(Nearest, f64)| (best.0.section, best.1);
    // The distance falls towards the nearest point from both ends.
    let [mut low, mut high] =
        [-apart, apart].map(|beyond| at(&in_section(best.0.section + beyond)));
    for step in 0..MOST_STEPS {
        let middle = 0.5 * (low.0 + high.0);
        let zero = (low.0 * high.1 - high.0 * low.1) / (high.1 - low.1);
        let guess = if step % 3 < 2 && zero > low.0 && zero < high.0 {
            zero
        } else {
            middle
        };
        let moved = (guess - best.0.section).abs();
        let there = in_section(guess);
        if there.1 < 0.0 {
            low = at(&there)
        } else {
            high = at(&there)
        }
        if there.0.distance <= best.0.distance {
            best = there;
        }
        if moved <= close || high.0 - low.0 <= close {
            break;
        }
    }
    best.0
}
