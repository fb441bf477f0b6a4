//! A gear of the pair at its position, and the frames of its half teeth.

use super::POINTS;
use super::half::{Ends, Half};
use gearlash::gear::Side;
use gearlash::pair::{GearPair, Member};
use std::rc::Rc;

/// One gear of the pair and the direction of its tooth 1.
pub(super) struct Stood<'a> {
    pub(super) assembly: &'a GearPair,
    pub(super) member: Member,
    /// Without a profile deviation.
    pub(super) half: Rc<Half>,
}

impl<'a> Stood<'a> {
    pub(super) fn new(assembly: &'a GearPair, member: Member) -> Stood<'a> {
        Stood {
            assembly,
            member,
            half: Rc::new(Half::new(assembly.gear(member).gear())),
        }
    }

    /// The half tooth on a side of a tooth.
    pub(super) fn half(&self, side: Side, tooth: u32) -> Rc<Half> {
        let gear = self.assembly.gear(self.member);
        match gear.modification(side, tooth) {
            None => Rc::clone(&self.half),
            Some(deviation) => Rc::new(Half::new(gear.gear()).deviating(deviation)),
        }
    }

    /// Frame of a half tooth, the gear turned to `rotation`.
    pub(super) fn frame(&self, rotation: f64, side: Side, tooth: u32) -> Frame {
        let gear = self.assembly.gear(self.member);
        let tooth_1 = self.assembly.mate_direction(self.member) + rotation;
        let centre = self.assembly.axis(self.member) + gear.displacement(tooth_1);
        let turn = tooth_1 + gear.tooth_angle(f64::from(tooth)) + gear.flank_offset(side, tooth);
        let (sin, cos) = turn.sin_cos();
        Frame {
            centre: [centre.x, centre.y],
            cos,
            sin,
            mirror: -side.sense(),
        }
    }

    /// A circle about a half tooth in its frame: half way up the centre line, and the distance of its furthest point.
    pub(super) fn circle(&self, half: &Half, ends: Ends) -> (f64, f64) {
        let middle = 0.5 * (self.half.root + self.half.tip);
        let points = (0..=4 * POINTS).map(|k| {
            let t = k as f64 / POINTS as f64;
            let [x, y] = half.along(t, ends);
            (x - middle).hypot(y)
        });
        // Between points of a convex curve the distance is slightly greater.
        (middle, 1.01 * points.fold(0.0, f64::max))
    }

    pub(super) fn ends(&self, side: Side, tooth: u32) -> Ends {
        let other = self.half(side.other(), tooth);
        Ends::new(&other, self.assembly.gear(self.member), side, tooth)
    }
}

#[derive(Clone, Copy)]
pub(super) struct Frame {
    pub(super) centre: [f64; 2],
    pub(super) cos: f64,
    pub(super) sin: f64,
    pub(super) mirror: f64,
}

impl Frame {
    pub(super) fn out(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let y = y * self.mirror;
        [
            self.centre[0] + self.cos * x - self.sin * y,
            self.centre[1] + self.sin * x + self.cos * y,
        ]
    }

    pub(super) fn seen(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let (x, y) = (x - self.centre[0], y - self.centre[1]);
        [
            self.cos * x + self.sin * y,
            self.mirror * (self.cos * y - self.sin * x),
        ]
    }
}
