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
    /// The point from the centre of each outline.
    from_axes: [C; 2],
    /// Leans of both toothings, and the normal out of the locked flank.
    leans: [C; 2],
    normal: C,
    /// The gear whose corner touches; `None` on the line of action.
    corner: Option<usize>,
}

impl LeaningTouch {
    /// Heights along each gear's own axis, mm, in the section at 0, and their rates along the face, mm per mm. The touch is in the section at `b`,
    /// mm, and `rates` are its [`LeaningFrame::rates`].
    pub fn heights_along(&self, b: f64, rates: [[f64; 2]; 2]) -> [[f64; 2]; 2] {
        [0, 1].map(|k| {
            let rate = 1.0 + rates[k][0];
            [self.heights[k] + b * (1.0 - rate), rate]
        })
    }
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
        let corner = [0, 1].into_iter().find(|&k| on[k] != rolls[k]);
        // On the line of action either gear has the point.
        let k = corner.unwrap_or(0);
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
            from_axes: centres.map(|centre| point - centre),
            leans,
            normal,
            corner,
        };
        for k in [0, 1] {
            let (lean, from_axis) = (leans[k], touch.from_axes[k]);
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

    /// Turns of the flanks by twist up to the heights of a pair with these rolls on the line of action `found`, to first order, rad.
    pub fn turns_on_line(
        &self,
        rolls: [f64; 2],
        found: &Separation,
        start: &NearStart,
    ) -> [f64; 2] {
        let leans = self.leans(found.gap_turned(start));
        let direction = found.direction_turned(start, 0.0);
        [0, 1].map(|k| {
            let outward = if k == 0 { -direction } else { direction };
            let from_axis = outward * C::new(1.0, -rolls[k]) * found.bases()[k];
            self.twists[k] * dot(leans[k], from_axis)
        })
    }

    /// Rates of [`LeaningTouch::heights`] and [`LeaningTouch::turns`] along the face. `turning` has the rates at which both teeth turn about
    /// their centres, the free gear's rotation included, rad per mm. The free toothing's lean is taken as constant: it turns with the gap.
    pub fn rates(
        &self,
        found: &Separation,
        start: &NearStart,
        touch: &LeaningTouch,
        turning: [f64; 2],
    ) -> [[f64; 2]; 2] {
        let moves = self.moves(found.gap_turned(start));
        let k = touch.corner.unwrap_or(0);
        let own = match touch.corner {
            Some(_) => C::i() * turning[k] * touch.from_axes[k],
            None => {
                // The line turns with the centres, and its point moves along it by the locked tooth's turn.
                let line = found.line_turning(start, moves);
                let outward = -found.direction_turned(start, 0.0);
                let base = found.bases()[0];
                C::i() * (line * touch.from_axes[0] - outward * (base * (line - turning[0])))
            }
        };
        let other = if k == 0 { own + moves } else { own - moves };
        let rates = if k == 0 { [own, other] } else { [other, own] };
        [0, 1].map(|k| {
            let lean = touch.leans[k];
            let square = lean.norm_sqr();
            let root = (1.0 + square).sqrt();
            let along = dot(lean, rates[k]);
            let height = (root - 1.0) + along / root;
            let outward = if k == 0 { touch.normal } else { -touch.normal };
            let stretch = along * dot(outward, lean) / (root * (root + 1.0));
            [height, height * self.twists[k] - stretch / found.bases()[k]]
        })
    }
}
