//! Where every tooth's half on one side stands in the gear's own frame.
//!
//! The left side is stored mirrored, so that all that follows knows right-hand
//! halves only. *Places* count counter-clockwise from tooth 1, in the mirrored
//! frame too. A place takes 24 bytes.

use super::shape::{C, Shape, turn};
use crate::gear::{AsBuilt, Side};
use std::f64::consts::TAU;

/// One side of all teeth of a gear.
#[derive(Debug, Clone)]
pub(super) struct Teeth {
    pub shape: Shape,
    /// `τ`.
    pub pitch: f64,
    /// Sense in which tooth numbers ascend in this frame.
    ascending: i64,
    /// Rotation of each half from its undisturbed place, rad.
    offsets: Vec<f64>,
    /// Direction of each half tooth's centre line, offset included.
    directions: Vec<C>,
    /// Displacement of the outline's centre from the axis at rotation 0 (tooth 1 on +x).
    pub displacement: C,
    /// Least and greatest offset.
    pub extremes: (f64, f64),
}

impl Teeth {
    pub fn new(gear: &AsBuilt, side: Side) -> Teeth {
        let toothing = gear.gear().toothing();
        let pitch = toothing.angular_pitch();
        // Right stays, left is mirrored in the x axis: angles change sign.
        let mirror = -side.sense();
        let count = toothing.teeth();
        let ascending = (mirror * gear.face().ascending()) as i64;
        let mut teeth = Teeth {
            shape: Shape::new(gear.gear()),
            pitch,
            ascending,
            offsets: Vec::with_capacity(count as usize),
            directions: Vec::with_capacity(count as usize),
            displacement: turn(mirror * gear.tooth_angle(gear.high_tooth())) * gear.eccentricity(),
            extremes: (0.0, 0.0),
        };
        for place in 0..i64::from(count) {
            let tooth = (ascending * place).rem_euclid(i64::from(count)) as u32 + 1;
            let offset = mirror * gear.flank_offset(side, tooth);
            teeth.offsets.push(offset);
            teeth
                .directions
                .push(turn(centred(place, count) * pitch + offset));
        }
        teeth.extremes = teeth.offsets.iter().fold(
            (f64::INFINITY, f64::NEG_INFINITY),
            |(least, most), &offset| (least.min(offset), most.max(offset)),
        );
        teeth
    }

    /// `z`.
    pub fn count(&self) -> i64 {
        self.offsets.len() as i64
    }

    /// The place `steps` counter-clockwise of that of tooth number `tooth`.
    pub fn place(&self, tooth: u32, steps: i64) -> usize {
        let place = self.ascending * (i64::from(tooth) - 1) + steps;
        // Nearly always within a turn or two: a division is slower.
        let (mut place, count) = (place, self.count());
        if place.abs() > 4 * count {
            place %= count;
        }
        while place < 0 {
            place += count;
        }
        while place >= count {
            place -= count;
        }
        place as usize
    }

    /// Pitches from tooth 1 to `tooth`, counter-clockwise positive, whole turns kept.
    pub fn pitches_to(&self, tooth: u32) -> f64 {
        (self.ascending * (i64::from(tooth) - 1)) as f64
    }

    /// The place `steps` counter-clockwise of `place`, for a few steps: no division.
    pub fn beside(&self, place: usize, steps: i64) -> usize {
        let count = self.count();
        let mut there = place as i64 + steps;
        while there < 0 {
            there += count;
        }
        while there >= count {
            there -= count;
        }
        there as usize
    }

    /// The tooth number at a place.
    pub fn number(&self, place: usize) -> u32 {
        let steps = if self.ascending > 0 || place == 0 {
            place
        } else {
            self.offsets.len() - place
        };
        steps as u32 + 1
    }

    /// Angle of a place from tooth 1, in (−π, π].
    pub fn angle(&self, place: usize) -> f64 {
        centred(place as i64, self.offsets.len() as u32) * self.pitch
    }

    pub fn offset(&self, place: usize) -> f64 {
        self.offsets[place]
    }

    pub fn direction(&self, place: usize) -> C {
        self.directions[place]
    }
}

/// The same place counted to either side of tooth 1: half the rounding of its angle.
fn centred(place: i64, count: u32) -> f64 {
    let count = i64::from(count);
    let signed = if 2 * place > count {
        place - count
    } else {
        place
    };
    signed as f64
}

/// `angle` within ±π, to 4e-16 rad, for up to a million turns.
///
/// Cody and Waite's reduction: 2π in three parts of which the first two have few
/// enough digits for their product with a count of turns to be exact.
pub(super) fn reduced(angle: f64) -> f64 {
    const PARTS: [f64; 3] = [
        6.283_185_303_211_212,
        3.968_374_316_654_089e-9,
        2.068_073_192_717_642e-18,
    ];
    if angle.abs() <= TAU / 2.0 {
        return angle;
    }
    let turns = nearest(angle / TAU) as f64;
    ((angle - turns * PARTS[0]) - turns * PARTS[1]) - turns * PARTS[2]
}

/// The whole number nearest to `value`, which is far from 2^63. (`f64::round` is a call into the
/// C library on the baseline processor.)
pub(super) fn nearest(value: f64) -> i64 {
    (value + 0.5f64.copysign(value)) as i64
}
