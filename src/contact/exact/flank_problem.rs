//! One side of a pair: which half teeth face each other, and their positions at a pose.
//!
//! The origin of the frame is on the free gear's axis, and the locked gear's axis is at `(a, 0)`. If the pinion is free, the picture is
//! turned by half a turn. The left side is mirrored in the line of centres. So there is only one problem: right-hand halves on both gears,
//! with contact where the free gear can turn no further clockwise, at the *greatest* gap.
//!
//! *Steps* count places counter-clockwise from the locked tooth nearest to the line of centres. The free tooth that
//! faces it is as many steps clockwise of its own.

use super::placed::PlacedHalf;
use super::shape::{C, turn};
use super::teeth::{Teeth, nearest, reduced};
use crate::contact::gap::{Origin, rounding};
use crate::gear::{AsBuilt, Side};
use crate::pair::{FacingTeeth, GearPair, Member, Pose, overlap_half_angle};
use std::f64::consts::PI;
use std::ops::Range;
use std::sync::Arc;

/// Difference of gaps at the free gear's base circle, mm, below which pairs touch together.
///
/// It is a thousand times the rounding of ordinary gears, and below the accuracy of any result.
const TIE_MM: f64 = 1e-9;

/// The half teeth of both gears on one side.
#[derive(Debug, Clone)]
pub(in crate::contact) struct FlankProblem {
    pub side: Side,
    pub locked: Arc<Teeth>,
    pub free: Arc<Teeth>,
    /// Displacements of the outlines' centres from their axes at rotation 0 (tooth 1 on +x).
    pub locked_off: C,
    pub free_off: C,
    /// `a`.
    pub distance: f64,
    /// Directions of the undisturbed centre line, about the line of centres, of locked half teeth that can reach the mate; `None` if none can.
    pub window: Option<(f64, f64)>,
    /// `1/r_bF` and `1/r_bL`.
    pub per_free_base: f64,
    pub per_locked_base: f64,
    /// Pitches of the locked gear per radian.
    pub per_pitch: f64,
    /// `κ = (r_bL/r_bF) τ_L − τ_F`: additional room on the line of action of a pair one step on, rad. It is 0 for equal base pitches.
    pub per_step: f64,
    /// Tie tolerance, rad.
    pub tie: f64,
    /// The operating pitch point.
    pub pitch_point: C,
}

impl FlankProblem {
    pub fn new(assembly: &GearPair, side: Side) -> FlankProblem {
        let teeth = |member| Arc::new(Teeth::new(assembly.gear(member), side));
        let teeth = (teeth(assembly.locked()), teeth(assembly.free()));
        FlankProblem::of(assembly, side, teeth)
    }

    /// The problem of these gears in another `assembly` with these teeth.
    pub fn at(&self, assembly: &GearPair) -> FlankProblem {
        let teeth = (Arc::clone(&self.locked), Arc::clone(&self.free));
        FlankProblem::of(assembly, self.side, teeth)
    }

    /// The problem in another section, `pair`, of the pair whose measuring plane this is. Its eccentricities have turned, and leads have
    /// turned its flanks.
    pub fn turned(&self, pair: &GearPair) -> FlankProblem {
        let teeth = |teeth: &Arc<Teeth>, gear: &AsBuilt| {
            if gear.has_leads() {
                Arc::new(Teeth::new(gear, self.side))
            } else {
                Arc::clone(teeth)
            }
        };
        let (locked, free) = (pair.gear(pair.locked()), pair.gear(pair.free()));
        if pair.has_leads() {
            let teeth = (teeth(&self.locked, locked), teeth(&self.free, free));
            return FlankProblem::of(pair, self.side, teeth);
        }
        FlankProblem {
            locked_off: displacement(locked, self.side),
            free_off: displacement(free, self.side),
            ..self.clone()
        }
    }

    /// The problem in a section with these teeth, a centre distance, mm, and displacements of both outlines at rotation 0. The window stays:
    /// it is that of all sections.
    pub fn in_section(
        &self,
        distance: f64,
        (locked_off, free_off): (C, C),
        (locked, free): (Arc<Teeth>, Arc<Teeth>),
    ) -> FlankProblem {
        let mut problem = FlankProblem {
            window: self.window.map(|(low, high)| {
                (
                    low + self.locked.farthest - locked.farthest,
                    high + locked.deepest - self.locked.deepest,
                )
            }),
            locked,
            free,
            locked_off,
            free_off,
            distance,
            pitch_point: self.pitch_point * (distance / self.distance),
            ..*self
        };
        problem.tie = problem.tie_at(distance);
        problem
    }

    /// Greatest change of a room by the gap, mm, off the line of action.
    pub fn most_turning(&self) -> f64 {
        let low = self.free.shape.lowest_roll();
        self.free.shape.base * (1.0 + low * low).sqrt() + self.free_off.norm()
    }

    /// This problem with all teeth that can reach the mate in any section, where axes lean.
    pub fn over_leans(&self, assembly: &GearPair) -> FlankProblem {
        let [locked, free] =
            [assembly.locked(), assembly.free()].map(|member| assembly.gear(member));
        // The nearest centres have the widest lens.
        let shift = assembly.shift_bound();
        let nearest = self.distance - 2.0 * shift;
        let more = 2.0 * shift / (nearest - free.reach());
        FlankProblem {
            window: window_half(locked, free, nearest).map(|half| {
                (
                    -half - more - self.locked.farthest,
                    half + more + self.locked.deepest,
                )
            }),
            ..self.clone()
        }
    }

    fn of(assembly: &GearPair, side: Side, teeth: (Arc<Teeth>, Arc<Teeth>)) -> FlankProblem {
        let [locked, free] =
            [assembly.locked(), assembly.free()].map(|member| assembly.gear(member));
        let mut problem = FlankProblem {
            side,
            locked: teeth.0,
            free: teeth.1,
            locked_off: displacement(locked, side),
            free_off: displacement(free, side),
            distance: assembly.center_distance(),
            window: None,
            per_free_base: 1.0 / free.gear().base_radius(),
            per_locked_base: 1.0 / locked.gear().base_radius(),
            per_pitch: 1.0 / locked.gear().basic_data().angular_pitch(),
            per_step: 0.0,
            tie: 0.0,
            pitch_point: C::from(assembly.operating_pitch_radius(assembly.free())),
        };
        if assembly.base_pitches_differ() {
            let ratio = problem.locked.shape.base * problem.per_free_base;
            problem.per_step = ratio * problem.locked.pitch - problem.free.pitch;
        }
        problem.tie = problem.tie_at(problem.distance);
        problem.window = window_half(locked, free, problem.distance).map(|half| {
            (
                -half - problem.locked.farthest,
                half + problem.locked.deepest,
            )
        });
        problem
    }

    /// Places the teeth at `pose`. `rotation` is the reduced rotation of the locked gear and `turned` is `e^{i
    /// rotation}`, both counted as in the picture.
    #[inline]
    pub fn posed(
        &self,
        pose: &Pose,
        teeth: (u32, u32),
        rotation: f64,
        turned: C,
    ) -> PosedFlanks<'_> {
        let (mirror, turned) = match self.side {
            Side::Right => (1.0, turned),
            Side::Left => (-1.0, turned.conj()),
        };
        // Whole turns matter: each turn a free gear with another number of teeth faces it with another tooth. The raw rotation counts them.
        let pitches = mirror * pose.locked_rotation() * self.per_pitch;
        let steps = -nearest(pitches + self.locked.pitches_to(teeth.0));
        let locked_place = self.locked.place(teeth.0, steps);
        // The facing place in the mirrored frame: see `Pose::facing_tooth`.
        let beyond = i64::from(pose.mating().flank != self.side);
        let free_place = self.free.place(teeth.1, beyond - steps);
        let free = self.free.half(free_place);
        let origin = free.direction;
        PosedFlanks {
            problem: self,
            turned,
            centre: C::from(self.distance) - turned * self.locked_off,
            ahead: reduced(mirror * rotation + self.locked.angle(locked_place)),
            onward: steps,
            locked_place,
            free_place,
            origin,
            free_offset: free.offset,
            free_centre: self.free_off * origin.conj(),
        }
    }

    /// `Σ`, the sum of the base radii.
    pub fn sum(&self) -> f64 {
        self.locked.shape.base + self.free.shape.base
    }

    /// Greatest difference that unequal base pitches make between the gaps of step 0 and of any step in reach, rad.
    pub fn all_steps(&self) -> f64 {
        match self.window {
            Some((low, high)) if self.per_step != 0.0 => {
                self.per_step.abs() * (low.abs().max(high.abs()) * self.per_pitch + 1.0)
            }
            _ => 0.0,
        }
    }

    /// Bound on the rounding of a gap, rad, with its contact at `radius` from the free axis and curves of the slope `σ`.
    pub fn rounding(&self, radius: f64, slope: f64) -> f64 {
        self.rounding_at(self.distance, radius, slope)
    }

    /// The tie tolerance at a centre distance.
    pub fn tie_at(&self, distance: f64) -> f64 {
        let base = self.free.shape.base;
        TIE_MM / base + 2.0 * self.rounding_at(distance, base, 1.0)
    }

    fn rounding_at(&self, distance: f64, radius: f64, slope: f64) -> f64 {
        let size = distance + self.locked.shape.tip_radius + self.free.shape.tip_radius;
        rounding(size, radius, slope)
    }
}

/// Displacement of a gear's outline from its axis at rotation 0, mirrored on the left side.
fn displacement(gear: &AsBuilt, side: Side) -> C {
    turn(-side.sense() * gear.tooth_angle(gear.high_tooth())) * gear.eccentricity()
}

/// Half the angle at the locked axis within which the locked gear's teeth can reach into the free gear's tip circle,
/// both about their rotation axes; `None` if they cannot.
fn window_half(locked: &AsBuilt, free: &AsBuilt, distance: f64) -> Option<f64> {
    let half = overlap_half_angle(locked.reach(), free.reach(), distance)?;
    // The nearest point of the free gear's circle; the rest of the lens is further out.
    let nearest = distance - free.reach();
    if nearest <= locked.eccentricity() {
        return Some(PI);
    }
    Some(half + (locked.eccentricity() / nearest).asin())
}

/// The half teeth of one side at one pose.
#[derive(Debug, Clone, Copy)]
pub(in crate::contact) struct PosedFlanks<'a> {
    pub problem: &'a FlankProblem,
    /// Rotation of the locked gear.
    pub turned: C,
    /// Centre of the locked outline.
    pub centre: C,
    /// Angle of the locked tooth of step 0 from the line of centres, rad.
    pub ahead: f64,
    /// Steps from the mating's locked tooth to that of step 0.
    pub onward: i64,
    locked_place: usize,
    free_place: usize,
    /// Direction of the free half tooth of step 0 at rotation 0, from which gaps count, and its offset.
    pub origin: C,
    pub free_offset: f64,
    /// Centre of the free outline at gap 0.
    pub free_centre: C,
}

impl<'a> PosedFlanks<'a> {
    /// Steps whose locked half tooth can reach the free gear; empty when none can.
    #[inline]
    pub fn steps(&self) -> Range<i64> {
        let Some((low, high)) = self.problem.window else {
            return 0..0;
        };
        let per_pitch = self.problem.per_pitch;
        // At most one revolution: a pair met twice would touch a turn later. The cast rounds towards zero: at worst one tooth too many.
        let count = self.problem.locked.count();
        let first = ((low - self.ahead) * per_pitch) as i64;
        let last = ((high - self.ahead) * per_pitch) as i64;
        first.max(-((count - 1) / 2))..last.min(count / 2) + 1
    }

    /// Steps whose locked tooth can reach the free gear: [`PosedFlanks::steps`], and the one before, whose far half can.
    pub fn steps_of_whole_teeth(&self) -> Range<i64> {
        let steps = self.steps();
        if self.problem.window.is_none() {
            return steps;
        }
        let least = -((self.problem.locked.count() - 1) / 2);
        (steps.start - 1).max(least)..steps.end
    }

    /// Steps whose locked half tooth can reach the free gear in some section, where sections turn the locked teeth by angles between `turns`,
    /// rad.
    pub fn steps_over(&self, turns: [f64; 2]) -> Range<i64> {
        let [least, most] = [turns[0].min(turns[1]), turns[0].max(turns[1])];
        let plane = self.steps();
        if plane.is_empty() {
            return plane;
        }
        let per_pitch = self.problem.per_pitch;
        let first = plane.start - (most.max(0.0) * per_pitch).ceil() as i64;
        first..plane.end - (least.min(0.0) * per_pitch).floor() as i64
    }

    /// Twist of a gear's teeth in this frame, rad per mm along the axis.
    pub fn twist(&self, assembly: &GearPair, member: Member) -> f64 {
        self.mirror() * assembly.gear(member).gear().basic_data().twist()
    }

    /// The locked and the free tooth of a step, which are those of `assembly`.
    pub fn facing_teeth<'b>(&self, assembly: &'b GearPair, step: i64) -> FacingTeeth<'b> {
        let [locked, free] = self.numbers(step);
        let teeth = [
            (assembly.gear(assembly.locked()), locked),
            (assembly.gear(assembly.free()), free),
        ];
        FacingTeeth::new(self.problem.side, teeth)
    }

    /// These teeth at the same steps, with the locked gear turned further by `angle`, rad, in this (mirrored) frame.
    pub fn turned_on(&self, angle: f64) -> PosedFlanks<'a> {
        let turned = self.turned * turn(angle);
        PosedFlanks {
            turned,
            centre: C::from(self.problem.distance) - turned * self.problem.locked_off,
            ahead: self.ahead + angle,
            ..*self
        }
    }

    /// These places for the teeth of `problem`, which differ only in their offsets and centres.
    pub fn of<'b>(&self, problem: &'b FlankProblem) -> PosedFlanks<'b> {
        let free = problem.free.half(self.free_place);
        let origin = free.direction;
        PosedFlanks {
            problem,
            origin,
            free_offset: free.offset,
            free_centre: problem.free_off * origin.conj(),
            turned: self.turned,
            centre: C::from(problem.distance) - self.turned * problem.locked_off,
            ahead: self.ahead,
            onward: self.onward,
            locked_place: self.locked_place,
            free_place: self.free_place,
        }
    }

    /// Places of the locked and the free tooth of a step.
    #[inline]
    pub fn places(&self, step: i64) -> (usize, usize) {
        (
            self.problem.locked.beside(self.locked_place, step),
            self.problem.free.beside(self.free_place, -step),
        )
    }

    /// Numbers of the locked and the free tooth of a step.
    pub fn numbers(&self, step: i64) -> [u32; 2] {
        let (locked, free) = self.places(step);
        [
            self.problem.locked.number(locked),
            self.problem.free.number(free),
        ]
    }

    /// The locked half tooth of a step.
    pub fn locked(&self, step: i64) -> PlacedHalf<'a> {
        let teeth = &self.problem.locked;
        let half = teeth.placed(teeth.beside(self.locked_place, step), self.centre);
        PlacedHalf {
            direction: -self.turned * half.direction,
            ..half
        }
    }

    /// The free half tooth of a step, at rotation 0.
    pub fn free(&self, step: i64) -> PlacedHalf<'a> {
        let teeth = &self.problem.free;
        teeth.placed(teeth.beside(self.free_place, -step), self.problem.free_off)
    }

    /// Directions of the locked and the free half tooth of a step, the free gear at rotation 0, rad; within ±π.
    #[inline]
    pub fn angles(&self, step: i64) -> [f64; 2] {
        let (locked_place, free_place) = self.places(step);
        let (locked, free) = (&self.problem.locked, &self.problem.free);
        let ahead = self.ahead + step as f64 * locked.pitch + locked.half(locked_place).offset;
        let free = free.angle(free_place) + free.half(free_place).offset;
        [reduced(PI + ahead), reduced(free)]
    }

    /// The origin of a step's gaps: the direction of its free tooth, and the gap in pitches at which that faces the mate.
    #[inline]
    pub fn origin_of(&self, step: i64) -> Origin {
        Origin {
            direction: self.origin,
            about: step as f64 * self.problem.free.pitch,
        }
    }

    /// `B` of [`super::line`], from the free outline's centre to the locked one's, and its derivative by the gap, at the gap `mu`.
    #[inline]
    pub fn centre_vector(&self, mu: f64) -> (C, C) {
        self.centre_vector_turned(turn(mu))
    }

    /// As [`PosedFlanks::centre_vector`]; `turned` is `e^{iμ}`.
    #[inline]
    pub fn centre_vector_turned(&self, turned: C) -> (C, C) {
        let off = self.free_centre * turned;
        (self.centre - off, C::new(off.im, -off.re))
    }

    /// The centre of the free outline at a rotation of the free gear, in this (mirrored) frame.
    pub fn free_centre_at(&self, rotation: f64) -> C {
        turn(rotation) * self.problem.free_off
    }

    /// Angle of the free tooth of step 0 from tooth 1, rad.
    pub fn free_angle(&self) -> f64 {
        self.problem.free.angle(self.free_place)
    }

    /// Sign of counter-clockwise in this frame: −1 for the mirrored left side.
    pub fn mirror(&self) -> f64 {
        -self.problem.side.sense()
    }

    /// The free gear's rotation at a gap, in this (mirrored) frame.
    pub fn rotation(&self, gap: f64) -> f64 {
        gap - (self.free_angle() + self.free_offset)
    }
}
