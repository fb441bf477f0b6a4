//! Model 3: exact backlash of eccentric involutes with pitch and thickness deviations.
//!
//! Each side of the free gear is solved alone: the model finds the rotations of the free gear at which facing involutes touch. Only
//! contact on the line of action counts.
//!
//! Derivation, in the frame of the line of centres. The locked gear's axis is the origin, the free gear's axis `(a, 0)`. Angles of a
//! gear count from the direction to its mate. The left side is mirrored in the x axis, which makes it a right side. In complex
//! notation, the right flank of a tooth with its centre at the angle `θ` on a gear centred at `C` is
//!
//! ```text
//! P(ξ) = C + r_b E (1 − iξ),   E = e^{i(ξ − ψ_b + θ)},   outward normal −iE,
//! ```
//!
//! where `ψ_b` is half the tooth on the base circle. At a contact the normals oppose: `E_2 = −E_1`. With `D = C_2 − C_1`,
//! `R = r_b1 + r_b2` and `Σ = r_b1 ξ_1 + r_b2 ξ_2`, equal points mean `D = E_1 (R − iΣ)`, so
//!
//! ```text
//! Σ² = |D|² − R²,   arg E_1 = arg D + atan(Σ/R),
//!
//! ξ_1 = arg E_1 + ψ_b1 − θ_1,   ξ_2 = (Σ − r_b1 ξ_1)/r_b2,   θ_2 = arg E_1 + ψ_b2 − ξ_2.
//! ```
//!
//! A profile deviation `δ` moves the point along the normal, `P = C + r_b E (1 − iξ) − iEδ(ξ)`. To first order the normal stays, and
//! `Σ = r_b1 ξ_1 + δ_1 + r_b2 ξ_2 + δ_2` with the deviations at the two points. The tilt of the normal, `δ'/(r_b ξ)`, moves the
//! contact along the flanks; its effect is of second order and neglected.
//!
//! Leads turn the flanks of the section at `b` by `δ(b)/r_b`: a pair is on the line over one stretch of the face, and `G` grows by the
//! greatest `Σ δ(b)/r_b2` over it.
//!
//! `C_2` turns with the free gear, and so does `D` with its rotation `φ`: the last line is a fixed point `φ = G(φ)`. With
//! `G' = Im(conj(E_1) dD/dφ)/r_b2` and `|dD/dφ| = e_2`, `|G'| ≤ e_2/r_b2`.

use crate::gear::{AsBuilt, DeviationCurve, Side};
use crate::numeric::{bisect, wrap_angle};
use crate::pair::{FacingTeeth, GearPair, Pose};
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
    /// Section with these rolls, mm from the measuring plane: the contact nearest to that plane; 0 for spur gears.
    pub section: f64,
}

impl SideContact {
    /// All contacts of facing `side` flanks within both gears' tip and form circles about their displaced centres.
    ///
    /// Also empty if the free gear's eccentricity is its base radius or more: the rotation at contact is then not unique.
    pub fn all<'a>(
        assembly: &'a GearPair,
        pose: &'a Pose,
        side: Side,
    ) -> impl Iterator<Item = SideContact> + 'a {
        OneSide::new(assembly, pose, side).contacts()
    }
}

/// Tolerance of a roll at the ends of the involute, over the tip roll. Rolls are sums of a few angles of order 1, rounded by some 1e-15.
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
    /// Twist of the locked teeth from the measuring plane to both ends of the common face, the lesser first, rad; 0 for spur gears.
    face: [f64; 2],
}

/// The common base tangent at one rotation of the free gear.
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

    /// All contacts on both involutes.
    pub(super) fn contacts(self) -> impl Iterator<Item = SideContact> + 'a {
        let window = self.window();
        self.steps(&window)
            .filter_map(move |steps| self.contact(steps, &window))
    }

    fn base_radii(&self) -> f64 {
        self.locked.gear().base_radius() + self.free.gear().base_radius()
    }

    /// `atan(Σ/R)` and `Σ` at a distance of the outlines' centres; 0 if the base circles overlap.
    fn tangent(&self, distance: f64) -> (f64, f64) {
        let base = self.base_radii();
        let length = ((distance - base) * (distance + base)).max(0.0).sqrt();
        (length.atan2(base), length)
    }

    /// The base tangent with the free gear turned by `turn` from its nominal rotation.
    fn line(&self, turn: f64) -> Line {
        let d = self.between + UnitComplex::new(turn) * self.displacement;
        let (angle, length) = self.tangent(d.norm());
        Line {
            direction: d.y.atan2(d.x) + angle,
            length,
        }
    }

    /// Angle `θ_1` of the locked tooth `steps` counter-clockwise of the mating's tooth, without its deviation.
    fn locked_angle(&self, steps: i64) -> f64 {
        let tooth = f64::from(self.pose.mating().tooth(self.assembly.locked()));
        let turned = self.pose.locked_rotation() + self.locked.tooth_angle(tooth);
        self.mirror * (turned + steps as f64 * self.locked.gear().basic_data().angular_pitch())
    }

    /// The range of `θ_1` that can bring the contact onto the locked gear's involute.
    ///
    /// At every rotation of the free gear, `|D|` is within `e_2` of its value for `e_2 = 0`, and `arg D` within `asin` of their ratio.
    /// The range follows from `ξ_1 = arg E_1 + ψ_b1 − θ_1`.
    fn window(&self) -> RangeInclusive<f64> {
        let gear = self.locked.gear();
        let (distance, e) = (self.between.norm(), self.free.eccentricity());
        let direction = self.between.y.atan2(self.between.x) + gear.half_base_angle();
        let swing = (e / distance).min(1.0).asin();
        let slack = if self.locked.is_modified() {
            // A flank with a deviation ends at another roll, off by less than a pitch.
            gear.basic_data().angular_pitch()
        } else {
            END * gear.tip_roll()
        };
        let low = direction - swing + self.tangent(distance - e).0 - gear.tip_roll();
        let high = direction + swing + self.tangent(distance + e).0 - gear.form_roll();
        // θ_1 + s lies in the range, for s over the face.
        low - slack - self.face[1]..=high + slack - self.face[0]
    }

    /// The stretch of the face, mm, over which a pair with these arms in the measuring plane is on the line, for gears with leads.
    fn stretch(&self, locked_arm: f64, free_arm: f64) -> Option<[f64; 2]> {
        let twist = self.mirror * self.locked.gear().basic_data().twist();
        let face = self.assembly.face();
        if twist == 0.0 {
            let on = on_involute(self.locked, locked_arm / self.locked.gear().base_radius())
                && on_involute(self.free, free_arm / self.free.gear().base_radius());
            return on.then_some(face);
        }
        let [from, to] = self.turns_on_involutes(locked_arm, free_arm)?;
        let mut ends = [from, to].map(|turn| (turn / twist).clamp(face[0], face[1]));
        ends.sort_by(f64::total_cmp);
        Some(ends)
    }

    /// Where both leads add most over a stretch of the face, mm, and how much more than in the measuring plane, mm.
    fn greatest_lead(teeth: &FacingTeeth, stretch: [f64; 2]) -> (f64, f64) {
        let mut places = teeth.knots(stretch, |_, place| place);
        let tops = places.windows(2).filter_map(|ends| {
            let beside = 1e-9 * (ends[1] - ends[0]);
            let (low, high) = (ends[0] + beside, ends[1] - beside);
            (teeth.rate(low) > 0.0 && teeth.rate(high) < 0.0)
                .then(|| bisect(low, high, 0.0, |b| teeth.rate(b) > 0.0)[0])
        });
        let tops: Vec<f64> = tops.collect();
        places.extend(tops);
        // The nearest to the measuring plane comes first.
        places.sort_by(|one, other| one.abs().total_cmp(&other.abs()));
        let mut best = (places[0], teeth.lead(places[0]));
        for b in places {
            let here = teeth.lead(b);
            if here > best.1 {
                best = (b, here);
            }
        }
        best
    }

    /// The twists `s` of the locked teeth, from and to, with a contact on both involutes; `None` without one on the common face.
    ///
    /// The arms are the lengths of the tangents to the base circles in the measuring plane, mm. A section has the rolls `ξ_1 − s` and
    /// `ξ_2 + s r_b1/r_b2` at the same rotation (own derivation: centres do not wind, and `r_b1 τ_1 + r_b2 τ_2 = 0`). Each involute
    /// allows a range of `s`, and the face limits it.
    fn turns_on_involutes(&self, locked_arm: f64, free_arm: f64) -> Option<[f64; 2]> {
        let (locked, free) = (self.locked.gear(), self.free.gear());
        let base = locked.base_radius();
        let (roll, per_free) = (locked_arm / base, free.base_radius() / base);
        let free_roll = free_arm / free.base_radius();
        let slack = END * locked.tip_roll().max(free.tip_roll() * per_free);
        let low = (roll - locked.tip_roll()).max((free.form_roll() - free_roll) * per_free);
        let high = (roll - locked.form_roll()).min((free.tip_roll() - free_roll) * per_free);
        let (from, to) = (low.max(self.face[0]), high.min(self.face[1]));
        (from <= to + slack).then(|| [from.min(to), to])
    }

    /// The locked teeth to try, as steps counter-clockwise of the mating's tooth.
    ///
    /// Three more teeth at each end, because a flank deviates by less than three pitches. [`AsBuilt::new`] keeps pitch deviations below
    /// τ/2. Positive tips keep half a tooth's extra thickness above −τ, and positive spaces below 5τ/2.
    fn steps(&self, window: &RangeInclusive<f64>) -> RangeInclusive<i64> {
        let pitch = self.locked.gear().basic_data().angular_pitch();
        let places = |angle: &f64| {
            // More than the fraction of any pose, and within i64.
            (self.mirror * (angle - self.locked_angle(0)) / pitch).clamp(-1e15, 1e15)
        };
        let (one, other) = (places(window.start()), places(window.end()));
        one.min(other).ceil() as i64 - 3..=one.max(other).floor() as i64 + 3
    }

    /// The contact of the locked tooth `steps` places on, if its `θ_1` is in the window and the contact lies on both involutes.
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
        // Angle of the facing tooth at the nominal rotation.
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
        // φ = G(φ): the error after a step is at most its length times rate/(1 − rate). Stop when that is below 1e-16 rad or when
        // steps no longer shrink. The rest is rounding, unless the base circles overlap on the way: G need not contract there, and a
        // limit of 1e-9 rad detects it.
        let has_leads = self.assembly.has_leads();
        let teeth = [(self.locked, locked_tooth), (self.free, free_tooth)];
        let teeth = FacingTeeth::new(self.side, teeth);
        let (mut turn, mut last) = (0.0, f64::INFINITY);
        // The leads' part of G, and the rounds in which it settles: the stretch on the line moves with it.
        let (mut leads, mut rounds) = (0.0, 0);
        loop {
            let line = self.line(turn);
            let locked_roll = line.direction + locked.half_base_angle() - theta;
            let locked_arm = locked_base * locked_roll + deviation(locked_flank, locked_roll);
            let free_arm = line.length - locked_arm;
            let mut free_roll = free_arm / free_base;
            if free_flank.is_some() {
                // The iteration contracts: a deviation's slope is far less than the base radius.
                for _ in 0..DEVIATION_STEPS {
                    free_roll = (free_arm - deviation(free_flank, free_roll)) / free_base;
                }
            }
            let next =
                wrap_angle(line.direction + free.half_base_angle() - free_roll - nominal + leads);
            let step = (next - turn).abs();
            turn = next;
            if step * rate > 1e-16 * (1.0 - rate) && step < last {
                last = step;
                continue;
            }
            if has_leads {
                let stretch = self.stretch(locked_arm, free_arm)?;
                let (section, lead) = OneSide::greatest_lead(&teeth, stretch);
                let more = lead / free_base;
                if (more - leads).abs() > LEADS_SETTLED && rounds < MOST_ROUNDS {
                    (leads, last, rounds) = (more, f64::INFINITY, rounds + 1);
                    continue;
                }
                return Some(SideContact {
                    rotation: self.pose.free_rotation() + self.mirror * turn,
                    locked_tooth,
                    free_tooth,
                    locked_roll,
                    free_roll,
                    section,
                })
                .filter(|_| step * rate < 1e-9 && line.length > 0.0);
            }
            let turned = if self.face == [0.0; 2] {
                (on_involute(self.locked, locked_arm / locked_base)
                    && on_involute(self.free, free_arm / free_base))
                .then_some(0.0)
            } else {
                // The place nearest to the measuring plane.
                let turns = self.turns_on_involutes(locked_arm, free_arm);
                turns.map(|[from, to]| 0f64.max(from).min(to))
            };
            let turned = turned.filter(|_| step * rate < 1e-9 && line.length > 0.0)?;
            return Some(SideContact {
                rotation: self.pose.free_rotation() + self.mirror * turn,
                locked_tooth,
                free_tooth,
                locked_roll: locked_roll - turned,
                free_roll: free_roll + turned * locked_base / free_base,
                section: if turned == 0.0 {
                    0.0
                } else {
                    turned / (self.mirror * self.locked.gear().basic_data().twist())
                },
            });
        }
    }
}

/// Change of a rotation by leads, rad, at which they are settled, and the rounds to it: each leaves a share of the leads' slope.
const LEADS_SETTLED: f64 = 1e-15;
const MOST_ROUNDS: u32 = 8;

/// Steps for the roll with a deviation. Each divides the error by `r_b/δ'`, some hundreds.
const DEVIATION_STEPS: u32 = 6;

/// A flank's deviation at a roll, mm.
fn deviation(flank: Option<&DeviationCurve>, roll: f64) -> f64 {
    flank.map_or(0.0, |flank| flank.at(roll))
}

/// Whether the involute's point at `roll` lies between form and tip circle.
fn on_involute(gear: &AsBuilt, roll: f64) -> bool {
    let (form, tip) = (gear.gear().form_roll(), gear.gear().tip_roll());
    form - END * tip <= roll && roll <= tip + END * tip
}

/// The tightest contact of each side; `None` without contact on the line of action.
///
/// Pairs within rounding, as of perfect gears, tie: any of them may be the result.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LineOfAction {
    /// The contact that limits clockwise rotation.
    pub right: Option<SideContact>,
    /// The contact that limits counter-clockwise rotation.
    pub left: Option<SideContact>,
}

impl LineOfAction {
    /// The tightest contacts at `pose`.
    pub fn new(assembly: &GearPair, pose: &Pose) -> LineOfAction {
        // Clockwise rotation stops at the greatest contact rotation, counter-clockwise rotation at the least.
        let tightest = |side: Side| {
            SideContact::all(assembly, pose, side).reduce(|best, next| {
                if side.sense() * (next.rotation - best.rotation) < 0.0 {
                    next
                } else {
                    best
                }
            })
        };
        LineOfAction {
            right: tightest(Side::Right),
            left: tightest(Side::Left),
        }
    }

    /// Lost motion `φ_j` = left − right, rad.
    pub fn angle(&self) -> Option<f64> {
        Some(self.left?.rotation - self.right?.rotation)
    }

    /// Circumferential backlash `j_wt = φ_j r_w` of the free gear, mm.
    pub fn backlash(&self, assembly: &GearPair) -> Option<f64> {
        Some(self.angle()? * assembly.operating_pitch_radius(assembly.free()))
    }
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

    /// No contact exists outside the window. Source: the contact of every tooth. The gears are eccentric, either one locked. One is
    /// undercut, so its involutes begin within the path of contact. Helical gears have faces on either side of the measuring plane.
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
