//! The position of every tooth's half on one side, in the gear's own frame.
//!
//! The left side is stored mirrored, so all later code knows only right-hand halves. *Places* count counter-clockwise
//! from tooth 1, also in the mirrored frame. A place takes 48 bytes.

use super::placed::PlacedHalf;
use super::shape::{C, HalfToothShape, turn};
use crate::gear::{AsBuilt, Profile, ProfilePart, Side};
use std::f64::consts::TAU;
use std::sync::Arc;

/// Greatest angle, rad, that [`slightly_turned`] takes from its series: the first terms left out, the twelfth and thirteenth power over their
/// factorials, are below rounding.
const SLIGHT: f64 = 0.2;

/// One side of the teeth of a gear: of all, or in a section of those in reach of the mate.
#[derive(Debug, Clone)]
pub(in crate::contact) struct Teeth {
    /// The half tooth without profile deviations.
    pub shape: Arc<HalfToothShape>,
    /// The half teeth with profile deviations, and the index of each place into them.
    modified: Option<Arc<(Vec<HalfToothShape>, Vec<u32>)>>,
    /// `τ`.
    pub pitch: f64,
    /// Sign with which tooth numbers increase in this frame.
    ascending: i64,
    /// `z`.
    count: i64,
    /// The place of the first half.
    first: usize,
    /// The halves of the first and the following places.
    halves: Vec<Half>,
    /// Least and greatest offset.
    pub offset_range: (f64, f64),
    /// Greatest angle of a far corner from its tooth's undisturbed centre line.
    pub farthest: f64,
    /// Greatest angle of a root land's end from its tooth's undisturbed centre line, to the other side.
    pub deepest: f64,
}

/// One half tooth.
#[derive(Debug, Clone, Copy)]
pub(in crate::contact) struct Half {
    /// Rotation from its undisturbed place, rad.
    pub offset: f64,
    /// Direction of its tooth's centre line, offset included.
    pub direction: C,
    /// Far corner of its tip land, where the tooth's other flank begins, in the frame of this half tooth.
    pub far: C,
    /// Parameter of the end of its root land: the middle of the space as built.
    pub root_end: f64,
}

impl Teeth {
    /// Whether profiles deviate.
    pub fn is_modified(&self) -> bool {
        self.modified.is_some()
    }

    pub fn new(gear: &AsBuilt, side: Side) -> Teeth {
        let basic_data = gear.gear().basic_data();
        let pitch = basic_data.angular_pitch();
        // Right stays, left is mirrored in the x axis: angles change sign.
        let mirror = -side.sense();
        let count = basic_data.teeth();
        let ascending = (mirror * gear.face().ascending()) as i64;
        let shape = |profile: Profile| HalfToothShape::new(&profile);
        let number = |place: i64| (ascending * place).rem_euclid(i64::from(count)) as u32 + 1;
        let modified = gear.is_modified().then(|| {
            let shapes = (0..gear.shapes(side)).map(|of| shape(gear.shape(side, of)));
            let places =
                (0..i64::from(count)).map(|place| gear.shape_of(side, number(place)) as u32);
            Arc::new((shapes.collect(), places.collect()))
        });
        let mut teeth = Teeth {
            shape: Arc::new(shape(Profile::new(gear.gear()))),
            modified,
            pitch,
            ascending,
            count: i64::from(count),
            first: 0,
            halves: Vec::with_capacity(count as usize),
            offset_range: (0.0, 0.0),
            farthest: f64::NEG_INFINITY,
            deepest: f64::NEG_INFINITY,
        };
        // The far corner of the tooth before, which most teeth share.
        let mut last = (f64::NAN, C::ZERO);
        for place in 0..i64::from(count) {
            let tooth = number(place);
            let offset = mirror * gear.flank_offset(side, tooth);
            // On a tooth thinner by more than half its land, the corner is on the near half.
            let (_, half_tip) = gear.profile(side.other(), tooth).range(ProfilePart::Tip);
            let far = half_tip + mirror * gear.flank_offset(side.other(), tooth);
            teeth.farthest = teeth.farthest.max(far);
            if last.0 != far - offset {
                last = (far - offset, turn(far - offset) * teeth.shape.tip_radius);
            }
            let root_end = gear.root_end(side, tooth);
            teeth.deepest = teeth.deepest.max(root_end - offset);
            teeth.halves.push(Half {
                offset,
                direction: turn(centred(place, count) * pitch + offset),
                far: last.1,
                root_end,
            });
        }
        teeth.set_offset_range();
        teeth
    }

    fn set_offset_range(&mut self) {
        self.offset_range = self
            .halves
            .iter()
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), half| {
                (least.min(half.offset), most.max(half.offset))
            });
    }

    /// The halves of `count` places from `first` in a section that turns the flanks slightly. `turns` has the turns, rad in this frame, of this
    /// flank and of the other flank of the teeth from one before the first place on. All halves must be known here.
    pub fn in_section(&self, first: usize, turns: &[[f64; 2]]) -> Teeth {
        let (start, _) = self.shape.range(ProfilePart::Root);
        let mut most = 0.0f64;
        // Teeth of one lead have one turn.
        let mut last = ([f64::NAN; 2], [C::ZERO; 2]);
        let halves = turns.windows(2).enumerate().map(|(nth, turns)| {
            let [[_, across], [own, other]] = [turns[0], turns[1]];
            let half = &self.halves[self.beside(first, nth as i64)];
            most = most.max(own.abs()).max(other.abs()).max(across.abs());
            if last.0 != turns[1] {
                last = (turns[1], [own, other - own].map(slightly_turned));
            }
            let [by_own, by_other] = last.1;
            Half {
                offset: half.offset + own,
                direction: half.direction * by_own,
                far: half.far * by_other,
                // The space ends at the other flank of the tooth before.
                root_end: (half.root_end - 0.5 * (across - own)).max(start),
            }
        });
        let halves = halves.collect();
        let mut teeth = Teeth {
            shape: Arc::clone(&self.shape),
            modified: self.modified.clone(),
            first,
            halves,
            farthest: self.farthest + most,
            deepest: self.deepest + 2.0 * most,
            ..*self
        };
        teeth.set_offset_range();
        teeth
    }

    /// The half tooth at a place, as it stands.
    #[inline]
    pub fn half(&self, place: usize) -> &Half {
        let nth = if place >= self.first {
            place - self.first
        } else {
            place + self.count as usize - self.first
        };
        &self.halves[nth]
    }

    /// The half tooth at a place, with the gear's centre at `centre` and tooth 1 on +x.
    pub fn placed(&self, place: usize, centre: C) -> PlacedHalf<'_> {
        let &Half {
            direction,
            far,
            root_end,
            ..
        } = self.half(place);
        PlacedHalf {
            shape: self.shape_at(place),
            centre,
            direction,
            far,
            root_end,
        }
    }

    /// The shape of the half tooth at a place.
    #[inline]
    pub fn shape_at(&self, place: usize) -> &HalfToothShape {
        match &self.modified {
            None => &self.shape,
            Some(modified) => &modified.0[modified.1[place] as usize],
        }
    }

    /// Whether every flank lies on one side of each of its tangents.
    pub fn is_convex(&self) -> bool {
        let convex =
            |modified: &(Vec<HalfToothShape>, Vec<u32>)| modified.0.iter().all(|s| s.is_convex);
        self.shape.is_convex && self.modified.as_deref().is_none_or(convex)
    }

    /// Greatest tilt of a flank's normal by its deviation, rad.
    pub fn tilt(&self) -> f64 {
        let shapes = self.modified.iter().flat_map(|modified| &modified.0);
        shapes.fold(0.0, |most, shape| most.max(shape.tilt))
    }

    /// Least radius of curvature of a flank from a roll outwards, mm; 0 at an edge or where the flank is not convex.
    pub fn least_bend_radius(&self, roll: f64) -> f64 {
        let shapes = self.modified.iter().flat_map(|modified| &modified.0);
        let least = shapes.map(|shape| shape.least_bend_radius(roll));
        least.fold(self.shape.base * roll, f64::min)
    }

    /// `z`.
    pub fn count(&self) -> i64 {
        self.count
    }

    /// The place `steps` counter-clockwise of tooth number `tooth`.
    pub fn place(&self, tooth: u32, steps: i64) -> usize {
        let place = self.ascending * (i64::from(tooth) - 1) + steps;
        // Usually within a turn or two: a division is slower.
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

    /// Pitches from tooth 1 to `tooth`, counter-clockwise positive, including whole turns.
    pub fn pitches_to(&self, tooth: u32) -> f64 {
        (self.ascending * (i64::from(tooth) - 1)) as f64
    }

    /// The place `steps` counter-clockwise of `place`, for a few steps, without a division.
    #[inline]
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
            self.count as usize - place
        };
        steps as u32 + 1
    }

    /// Angle of a place from tooth 1, in (−π, π].
    pub fn angle(&self, place: usize) -> f64 {
        centred(place as i64, self.count as u32) * self.pitch
    }
}

/// `e^{iα}` of an angle that is usually slight, rad.
#[inline]
pub(super) fn slightly_turned(angle: f64) -> C {
    if angle.abs() > SLIGHT {
        return turn(angle);
    }
    let q = angle * angle;
    // By Horner's rule: each factor is the quotient of two factorials.
    let series = |factors: [f64; 5]| factors.iter().fold(1.0, |sum, by| 1.0 - q * by * sum);
    let cos = series([1.0 / 90.0, 1.0 / 56.0, 1.0 / 30.0, 1.0 / 12.0, 1.0 / 2.0]);
    let sin = series([1.0 / 110.0, 1.0 / 72.0, 1.0 / 42.0, 1.0 / 20.0, 1.0 / 6.0]);
    C::new(cos, angle * sin)
}

/// The place counted to either side of tooth 1, which halves the rounding of its angle.
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
/// Cody and Waite's reduction: 2π is the sum of three parts. The first two have so few digits that their product with a
/// count of turns is exact.
pub(in crate::contact) fn reduced(angle: f64) -> f64 {
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

/// The whole number nearest to `value`, which is far from 2^63. `f64::round` would call the C library on the baseline processor.
pub(super) fn nearest(value: f64) -> i64 {
    (value + 0.5f64.copysign(value)) as i64
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gear::{Deviations, Face, GearDesign};
    use std::f64::consts::PI;

    /// A tooth and side takes at most 128 bytes (issue 3); here 48.
    #[test]
    fn a_tooth_takes_48_bytes_a_side() {
        let gear = GearDesign::plain(17, 2.0).built(Face::Front, &Deviations::default());
        let teeth = Teeth::new(&gear, Side::Right);
        assert_eq!(size_of_val(teeth.halves.as_slice()), 17 * 48);
    }

    /// Source: sin and cos of the C library, which reduce exactly.
    #[test]
    fn angles_are_reduced_without_loss() {
        for k in 1..2000 {
            let angle = f64::from(k * k) * 0.987;
            let there = reduced(angle);
            assert!(there.abs() <= PI + 1e-9);
            assert!((turn(there) - turn(angle)).norm() < 5e-16, "{angle}");
            assert_eq!(reduced(-angle), -there);
        }
    }
}
