//! Teeth of leaning axes in the frame of a pose: centres, leans, and turns of flanks along the face.
//!
//! [`crate::pair::section_at`] derives the section of a leaning gear. Here its centres and the turns of its flanks are functions of the
//! place along the face. The search of the tightest place uses them, and so do the bounds of extremes.

use super::flank_problem::PosedFlanks;
use super::separation::{NearStart, Separation};
use super::shape::C;
use crate::contact::gap::dot;
use crate::pair::{GearPair, Member};

/// Leans in the frame of a pose, mm per mm.
#[derive(Debug, Clone, Copy)]
pub(super) struct LeaningFrame {
    /// Move of the locked outline's centre, relative to the free axis.
    locked_centre: C,
    /// Move of the free outline's centre at gap 0.
    free_centre: C,
    /// Lean of the locked toothing, and of the free shaft.
    locked: C,
    free_shaft: C,
    /// Twist of the locked and of the free gear, rad/mm.
    twists: [f64; 2],
}

/// A flank of each gear that touch in a section of leaning axes, locked and free.
#[derive(Debug, Clone, Copy)]
pub(super) struct LeaningTouch {
    /// Heights of the point over the section, mm, along each gear's own axis.
    pub heights: [f64; 2],
    /// Turns of the flanks by twist up to these heights and by the stretch of the section, rad. Leads are not in them.
    pub turns: [f64; 2],
}

impl LeaningFrame {
    /// `None` where axes are parallel.
    pub fn new(assembly: &GearPair, posed: &PosedFlanks) -> Option<LeaningFrame> {
        if !assembly.leans() {
            return None;
        }
        let mirror = posed.mirror();
        let [x, y] = assembly.lean();
        let axes = C::new(x, mirror * y);
        let members = [assembly.locked(), assembly.free()];
        let own = members.map(|member| {
            let lean = assembly.gear(member).lean(0.0);
            C::new(lean.x, mirror * lean.y)
        });
        // At rotation 0 tooth 1 is on +x in `lean` and in this frame.
        let locked = -posed.turned * own[0];
        // The picture is turned by half a turn where the pinion is free.
        let (shaft, free_shaft) = match assembly.free() {
            Member::Wheel => (axes, C::ZERO),
            Member::Pinion => (C::ZERO, -axes),
        };
        Some(LeaningFrame {
            locked_centre: axes + locked,
            free_centre: own[1] * posed.origin.conj(),
            locked: shaft + locked,
            free_shaft,
            twists: members.map(|member| posed.twist(assembly, member)),
        })
    }

    /// Leans of the locked and of the free toothing; `turned` is `e^{iμ}` of the gap.
    pub fn leans(&self, turned: C) -> [C; 2] {
        [self.locked, self.free_shaft + self.free_centre * turned]
    }

    /// The teeth of `posed` with the centres of the section at `b`, mm.
    pub fn at<'a>(&self, posed: &PosedFlanks<'a>, b: f64) -> PosedFlanks<'a> {
        let mut here = *posed;
        here.centre += self.locked_centre * b;
        here.free_centre += self.free_centre * b;
        here
    }

    /// The teeth of `posed` with the centres of the section at `b`, mm, the gap of the pair of `step` there, and its touch from which heights
    /// count. The teeth are turned by `turns`, rad, without the heights, and touch near `start`. `None` where they do not face each other.
    pub fn undisturbed<'a>(
        &self,
        posed: &PosedFlanks<'a>,
        (step, b): (i64, f64),
        turns: [f64; 2],
        start: &NearStart,
    ) -> Option<(PosedFlanks<'a>, Separation, LeaningTouch)> {
        let here = self.at(posed, b);
        let found = Separation::near(&here, step, turns, start);
        found
            .touches
            .then(|| (here, found, self.touch(b, &here, &found, start)))
    }

    /// Rate of the room `s` of a touch by the moves of both centres, mm per mm along the face.
    pub fn rate(&self, found: &Separation, start: &NearStart) -> f64 {
        let moves = self.moves(found.gap_turned(start));
        (found.direction_turned(start, 0.0) * moves.conj()).im
    }

    /// Move of the locked centre against the free one, mm per mm along the face; `turned` is `e^{iμ}` of the gap.
    pub fn moves(&self, turned: C) -> C {
        self.locked_centre - self.free_centre * turned
    }

    /// The teeth of a section at `b`, mm, `here` with its centres, that touch as `found` says.
    pub fn touch(
        &self,
        b: f64,
        here: &PosedFlanks,
        found: &Separation,
        start: &NearStart,
    ) -> LeaningTouch {
        let problem = here.problem;
        let bases = [problem.locked.shape.base, problem.free.shape.base];
        let turned = found.gap_turned(start);
        let centres = [here.centre, here.free_centre * turned];
        let (rolls, on) = (found.rolls(), found.rolls_on_arcs());
        // The gear whose corner touches; on the line of action either has the point.
        let k = usize::from(on[0] == rolls[0] && on[1] != rolls[1]);
        // E = ∓e^{iβ}, turned back to the corner's own tangent: P = C + r_b E (1 − iξ).
        let sign = if k == 0 { -1.0 } else { 1.0 };
        let e = sign * found.direction_turned(start, on[k] - rolls[k]);
        let point = centres[k] + e * C::new(1.0, -on[k]) * bases[k];
        let e = -found.direction_turned(start, 0.0);
        let normal = C::new(e.im, -e.re);
        let leans = self.leans(turned);
        let mut touch = LeaningTouch {
            heights: [0.0; 2],
            turns: [0.0; 2],
        };
        for k in [0, 1] {
            let (lean, from_axis) = (leans[k], point - centres[k]);
            let square = lean.norm_sqr();
            let root = (1.0 + square).sqrt();
            let along = dot(lean, from_axis);
            let height = b * (root - 1.0) + along / root;
            touch.heights[k] = height;
            if square != 0.0 {
                let outward = if k == 0 { normal } else { -normal };
                let stretch = (1.0 - 1.0 / root) / square * along * dot(outward, lean);
                touch.turns[k] = height * self.twists[k] - stretch / bases[k];
            }
        }
        touch
    }
}
