//! One side of model 3: the rotations of the free gear at which facing involutes touch.
//!
//! Derivation, in the frame of the line of centres: the locked gear's axis at
//! the origin, the free gear's at `(a, 0)`, a gear's angles counted from the
//! direction to its mate; the left side mirrored in the x axis, which makes it a
//! right side. In complex notation the right flank of a tooth whose centre
//! stands at `θ` on a gear centred at `C` is
//!
//! ```text
//! P(ξ) = C + r_b E (1 − iξ),   E = e^{i(ξ − ψ_b + θ)},   outward normal −iE,
//! ```
//!
//! `ψ_b` half the tooth on the base circle. Where two flanks touch, the normals
//! oppose: `E_2 = −E_1`. With `D = C_2 − C_1`, `R = r_b1 + r_b2` and `Σ = r_b1 ξ_1 + r_b2 ξ_2`
//! equal points say `D = E_1 (R − iΣ)`, so that
//!
//! ```text
//! Σ² = |D|² − R²,   arg E_1 = arg D + atan(Σ/R),
//! ξ_1 = arg E_1 + ψ_b1 − θ_1,   ξ_2 = (Σ − r_b1 ξ_1)/r_b2,   θ_2 = arg E_1 + ψ_b2 − ξ_2.
//! ```
//!
//! A profile deviation `δ` puts the point as much farther out along the line, `P = C + r_b E (1 − iξ) − iEδ(ξ)`, and leaves its normal to first
//! order: `Σ = r_b1 ξ_1 + δ_1 + r_b2 ξ_2 + δ_2` with the deviations at the two points. What it tilts the normal by, `δ'/(r_b ξ)`, moves the
//! contact along the flanks and is left out: it costs the square of it.
//!
//! `C_2` turns with the free gear, hence `D` with its rotation `φ`: the last
//! line is a fixed point `φ = G(φ)`. Differentiating,
//! `G' = Im(conj(E_1) dD/dφ)/r_b2`, and `|dD/dφ| = e_2`: `|G'| ≤ e_2/r_b2`.

use crate::gear::{AsBuilt, RollCurve, Side};
use crate::numeric::wrap_angle;
use crate::pair::{GearPair, Pose};
use nalgebra::{UnitComplex, Vector2};
use std::ops::RangeInclusive;

/// Contact of two involutes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SideContact {
    /// Rotation of the free gear, rad, counted as in [`Pose`].
    pub rotation: f64,
    /// Tooth of the locked gear.
    pub locked_tooth: u32,
    /// Tooth of the free gear.
    pub free_tooth: u32,
    /// Roll `ξ` of the contact on the locked gear.
    pub locked_roll: f64,
    /// Roll `ξ` of the contact on the free gear.
    pub free_roll: f64,
    /// Where along the axes it has these rolls, mm from the measuring plane: the place of the contact nearest to it; 0 of spur gears.
    pub section: f64,
}

impl SideContact {
    /// Every pair of facing `side` flanks whose contact lies within both gears' tip and form circles
    /// (about their displaced centres).
    ///
    /// Empty, too, when the free gear is eccentric by its base radius or more: its rotation
    /// at contact is then not unique.
    pub fn all<'a>(
        assembly: &'a GearPair,
        pose: &'a Pose,
        side: Side,
    ) -> impl Iterator<Item = SideContact> + 'a {
        OneSide::new(assembly, pose, side).contacts()
    }
}

/// A roll this part of the tip roll beyond its end still counts as on the involute.
/// Rolls are sums of a few angles of order 1: their rounding is some 1e-15.
const END: f64 = 1e-12;

/// One side of a pose, mirrored if left. All angles from the line of centres.
pub(super) struct OneSide<'a> {
    assembly: &'a GearPair,
    pose: &'a Pose,
    side: Side,
    /// −1 on the left side: angles change sign in the mirror.
    mirror: f64,
    locked: &'a AsBuilt,
    free: &'a AsBuilt,
    /// Centre of the free gear's eccentric circle less the centre of the locked outline, mm.
    between: Vector2<f64>,
    /// From there to the centre of the free outline, at the nominal rotation, mm.
    displacement: Vector2<f64>,
    /// How far the locked teeth wind from the measuring plane to both ends of the common face, the lesser first, rad; 0 of spur gears.
    face: [f64; 2],
}

/// The common base tangent of one rotation of the free gear.
struct Line {
    /// `arg E_1`, rad.
    direction: f64,
    /// `Σ`, its length between the two base circles, mm.
    length: f64,
}

impl<'a> OneSide<'a> {
    pub(super) fn new(assembly: &'a GearPair, pose: &'a Pose, side: Side) -> OneSide<'a> {
        let mirror = -side.sense();
        let (locked, free) = (
            assembly.gear(assembly.locked()),
            assembly.gear(assembly.free()),
        );
        let seen = |vector: Vector2<f64>| Vector2::new(vector.x, mirror * vector.y);
        let twist = mirror * locked.gear().basic_data().twist();
        let mut face = assembly.face().map(|b| twist * b);
        face.sort_by(f64::total_cmp);
        // The free gear's direction to its mate is −x.
        OneSide {
            assembly,
            pose,
            side,
            mirror,
            locked,
            free,
            between: Vector2::new(assembly.center_distance(), 0.0)
                - seen(locked.displacement(pose.locked_rotation())),
            displacement: -seen(free.displacement(pose.free_rotation())),
            face,
        }
    }

    /// Every pair of flanks whose contact lies on both involutes.
    pub(super) fn contacts(self) -> impl Iterator<Item = SideContact> + 'a {
        let window = self.window();
        self.steps(&window)
            .filter_map(move |steps| self.contact(steps, &window))
    }

    fn base_radii(&self) -> f64 {
        self.locked.gear().base_radius() + self.free.gear().base_radius()
    }

    /// `atan(Σ/R)` and `Σ` of a distance of the outlines' centres; 0 where the base circles overlap.
    fn tangent(&self, distance: f64) -> (f64, f64) {
        let base = self.base_radii();
        let length = ((distance - base) * (distance + base)).max(0.0).sqrt();
        (length.atan2(base), length)
    }

    /// With the free gear turned by `turn` beyond its nominal rotation.
    fn line(&self, turn: f64) -> Line {
        let d = self.between + UnitComplex::new(turn) * self.displacement;
        let (angle, length) = self.tangent(d.norm());
        Line {
            direction: d.y.atan2(d.x) + angle,
            length,
        }
    }

    /// Angle `θ_1` of the locked tooth `steps` counter-clockwise of the mating's, without its deviation.
    fn locked_angle(&self, steps: i64) -> f64 {
        let tooth = f64::from(self.pose.mating().tooth(self.assembly.locked()));
        let turned = self.pose.locked_rotation() + self.locked.tooth_angle(tooth);
        self.mirror * (turned + steps as f64 * self.locked.gear().basic_data().angular_pitch())
    }

    /// The range of `θ_1` that can bring the contact onto the locked gear's involute.
    ///
    /// Whatever the free gear's rotation, `|D|` stays within `e_2` of its value for `e_2 = 0`, and
    /// `arg D` within `asin` of their ratio; `ξ_1 = arg E_1 + ψ_b1 − θ_1` does the rest.
    fn window(&self) -> RangeInclusive<f64> {
        let gear = self.locked.gear();
        let (distance, e) = (self.between.norm(), self.free.eccentricity());
        let direction = self.between.y.atan2(self.between.x) + gear.half_base_angle();
        let swing = (e / distance).min(1.0).asin();
        let slack = match self.locked.is_modified() {
            // A flank that deviates ends at another roll: by less than a pitch, or it were none.
            true => gear.basic_data().angular_pitch(),
            false => END * gear.tip_roll(),
        };
        let low = direction - swing + self.tangent(distance - e).0 - gear.tip_roll();
        let high = direction + swing + self.tangent(distance + e).0 - gear.form_roll();
        // θ_1 + s stands there, s from one end of the face to the other.
        low - slack - self.face[1]..=high + slack - self.face[0]
    }

    /// The least turn `s` of the locked teeth along the common face at which a contact lies on both involutes whose tangents to the base circles are
    /// so long in the measuring plane, mm.
    ///
    /// Teeth wind as gears roll: a section has the rolls `ξ_1 − s` and `ξ_2 + s r_b1/r_b2`, and the same rotation (own derivation: centres
    /// do not wind, and `r_b1 τ_1 + r_b2 τ_2 = 0`). Each involute allows a range of `s`; what they have in common with the face counts.
    fn on_involutes(&self, locked_arm: f64, free_arm: f64) -> Option<f64> {
        let (locked, free) = (self.locked.gear(), self.free.gear());
        let base = locked.base_radius();
        let (roll, per_free) = (locked_arm / base, free.base_radius() / base);
        let free_roll = free_arm / free.base_radius();
        let slack = END * locked.tip_roll().max(free.tip_roll() * per_free);
        let low = (roll - locked.tip_roll()).max((free.form_roll() - free_roll) * per_free);
        let high = (roll - locked.form_roll()).min((free.tip_roll() - free_roll) * per_free);
        let (from, to) = (low.max(self.face[0]), high.min(self.face[1]));
        // The place nearest to the measuring plane.
        (from <= to + slack).then(|| 0f64.max(from.min(to)).min(to))
    }

    /// The locked teeth to try, as steps counter-clockwise of the mating's.
    ///
    /// Three more at each end: a flank deviates by less than three pitches. ([`AsBuilt::new`]
    /// keeps pitch deviations below τ/2, every tip above 0, so half a tooth's extra thickness above
    /// −τ, and every space above 0, so the same below 5τ/2.)
    fn steps(&self, window: &RangeInclusive<f64>) -> RangeInclusive<i64> {
        let pitch = self.locked.gear().basic_data().angular_pitch();
        let places = |angle: &f64| {
            // Far beyond any pose's fraction, and i64 still counts it.
            (self.mirror * (angle - self.locked_angle(0)) / pitch).clamp(-1e15, 1e15)
        };
        let (one, other) = (places(window.start()), places(window.end()));
        one.min(other).ceil() as i64 - 3..=one.max(other).floor() as i64 + 3
    }

    /// The contact of the locked tooth `steps` places on, if its `θ_1` is in the window and the contact on both involutes.
    fn contact(&self, steps: i64, window: &RangeInclusive<f64>) -> Option<SideContact> {
        let locked_tooth = self
            .locked
            .counter_clockwise(self.pose.mating().tooth(self.assembly.locked()), steps);
        let theta = self.locked_angle(steps)
            + self.mirror * self.locked.flank_offset(self.side, locked_tooth);
        if !window.contains(&theta) {
            return None;
        }
        let free_tooth = self.pose.facing_tooth(self.assembly, self.side, steps);
        // Where the facing flank's tooth stands at the nominal rotation.
        let nominal = wrap_angle(
            self.mirror
                * (self.pose.free_rotation()
                    + self.free.tooth_angle(f64::from(free_tooth))
                    + self.free.flank_offset(self.side, free_tooth)),
        );
        let (locked, free) = (self.locked.gear(), self.free.gear());
        let (locked_base, free_base) = (locked.base_radius(), free.base_radius());
        let locked_flank = self.locked.modification(self.side, locked_tooth);
        let free_flank = self.free.modification(self.side, free_tooth);
        let rate = self.free.eccentricity() / free_base;
        if rate >= 1.0 {
            return None;
        }
        // φ = G(φ): the error after a step is at most its length times rate/(1 − rate). Done when
        // that is below 1e-16 rad, or when steps no longer shrink: what is left is rounding, unless
        // the base circles overlap on the way, where G need not contract and 1e-9 rad tells.
        let (mut turn, mut last) = (0.0, f64::INFINITY);
        loop {
            let line = self.line(turn);
            let locked_roll = line.direction + locked.half_base_angle() - theta;
            let locked_arm = locked_base * locked_roll + deviation(locked_flank, locked_roll);
            let free_arm = line.length - locked_arm;
            let mut free_roll = free_arm / free_base;
            if free_flank.is_some() {
                // Contracts: a deviation's slope is less than the base radius, and far less in practice.
                for _ in 0..DEVIATION_STEPS {
                    free_roll = (free_arm - deviation(free_flank, free_roll)) / free_base;
                }
            }
            let next = wrap_angle(line.direction + free.half_base_angle() - free_roll - nominal);
            let step = (next - turn).abs();
            turn = next;
            if step * rate > 1e-16 * (1.0 - rate) && step < last {
                last = step;
                continue;
            }
            let turned = match self.face == [0.0; 2] {
                true => (on_involute(self.locked, locked_arm / locked_base)
                    && on_involute(self.free, free_arm / free_base))
                .then_some(0.0),
                false => self.on_involutes(locked_arm, free_arm),
            };
            let turned = turned.filter(|_| step * rate < 1e-9 && line.length > 0.0)?;
            return Some(SideContact {
                rotation: self.pose.free_rotation() + self.mirror * turn,
                locked_tooth,
                free_tooth,
                locked_roll: locked_roll - turned,
                free_roll: free_roll + turned * locked_base / free_base,
                section: match turned == 0.0 {
                    true => 0.0,
                    false => turned / (self.mirror * self.locked.gear().basic_data().twist()),
                },
            });
        }
    }
}

/// Each divides what is left by `r_b/δ'`, some hundreds.
const DEVIATION_STEPS: u32 = 6;

/// A flank's deviation at a roll, mm.
fn deviation(flank: Option<&RollCurve>, roll: f64) -> f64 {
    flank.map_or(0.0, |flank| flank.at(roll))
}

/// Whether a point lies between form and tip circle whose tangent to the base circle is as long as that of the involute at `roll`.
fn on_involute(gear: &AsBuilt, roll: f64) -> bool {
    let (form, tip) = (gear.gear().form_roll(), gear.gear().tip_roll());
    form - END * tip <= roll && roll <= tip + END * tip
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gear::{BasicGearData, Deviations, Face, Gear, GearDesign, Hand};
    use crate::pair::{Mating, Member};

    fn gear(teeth: u32, face: Face, helix: f64, hand: Hand, eccentricity: f64) -> AsBuilt {
        let data = BasicGearData::new(teeth, 3.0, 20f64.to_radians()).unwrap();
        let data = data.with_helix(helix, hand).unwrap();
        let deviations = Deviations {
            eccentricity,
            high_tooth: 2.3,
            ..Deviations::default()
        };
        let gear = Gear::nominal(GearDesign::standard(data)).unwrap();
        AsBuilt::new(gear, face, &deviations).unwrap()
    }

    /// The same question to every tooth, whatever its place: of eccentric gears, either locked, one of them undercut so that its involutes begin within the
    /// path of contact, and of helical ones, whose faces begin on either side of the measuring plane.
    #[test]
    fn no_tooth_that_touches_is_outside_the_window() {
        let faces = [[0.0, 0.0], [-70.0, -20.0], [15.0, 80.0], [-30.0, 45.0]];
        let (mut found, mut beside) = (0, 0);
        for (face, free_off) in faces
            .into_iter()
            .flat_map(|face| [(face, 0.0), (face, 1.4)])
        {
            for teeth in [[19, 23], [8, 47]] {
                let helix = if face == [0.0; 2] { 0.0 } else { 0.3 };
                let wheel = gear(teeth[0], Face::Front, helix, Hand::Right, 0.9);
                let pinion = gear(teeth[1], Face::Back, helix, Hand::Left, free_off);
                for locked in Member::BOTH {
                    let sum = f64::from(teeth[0] + teeth[1]);
                    let distance = 1.5 * sum / f64::cos(helix) + 2.6;
                    let (wheel, pinion) = (wheel.clone(), pinion.clone());
                    let pair = GearPair::with_locked(wheel, pinion, distance, locked);
                    let pair = pair.unwrap().with_face(face).unwrap();
                    for k in 0..400u32 {
                        let mating = Mating {
                            wheel_tooth: 1 + k % teeth[0],
                            pinion_tooth: 1 + (5 * k) % teeth[1],
                            flank: Side::Right,
                            fraction: f64::from(k % 13) / 13.0,
                        };
                        let pose = Pose::new(&pair, mating);
                        for side in Side::BOTH {
                            let own: Vec<SideContact> =
                                OneSide::new(&pair, &pose, side).contacts().collect();
                            let one = OneSide::new(&pair, &pose, side);
                            let anywhere = f64::NEG_INFINITY..=f64::INFINITY;
                            let each = (-60..=60).filter_map(|steps| one.contact(steps, &anywhere));
                            assert_eq!(own, each.collect::<Vec<_>>(), "{face:?} {free_off} {k}");
                            found += own.len();
                            beside += own.iter().filter(|contact| contact.section != 0.0).count();
                        }
                    }
                }
            }
        }
        assert!(found > 10_000 && beside > 2000, "{found} {beside}");
    }
}
